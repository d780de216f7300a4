#include <algorithm>
#include <cmath>

#include "shading/color/font.h"
#include "x11/drawing/wording.h"
#include "x11/stepper/sort_pen.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell {

namespace {

constexpr std::array kOrder{Test::XExtents,    Test::YExtents, Test::PBehindQ,    Test::QInFrontOfP,
                            Test::Projections, Test::QBehindP, Test::PInFrontOfQ, Test::Overlap};

void drawHeading(SortPen& pen) {
  const Rect& at = pen.at.table;
  const int y = at.y + (pen.at.compact ? 14 : 18), right = at.x + at.width;
  pen.caps(at.x, y, "WHY");
  if (!pen.event) return;
  int x = at.x + 45;
  const bool pair = pen.Q() >= 0;
  const std::string asks = !pen.sorting()          ? "may P be painted before Q?"
                           : pen.view.own->clicksQ ? "a click chooses Q"
                                                   : "a click chooses P";
  const bool asked = pair && (pen.compare != nullptr || pen.sorting()) && at.width > 520;
  const int room = (right - (asked ? textWidth(asks) + 12 : 0) - x) / (pair ? 2 : 1) - 34;
  const auto name = [&](int id, bool isP) {
    drawBadge(pen, x, y - 11, isP);
    const std::string farthest = numberAndPart(pen.run, id) +
                                 (pen.event->kind == Event::Kind::Take && !pen.view.own ? ", farthest" : "");
    x = pen.ink(x + 18, y, fitting(farthest, room)) + 24;
  };
  name(pen.P(), true);
  if (pair) name(pen.Q(), false);
  if (asked) pen.softRight(right, y, asks);
}

/// Draws the answer at the end of a row, aligned right: a mark and words.
void drawAnswer(SortPen& pen, int right, int y, const TestAnswer& answer) {
  const bool holds = answer.mark == TestAnswer::Mark::Tick;
  const Cell cell = holds ? Cell::Good : Cell::Alarm;
  const int x = pen.paint.textRight(right, y, answer.words, pen(cell));
  if (holds)
    pen.paint.tick(x - 16, y - 8, pen(cell));
  else
    pen.paint.cross(x - 17, y - 8, pen(cell));
}

/// Tests 1 to 5, while the student says which of them tells: what is known of P and Q so far.
void drawOwnTests(SortPen& pen) {
  const int numbers = pen.at.table.x + (pen.at.compact ? 174 : 186);
  for (int k = 0; k < kOwnTests; ++k) {
    const Rect row = pen.at.testRow(k);
    const Test test = kOrder[k];
    const int y = row.y + pen.at.line - 4, right = row.x + row.width;
    // At an earlier step, only the test that was named then is known.
    std::optional<bool> passed;
    if (pen.sorting())
      passed = pen.view.own->passed[k];
    else if (pen.compare && pen.compare->test == test)
      passed = true;
    if (pen.look(SortPart::Test, k).hovered && pen.sorting()) pen.paint.fillRect(row, pen(Cell::Focus));
    if (pen.view.own->naming && pen.sorting())
      pen.key(row.x - 3, y - 11, shortNameOf(test));
    else
      pen.soft(row.x, y, shortNameOf(test));
    const bool pair = pen.Q() >= 0;
    pen.paint.text(row.x + (pen.at.compact ? 20 : 24), y, questionOf(test),
                   pen(pair ? Cell::Ink : Cell::Faint));
    if (passed) {
      const Event compare{
          .kind = Event::Kind::Compare, .test = *passed ? test : Test::Overlap, .P = pen.P(), .Q = pen.Q()};
      const TestAnswer answer = answerOf(compare, test);
      pen.ink(
          numbers, y,
          numbersThatFit(pen.run.explainer(), compare, test, right - textWidth(answer.words) - 24 - numbers));
      drawAnswer(pen, right, y, answer);
    } else if (pair && pen.sorting()) {
      pen.softRight(right, y, "does it tell?");
    }
  }
}

}  // namespace

