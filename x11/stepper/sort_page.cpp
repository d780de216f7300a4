#include "x11/stepper/sort_page.h"

#include <algorithm>
#include <cmath>

#include "shading/color/font.h"
#include "x11/drawing/wording.h"
#include "x11/stepper/sort_pen.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell {

void drawBadge(SortPen& pen, int x, int y, bool isP) {
  const Rect box{x, y, 13, 13};
  pen.paint.fillRect(box, pen(isP ? Cell::P : Cell::Q));
  if (!isP) pen.paint.frame(box, pen(Cell::Ink));
  pen.bold(x + 3, y + 11, isP ? "P" : "Q", isP ? Cell::White : Cell::Black);
}

namespace {

/// Tells the list where the controls are. The page draws them all itself.
void placeControls(ControlList& list, const SortLayout& at, const SortState& view, const SortDrawn& drawn) {
  const auto place = [&](SortPart part, int index, const Rect& area) {
    list.place(sortId(part, index), {.area = area, .bare = true});
  };
  placeTransport(list, at);
  for (int k = 0; k < kToggleCount; ++k) list.place(sortId(SortPart::Toggle, k), at.toggles[k]);
  for (int k = 0; view.asking && k < static_cast<int>(kAnswers.size()); ++k)
    place(SortPart::Answer, k, at.answers[k]);
  for (int k = 0; view.own && k < static_cast<int>(kActs.size()); ++k) place(SortPart::Act, k, at.acts[k]);
  for (int k = 0; view.own && k < kOwnTests; ++k) place(SortPart::Test, k, at.testRow(k));
  for (int k = 0; k < static_cast<int>(drawn.ring.size()); ++k) place(SortPart::Ring, k, drawn.ring[k].area);
  for (int k = 0; k < static_cast<int>(drawn.rows.size()); ++k)
    if (drawn.rows[k] >= 0)
      place(SortPart::Row, k, {at.list.x, at.list.y + k * at.line, at.list.width, at.line});
}

}  // namespace

SortDrawn drawSortPage(Painter paint, const SortLayout& layout, SortRun& run, const SortState& view,
                       const CellPlan& plan, ControlList* list) {
  run.goTo(view.step);
  SortLayout at = layout;
  std::vector<RingLink> ring;
  if (!view.asking && !at.ring.empty() && (at.shut || !view.code)) ring = run.ring();
  if (!ring.empty() && !at.shut) at.list.height -= at.ring.height;
  std::optional<Event> event = run.asTested();
  const bool sorting = view.own && view.step == run.steps();
  if (sorting && view.own->P >= 0)
    event = Event{.kind = Event::Kind::Take, .P = view.own->P, .Q = view.own->Q};
  else if (sorting)
    event.reset();
  const Event* compare = comparisonAt(run.sorted(), view.step);
  if (event && compare && (compare->P != event->P || compare->Q != event->Q)) compare = nullptr;
  if (sorting) compare = nullptr;
  // Where another program is wrong about a Q that the step does not name, or has not tested, we test it.
  const std::vector<const FalseStep*> wrong =
      view.own || view.asking ? std::vector<const FalseStep*>{} : run.wrong();
  std::optional<Event> ours;
  for (const FalseStep* one : wrong)
    if (event && !ours && one->Q >= 0 && !run.partsOf(one->Q).empty()) {
      if (event->Q < 0) event->Q = run.partsOf(one->Q)[0];
      if (event->Q != event->P) ours = run.compared(event->P, event->Q);
    }
  if (ours && !compare) compare = &*ours;
  const int cut = event && event->kind == Event::Kind::Split ? run.replay().event()->P : -1;
  SortPen pen{
      {paint.within(at.body), plan}, at, run, view, event ? &*event : nullptr, compare, cut, wrong, list};
  pen.paint.fillRect(at.body, plan[Cell::Paper]);
  SortDrawn drawn;
  drawn.loupe = drawSortPicture(pen);
  drawTests(pen);
  drawFinding(pen);
  if (!at.shut && view.code && !view.own) {
    const int top = at.side.y;
    drawPseudocode(pen, {at.list.x, top, at.list.width, at.counts.y - 6 - top}, at.line,
                   "Foley & van Dam 15.5.1", sortCode(run, view));
  } else if (!at.shut) {
    drawn.rows = drawSidesAndList(pen);
  }
  if (!ring.empty()) drawn.ring = drawRing(pen, ring);
  drawCounts(pen);
  pen.rule(at.body.x, at.rule, at.body.width);
  drawTransport(pen);
  drawTimeline(pen);
  if (list) placeControls(*list, at, view, drawn);
  return drawn;
}

namespace {

constexpr int kTestsShown = 8;

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
    const bool isFarthest = pen.event->kind == Event::Kind::Take && !pen.view.own && !pen.run.theirs();
    const std::string farthest = pen.run.name(id) + (isFarthest ? ", farthest" : "");
    x = pen.ink(x + 18, y, fitting(farthest, room)) + 24;
  };
  name(pen.P(), true);
  if (pair) name(pen.Q(), false);
  if (asked) pen.softRight(right, y, asks);
}

/// Draws the answer at the end of a row, aligned right: a mark and words.
void drawAnswer(SortPen& pen, int right, int y, const TestAnswer& answer) {
  using Is = TestAnswer::Mark;
  const bool holds = answer.mark == Is::Tick;
  const Cell cell = holds ? Cell::Good : answer.mark == Is::None ? Cell::Soft : Cell::Alarm;
  const int x = pen.paint.textRight(right, y, answer.words, pen(cell));
  if (holds)
    pen.paint.tick(x - 16, y - 8, pen(cell));
  else if (answer.mark == Is::Cross)
    pen.paint.cross(x - 17, y - 8, pen(cell));
}

