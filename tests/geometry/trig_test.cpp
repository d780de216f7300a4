#include "geometry/exact/trig.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace xnewell::THIS_FILE {

// The values are within the stated 2^-51 of the C library's long double functions, whose argument is reduced
// exactly.
TEST(Trig, AgreesWithLongDouble) {
  constexpr long double kDegree = 3.14159265358979323846264338327950288L / 180.0L;
  std::mt19937 rng{90};
  std::uniform_real_distribution<double> angle{-360.0, 360.0};
  for (int i = 0; i < 200'000; ++i) {
    const double degrees = i <= 1440 ? i / 2.0 - 360.0 : angle(rng);
    const auto [sine, cosine] = sinCosDegrees(degrees);
    const long double s = std::sin(degrees * kDegree), c = std::cos(degrees * kDegree);
    ASSERT_LE(std::abs(sine - s), 0x1p-51L) << degrees;
    ASSERT_LE(std::abs(cosine - c), 0x1p-51L) << degrees;
    if (std::abs(degrees) <= 80.0) {
      ASSERT_LE(std::abs(tanDegrees(degrees) - s / c), 0x1p-48L * std::abs(s / c));
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

// The angle is within the stated 2^-45 degrees of the C library's long double arc tangent, whatever the size
// of the pair. Multiples of 45 degrees are exact. A quarter turn and a reflection change the angle as they
// should.
TEST(Trig, DegreesOfASineAndACosine) {
  constexpr long double kDegree = 3.14159265358979323846264338327950288L / 180.0L;
  std::mt19937 rng{91};
  std::uniform_real_distribution<double> coordinate{-1.0, 1.0}, binary{-1000.0, 0.0};
  for (int i = 0; i < 200'000; ++i) {
    const double size = i % 2 ? std::exp2(binary(rng)) : 1.0;
    const double s = coordinate(rng) * (i % 3 ? 1.0 : size), c = coordinate(rng);
    const double degrees = degreesOf(s, c);
    ASSERT_LE(
        std::abs(degrees - std::atan2(static_cast<long double>(s), static_cast<long double>(c)) / kDegree),
        0x1p-45L)
        << s << ' ' << c;
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
