#pragma once

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "geometry/exact/scale.h"

namespace xnewell {

/// The smallest axis-aligned box that holds a set of points. A new box is empty, and the centre of an empty
/// box is not a number (NaN).
struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  [[nodiscard]] glm::dvec3 centre() const { return low / 2.0 + high / 2.0; }
  /// The length of the longest side. It may overflow to infinity.
  [[nodiscard]] double side() const { return largest(high - low); }
  /// The largest absolute value of a coordinate.
  [[nodiscard]] double magnitude() const { return std::max(largest(glm::abs(low)), largest(glm::abs(high))); }
};

/// The box of `points`. For no points it is the origin alone, so that all its coordinates are finite.
[[nodiscard]] inline Box boxOf(const std::vector<glm::dvec3>& points) {
  if (points.empty()) return {glm::dvec3{0.0}, glm::dvec3{0.0}};
  Box box;
  for (const glm::dvec3& p : points) box.add(p);
  return box;
}

}  // namespace xnewell
