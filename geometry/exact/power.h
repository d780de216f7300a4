#pragma once

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

}  // namespace xnewell
