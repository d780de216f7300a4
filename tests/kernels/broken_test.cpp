#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <random>

#include "geometry/view/screen_grid.h"
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

/// As EdgeWalk::column(), some rows below the first. Broken: x starts 2^-29 below the upper end of its
/// interval instead of 2^-32.
int columnWithALargeTolerance(const glm::ivec3& a, const glm::ivec3& b, int firstRow, int row) {
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const std::int64_t yc = (std::int64_t{firstRow} << kGridBits) + kGrid / 2;
  const std::int64_t M = -((-((a.x - kGrid / 2) * dy + (yc - a.y) * dx)) >> kGridBits);
  const double perRow = 0x1p47 / static_cast<double>(dy);
  std::int64_t x = static_cast<std::int64_t>(static_cast<double>(M) * perRow) +
                   ((std::int64_t{1} << 47) - 1 - (std::int64_t{1} << 18));
  if (dy >= kGrid) x += (row - firstRow) * static_cast<std::int64_t>(static_cast<double>(dx) * perRow);
  return static_cast<int>(x >> 47);
}

/// As point(), in one coordinate. Broken: the last digit of a constant, 3.
double bezierWithAWrongDigit(const Numbers& in) {
  constexpr double kThree = 3.000000000000004;
  const auto curve = [](const std::array<double, 4>& p, double t) {
    const double s = 1.0 - t;
    const double b0 = s * s * s, b1 = kThree * (s * s * t), b2 = kThree * (t * t * s), b3 = t * t * t;
    return (b0 * p[0] + b3 * p[3]) + (b1 * p[1] + b2 * p[2]);
  };
  std::array<double, 4> rows;
  for (std::size_t i = 0; i < 4; ++i)
    rows[i] = curve({in[4 * i], in[4 * i + 1], in[4 * i + 2], in[4 * i + 3]}, in[17]);
  return curve(rows, in[16]);
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

TEST(BrokenKernel, ALargeToleranceIsFound) {
  Kernel kernel = kernelOf("walk along an edge");
  EXPECT_LE(worstOf(kernel).share, 1.0);
  kernel.run = [](const Numbers& in) {
    const auto at = [&](int k) { return static_cast<int>(in[k]); };
    return Numbers{
        static_cast<double>(columnWithALargeTolerance({at(0), at(1), 0}, {at(2), at(3), 0}, at(5), at(4)))};
  };
  EXPECT_EQ(worstOf(kernel).share, kWrong);
  // Random edges, as long as the grid and shorter.
  Random random{3};
  for (int k = 0; k < 200'000; ++k) {
    const double size = random.power(10, 29);
    Numbers in;
    for (int i = 0; i < 4; ++i) in.push_back(std::round(random.uniform(-size, size)));
    in.push_back(static_cast<double>(random.below(8192)));
    in = kernel.prepare(in);
    if (!in.empty()) {
      ASSERT_LE(kernel.judge(in, kernel.run(in)), 1.0);
    }
  }
}

TEST(BrokenKernel, AWrongDigitIsFound) {
  Kernel kernel = kernelOf("Bezier point");
  EXPECT_LE(worstOf(kernel).share, 1.0);
  kernel.run = [](const Numbers& in) { return Numbers{bezierWithAWrongDigit(in)}; };
  EXPECT_GT(worstOf(kernel).share, 1.0);
  // As Bezier.AgreesWithDeCasteljau: it allows 16 * 8 * 2^-53 for coordinates up to 4, and that is enough.
  for (unsigned seed = 0; seed < 2'000; ++seed) {
    Random random{seed};
    Numbers in;
    for (int k = 0; k < 16; ++k) in.push_back(random.uniform(-4, 4));
    for (int k = 0; k < 2; ++k) in.push_back(random.uniform(0, 1));
    double largest = 0;
    for (int k = 0; k < 16; ++k) largest = std::max(largest, std::abs(in[k]));
    ASSERT_LT(kernel.judge(in, kernel.run(in)) * 0x1p-49 * largest, 16 * 8 * 0x1p-53);
  }
}

}  // namespace xnewell
