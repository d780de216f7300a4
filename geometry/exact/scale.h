#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

namespace xnewell {

/// Functions that scale by powers of two. Such scaling rounds nothing.

/// p 2^exponent, |exponent| <= 2000. Exact if the result is a normal number. It multiplies by two factors
/// because 2^exponent itself may overflow; std::ldexp would be a call for each coordinate.
[[nodiscard]] inline glm::dvec3 scaled(const glm::dvec3& p, int exponent) {
  const int half = exponent / 2;
  return p * std::ldexp(1.0, half) * std::ldexp(1.0, exponent - half);
}

/// The largest coordinate of v.
[[nodiscard]] inline double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

}  // namespace xnewell
