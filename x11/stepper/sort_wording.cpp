#include "x11/stepper/sort_wording.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "shading/color/font.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

/// The lines, in the order of the book.
enum SortLine {
  Sort,
  While,
  TakeP,
  MarkP,
  EachQ,
  TestOne,
  TestTwo,
  TestThree,
  TestFour,
  TestFive,
  OnePlane,
  TestThreeOther,
  TestFourOther,
  Nearer,
  MoveQ,
  IsMarked,
  SplitP,
  NoSplit,
  PaintP,
  kLines
};
constexpr std::array<std::string_view, kLines> kText{"sort the polygons by their farthest z",
                                                     "while a polygon is left",
                                                     "  P = the first of the list",
                                                     "  mark P",
                                                     "  for each Q whose z-extent reaches P's",
                                                     "    1  x-extents apart: next Q",
                                                     "    2  y-extents apart: next Q",
                                                     "    3  P behind the plane of Q: next Q",
                                                     "    4  Q before the plane of P: next Q",
                                                     "    5  no common area: next Q",
                                                     "    one plane: the later face is in front",
                                                     "    3' Q behind the plane of P: Q first",
                                                     "    4' P before the plane of Q: Q first",
                                                     "    6  where they overlap, which is nearer?",
                                                     "    Q first: move and mark it, P = Q",
                                                     "    Q is marked already: a cycle",
                                                     "      split P by the plane of Q",
                                                     "      no split helps: another pair",
                                                     "  paint P"};

/// The line of each test, and of each kind of event but a comparison.
constexpr std::array<SortLine, kTests> kTestLines{
    OnePlane, TestOne, TestTwo, TestThree, TestFour, TestFive, TestThreeOther, TestFourOther, Nearer};
constexpr std::array kEventLines{TakeP, Sort, MoveQ, IsMarked, NoSplit, NoSplit, NoSplit, SplitP, PaintP};

SortLine lineOf(Test test) { return kTestLines[static_cast<std::size_t>(test)]; }

}  // namespace

std::vector<CodeLine> sortCode(SortRun& run, const SortState& view) {
  std::vector<CodeLine> lines;
  for (const std::string_view text : kText) lines.push_back({std::string{text}});
  for (const SortLine own : {MarkP, OnePlane, Nearer, NoSplit}) lines[own].ours = true;
  const auto ran = [&](SortLine line, CodeLine::Ran how) { lines[static_cast<std::size_t>(line)].ran = how; };
  const auto values = [&](SortLine line, std::string text) {
    lines[static_cast<std::size_t>(line)].values = std::move(text);
  };
  values(While, grouped(static_cast<std::int64_t>(run.replay().list(1'000'000).size())) + " left");
  if (view.step == 0) {
    ran(Sort, CodeLine::Ran::Now);
    return lines;
  }
  const Event& e = run.sorted().events[static_cast<std::size_t>(view.step - 1)];
  // P is the first of the list, or the Q of a move: then others are marked below it.
  const int P = e.kind == Event::Kind::Move ? e.Q : run.asTested()->P;
  const std::vector<int> marked = run.replay().marked();
  const bool taken = std::ranges::all_of(marked, [&](int id) { return id == P; });
  values(taken ? TakeP : MoveQ, "P = " + run.explainer().name(P));
  if (e.Q >= 0) values(EachQ, "Q = " + run.explainer().name(e.Q));
  if (e.kind == Event::Kind::Compare) {
    ran(EachQ, CodeLine::Ran::Before);
    if (view.asking) {
      ran(EachQ, CodeLine::Ran::Now);
      return lines;
    }
    // The tests before it failed. SamePlane is decided by itself.
    const SortLine now = lineOf(e.test);
    if (run.theirs()) {
      for (const auto& [test, answer] : testsShown(run, e)) {
        ran(lineOf(test), CodeLine::Ran::Before);
        values(lineOf(test), answer.words);
      }
    } else {
      if (e.test != Test::SamePlane)
        for (int k = TestOne; k < now; ++k)
          if (k != OnePlane)
            ran(static_cast<SortLine>(k), CodeLine::Ran::Before), values(static_cast<SortLine>(k), "no");
      values(now, std::string{kAnswers[static_cast<std::size_t>(e.verdict)]});
    }
  }
  if (e.kind == Event::Kind::Take) ran(MarkP, CodeLine::Ran::Before);
  ran(e.kind == Event::Kind::Compare ? lineOf(e.test) : kEventLines[static_cast<std::size_t>(e.kind)],
      CodeLine::Ran::Now);
  return lines;
}

