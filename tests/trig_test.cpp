#include "geometry/trig.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

// Within the stated 2^-51 of the C library's long double functions, whose argument is reduced exactly.
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

// Exact where the value is 0, 1/2, 1; one turn more changes nothing; sine odd, cosine even.
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
