#include "shading/fill/affine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>

#include "geometry/exact/int128.h"
#include "geometry/view/project.h"
#include "geometry/view/scanline.h"
#include "tests/support/affine_over.h"

namespace xnewell::THIS_FILE {

namespace {

using Triangle = std::array<glm::ivec3, 3>;
using Values = std::array<double, 3>;

/// Exact planes. Values are multiples of 2^-40, so all numbers below are integers of less than 2^112.
struct ExactPlane {
  glm::ivec3 origin;
  Int128 atOrigin, D, alongX, alongY;  ///< alongX / D a grid step

  ExactPlane(const Triangle& p, const std::array<std::int64_t, 3>& W) : origin{p[0]}, atOrigin{W[0]} {
    const std::int64_t x1 = p[1].x - p[0].x, y1 = p[1].y - p[0].y, x2 = p[2].x - p[0].x, y2 = p[2].y - p[0].y;
    D = x1 * y2 - x2 * y1;
    alongX = Int128{W[1] - W[0]} * y2 - Int128{W[2] - W[0]} * y1;
    alongY = Int128{W[2] - W[0]} * x1 - Int128{W[1] - W[0]} * x2;
  }
  /// value - plane at the centre of pixel (i, j), value in units of the plane.
  [[nodiscard]] double difference(std::int64_t value, int i, int j) const {
    const Int128 x = std::int64_t{i} * kGrid + kGrid / 2 - origin.x;
    const Int128 y = std::int64_t{j} * kGrid + kGrid / 2 - origin.y;
    return approximately((value - atOrigin) * D - alongX * x - alongY * y) / approximately(D);
  }
  /// The larger of the two gradients, for each pixel.
  [[nodiscard]] double gradient() const {
    return std::max(std::abs(approximately(alongX)), std::abs(approximately(alongY))) /
           std::abs(approximately(D)) * kGrid;
  }
};

std::array<std::int64_t, 3> inSteps(const Values& v, double stepsOfOne) {
  return {std::llrint(v[0] * stepsOfOne), std::llrint(v[1] * stepsOfOne), std::llrint(v[2] * stepsOfOne)};
}

enum class Kind { Small, Picture, Grid, Needle, Corners };

class RandomCase {
 public:
  explicit RandomCase(unsigned seed) : rng_{seed}, kind_{static_cast<Kind>(seed % 5)} {}

  int uniform(int low, int high) { return std::uniform_int_distribution{low, high}(rng_); }

  Triangle triangle() {
    constexpr int kPicture = kMaxPicture * kGrid, kGuard = 1 << 29;
    Triangle p;
    do {
      const glm::ivec3 at{uniform(0, kPicture), uniform(0, kPicture), 0};
      const int side = kGrid << uniform(0, 5);
      for (glm::ivec3& v : p) {
        if (kind_ == Kind::Small)
          v = glm::min(at + glm::ivec3{uniform(0, side), uniform(0, side), 0}, kGuard);
        if (kind_ == Kind::Picture) v = {uniform(0, kPicture), uniform(0, kPicture), 0};
        if (kind_ == Kind::Grid) v = {uniform(-kGuard, kGuard), uniform(-kGuard, kGuard), 0};
        if (kind_ == Kind::Needle) v = {uniform(0, kPicture), uniform(0, kPicture), 0};
        if (kind_ == Kind::Corners) v = {kGuard * uniform(-1, 1), kGuard * uniform(-1, 1), 0};
      }
      // Almost between the other two, by up to 2^0 .. 2^16 grid steps.
      const int off = 1 << uniform(0, 16);
      if (kind_ == Kind::Needle) {
        const double t = uniform(0, 1 << 20) * 0x1p-20;
        p[2] = {p[0].x + std::lrint(t * (p[1].x - p[0].x)) + uniform(-off, off),
                p[0].y + std::lrint(t * (p[1].y - p[0].y)) + uniform(-off, off), 0};
        p[2] = glm::clamp(p[2], -kGuard, kGuard);
      }
    } while (doubleArea(p.data(), 3) == 0);
    if (doubleArea(p.data(), 3) < 0) std::swap(p[1], p[2]);
    return p;
  }

  /// Multiples of 2^-40: anywhere in the range, at its ends, or near one another.
  Values values() {
    const auto least = std::llrint(kLeastValue * 0x1p40),
               largest = std::llrint(std::floor(kLargestValue * 0x1p40));
    const auto steps = [&](std::int64_t low, std::int64_t high) {
      return static_cast<double>(std::uniform_int_distribution{low, high}(rng_)) * 0x1p-40;
    };
    const int kind = uniform(0, 2);
    const std::int64_t near = std::uniform_int_distribution{least, largest - (1 << 20)}(rng_);
    Values v{};
    for (double& value : v) {
      if (kind == 0) value = steps(least, largest);
      if (kind == 1) value = uniform(0, 1) != 0 ? kLeastValue : static_cast<double>(largest) * 0x1p-40;
      if (kind == 2) value = steps(near, near + (1 << 20));
    }
    return v;
  }

