#include "geometry/exact/trig.h"

#include <cmath>
#include <utility>

namespace xnewell {

SinCos sinCosDegrees(double degrees) {
  // Reduce the angle to within 45 degrees of a multiple of 90. All three steps are exact.
  const double magnitude = std::fmod(std::abs(degrees), 360.0);
  const int quarter = static_cast<int>(magnitude / 90.0 + 0.5);
  const double left = magnitude - 90.0 * quarter;

  // Taylor's series. The first terms left out are below 45 deg^19 / 19! < 2^-60.
  const double x = left * (3.14159265358979323846 / 180.0), x2 = x * x;
  double sine = 0.0, cosine = 0.0;
  for (int k = 17; k >= 3; k -= 2) sine = (1.0 + sine) * -x2 / (k * (k - 1));
  for (int k = 18; k >= 2; k -= 2) cosine = (1.0 + cosine) * -x2 / (k * (k - 1));
  sine = x + x * sine;
  cosine = 1.0 + cosine;
  if (std::abs(left) == 30.0) sine = std::copysign(0.5, left);
  if (std::abs(left) == 45.0) {
    cosine = std::sqrt(0.5);
    sine = std::copysign(cosine, left);
  }
  if (quarter % 2 == 1) sine = std::exchange(cosine, -sine);
  if (quarter == 2 || quarter == 3) {
    sine = -sine;
    cosine = -cosine;
  }
  return {degrees < 0.0 ? -sine : sine, cosine};
}

double tanDegrees(double degrees) {
  const auto [sine, cosine] = sinCosDegrees(degrees);
  return sine / cosine;
}

double degreesOf(double sine, double cosine) {
  double s = std::abs(sine), c = std::abs(cosine);
  const bool steep = s > c;  // then find the angle's complement to 90 degrees, in [0, 45]
  if (steep) std::swap(s, c);
  if (c == 0.0) return 0.0;

  // Subtract the nearest of 0, 22.5 and 45 degrees. t is the tangent of the difference.
  constexpr double kTangent11 = 0.19891236737965800691, kTangent22 = 0.41421356237309504880,
                   kTangent33 = 0.66817863791929891999;
  double degrees = 0.0, tangent = 0.0;
  if (s > kTangent33 * c)
    tangent = 1.0, degrees = 45.0;
  else if (s > kTangent11 * c)
    tangent = kTangent22, degrees = 22.5;
  const double t = (s - tangent * c) / (c + tangent * s);

  // Gregory's series. The first term left out is below tan(11.25 deg)^23 / 23 < 2^-57.
  const double t2 = t * t;
  double series = 0.0;
  for (int k = 21; k >= 3; k -= 2) series = (1.0 / k + series) * -t2;
  degrees += (t + t * series) * (180.0 / 3.14159265358979323846);
  if (steep) degrees = 90.0 - degrees;
  if (cosine < 0.0) degrees = 180.0 - degrees;
  return sine < 0.0 ? -degrees : degrees;
}

}  // namespace xnewell
