#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace xnewell {

/// The least of the repetitions: the time that the machine takes while nothing else runs on it. Use it as
/// `ComputeStatistics("least", least)`.
[[nodiscard]] inline double least(const std::vector<double>& repetitions) {
  return *std::ranges::min_element(repetitions);
}

/// Processor time in milliseconds, not wall time: machines are shared.
[[nodiscard]] inline double processorTime() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace xnewell
