#pragma once

#include <algorithm>
#include <vector>

namespace xnewell {

/// The least of the repetitions: what a machine takes while its neighbours leave it alone. For
/// `ComputeStatistics("least", least)`.
[[nodiscard]] inline double least(const std::vector<double>& repetitions) {
  return *std::ranges::min_element(repetitions);
}

}  // namespace xnewell