void drawTests(SortPen& pen) {
  drawHeading(pen);
  if (pen.view.own) return drawOwnTests(pen);
  const Rect& at = pen.at.table;
  const int heading = at.height - static_cast<int>(kOrder.size()) * pen.at.line;
  const int numbers = at.x + (pen.at.compact ? 174 : 186), right = at.x + at.width;
  const std::vector<ShownTest> made =
      pen.told() ? testsShown(pen.run, *pen.compare) : std::vector<ShownTest>{};
  // A polygon that is painted has passed against every Q. The table shows by which tests.
  const bool painted = pen.event && pen.event->kind == Event::Kind::Paint && !pen.compare;
  const std::array<int, kTests> settled =
      painted ? settledFor(pen.run.sorted(), pen.view.step) : std::array<int, kTests>{};
  int y = at.y + heading + pen.at.line - 4;
  for (Test test : kOrder) {
    // For two polygons in one plane the face numbers decide, not test 6.
    if (test == Test::Overlap && std::ranges::find(made, Test::SamePlane, &ShownTest::test) != made.end())
      test = Test::SamePlane;
    const int pairs = settled[static_cast<int>(test)] +
                      (test == Test::Overlap ? settled[static_cast<int>(Test::SamePlane)] : 0);
    const auto row = std::ranges::find(made, test, &ShownTest::test);
    const bool reached = pairs > 0 || row != made.end();
    if (test == Test::QBehindP) pen.rule(at.x, y - pen.at.line + 4, at.width);
    const Cell cell = reached ? Cell::Ink : Cell::Faint;
    pen.paint.text(at.x, y, shortNameOf(test), pen(reached ? Cell::Soft : Cell::Faint));
    pen.paint.text(at.x + (pen.at.compact ? 20 : 24), y, questionOf(test), pen(cell));
    if (pairs > 0) {
      pen.ink(numbers, y, "settled it against " + counted(pairs, "polygon"));
    } else if (reached) {
      const TestAnswer& answer = row->answer;
      pen.ink(numbers, y,
              numbersThatFit(pen.run.explainer(), *pen.compare, test,
                             right - textWidth(answer.words) - 24 - numbers));
      drawAnswer(pen, right, y, answer);
    } else if (pen.view.asking) {
      pen.softRight(right, y, "?");
    }
    y += pen.at.line;
  }
}

void drawFinding(SortPen& pen) {
  const Rect& at = pen.at.finding;
  pen.paint.fillRect(at, pen(Cell::White));
  const StepFinding finding = findingOf(pen.run, pen.view);
  const bool alarm = finding.alarm;
  pen.paint.fillRect({at.x, at.y, 3, at.height}, pen(alarm ? Cell::Alarm : Cell::Ink));
  const int x = at.x + 13, room = at.width - 20;
  int y = at.y + pen.at.line - (pen.at.compact ? 2 : 1);
  if (const Rect& head = pen.at.headline; !head.empty()) {
    pen.paint.text(head.x, head.y + 23, beginningOf(finding.bold, head.width, Voice::Title), pen(Cell::Ink),
                   Voice::Title);
    y -= pen.at.line;
  } else {
    const int end = pen.bold(x, y, fitting(finding.bold, room));
    if (!finding.aside.empty() && end + 12 + textWidth(finding.aside) <= at.x + at.width - 6)
      pen.softRight(at.x + at.width - 8, y, finding.aside);
  }
  if (pen.sorting()) {
    for (std::size_t k = 0; k < kActs.size(); ++k) {
      const Rect& r = pen.at.acts[k];
      if (pen.look(SortPart::Act, static_cast<int>(k)).hovered)
        pen.paint.fillRect({r.x - 3, r.y - 1, r.width + 6, r.height + 1}, pen(Cell::Focus));
      const int width = pen.key(r.x, r.y + 1, std::string_view{&kActKeys[k], 1});
      pen.paint.text(r.x + width + 6, r.y + 1 + kKeyCapBaseline, kActs[k],
                     pen(pen.P() >= 0 && (k == 0 || pen.Q() >= 0) ? Cell::Ink : Cell::Faint));
    }
    y = pen.at.acts.back().y + pen.at.acts.back().height + pen.at.line - 2;
  } else if (pen.view.asking) {
    for (std::size_t k = 0; k < kAnswers.size(); ++k) {
      const Rect& r = pen.at.answers[k];
      if (pen.look(SortPart::Answer, static_cast<int>(k)).hovered)
        pen.paint.fillRect({r.x - 3, r.y - 1, r.width + 6, r.height + 1}, pen(Cell::Focus));
      const int width = pen.key(r.x, r.y + 1, std::string_view{&kAnswerKeys[k], 1});
      pen.ink(r.x + width + 6, r.y + 1 + kKeyCapBaseline, kAnswers[k]);
    }
    y += 2 * pen.at.line;
  } else {
    y += pen.at.line;
  }
  for (const std::string& line : broken(finding.why, room / kGlyphWidth)) {
    if (y > at.y + at.height) break;
    pen.ink(x, y, line);
    y += pen.at.line;
  }
}

}  // namespace xnewell