namespace {

Range scaled(const Range& r, double scale) { return {r.low * scale, r.high * scale}; }

/// A number without decimals from 10 on, else with one, or with enough to show that it is not 0.
std::string shown(double v) {
  int decimals = std::abs(v) < 10.0;
  while (decimals < 6 && v != 0.0 && std::abs(v) * std::pow(10.0, decimals) < 0.5) ++decimals;
  return fixed(v, decimals);
}

std::vector<std::string> extentNumbers(Range P, Range Q) {
  const auto share = [&] { return std::min(P.high, Q.high) - std::max(P.low, Q.low); };
  const bool whole =
      std::abs(share()) >= 10.5;  // then their ends are, too, and their difference is the share
  for (double* const end : {&P.low, &P.high, &Q.low, &Q.high})
    if (whole) *end = std::round(*end);
  const double shared = share();
  const auto text = [&](const Range& r) { return fixed(r.low, !whole) + ".." + fixed(r.high, !whole); };
  const std::string both = text(P) + " and " + text(Q);
  // Extents that only touch do not overlap: they share 0.0 px.
  const std::string words = shared > 0.0 ? "share " + shown(shared) + " px" : shown(-shared) + " px apart";
  return {both + (shared > 0.0 ? " " : ", ") + words, words};
}

/// How many corners lie on the side that the test asks for, and the distance of each.
std::vector<std::string> planeNumbers(const Explainer& explainer, int of, int other, bool behind,
                                      double scale) {
  const std::vector<CornerDistance> corners = explainer.distances(of, other);
  int kept = 0, on = 0;  // on the plane, as far as rounding tells
  std::string each;
  for (const CornerDistance& c : corners) {
    kept += !c.mayBeOn && (behind ? c.sign < 0 : c.sign > 0);
    on += c.mayBeOn;
    each += (each.empty() ? "" : " ") + distanceText(c, scale);
  }
  const std::string side = behind ? "behind" : "in front";
  std::string count = std::to_string(kept) + " of " +
                      counted(static_cast<std::int64_t>(corners.size()), "corner") + " " + side;
  std::string brief = std::to_string(kept) + " of " + std::to_string(corners.size()) + " " + side;
  if (on > 0) {
    count += ", " + std::to_string(on) + " on it";
    brief += ", " + std::to_string(on) + " on it";
  }
  return {count + ": " + each, brief + ": " + each, count, brief};
}

constexpr std::array<std::string_view, 3> kVerdicts{
    "P may be painted before Q.", "Q must be painted before P.", "P and Q pass through each other."};

/// By Event::Kind; some depend on more.
constexpr std::array<std::string_view, 9> kFindings{"",
                                                    "",
                                                    "Q goes first.",
                                                    "The order is a cycle.",
                                                    "The plane of Q does not cut P.",
                                                    "A cut here leaves the cycle.",
                                                    "P and Q only touch.",
                                                    "P is cut in two.",
                                                    "P is painted."};
constexpr std::array kAlarming{Event::Kind::Cycle, Event::Kind::Impossible, Event::Kind::Vain,
                               Event::Kind::Split};

/// What is wrong with a step of another program, by Falsehood.
constexpr std::array<std::string_view, kFalsehoods.size()> kWrong{"The answer is wrong.",
                                                                  "A test is left out.",
                                                                  "Q may not go first.",
                                                                  "P is painted too early.",
                                                                  "The same again: this does not end.",
                                                                  "This plane does not cut it.",
                                                                  "The pieces are exchanged.",
                                                                  "The pieces are not those of this plane.",
                                                                  "The pieces do not cover it once.",
                                                                  "P has another outline in the scene.",
                                                                  "This number is another polygon's.",
                                                                  "The shading is not copied.",
                                                                  "P is not there any more.",
                                                                  "There is no such polygon.",
                                                                  "P and Q are the same polygon.",
                                                                  "A polygon is lost."};

std::string_view answerText(Verdict verdict) { return kAnswers[static_cast<std::size_t>(verdict)]; }

/// True if another program has made this test, and it does not tell.
bool saysNo(const SortRun& run, const Event& e) {
  return run.theirs() && e.kind == Event::Kind::Compare && e.verdict == Verdict::Crossing;
}

/// The sentence of the step, without its first word, which is in the bold line or the status already.
std::string sentenceOf(const SortRun& run) {
  const Event& e = *run.replay().event();
  const int splits = run.replay().splits() - (e.kind == Event::Kind::Split);
  if (saysNo(run, e)) {
    if (e.test == Test::Overlap) return "Where they overlap, P is nearer somewhere.";
    return run.explainer().sentence({.kind = e.kind, .test = Test::Overlap, .P = e.P, .Q = e.Q}, e.test);
  }
  if (run.theirs() && e.kind == Event::Kind::Take)
    return run.isAdded() ? "No line takes it; line " + std::to_string(run.line()) + " is about it."
                         : "It becomes P and gets a mark.";
  if (run.theirs() && e.kind == Event::Kind::Split) {
    const int behind = run.fragments().pieceOf(splits);
    return "P is split by the plane of Q into " + run.name(behind) + ", behind it, and " +
           run.name(behind + 1) + ", in front.";
  }
  std::string sentence = run.explainer().sentence(e, splits, run.asTested()->P != e.P);
  if (e.kind != Event::Kind::Compare)
    if (const std::size_t colon = sentence.find(": "); colon != std::string::npos) {
      return capitalized(sentence.substr(colon + 2));
    }
  return sentence;
}

}  // namespace

