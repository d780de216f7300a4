#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/exact/trig.h"
#include "geometry/view/screen_plane.h"
#include "shading/light/reflect.h"
#include "tests/kernels/search.h"

namespace xnewell {

/// Three copies of kernels, each broken in one place that random inputs hardly meet. The search must find the
/// error. Each test also draws random inputs as the ordinary test of that kernel does, and shows that they
/// meet no error above that test's bound.

namespace {

Kernel kernelOf(const std::string& name) {
  for (Kernel& kernel : allKernels())
    if (kernel.name == name) return kernel;
  ADD_FAILURE() << "no kernel " << name;
  return {};
}

/// As sinCosDegrees().sin. Broken: one term of the series has the wrong sign in the last millionth of a
/// degree before 45.
double sineWithAFlippedTerm(double degrees) {
  const double magnitude = std::fmod(std::abs(degrees), 360.0);
  const int quarter = static_cast<int>(magnitude / 90.0 + 0.5);
  const double left = magnitude - 90.0 * quarter;
  const double x = left * (3.14159265358979323846 / 180.0), x2 = x * x;
  const bool flipped = std::abs(left) > 45.0 - 1e-6 && std::abs(left) < 45.0;
  double sine = 0.0, cosine = 0.0;
  for (int k = 17; k >= 3; k -= 2) sine = (1.0 + sine) * (flipped && k == 13 ? x2 : -x2) / (k * (k - 1));
  for (int k = 18; k >= 2; k -= 2) cosine = (1.0 + cosine) * -x2 / (k * (k - 1));
  sine = x + x * sine;
  cosine = 1.0 + cosine;
  if (std::abs(left) == 30.0) sine = std::copysign(0.5, left);
  if (std::abs(left) == 45.0) cosine = std::sqrt(0.5), sine = std::copysign(cosine, left);
  if (quarter % 2 == 1) sine = cosine;
  if (quarter == 2 || quarter == 3) sine = -sine;
  return degrees < 0.0 ? -sine : sine;
}

/// As compareDepths(). Broken: the tolerance of its filter is a sixteenth of what rounding needs.
int compareWithASmallTolerance(const ScreenPlane& P, const ScreenPlane& Q, std::int64_t x, std::int64_t y) {
  const double zP = depthAt(P, x, y), zQ = depthAt(Q, x, y), difference = zP - zQ;
  if (std::abs(difference) > 0x1p-54 * (std::abs(zP) + std::abs(zQ))) return difference > 0 ? 1 : -1;
  return compareDepths(P, Q, x, y);
}

/// As reflectedCosine(). Broken: the last digit of a constant.
double reflectedWithAWrongDigit(double NdotL, double NdotV, double LdotV) {
  return 2.00000000000001 * NdotL * NdotV - LdotV;
}

Worst worstOf(const Kernel& kernel) { return searchWorst(kernel, kRoundingModes[0], 3'000, 1); }

}  // namespace

TEST(BrokenKernel, AFlippedTermInANarrowRangeIsFound) {
  // As Trig.AgreesWithLongDouble.
  constexpr long double kDegree = 3.14159265358979323846264338327950288L / 180.0L;
  std::mt19937 rng{90};
  std::uniform_real_distribution<double> angle{-360.0, 360.0};
  for (int i = 0; i < 200'000; ++i) {
    const double degrees = i <= 1440 ? i / 2.0 - 360.0 : angle(rng);
    ASSERT_LE(std::abs(sineWithAFlippedTerm(degrees) - std::sin(degrees * kDegree)), 0x1p-51L) << degrees;
  }
  Kernel kernel = kernelOf("sine");
  EXPECT_LE(worstOf(kernel).share, 1.0);
  kernel.run = [](const Numbers& in) { return Numbers{sineWithAFlippedTerm(in[0])}; };
  const Worst worst = worstOf(kernel);
  EXPECT_GT(worst.share, 2.0);
}

TEST(BrokenKernel, ASmallToleranceIsFound) {
  Kernel kernel = kernelOf("order of two depths");
  EXPECT_LE(worstOf(kernel).share, 1.0);
  const auto planes = [run = kernel.run](const Numbers& in, const auto& compare) {
    Numbers out = run(in);
    out[0] = compare(screenPlaneOf(in, 0), screenPlaneOf(in, 9), static_cast<std::int64_t>(in[18]),
                     static_cast<std::int64_t>(in[19]));
    return out;
  };
  kernel.run = [planes](const Numbers& in) { return planes(in, compareWithASmallTolerance); };
  EXPECT_EQ(worstOf(kernel).share, kWrong);
  // Random triangles: none of them meets the error.
  Random random{3};
  for (int k = 0; k < 200'000; ++k) {
    Numbers in;
    for (const Coordinate& c : kernel.input) in.push_back(std::round(random.uniform(c.low, c.high)));
    in = kernel.prepare(in);
    if (in.empty()) continue;
    ASSERT_EQ(planes(in, compareWithASmallTolerance)[0], planes(in, compareDepths)[0]);
  }
}

TEST(BrokenKernel, AWrongLastDigitIsFound) {
  Kernel kernel = kernelOf("R.V");
  EXPECT_LE(worstOf(kernel).share, 1.0);
  const auto reflected = [](const Numbers& in) {
    const Vec<double> N{in[0], in[1], in[2]}, L{in[3], in[4], in[5]}, V{in[6], in[7], in[8]};
    return Numbers{reflectedWithAWrongDigit(dot(N, L), dot(N, V), dot(L, V))};
  };
  kernel.run = reflected;
  EXPECT_GT(worstOf(kernel).share, 2.0);
  // Equation.LoopsOverManyPlacesGiveTheSame allows 2^-45 (1 + n).
  Random random{3};
  for (int k = 0; k < 20'000; ++k) {
    Numbers in;
    for (int i = 0; i < 9; ++i) in.push_back(random.uniform(-1, 1));
    in = kernel.prepare(in);
    if (in.empty()) continue;
    ASSERT_LE(kernel.judge(in, reflected(in)) * 0x1p-48, 0x1p-45 * 2);
  }
}

}  // namespace xnewell
