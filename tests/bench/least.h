#pragma once

#include <algorithm>
#include <vector>

namespace xnewell {

/// The least of the repetitions: the time that the machine takes while nothing else runs on it. Use it as
/// `ComputeStatistics("least", least)`.
[[nodiscard]] inline double least(const std::vector<double>& repetitions) {
  return *std::ranges::min_element(repetitions);
}

}  // namespace xnewell
