#pragma once

#include <algorithm>
#include <vector>

#include "depthsort/fragment_spans.h"
#include "depthsort/oracle.h"

namespace xnewell {

/// The index of the face painted last at each sample, row by row, with the fragments in their order; kNothing
/// where there is none.
[[nodiscard]] inline std::vector<int> painted(const SnappedScene& scene, const SortedScene& sorted, int width,
                                              int height) {
  std::vector<int> faces(std::size_t(width) * height, kNothing);
  for (const Fragment& fragment : sorted.fragments)
    forEachSpan(scene, sorted, fragment, width, height, [&](int row, int from, int to) {
      const auto begin = faces.begin() + std::ptrdiff_t{row} * width;
      std::fill(begin + from, begin + to, fragment.face);
    });
  return faces;
}

}  // namespace xnewell