std::string capitalized(std::string words) {
  words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

bool isQuestion(const Event& event) {
  return event.kind == Event::Kind::Compare && event.test != Test::XExtents && event.test != Test::YExtents;
}

std::string stepText(const SortRun& run) {
  const std::optional<Event> e = run.asTested();
  if (!e) return "start: nothing is painted";
  const std::string line = run.theirs() ? "line " + std::to_string(run.line()) + ", " : "";
  const std::string test =
      !run.theirs() || e->kind != Event::Kind::Compare
          ? ""
          : ' ' + std::string{shortNameOf(e->test)} + (saysNo(run, *e) ? " says no" : " says yes");
  std::string words =
      line + std::string{run.isAdded() ? "not taken" : wordFor(e->kind)} + test + ": P " + run.name(e->P);
  if (e->Q >= 0) words += ", Q " + run.name(e->Q);
  return words;
}

std::string_view shortNameOf(Test test) {
  return test == Test::SamePlane ? "=" : kTestRows[static_cast<std::size_t>(test)].name;
}

std::string_view questionOf(Test test) {
  constexpr std::array<std::string_view, kTests> kQuestions{
      "in one plane?",       "x-extents apart?",         "y-extents apart?",
      "P behind Q's plane?", "Q in front of P's plane?", "projections apart?",
      "Q behind P's plane?", "P in front of Q's plane?", "nearer in the overlap?"};
  return kQuestions[static_cast<std::size_t>(test)];
}

std::string_view nameOf(const SortRun& run, Landmark kind) {
  return run.theirs() && kind == Landmark::Failed ? "false" : kLandmarks[static_cast<int>(kind)].name;
}

std::string distanceText(const CornerDistance& corner, double scale) {
  if (corner.sign == 0) return "0.0";
  return (corner.sign > 0 ? "+" : "-") + shown(std::abs(corner.inFront) * scale);
}

std::vector<std::string> numbersOf(const Explainer& explainer, const Event& e, Test test, double scale) {
  if (const std::optional<PlaneTest> plane = planeTestOf(test))
    return planeNumbers(explainer, plane->ofP ? e.P : e.Q, plane->ofP ? e.Q : e.P, plane->side < 0, scale);
  switch (test) {
    case Test::XExtents:
      return extentNumbers(scaled(explainer.xExtent(e.P), scale), scaled(explainer.xExtent(e.Q), scale));
    case Test::YExtents:
      return extentNumbers(scaled(explainer.yExtent(e.P), scale), scaled(explainer.yExtent(e.Q), scale));
    case Test::Projections: {
      if (const std::optional<SeparatingEdge> edge = explainer.separatingEdge(e.P, e.Q))
        return {std::string{"an edge of "} + (edge->ofP ? "P has all of Q" : "Q has all of P") +
                    " on its other side",
                std::string{"an edge of "} + (edge->ofP ? "P" : "Q") + " separates them",
                "an edge separates them"};
      const double shared = explainer.commonArea(e.P, e.Q).area * scale * scale;
      const std::string area = shared < 1000.0 ? shown(shared) : grouped(std::llround(shared));
      return {"they share " + area + " square px", area + " square px"};
    }
    case Test::SamePlane: {
      const int p = explainer.fragments().face(e.P).number, q = explainer.fragments().face(e.Q).number;
      return {"P is face " + std::to_string(p) + ", Q is " + std::to_string(q) + ": the later is nearer",
              std::to_string(p) + ", " + std::to_string(q) + ": the later is nearer", "by number"};
    }
    case Test::Overlap: {
      const Range ahead = scaled(explainer.commonArea(e.P, e.Q).aheadOfQ, scale);
      const std::string range = shown(ahead.low) + " to " + shown(ahead.high) + " px";
      return {ahead.high <= 0.0
                  ? "P is behind Q by " + shown(-ahead.high) + " to " + shown(-ahead.low) + " px"
                  : "P is in front of Q by " + range,
              "zP - zQ: " + range, range};
    }
    default:
      return {""};
  }
}

std::string numbersThatFit(const Explainer& explainer, const Event& e, Test test, int width, double scale) {
  const std::vector<std::string> texts = numbersOf(explainer, e, test, scale);
  for (const std::string& text : texts)
    if (textWidth(text) <= width) return text;
  return fitting(texts.back(), width);
}

std::string fitting(std::string_view text, int width) {
  const int letters = std::max(0, width / kGlyphWidth);
  if (static_cast<int>(codesOf(text).size()) <= letters) return std::string{text};
  const std::vector<std::string> lines = broken(text, std::max(1, letters - 2));
  return lines.empty() ? "" : lines.front() + "..";
}

TestAnswer answerOf(const Event& e, Test test) {
  using Mark = TestAnswer::Mark;
  if (test != e.test) return {Mark::Cross, "no"};
  if (e.verdict == Verdict::Crossing) return {Mark::Cross, "both are"};
  return {Mark::Tick, "yes, " + std::string{answerText(e.verdict)}};
}

std::vector<ShownTest> testsShown(const SortRun& run, const Event& compare) {
  using Mark = TestAnswer::Mark;
  std::vector<ShownTest> tests;
  const std::vector<Event>& events = run.sorted().events;
  int step = run.replay().step();
  if (!run.theirs() || comparisonAt(run.sorted(), step) == nullptr) {
    for (const Test test : run.explainer().testsMade(compare))
      tests.push_back({test, answerOf(compare, test)});
    if (run.theirs())
      for (ShownTest& one : tests) one.answer = {Mark::None, "not made; it is " + one.answer.words};
    return tests;
  }
  for (const FalseStep* wrong : run.wrong())
    if (wrong->kind == Falsehood::LeftOut)
      tests.push_back({*wrong->test, {Mark::None, "left out; it is yes"}});
  while (events[step - 1].kind != Event::Kind::Compare) --step;
  const int P = events[step - 1].P, Q = events[step - 1].Q;
  for (; step > 0; --step) {
    const Event& e = events[step - 1];
    if (e.kind != Event::Kind::Compare || e.P != P || e.Q != Q) break;
    const std::vector<const FalseStep*> all = run.wrongAt(step);
    const bool wrong = std::ranges::find(all, Falsehood::Answer, &FalseStep::kind) != all.end();
    const std::string yes = "yes", no = "no", &said = e.verdict == Verdict::Crossing ? no : yes;
    tests.push_back(
        {e.test,
         {wrong ? Mark::Cross : Mark::Tick, wrong ? said + "; it is " + (said == no ? yes : no) : said}});
  }
  std::ranges::reverse(tests);
  return tests;
}

StepFinding findingOf(const SortRun& run, const SortState& view) {
  const Event* const e = run.replay().event();
  if (const auto& own = view.own)
    return {own->bold, own->why,
            own->score.asked > 0 ? std::to_string(own->score.right) + " of " +
                                       std::to_string(own->score.asked) + " steps valid"
                                 : "",
            own->alarm};
  const auto polygons = static_cast<std::int64_t>(run.sorted().list.size());
  if (e == nullptr && run.theirs()) {
    const auto wrong = std::ssize(run.landmarks().steps(Landmark::Failed));
    const int untested = run.theirs()->report.untested;
    return {wrong == 0 ? untested == 0 ? "No step of this run is false."
                                       : "No step is false, but " + counted(untested, "pair") +
                                             (untested == 1 ? " was" : " were") + " never tested."
                       : counted(wrong, "step") + " of this run " + (wrong == 1 ? "is" : "are") + " false.",
            wrong == 0
                ? "Each step is shown beside what is right."
                : "The timeline has a red mark for each: j goes to the next one. Each step is shown beside "
                  "what is right.",
            "", wrong > 0};
  }
  if (e == nullptr) {
    if (polygons == 0) return {"There is nothing to sort.", "No polygon of the scene is visible."};
    return {"Nothing is painted yet.",
            "The list holds " + counted(polygons, "polygon") +
                ", the farthest first. Each step is one decision: press the right arrow for the next."};
  }
  if (view.asking)
    return {"What follows?",
            "P and Q overlap in x, y and z. Look, then answer; the right arrow shows the answer."};

  StepFinding finding{.bold = "", .why = sentenceOf(run)};
  const std::vector<const FalseStep*> wrong = run.wrong();
  finding.bold = kFindings[static_cast<std::size_t>(e->kind)];
  if (e->kind == Event::Kind::Take) finding.bold = "P is " + run.name(e->P) + ".";
  if (e->kind == Event::Kind::Compare) finding.bold = kVerdicts[static_cast<std::size_t>(e->verdict)];
  if (e->kind == Event::Kind::Split) {
    if (run.asTested()->P != e->P) finding.bold = "Q is cut in two.";
    if (const Event* const compare = comparisonAt(run.sorted(), view.step);
        compare && compare->verdict == Verdict::Crossing && !run.theirs())
      finding.why = "P and Q pass through each other" +
                    std::string{compare->P == e->P ? ": " : "; Q is smaller, so it is cut: "} + finding.why;
    else if (!compare || compare->P != e->P)
      finding.why += " The steps before show why.";
  }
  if (e->kind == Event::Kind::Paint && run.replay().step() == run.steps() && run.waiting().empty())
    finding.bold += " It was the last polygon.";
  finding.alarm = e->kind == Event::Kind::Compare ? e->verdict == Verdict::Crossing
                                                  : std::ranges::find(kAlarming, e->kind) != kAlarming.end();
  if (saysNo(run, *e)) finding.bold = "Test " + std::string{shortNameOf(e->test)} + " does not tell.";
  if (run.theirs()) finding.alarm = !wrong.empty();
  if (!wrong.empty()) {
    finding.bold = kWrong[static_cast<std::size_t>(wrong[0]->kind)];
    finding.why.clear();
    for (const FalseStep* one : wrong)
      finding.why += (finding.why.empty() ? "" : " ") +
                     std::string{one->follows ? "It may follow from a step before: " : ""} +
                     capitalized(one->says) + '.';
  }
  if (view.answer)
    finding.aside = "you said: " + std::string{answerText(*view.answer)} +
                    (*view.answer == run.verdict() ? ", and that is right" : "");
  return finding;
}

std::vector<std::string> stepAsLines(const SortRun& run, const SortState& view) {
  std::vector<std::string> lines{stepText(run)};
  if (view.asking) return lines;
  const std::optional<Event> e = run.asTested();
  if (e && e->kind == Event::Kind::Compare && !view.own)
    for (const auto& [test, answer] : testsShown(run, *e))
      lines.push_back(std::string{shortNameOf(test)} + "   " + std::string{questionOf(test)} + "   " +
                      numbersOf(run.explainer(), *e, test, run.scale()).front() + "   " + answer.words);
  const StepFinding finding = findingOf(run, view);
  if (view.own && view.own->P >= 0) {
    lines.back() = "you sort: P " + run.name(view.own->P);
    if (view.own->Q >= 0) lines.back() += ", Q " + run.name(view.own->Q);
    if (!finding.aside.empty()) lines.push_back(finding.aside);
  }
  std::string cycle;
  for (const RingLink& link : run.ring())
    cycle += (cycle.empty() ? "painted before the next: " : ", ") + run.shortName(link.id) +
             (link.by == RingLink::By::Test ? " (step " + std::to_string(link.step) + ")" : "");
  if (!cycle.empty()) lines.push_back(cycle);
  lines.push_back(finding.bold);
  if (!finding.why.empty()) lines.push_back(finding.why);
  return lines;
}

}  // namespace xnewell
