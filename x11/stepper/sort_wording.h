#pragma once

#include <string>
#include <vector>

#include "x11/kit/pseudocode.h"
#include "x11/stepper/sort_page.h"
#include "x11/stepper/sort_run.h"
#include "x11/stepper/sort_state.h"

namespace xnewell {

/// Newell's sort line by line, with the line that a step of the run is. While a question is open, the tests
/// and what follows them are not told. @see Newell, Newell and Sancha 1972; Foley & van Dam 2e §15.5.1
[[nodiscard]] std::vector<CodeLine> sortCode(SortRun& run, const SortState& view);

/// The words and numbers of the stepper's page.

[[nodiscard]] std::string capitalized(std::string words);

/// True if the learner may be asked about the step: it compares two polygons whose extents overlap in x and
/// y.
[[nodiscard]] bool isQuestion(const Event& event);

/// `test: P 85 body, Q 482 spout`; shorter if there is no Q.
[[nodiscard]] std::string stepText(const SortRun& run);

/// The tests in the order of the table, from 0.
[[nodiscard]] constexpr Test testAt(int row) { return static_cast<Test>(row + 1); }
/// `1`, `3'`, or `=` for two polygons in one plane.
[[nodiscard]] std::string_view shortNameOf(Test test);
/// `P behind Q's plane?`
[[nodiscard]] std::string_view questionOf(Test test);

/// A distance with its sign, `+3.1` or `+31`, and enough decimals to show that it is not 0. A distance of
/// exactly 0 has no sign.
[[nodiscard]] std::string distanceText(const CornerDistance& corner, double scale = 1);

/// The numbers that decide a test of a Compare event, in several wordings, the longest first. Here and above
/// `scale` is that of SortRun.
[[nodiscard]] std::vector<std::string> numbersOf(const Explainer& explainer, const Event& compare, Test test,
                                                 double scale = 1);

/// The first of these that is at most `width` pixels wide, or else as much of the last as fits.
[[nodiscard]] std::string numbersThatFit(const Explainer& explainer, const Event& compare, Test test,
                                         int width, double scale = 1);
/// As much of a text as fits.
[[nodiscard]] std::string fitting(std::string_view text, int width);

struct TestAnswer {
  enum class Mark { Tick, Cross, None } mark;
  std::string words;  ///< `no`, `yes, P first`
};
[[nodiscard]] TestAnswer answerOf(const Event& compare, Test test);
struct ShownTest {
  Test test;
  TestAnswer answer;
};
/// The tests that led to the present step, the last one last: those of a Compare event, or those that another
/// program has made of the pair, with our verdict on each.
[[nodiscard]] std::vector<ShownTest> testsShown(const SortRun& run, const Event& compare);
/// `false` in place of `failed` in the run of another program.
[[nodiscard]] std::string_view nameOf(const SortRun& run, Landmark kind);

/// The result of a step.
struct StepFinding {
  std::string bold, why;
  std::string aside = {};  ///< what the learner has predicted
  bool alarm = false;      ///< a cut, or a step that leads to one
};
[[nodiscard]] StepFinding findingOf(const SortRun& run, const SortState& view);
/// The step, the tests that were made with their numbers, and the result: a line each. Nothing is told that
/// the learner is asked to predict.
[[nodiscard]] std::vector<std::string> stepAsLines(const SortRun& run, const SortState& view);

}  // namespace xnewell
