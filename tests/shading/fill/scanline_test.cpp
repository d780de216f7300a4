#include "geometry/view/scanline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "geometry/exact/int128.h"
#include "shading/fill/fill.h"

namespace xnewell::THIS_FILE {

namespace {

/// The sample rule by its definition: the sign of the edge function at the pixel's centre, if 0 the sign
/// of its x coefficient, if 0 that of its y coefficient; in 128 bits.
bool owns(const std::vector<glm::ivec3>& p, int i, int j) {
  for (std::size_t k = 0; k < p.size(); ++k) {
    const glm::ivec3 &a = p[k], &b = p[(k + 1) % p.size()];
    const Int128 A = std::int64_t{b.y} - a.y, B = std::int64_t{a.x} - b.x;  // inside is positive
    const Int128 x = std::int64_t{i} * kGrid + kGrid / 2 - a.x, y = std::int64_t{j} * kGrid + kGrid / 2 - a.y;
    const Int128 value = A * x + B * y;
    const int sign = value != 0 ? (value > 0 ? 1 : -1) : A != 0 ? (A > 0 ? 1 : -1) : (B > 0 ? 1 : -1);
    if (sign < 0) return false;
  }
  return true;
}

int checked = 0;

void expectRule(const std::vector<glm::ivec3>& p, int width, int height) {
  std::vector<int> painted(std::size_t(width) * height, 0);
  forEachSpan(p.data(), static_cast<int>(p.size()), width, height, [&](int row, int from, int to) {
    ASSERT_TRUE(row >= 0 && row < height && from >= 0 && from < to && to <= width);
    for (int i = from; i < to; ++i) ++painted[std::size_t(row) * width + i];
  });
  IndexImage image{width, height, 7};
  fillConvex(image, p.data(), static_cast<int>(p.size()), FlatCell{201});
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      checked += owns(p, i, j);
      ASSERT_EQ(painted[std::size_t(j) * width + i], owns(p, i, j) ? 1 : 0) << "pixel " << i << ", " << j;
      ASSERT_EQ(image.row(j)[i], owns(p, i, j) ? 201 : 7) << "filled pixel " << i << ", " << j;
    }
}

std::vector<glm::ivec3> counterClockwise(std::vector<glm::ivec3> p) {
  if (doubleArea(p.data(), static_cast<int>(p.size())) < 0) std::reverse(p.begin(), p.end());
  return p;
}

}  // namespace

// If the corners of a square are pixel centres, its left and top edges are in, and its right and bottom edges
// are out.
TEST(Scanline, TopLeftRule) {
  const int c = kGrid / 2;
  const std::vector<glm::ivec3> square = counterClockwise({{kGrid + c, kGrid + c, 0},
                                                           {3 * kGrid + c, kGrid + c, 0},
                                                           {3 * kGrid + c, 3 * kGrid + c, 0},
                                                           {kGrid + c, 3 * kGrid + c, 0}});
  std::vector<std::array<int, 3>> spans;
  forEachSpan(square.data(), 4, 10, 10, [&](int row, int from, int to) { spans.push_back({row, from, to}); });
  EXPECT_EQ(spans, (std::vector<std::array<int, 3>>{{1, 1, 3}, {2, 1, 3}}));
}

