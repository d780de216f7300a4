#pragma once

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "geometry/exact/scale.h"

namespace xnewell {

/// The smallest box that holds points; before add() it holds none, and its centre is not a number.
struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  [[nodiscard]] glm::dvec3 centre() const { return low / 2.0 + high / 2.0; }
  /// The longest, which may overflow to infinity.
  [[nodiscard]] double side() const { return largest(high - low); }
  /// Of the largest coordinate.
  [[nodiscard]] double magnitude() const { return std::max(largest(glm::abs(low)), largest(glm::abs(high))); }
};

/// Of no points the origin, so that all of it is finite.
[[nodiscard]] inline Box boxOf(const std::vector<glm::dvec3>& points) {
  if (points.empty()) return {glm::dvec3{0.0}, glm::dvec3{0.0}};
  Box box;
  for (const glm::dvec3& p : points) box.add(p);
  return box;
}

}  // namespace xnewell
