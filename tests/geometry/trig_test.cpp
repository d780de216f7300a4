#include "geometry/exact/trig.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tests/support/extended.h"

namespace xnewell::THIS_FILE {

namespace {

/// A degree in radians, to 64 bits.
const Extended kDegree = (Extended{0x1.921fb54442d18p1} + 0x1.1a62633145c07p-53) / 180;

/// Sine and cosine by their series, of an angle that is at most 45 degrees away from a quarter turn.
struct BySeries {
  Extended sin, cos;
};
BySeries bySeries(double degrees) {
  const double quarters = std::nearbyint(degrees / 90);
  const Extended x = (degrees - 90 * quarters) * kDegree;  // the difference is exact
  std::array<Extended, 2> sums{0, 0};                      // of the even powers and of the odd ones
  static const auto inverses = [] {
    std::array<Extended, 24> of{};
    Extended factorial = 1;
    for (int n = 0; n < 24; ++n) of[n] = 1 / factorial, factorial *= n + 1;
    return of;
  }();
  Extended power = 1;
  for (int n = 0; n < 24; ++n, power *= x) sums[n % 2] += (n % 4 < 2 ? power : -power) * inverses[n];
  const auto [c, s] = sums;
  switch (static_cast<int>(quarters) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace

// The values are within the stated 2^-51 of those of the series.
TEST(Trig, AgreesWithTheSeries) {
  using std::abs;  // and that of two doubles
  std::mt19937 rng{90};
  std::uniform_real_distribution<double> angle{-360.0, 360.0};
  for (int i = 0; i < 200'000; ++i) {
    const double degrees = i <= 1440 ? i / 2.0 - 360.0 : angle(rng);
    const auto [sine, cosine] = sinCosDegrees(degrees);
    const auto [s, c] = bySeries(degrees);
    ASSERT_LE(static_cast<double>(abs(sine - s)), 0x1p-51) << degrees;
    ASSERT_LE(static_cast<double>(abs(cosine - c)), 0x1p-51) << degrees;
    if (std::abs(degrees) <= 80.0) {
      ASSERT_LE(static_cast<double>(abs(tanDegrees(degrees) - s / c)),
                static_cast<double>(0x1p-48 * abs(s / c)));
    }
  }
}

// Values of 0, 1/2 and 1 are exact. A whole turn changes nothing. The sine is odd and the cosine even.
TEST(Trig, ExactValuesAndSymmetries) {
  for (int turns = -720; turns <= 720; turns += 360) {
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(sinCosDegrees(turns + 90 * k).sin, (std::array{0, 1, 0, -1}[k]));
      EXPECT_EQ(sinCosDegrees(turns + 90 * k).cos, (std::array{1, 0, -1, 0}[k]));
    }
    EXPECT_EQ(sinCosDegrees(turns + 30).sin, 0.5);
    EXPECT_EQ(sinCosDegrees(turns + 60).cos, 0.5);
    EXPECT_EQ(sinCosDegrees(turns + 210).sin, -0.5);
    EXPECT_EQ(tanDegrees(turns + 45), 1.0);
  }
  for (double d = 0.0; d < 400.0; d += 0.37) {
    EXPECT_EQ(sinCosDegrees(-d).sin, -sinCosDegrees(d).sin);
    EXPECT_EQ(sinCosDegrees(-d).cos, sinCosDegrees(d).cos);
  }
}

// The angle is within the stated 2^-45 degrees of the one whose sine and cosine are those of the pair, by the
// series, whatever the size of the pair. Multiples of 45 degrees are exact. A quarter turn and a reflection
// change the angle as they should.
TEST(Trig, DegreesOfASineAndACosine) {
  std::mt19937 rng{91};
  std::uniform_real_distribution<double> coordinate{-1.0, 1.0}, binary{-1000.0, 0.0};
  for (int i = 0; i < 200'000; ++i) {
    const double size = i % 2 ? std::exp2(binary(rng)) : 1.0;
    const double s = coordinate(rng) * (i % 3 ? 1.0 : size), c = coordinate(rng);
    const double degrees = degreesOf(s, c);
    // The pair, turned back by the angle, leaves a sine that is the angle still missing.
    const auto [sine, cosine] = bySeries(degrees);
    const Extended across = s * cosine - c * sine, along = s * sine + c * cosine;
    ASSERT_GT(along, 0);
    ASSERT_LE(std::abs(static_cast<double>(across / along / kDegree)), 0x1p-45) << s << ' ' << c;
    ASSERT_EQ(degreesOf(-s, c), -degrees);
    ASSERT_EQ(degreesOf(std::ldexp(s, 900), std::ldexp(c, 900)), degrees);
    ASSERT_EQ(degreesOf(std::abs(s), -std::abs(c)), 180.0 - degreesOf(std::abs(s), std::abs(c)));
  }
  EXPECT_EQ(degreesOf(0, 0), 0.0);
  for (int k = -3; k <= 4; ++k) {
    const int s = std::array{-1, -1, -1, 0, 1, 1, 1, 0}[k + 3],
              c = std::array{-1, 0, 1, 1, 1, 0, -1, -1}[k + 3];
    EXPECT_EQ(degreesOf(3 * s, 3 * c), 45.0 * k);
  }
  for (int d = -179; d <= 180; ++d)
    EXPECT_NEAR(degreesOf(sinCosDegrees(d).sin, sinCosDegrees(d).cos), d, 60 * 0x1p-51 + 0x1p-45);
}

}  // namespace xnewell::THIS_FILE
