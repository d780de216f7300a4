#pragma once

namespace xnewell {

struct SinCos {
  double sin, cos;
};

/// Sine and cosine of an angle in degrees, |degrees| < 2^52, by + - * and sqrt alone, so the same on every
/// machine (the C library's last bit differs). Within 2^-51 of exact; exact where the value is 0, 1/2 or 1,
/// and equal for both at 45 degrees. Odd and even to the bit.
[[nodiscard]] SinCos sinCosDegrees(double degrees);

/// sin / cos, within 2^-48 relatively up to 80 degrees; exactly 1 at 45, infinite at 90.
[[nodiscard]] double tanDegrees(double degrees);

/// The angle in degrees, in (-180, 180], with this ratio of sine to cosine: an angle between vectors from
/// their cross and dot product. By + - * and / alone. Within 2^-45 of exact; exact for multiples of 45.
/// Numbers of any size from 2^-1000 to 2^1000; 0 if both are 0.
[[nodiscard]] double degreesOf(double sine, double cosine);

}  // namespace xnewell
