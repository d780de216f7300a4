#pragma once

#include <cstdint>
#include <span>

#include "geometry/view/project.h"

namespace xnewell {

/// A proof that an order of painting is right: the tests of the depth sort for every pair of faces.

struct PairCheck {
  std::int64_t pairs = 0;       ///< pairs of faces whose boxes overlap on the screen
  std::int64_t outOfOrder = 0;  ///< of these, how many have a first one that may not be painted first
  bool complete = true;         ///< false if there were too many pairs, and some were not looked at
  /// True if every sample shows the right face of the snapped scene, except at contacts (depth_sort.h).
  [[nodiscard]] bool proves() const { return complete && outOfOrder == 0; }
};

/// Looks at no more than `most` pairs. `order` are indices into scene.faces, the first painted first; the
/// scene has planes (addPlanes()) and is for a picture of width x height pixels.
[[nodiscard]] PairCheck checkPairs(const SnappedScene& scene, std::span<const int> order, int width,
                                   int height, std::int64_t most = 2'000'000);

}  // namespace xnewell
