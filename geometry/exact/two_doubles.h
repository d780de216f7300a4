#pragma once

#include <cmath>
#include <compare>
#include <limits>

#include "geometry/exact/int128.h"

namespace xnewell {

/// A number as the sum of two doubles: |low| <= 2^-52 |high|. The sum of x and y is off by at most
/// 2^-100 (|x| + |y|), product, quotient and root by at most 2^-100 of themselves. In another rounding mode
/// than to nearest, Dekker's halves may have a bit more, and their products round: then kTwoDoubles takes the
/// place of 2^-100. Numbers and results are 0 or between 2^-400 and 2^900; an infinity can only be compared.
/// Compiled without contraction, they have the same bits on all processors.
/// @see Dekker 1971; Knuth, TAOCP 2 §4.2.2
struct TwoDoubles {
  double high, low;

  /// As of double: its value is not set.
  TwoDoubles() = default;
  TwoDoubles(double v, double more = 0.0) : high{v}, low{more} {}  // NOLINT(google-explicit-constructor)
  explicit operator double() const { return high; }
  friend std::partial_ordering operator<=>(const TwoDoubles&, const TwoDoubles&) = default;
};
inline constexpr double kTwoDoubles = 0x1p-76;

/// high + low, where |low| is small beside |high|.
[[nodiscard]] inline TwoDoubles renormed(double high, double low) {
  const double sum = high + low;
  return {sum, low - (sum - high)};
}

[[nodiscard]] inline TwoDoubles operator+(const TwoDoubles& x, const TwoDoubles& y) {
  const double sum = x.high + y.high, ofY = sum - x.high;
  const double rest = (x.high - (sum - ofY)) + (y.high - ofY);
  return renormed(sum, rest + (x.low + y.low));
}

[[nodiscard]] inline TwoDoubles operator-(const TwoDoubles& x) { return {-x.high, -x.low}; }
[[nodiscard]] inline TwoDoubles operator-(const TwoDoubles& x, const TwoDoubles& y) { return x + -y; }
[[nodiscard]] inline TwoDoubles abs(const TwoDoubles& x) { return x.high < 0.0 ? -x : x; }

[[nodiscard]] inline TwoDoubles operator*(const TwoDoubles& x, const TwoDoubles& y) {
  constexpr double kHalves = 0x1p27 + 1.0;  // a double is the sum of two numbers of 26 bits
  const double xScaled = kHalves * x.high, yScaled = kHalves * y.high;
  const double x1 = xScaled - (xScaled - x.high), x2 = x.high - x1;
  const double y1 = yScaled - (yScaled - y.high), y2 = y.high - y1;
  const double product = x.high * y.high;
  const double rest = ((x1 * y1 - product) + x1 * y2 + x2 * y1) + x2 * y2;
  return renormed(product, rest + (x.high * y.low + x.low * y.high));
}

/// A quotient of doubles, and the rest's quotient.
[[nodiscard]] inline TwoDoubles operator/(const TwoDoubles& x, const TwoDoubles& y) {
  const double first = x.high / y.high;
  return renormed(first, (x - first * y).high / y.high);
}

/// One step of Newton's method from the root of a double.
[[nodiscard]] inline TwoDoubles sqrt(const TwoDoubles& x) {
  if (x.high == 0.0) return x;
  const double first = std::sqrt(x.high);
  return renormed(first, (x - TwoDoubles{first} * first).high / (2.0 * first));
}

inline TwoDoubles& operator+=(TwoDoubles& x, const TwoDoubles& y) { return x = x + y; }
inline TwoDoubles& operator-=(TwoDoubles& x, const TwoDoubles& y) { return x = x - y; }
inline TwoDoubles& operator*=(TwoDoubles& x, const TwoDoubles& y) { return x = x * y; }
inline TwoDoubles& operator/=(TwoDoubles& x, const TwoDoubles& y) { return x = x / y; }

/// An integer n, off by at most kTwoDoubles |n|.
[[nodiscard]] inline TwoDoubles twoDoubles(const Int128& n) {
  const Int128 magnitude = n < 0 ? Int128{-n} : n;
  // Four parts of 32 bits. None is negative, so no sum cancels.
  const auto part = [&](int shift) {
    return static_cast<double>(static_cast<std::uint32_t>((magnitude >> shift) & 0xFFFFFFFFu));
  };
  const TwoDoubles sum =
      renormed(part(96) * 0x1p96, part(64) * 0x1p64) + renormed(part(32) * 0x1p32, part(0));
  return n < 0 ? -sum : sum;
}

}  // namespace xnewell

/// With it, GLM's vectors take these numbers.
template <>
struct std::numeric_limits<xnewell::TwoDoubles> : std::numeric_limits<double> {
  static xnewell::TwoDoubles infinity() { return std::numeric_limits<double>::infinity(); }
};
