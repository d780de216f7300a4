#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>

namespace xnewell {

/// x^n by repeated squaring; x^0 = 1. It takes at most 2 log2(n) multiplications. Each is correctly rounded,
/// so the result is the same on every machine (the C library's pow is not). The relative error is at most
/// n 2^-53, for n up to 2^26. A result below 2^-1022 is off by up to 2^-1068 more: then up to 40 products
/// lose their last bits.
[[nodiscard]] constexpr double power(double x, int n) {
  double result = 1.0;
  for (; n > 0; n >>= 1) {
    if (n & 1) result *= x;
    x *= x;
  }
  return result;
}

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

/// v / |v|, without overflow or underflow on the way. For the zero vector, and if a coordinate is not finite,
/// the result is 0. Each coordinate is off by at most 2^-51 of itself (three roundings under the root count
/// half, then come the root and the quotient) or 2^-1073.
[[nodiscard]] glm::dvec3 unit(glm::dvec3 v);

}  // namespace xnewell
