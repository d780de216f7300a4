#pragma once

#include <string>

#include "shading/extremes/extremes.h"

namespace xnewell {

/// What was found on a way, in words. What is said "up to" or "from ... on" holds at every value that was
/// tried there.

/// "Stopped: 5 of 13 ways were finished."; "" if all were.
[[nodiscard]] std::string stoppedText(const Extremes& extremes);

/// What is wrong with the picture of the scene as it is: "The set-up itself is wrong: a face that is not the
/// nearest at 96 of 720 samples.", or doubtful, or that it shows no face; "" if it is right.
[[nodiscard]] std::string findingOf(const ExtremeStep& setUp);

/// What was found on a way: "right up to 1e+09 times its size", or each fault with the values that have it:
/// "wrong from 1e+12 times its size on: another face or shade than at first at 1 of 477 samples". What is
/// wrong in the same way where the way begins as in the set-up is told without numbers. What is only
/// doubtful is called so.
[[nodiscard]] std::string findingOf(const Extreme& way, const ExtremeStep& setUp);

/// The first step with a fault that the way did not begin with because of the set-up; nullptr if there is
/// none.
[[nodiscard]] const ExtremeStep* firstWrong(const Extreme& way, const ExtremeStep& setUp);

/// The same, or if no step is wrong, the first that is doubtful or shows no face. Its `why` explains what was
/// found.
[[nodiscard]] const ExtremeStep* firstToExplain(const Extreme& way, const ExtremeStep& setUp);

}  // namespace xnewell
