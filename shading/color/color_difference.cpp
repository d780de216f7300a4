#include "shading/color/color_difference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace xnewell {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// The linear light of an sRGB value. Both lie in [0, 1].
double linear(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

/// CIE's cube root. Near black a straight line replaces it; the two meet at (6/29)^3 with the same slope.
double labRoot(double t) {
  constexpr double kJoin = 6.0 / 29.0;
  return t > kJoin * kJoin * kJoin ? std::cbrt(t) : t / (3 * kJoin * kJoin) + 4.0 / 29.0;
}

/// The hue angle in degrees, in [0, 360). It is 0 for a neutral colour.
double hueAngle(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double angle = std::atan2(b, a) / kDegree;
  return angle < 0 ? angle + 360 : angle;
}

double square(double x) { return x * x; }

/// sqrt(C^7 / (C^7 + 25^7)). It is 0 for grays and tends to 1 for the most colourful colours.
double saturation(double C) {
  const double seventh = std::pow(C, 7);
  return std::sqrt(seventh / (seventh + 6103515625.0));
}

}  // namespace

Lab labFromSrgb(Rgb16 color) {
  const double r = linear(color.r / 65535.0), g = linear(color.g / 65535.0), b = linear(color.b / 65535.0);
  // Each row is divided by its own sum, which is the white point. So white is (100, 0, 0) and grays are
  // neutral.
  const double X = labRoot((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.9504700);
  const double Y = labRoot((0.2126729 * r + 0.7151522 * g + 0.0721750 * b) / 1.0000001);
  const double Z = labRoot((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.0888300);
  return {116 * Y - 16, 500 * (X - Y), 200 * (Y - Z)};
}

Lab labFromSrgb(const std::uint8_t* rgb) {
  const auto wide = [](std::uint8_t v) { return static_cast<std::uint16_t>(257 * v); };
  return labFromSrgb(Rgb16{wide(rgb[0]), wide(rgb[1]), wide(rgb[2])});
}

// The letters are the paper's, without the primes: equations (2) to (22).
double ciede2000(const Lab& p, const Lab& q) {
  const double G = (1 - saturation((std::hypot(p.a, p.b) + std::hypot(q.a, q.b)) / 2)) / 2;
  const double a1 = (1 + G) * p.a, a2 = (1 + G) * q.a;
  const double C1 = std::hypot(a1, p.b), C2 = std::hypot(a2, q.b);
  const double h1 = hueAngle(a1, p.b), h2 = hueAngle(a2, q.b);

  // The difference of the hues, taken the short way round the circle, and their mean. A neutral colour has no
  // hue: the difference is then 0, and the hue of the other colour is the mean.
  constexpr double kRounding = 1e-12;  // degrees; the rounding error of an angle below 360 is smaller
  const bool neutral = C1 * C2 == 0, wraps = !neutral && std::abs(h2 - h1) > 180 + kRounding;
  double dh = neutral ? 0 : h2 - h1;
  if (wraps) dh += dh > 0 ? -360 : 360;
  double h = neutral ? h1 + h2 : (h1 + h2) / 2;
  if (wraps) h += h < 180 ? 180 : -180;

  const double dL = q.L - p.L, dC = C2 - C1, dH = 2 * std::sqrt(C1 * C2) * std::sin(dh / 2 * kDegree);
  const double L = (p.L + q.L) / 2, C = (C1 + C2) / 2;
  const double T = 1 - 0.17 * std::cos((h - 30) * kDegree) + 0.24 * std::cos(2 * h * kDegree) +
                   0.32 * std::cos((3 * h + 6) * kDegree) - 0.20 * std::cos((4 * h - 63) * kDegree);
  const double SL = 1 + 0.015 * square(L - 50) / std::sqrt(20 + square(L - 50));
  const double SC = 1 + 0.045 * C, SH = 1 + 0.015 * C * T;
  const double turn = 30 * std::exp(-square((h - 275) / 25));
  const double RT = -std::sin(2 * turn * kDegree) * 2 * saturation(C);
  return std::sqrt(square(dL / SL) + square(dC / SC) + square(dH / SH) + RT * (dC / SC) * (dH / SH));
}

}  // namespace xnewell