 private:
  std::mt19937 rng_;
  Kind kind_;
};

/// Samples of a triangle in the largest picture: the ends and the middle of some rows.
template <class Visit>
void forSomeSamples(RandomCase& random, const Triangle& p, Visit&& visit) {
  const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
  const int first = std::clamp(sampleFrom(top), 0, kMaxPicture),
            end = std::clamp(sampleFrom(bottom), 0, kMaxPicture);
  if (first == end) return;
  const auto visitRow = [&](int row, int from, int to) {
    for (const int i : {from, (from + to) / 2, to - 1}) visit(i, row);
  };
  for (int k = 0; k < 8; ++k) {
    const int row = k == 0 ? first : k == 1 ? end - 1 : random.uniform(first, end - 1);
    forEachSpan(p.data(), 3, row, kMaxPicture, std::min(row + 4, end), visitRow);
  }
}

}  // namespace

// At every sample of a triangle, the plane of the value differs from the exact one by no more than affine.h
// says.
TEST(Affine, StaysWithinItsBoundOfTheExactPlane) {
  int samples = 0, steep = 0;
  double worst = 0;  // share of the bound
  for (unsigned seed = 0; seed < 20'000; ++seed) {
    SCOPED_TRACE(seed);
    RandomCase random{seed};
    const Triangle p = random.triangle();
    const Values v = random.values();
    const AffineValue value = affineOver(p.data(), v);
    const double gradient = ExactPlane{p, inSteps(v, 0x1p24)}.gradient();
    if (gradient > AffineOver::kSteepest * (1 + 1e-9)) {
      const double mean = (v[0] + v[1] + v[2]) / 3;
      EXPECT_EQ(value.gx, 0u);
      EXPECT_EQ(value.gy, 0u);
      EXPECT_NEAR(value.c * 0x1p-24, mean, 0x1p-22);
      ++steep;
      continue;
    }
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
    const double extent = (double(right) - left + bottom - top) / kGrid;
    const double bound = ((0.5 + 0x1p-7) * extent + 1) * 0x1p16;
    const ExactPlane exact{p, inSteps(v, 0x1p40)};
    forSomeSamples(random, p, [&](int i, int j) {
      const double off = std::abs(exact.difference(std::int64_t{value.at(i, j)} << 16, i, j));
      worst = std::max(worst, off / bound);
      ASSERT_LE(off, bound) << "pixel " << i << ", " << j;
      ++samples;
    });
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(samples, 300'000);
  EXPECT_GT(steep, 500);
  EXPECT_GT(worst, 0.8);  // the bound says something
}

// One addition for each pixel and one for each row, as a filler does, give the value by its definition. The
// test uses the widest row and the tallest column, with gradients of all sizes.
TEST(Affine, StepsAreExact) {
  std::mt19937 rng{1971};
  for (int k = 0; k < 200; ++k) {
    const AffineValue value{static_cast<std::uint32_t>(rng()), static_cast<std::uint32_t>(rng()) >> k % 32,
                            static_cast<std::uint32_t>(rng())};
    const int row = static_cast<int>(rng() % kMaxPicture);
    std::uint32_t along = value.c;
    for (int j = 0; j < row; ++j) along += value.gy;
    for (int i = 0; i < kMaxPicture; ++i, along += value.gx) ASSERT_EQ(along, value.at(i, row)) << i;
  }
}

// At vertices that are pixel centres, a face has the vertices' values, and half way between them the mean.
TEST(Affine, PassesThroughTheVertices) {
  const auto centre = [](int i, int j) {
    return glm::ivec3{i * kGrid + kGrid / 2, j * kGrid + kGrid / 2, 0};
  };
  const Triangle p{centre(10, 10), centre(10, 42), centre(74, 42)};
  const AffineValue value = affineOver(p.data(), {64, 128, 32});
  EXPECT_EQ(value.at(10, 10), 64u << 24);
  EXPECT_EQ(value.at(10, 42), 128u << 24);
  EXPECT_EQ(value.at(74, 42), 32u << 24);
  EXPECT_EQ(value.at(42, 42), 80u << 24);
}

// A face without area has no plane; it has the mean of its values.
TEST(Affine, IsFlatWithoutAnArea) {
  const Triangle line{glm::ivec3{0, 0, 0}, {kGrid, kGrid, 0}, {3 * kGrid, 3 * kGrid, 0}};
  EXPECT_EQ(affineOver(line.data(), {1, 2, 6}), (AffineValue{3u << 24, 0, 0}));
  const Triangle point{};
  EXPECT_EQ(affineOver(point.data(), {1, 2, 6}), (AffineValue{3u << 24, 0, 0}));
}

}  // namespace xnewell::THIS_FILE