/// What is known of the tests of P and Q; while the student sorts, of those that were named.
std::vector<ShownTest> knownTests(const SortPen& pen) {
  if (!pen.view.own) return pen.told() ? testsShown(pen.run, *pen.compare) : std::vector<ShownTest>{};
  std::vector<ShownTest> known;
  for (int k = 0; k < kOwnTests; ++k) {
    const Test test = testAt(k);
    // At an earlier step, only the test that was named then is known.
    const bool named = pen.compare && pen.compare->test == test;
    const std::optional<bool> passed = pen.sorting() ? pen.view.own->passed[k]
                                       : named       ? std::optional{true}
                                                     : std::nullopt;
    if (passed)
      known.push_back(
          {test,
           answerOf({.kind = Event::Kind::Compare, .test = *passed ? test : Test::Overlap, .P = pen.P()},
                    test)});
  }
  return known;
}

}  // namespace

void drawTests(SortPen& pen) {
  drawHeading(pen);
  const bool own = pen.view.own.has_value(), sorting = pen.sorting(), pair = pen.Q() >= 0;
  const std::vector<ShownTest> known = knownTests(pen);
  // A polygon that is painted has passed against every Q. The table shows by which tests.
  const bool painted = !own && pen.event && pen.event->kind == Event::Kind::Paint && !pen.compare;
  const std::array<int, kTests> settled =
      painted ? settledFor(pen.run.sorted(), pen.view.step) : std::array<int, kTests>{};
  for (int k = 0; k < (own ? kOwnTests : kTestsShown); ++k) {
    // For two polygons in one plane the face numbers decide, not test 6.
    const bool inPlane = testAt(k) == Test::Overlap &&
                         std::ranges::find(known, Test::SamePlane, &ShownTest::test) != known.end();
    const Test test = inPlane ? Test::SamePlane : testAt(k);
    const int pairs = settled[static_cast<int>(test)] +
                      (test == Test::Overlap ? settled[static_cast<int>(Test::SamePlane)] : 0);
    const auto shown = std::ranges::find(known, test, &ShownTest::test);
    const bool reached = own ? pair : pairs > 0 || shown != known.end();
    const Rect row = pen.at.testRow(k);
    const int y = row.y + pen.at.line - 4, right = row.x + row.width,
              numbers = row.x + (pen.at.compact ? 174 : 186);
    if (test == Test::QBehindP) pen.rule(row.x, row.y, row.width);
    if (own && sorting && pen.look(SortPart::Test, k).hovered) pen.paint.fillRect(row, pen(Cell::Focus));
    if (own && sorting && pen.view.own->naming)
      pen.key(row.x - 3, y - 11, shortNameOf(test));
    else
      pen.paint.text(row.x, y, shortNameOf(test), pen(own || reached ? Cell::Soft : Cell::Faint));
    pen.paint.text(row.x + (pen.at.compact ? 20 : 24), y, questionOf(test),
                   pen(reached ? Cell::Ink : Cell::Faint));
    if (pairs > 0) {
      pen.ink(numbers, y, "settled it against " + counted(pairs, "polygon"));
    } else if (shown != known.end()) {
      const Event compare{.kind = Event::Kind::Compare, .P = pen.P(), .Q = pen.Q()};
      pen.ink(numbers, y,
              numbersThatFit(pen.run.explainer(), own ? compare : *pen.compare, test,
                             right - textWidth(shown->answer.words) - 24 - numbers, pen.run.scale()));
      drawAnswer(pen, right, y, shown->answer);
    } else if (pen.view.asking || (own && pair && sorting)) {
      pen.softRight(right, y, own ? "does it tell?" : "?");
    }
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
  const auto offer = [&](SortPart part, std::size_t k, const Rect& r, char key, std::string_view words,
                         Cell cell) {
    if (pen.look(part, static_cast<int>(k)).hovered)
      pen.paint.fillRect({r.x - 3, r.y - 1, r.width + 6, r.height + 1}, pen(Cell::Focus));
    const int width = pen.key(r.x, r.y + 1, std::string_view{&key, 1});
    pen.paint.text(r.x + width + 6, r.y + 1 + kKeyCapBaseline, words, pen(cell));
  };
  if (pen.sorting()) {
    for (std::size_t k = 0; k < kActs.size(); ++k)
      offer(SortPart::Act, k, pen.at.acts[k], kActKeys[k], kActs[k],
            pen.P() >= 0 && (k == 0 || pen.Q() >= 0) ? Cell::Ink : Cell::Faint);
    y = pen.at.acts.back().y + pen.at.acts.back().height + pen.at.line - 2;
  } else {
    for (std::size_t k = 0; pen.view.asking && k < kAnswers.size(); ++k)
      offer(SortPart::Answer, k, pen.at.answers[k], kAnswerKeys[k], kAnswers[k], Cell::Ink);
    y += (1 + pen.view.asking) * pen.at.line;
  }
  std::vector<std::string> lines = broken(finding.why, room / kGlyphWidth);
  const int rows = std::max(1, (at.y + at.height - y) / pen.at.line + 1);
  if (std::ssize(lines) > rows) {
    const std::string next = lines[rows];
    lines.resize(rows);
    lines.back() = fitting(lines.back() + " " + next, room);  // ends with ..
  }
  for (const std::string& line : lines) pen.ink(x, y, line), y += pen.at.line;
}

}  // namespace xnewell
