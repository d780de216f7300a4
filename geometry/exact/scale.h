#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

namespace xnewell {

/// Scaling by powers of two, which rounds nothing.

/// p 2^exponent, |exponent| <= 2000: exact where that is a normal number. (Two factors, for 2^exponent itself
/// may overflow; std::ldexp is a call for each coordinate.)
[[nodiscard]] inline glm::dvec3 scaled(const glm::dvec3& p, int exponent) {
  const int half = exponent / 2;
  return p * std::ldexp(1.0, half) * std::ldexp(1.0, exponent - half);
}

[[nodiscard]] inline double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

}  // namespace xnewell
