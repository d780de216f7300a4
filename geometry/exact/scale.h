#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>

namespace xnewell {

/// Functions that scale by powers of two. Such scaling rounds nothing.

/// p 2^exponent, |exponent| <= 2000. Exact if the result is a normal number. It multiplies by two factors
/// because 2^exponent itself may overflow; std::ldexp would be a call.
[[nodiscard]] inline glm::dvec3 scaled(const glm::dvec3& p, int exponent) {
  const auto power = [](int n) { return std::bit_cast<double>(std::uint64_t(1023 + n) << 52); };  // 2^n
  const int half = exponent / 2;
  return p * power(half) * power(exponent - half);
}

/// The largest coordinate of v.
[[nodiscard]] inline double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

}  // namespace xnewell
