#pragma once

#include <string>
#include <vector>

#include "x11/stepper/sort_page.h"

namespace xnewell {

/// The words and numbers of the stepper's page.

/// Whether a step may be asked about: two polygons whose extents overlap in x and y are compared.
[[nodiscard]] bool isQuestion(const Event& event);

/// `85 body`
[[nodiscard]] std::string numberAndPart(const SortRun& run, int id);
/// `test: P 85 body, Q 482 spout`, or of a step without Q.
[[nodiscard]] std::string stepInWords(const SortRun& run);

/// `1`, `3'`, or `=` for two in one plane.
[[nodiscard]] std::string_view shortNameOf(Test test);
/// `P behind Q's plane?`
[[nodiscard]] std::string_view questionOf(Test test);

/// A distance with its sign, `+3.1`, with as many decimals as show that it is not 0; what is exactly 0 has no
/// sign.
[[nodiscard]] std::string distanceText(const CornerDistance& corner);

/// The numbers that decide a test of a Compare event, the fullest wording first.
[[nodiscard]] std::vector<std::string> numbersOf(const Explainer& explainer, const Event& compare, Test test);

struct TestAnswer {
  enum class Mark { Tick, Cross } mark;
  std::string words;  ///< `no`, `yes, P first`
};
[[nodiscard]] TestAnswer answerOf(const Event& compare, Test test);

/// What a step amounts to.
struct StepFinding {
  std::string bold, why;
  std::string aside = {};  ///< whether the learner foresaw it
  bool alarm = false;      ///< a cut, or what leads to one
};
[[nodiscard]] StepFinding findingOf(const SortRun& run, const SortView& view);

}  // namespace xnewell
