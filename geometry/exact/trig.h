#pragma once

namespace xnewell {

struct SinCos {
  double sin, cos;
};

/// The sine and cosine of an angle in degrees, |degrees| < 2^52. They use only + - * and sqrt, so they are
/// the same on every machine (the C library's last bit differs). The error is at most 2^-51. Values of 0, 1/2
/// and 1 are exact, and at 45 degrees both are equal. The sine is odd and the cosine even, to the last bit.
[[nodiscard]] SinCos sinCosDegrees(double degrees);

/// sin / cos; exactly 1 at 45, infinite at 90. The relative error is at most 2^-48 for 0 and for 2^-1000 to
/// 80 degrees. (A smaller angle loses bits when it becomes radians.)
[[nodiscard]] double tanDegrees(double degrees);

/// The angle in degrees, in (-180, 180], whose sine and cosine have this ratio and these signs; rounding may
/// give -180. Use it to find the angle between two vectors from their cross and dot products. It uses only
/// + - * and /. The error is at most 2^-45; multiples of 45 are exact. The arguments need not be normalised:
/// 2^-1000 to 2^1000 in size. The result is 0 if both are 0.
[[nodiscard]] double degreesOf(double sine, double cosine);

}  // namespace xnewell