// Every sample of random triangles is decided as the edge functions in 128 bits decide it. Vertices lie
// anywhere, on pixel centres and on corners, within and far outside the picture; some triangles are needles.
TEST(Scanline, OwnsExactlyTheSamplesOfTheRule) {
  checked = 0;
  for (unsigned seed = 0; seed < 4000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const auto uniform = [&](int low, int high) { return std::uniform_int_distribution{low, high}(rng); };
    const int kind = static_cast<int>(seed % 4);
    std::vector<glm::ivec3> p(3);
    for (glm::ivec3& v : p) {
      if (kind == 0) v = {uniform(0, 20 * kGrid), uniform(0, 16 * kGrid), 0};
      if (kind == 1) v = {uniform(0, 40) * kGrid / 2, uniform(0, 32) * kGrid / 2, 0};
      if (kind == 2) v = {uniform(-(1 << 29), 1 << 29), uniform(-(1 << 29), 1 << 29), 0};
      if (kind == 3) v = {uniform(0, 20 * kGrid), 7 * kGrid + uniform(-3, 3) + kGrid / 2, 0};
    }
    if (doubleArea(p.data(), 3) == 0) continue;
    expectRule(counterClockwise(p), 20, 16);
  }
  EXPECT_GT(checked, 100'000);  // the samples were really there
}

// Small triangles, which are filled block by block, have the same samples by either rule: inside the picture,
// across every border and corner and beyond, on and off the lattice of ties, and in pictures smaller than a
// block.
TEST(Scanline, SmallTrianglesOwnTheSamplesOfTheRule) {
  checked = 0;
  for (unsigned seed = 0; seed < 20'000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const auto uniform = [&](int low, int high) { return std::uniform_int_distribution{low, high}(rng); };
    const int width = seed % 7 == 0 ? uniform(1, 12) : 19, height = seed % 7 == 0 ? uniform(1, 12) : 13;
    const int side = uniform(1, 9), step = seed % 2 ? 1 : kGrid / 2;
    const glm::ivec3 at{uniform(-10 * kGrid / step, (width + 1) * kGrid / step),
                        uniform(-10 * kGrid / step, (height + 1) * kGrid / step), 0};
    std::vector<glm::ivec3> p(3);
    for (glm::ivec3& v : p)
      v = (at + glm::ivec3{uniform(0, side * kGrid / step), uniform(0, side * kGrid / step), 0}) * step;
    if (doubleArea(p.data(), 3) == 0) continue;
    expectRule(counterClockwise(p), width, height);
  }
  EXPECT_GT(checked, 10'000);
}

// A span of any length fills its own cells and none next to them, also where stores overlap.
TEST(Scanline, SpansAreFilledToTheirEnds) {
  for (int count = 1; count <= 80; ++count) {
    std::array<std::uint8_t, 100> cells{};
    fillSpan(cells.data() + 10, count, 201);
    for (int i = 0; i < 100; ++i) ASSERT_EQ(cells[i], i >= 10 && i < 10 + count ? 201 : 0) << count;
  }
}

// The exact edge walk does not drift: it agrees with a new division in every row. The edges cross the tallest
// picture and the whole guard band, with the coarsest and the finest slopes.
TEST(Scanline, EdgesAreExactOver8192Rows) {
  long long rows = 0, ties = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const auto uniform = [&](int low, int high) { return std::uniform_int_distribution{low, high}(rng); };
    glm::ivec3 a{uniform(-(1 << 29), 1 << 29), -uniform(0, 1 << 29), 0};
    glm::ivec3 b{uniform(-(1 << 29), 1 << 29), (1 << 29) - uniform(0, 100), 0};
    if (seed % 3 == 0) {  // through pixel centres
      a = {kGrid * uniform(-8000, 8000) + kGrid / 2, kGrid / 2, 0};
      b = {kGrid * uniform(-8000, 8000) + kGrid / 2, kGrid * 8190 + kGrid / 2, 0};  // 8190 = 2 3^2 5 7 13
    }
    if (seed % 3 == 1) b.x = a.x + uniform(-5, 5);  // almost upright
    const int first = std::max(0, sampleFrom(a.y));
    EdgeWalk edge{a, b, first};
    for (int row = first; row < std::min(8192, sampleFrom(b.y)); ++row, edge.nextRow(), ++rows) {
      const Int128 dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
      const Int128 yc = std::int64_t{row} * kGrid + kGrid / 2;
      const Int128 numerator = (a.x - kGrid / 2) * dy + (yc - a.y) * dx, denominator = dy * kGrid;
      Int128 column = numerator / denominator;
      if (column * denominator < numerator) ++column;
      ties += column * denominator == numerator;
      ASSERT_EQ(edge.column(), static_cast<int>(column)) << row;
    }
  }
  EXPECT_GT(rows, 1'000'000);
  EXPECT_GT(ties, 100);
}

// A mesh of faces that share edges covers every sample exactly once. The test connects random points in a
// square as a fan of triangles around each cell of a jittered lattice.
TEST(Scanline, SharedEdgesLeaveNoGapAndNoOverlap) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    constexpr int kCells = 9, kStep = 3 * kGrid;
    const int jitter = seed % 2 ? kStep / 5 : 0;
    std::vector<glm::ivec3> v;
    for (int y = 0; y <= kCells; ++y)
      for (int x = 0; x <= kCells; ++x) {
        const bool border = x == 0 || y == 0 || x == kCells || y == kCells;
        const auto off = [&] { return border ? 0 : std::uniform_int_distribution{-jitter, jitter}(rng); };
        v.push_back({x * kStep + kGrid / 2 + off(), y * kStep + kGrid / 2 + off(), 0});
      }
    constexpr int kSide = 3 * kCells + 2;
    std::vector<int> owners(kSide * kSide, 0);
    const auto fill = [&](std::vector<glm::ivec3> p) {
      p = counterClockwise(p);
      forEachSpan(p.data(), 3, kSide, kSide, [&](int row, int from, int to) {
        for (int i = from; i < to; ++i) ++owners[row * kSide + i];
      });
    };
    for (int y = 0; y < kCells; ++y)
      for (int x = 0; x < kCells; ++x) {
        const int a = y * (kCells + 1) + x, b = a + 1, c = a + kCells + 2, d = a + kCells + 1;
        if ((rng() & 1u) != 0)
          fill({v[a], v[b], v[c]}), fill({v[a], v[c], v[d]});
        else
          fill({v[a], v[b], v[d]}), fill({v[b], v[c], v[d]});
      }
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i)
        ASSERT_EQ(owners[j * kSide + i], i < 3 * kCells && j < 3 * kCells ? 1 : 0) << i << ", " << j;
  }
}

}  // namespace xnewell::THIS_FILE
