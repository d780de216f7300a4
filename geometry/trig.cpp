#include "geometry/trig.h"

#include <cmath>
#include <utility>

SinCos sinCosDegrees(double degrees) {
  // All three steps are exact: what is left is within 45 degrees of a multiple of 90.
  const double magnitude = std::fmod(std::abs(degrees), 360.0);
  const int quarter = static_cast<int>(magnitude / 90.0 + 0.5);
  const double left = magnitude - 90.0 * quarter;

  // Taylor's series; the first terms left out are below 45 deg^19 / 19! < 2^-60.
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
