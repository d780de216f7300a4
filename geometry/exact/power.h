#pragma once

namespace xnewell {

/// x^n by squaring, x^0 = 1. At most 2 log2(n) multiplications, each correctly rounded, so the same on
/// every machine (the C library's pow is not) and within n 2^-53 of exact, relatively.
[[nodiscard]] constexpr double power(double x, int n) {
  double result = 1.0;
  for (; n > 0; n >>= 1) {
    if (n & 1) result *= x;
    x *= x;
  }
  return result;
}

}  // namespace xnewell
