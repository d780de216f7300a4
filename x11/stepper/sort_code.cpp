#include "x11/stepper/sort_code.h"

#include <algorithm>
#include <array>

#include "x11/drawing/wording.h"
#include "x11/stepper/sort_wording.h"

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

}  // namespace xnewell
