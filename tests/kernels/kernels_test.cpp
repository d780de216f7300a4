#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <glm/vec3.hpp>
#include <map>
#include <sstream>

#include "geometry/view/screen_grid.h"
#include "tests/kernels/search.h"

namespace xnewell {

namespace {

const std::vector<Kernel>& kernels() {
  static const std::vector<Kernel> all = geometryKernels() + shadingKernels();
  return all;
}

/// The rows of worst_inputs.txt, by kernel: the share when it rounds to nearest, and the input.
const std::vector<Worst>& worstInputs(const std::string& kernel) {
  static const auto rows = [] {
    std::map<std::string, std::vector<Worst>> read;
    std::ifstream file{XNEWELL_WORST_INPUTS};
    for (std::string line; std::getline(file, line);) {
      const std::size_t first = line.find(" | "), second = line.find(" | ", first + 3);
      if (second == std::string::npos) throw std::runtime_error{"not a row: " + line};
      Worst row{std::stod(line.substr(first + 3)), {}};
      std::istringstream numbers{line.substr(second + 3)};
      for (std::string number; numbers >> number;) row.input.push_back(std::strtod(number.c_str(), nullptr));
      read[line.substr(0, first)].push_back(row);
    }
    return read;
  }();
  return rows.at(kernel);
}

Worst worstOf(const Kernel& kernel, const RoundingMode& mode, int evaluations, std::uint64_t seed) {
  std::vector<Numbers> start;
  for (const Worst& row : worstInputs(kernel.name)) start.push_back(row.input);
  return searchWorst(kernel, start, mode, std::max(20, static_cast<int>(evaluations * kernel.effort)), seed);
}

std::string testName(const testing::TestParamInfo<std::size_t>& info) {
  std::string name;
  for (const char c : kernels()[info.param].name)
    name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

class KernelBound : public testing::TestWithParam<std::size_t> {};

}  // namespace

// Searches of a few thousand inputs find none beyond the bound that the header claims, in any rounding mode.
// Another seed looks in other places. XNEWELL_EVALUATIONS makes them longer, and prints what they find as
// rows.
TEST_P(KernelBound, HoldsWhereASearchLooks) {
  const Kernel& kernel = kernels()[GetParam()];
  const char* const longer = std::getenv("XNEWELL_EVALUATIONS");
  for (const RoundingMode& mode : kRoundingModes) {
    const bool nearest = mode.name == "nearest";
    const int evaluations = longer ? std::atoi(longer) : nearest ? 4'000 : 1'000;
    for (std::uint64_t seed = 7; seed < (nearest ? 10 : 8); ++seed) {
      const Worst worst = worstOf(kernel, mode, evaluations, seed);
      EXPECT_LE(worst.share, 1.0) << kernel.claim << "; " << mode.name << ", seed " << seed << ", input "
                                  << testing::PrintToString(worst.input);
      if (!longer || worst.input.empty()) continue;
      std::printf("%s | %.4g |", kernel.name.c_str(), shareAt(kernel, worst.input, kRoundingModes[0]));
      for (const double v : worst.input) std::printf(" %a", v);
      std::printf("\n");
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Kernels, KernelBound, testing::Range(std::size_t{0}, kernels().size()), testName);

// The worst inputs that long searches found are within the bounds, in all modes. To nearest, they are as bad
// as when they were found: else the kernel has changed, and the row must be made again.
TEST_P(KernelBound, HoldsForTheWorstInputs) {
  const Kernel& kernel = kernels()[GetParam()];
  for (const Worst& row : worstInputs(kernel.name)) {
    SCOPED_TRACE(testing::PrintToString(row.input));
    ASSERT_EQ(row.input.size(), kernel.input.size());
    EXPECT_NEAR(shareAt(kernel, row.input, kRoundingModes[0]), row.share, 1e-3 * row.share);
    for (const RoundingMode& mode : kRoundingModes)
      EXPECT_LE(shareAt(kernel, row.input, mode), 1.0) << kernel.claim << "; " << mode.name;
  }
}

// The search finds the worst input of a small range: all floats from 1 to 1 + 2^-11, whose squares are
// judged one by one. It also finds a single input among 2^64 if the errors beside it lead there.
TEST(KernelSearch, FindsTheWorst) {
  static constexpr auto squareError = [](double x) {
    const float rounded = static_cast<float>(x) * static_cast<float>(x);
    return std::abs(rounded - x * x) * 0x1p23;
  };
  const auto same = [](In in) { return in; };
  const Kernel square{"square", "",   floats(1, 1 + 0x1p-11),
                      nullptr,  same, [](In in, In) { return squareError(in[0]); }};
  double worst = 0;
  for (int k = 0; k <= 1 << 12; ++k) worst = std::max(worst, squareError(1 + k * 0x1p-23));
  EXPECT_EQ(searchWorst(square, {}, kRoundingModes[0], 30'000, 1).share, worst);

  const Kernel hill{"hill", "", doubles(-1e300, 1e300), nullptr, same, [](In in, In) {
                      const Coordinate c{};
                      return 1 / (1 + std::abs(double(c.encode(in[0]) - c.encode(0x1.23456789abcdep-345))));
                    }};
  EXPECT_EQ(searchWorst(hill, {}, kRoundingModes[0], 5'000, 1).share, 1.0);
}

// Three copies of kernels, each broken in one place that random inputs hardly meet: with each of them in the
// program, the ordinary tests of that kernel still passed. The search finds all three.

// As sinCosDegrees().sin. Broken: one term of the series has the wrong sign in the last millionth of a degree
// before 45.
Numbers sineWithAFlippedTerm(In in) {
  const double degrees = in[0], magnitude = std::fmod(std::abs(degrees), 360.0);
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
  return {degrees < 0.0 ? -sine : sine};
}

// As EdgeWalk::column(), some rows below the first. Broken: x starts 2^-29 below the upper end of its
// interval instead of 2^-32.
Numbers columnWithALargeTolerance(In in) {
  const auto at = [&](std::size_t k) { return static_cast<std::int64_t>(in[k]); };
  const std::int64_t dx = at(2) - at(0), dy = at(3) - at(1), yc = at(5) * kGrid + kGrid / 2;
  const std::int64_t M = -((-((at(0) - kGrid / 2) * dy + (yc - at(1)) * dx)) >> kGridBits);
  const double perRow = 0x1p47 / static_cast<double>(dy);
  std::int64_t x = static_cast<std::int64_t>(static_cast<double>(M) * perRow) +
                   ((std::int64_t{1} << 47) - 1 - (std::int64_t{1} << 18));
  if (dy >= kGrid) x += (at(4) - at(5)) * static_cast<std::int64_t>(static_cast<double>(dx) * perRow);
  return {static_cast<double>(x >> 47)};
}

// As point(), in one coordinate. Broken: the last digit of a constant, 3.
Numbers bezierWithAWrongDigit(In in) {
  const auto curve = [](const double* p, double t) {
    constexpr double three = 3.000000000000004;
    const double s = 1.0 - t;
    const double b0 = s * s * s, b1 = three * (s * s * t), b2 = three * (t * t * s), b3 = t * t * t;
    return (b0 * p[0] + b3 * p[3]) + (b1 * p[1] + b2 * p[2]);
  };
  std::array<double, 4> rows;
  for (std::size_t i = 0; i < 4; ++i) rows[i] = curve(&in[4 * i], in[17]);
  return {curve(rows.data(), in[16])};
}

TEST(KernelSearch, FindsThreeBrokenKernels) {
  const std::map<std::string, Numbers (*)(In)> broken{{"sine", sineWithAFlippedTerm},
                                                      {"walk along an edge", columnWithALargeTolerance},
                                                      {"Bezier point", bezierWithAWrongDigit}};
  for (const auto& [name, run] : broken) {
    Kernel kernel = *std::ranges::find(kernels(), name, &Kernel::name);
    EXPECT_LE(worstOf(kernel, kRoundingModes[0], 4'000, 1).share, 1.0) << name;
    kernel.run = run;
    EXPECT_GT(worstOf(kernel, kRoundingModes[0], 4'000, 1).share, 1.0) << name;
  }
}

}  // namespace xnewell
