#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/exact/int128.h"
#include "geometry/view/project.h"
#include "geometry/view/scanline.h"
#include "geometry/view/screen_plane.h"
#include "shading/course/course.h"
#include "shading/fill/affine.h"
#include "shading/fill/environment.h"
#include "shading/fill/fill.h"
#include "shading/fill/gouraud.h"
#include "tests/support/random_triangles.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Triangles and their pixels

using Triangle = std::array<glm::ivec3, 3>;

/// The sample rule by its definition: the sign of the edge function at the pixel's centre, if 0 the sign
/// of its x coefficient, if 0 that of its y coefficient; in 128 bits.
bool owns(std::span<const glm::ivec3> p, int i, int j) {
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

/// Random triangles of every size, from a part of a pixel to far more than the picture, at, across and beyond
/// its borders, on and off the lattice of ties.
class Triangles {
 public:
  explicit Triangles(unsigned seed) : rng_{seed} {}

  int uniform(int low, int high) { return std::uniform_int_distribution{low, high}(rng_); }
  /// At the vertices of a triangle: anywhere in the range, or at its ends.
  std::array<double, 3> values() {
    std::array<double, 3> v{};
    const int kind = uniform(0, 3);
    for (double& value : v) {
      value = std::uniform_real_distribution{kLeastValue, kLargestValue}(rng_);
      if (kind == 0) value = uniform(0, 1) != 0 ? kLeastValue : kLargestValue;
    }
    return v;
  }
  /// Counter-clockwise as seen, with an area.
  Triangle triangle(int width, int height) {
    static constexpr std::array kSides{1, 2, 4, 8, 9, 16, 30, 60, 200, 8000};
    const int side = kSides[uniform(0, kSides.size() - 1)], step = uniform(0, 1) != 0 ? 1 : kGrid / 2;
    const auto within = [&](int low, int high) {
      return uniform(low * (kGrid / step), high * (kGrid / step));
    };
    Triangle p;
    do {
      const glm::ivec3 at{within(-side, width), within(-side, height), 0};
      for (glm::ivec3& v : p) v = (at + glm::ivec3{within(0, side), within(0, side), 0}) * step;
    } while (doubleArea(p.data(), 3) == 0);
    if (doubleArea(p.data(), 3) < 0) std::swap(p[1], p[2]);
    return p;
  }

 private:
  std::mt19937 rng_;
};

/// Tables without a pattern, so that a wrong index gives a wrong cell.
std::vector<std::uint8_t> randomTable(unsigned seed) {
  std::mt19937 rng{seed};
  std::vector<std::uint8_t> table(65'536);
  std::ranges::generate(table, [&] { return static_cast<std::uint8_t>(rng()); });
  return table;
}

struct Checked {
  int samples = 0, pieces = 0, small = 0, large = 0, clipped = 0;
};
constexpr std::uint8_t kGround = 7;

/// Fills a triangle, and again row by row in pieces of any length; compares both with a plain loop over all
/// pixels: the rule's definition decides, `cellAt` is what the shader should give.
template <class S, class CellAt>
void expectCells(Triangles& random, const Triangle& p, int width, int height, const S& shader,
                 CellAt&& cellAt, Checked& checked) {
  IndexImage image{width, height, kGround}, pieces = image;
  fillConvex(image, p.data(), 3, shader);
  forEachSpan(p.data(), 3, width, height, [&](int row, int from, int to) {
    for (int i = from, end = 0; i < to; i = end, ++checked.pieces) {
      end = std::min(to, i + random.uniform(1, 1 << random.uniform(0, 7)));
      shader.span(pieces.row(row) + i, i, row, end - i);
    }
  });
  int samples = 0;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      const bool owned = owns(p, i, j);
      samples += owned;
      const std::uint8_t cell = owned ? cellAt(i, j) : kGround;
      ASSERT_EQ(image.row(j)[i], cell) << "pixel " << i << ", " << j;
      ASSERT_EQ(pieces.row(j)[i], cell) << "in pieces, pixel " << i << ", " << j;
    }
  const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
  checked.samples += samples;
  if (samples == 0) return;
  ++(sampleFrom(right) - sampleFrom(left) <= 8 && sampleFrom(bottom) - sampleFrom(top) <= 8 ? checked.small
                                                                                            : checked.large);
  checked.clipped += left < 0 || top < 0 || right > width * kGrid || bottom > height * kGrid;
}

/// The shader and its plain definition that `make` gives for a triangle.
template <class Make>
void expectShader(Make&& make) {
  Checked checked;
  const Seeds seeds{8000};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    Triangles random{seed};
    const bool narrow = seed % 7 == 0;
    const int width = narrow ? random.uniform(1, 20) : 150, height = narrow ? random.uniform(1, 12) : 60;
    const Triangle p = random.triangle(width, height);
    const auto [shader, cellAt] = make(random, p);
    expectCells(random, p, width, height, shader, cellAt, checked);
    if (testing::Test::HasFatalFailure()) return;
  }
  if (!seeds.all()) return;
  EXPECT_GT(checked.samples, 500'000);  // all of it was exercised
  EXPECT_GT(checked.pieces, 50'000);
  EXPECT_GT(checked.small, 1500);
  EXPECT_GT(checked.large, 1500);
  EXPECT_GT(checked.clipped, 1000);
}

TEST(Fill, GouraudLinearIsTheWholePartOfTheValue) {
  expectShader([](Triangles& random, const Triangle& p) {
    const AffineValue value = affineOver(p.data(), random.values());
    return std::pair{GouraudLinear{value},
                     [value](int i, int j) { return static_cast<std::uint8_t>(value.at(i, j) >> 24); }};
  });
}

// The cells begin anywhere: evenly, and many of them at the same or at neighbouring values.
TEST(Fill, GouraudTableIsFoundByTheValue) {
  std::vector<std::uint32_t> begins;
  for (std::uint32_t j = 1; j < 200; ++j) begins.push_back(j * 0x0123'4567);
  for (std::uint32_t j = 0; j < 40; ++j) begins.push_back(0xF000'0000 + j / 3);
  const CellsByKey cellsOf{10, begins};
  expectShader([&](Triangles& random, const Triangle& p) {
    const AffineValue value = affineOver(p.data(), random.values());
    return std::pair{GouraudTable{value, &cellsOf}, [&begins, value](int i, int j) {
                       const auto begun = [&](std::uint32_t begin) { return begin <= value.at(i, j); };
                       return static_cast<std::uint8_t>(10 + std::ranges::count_if(begins, begun));
                     }};
  });
}

// A map's marked samples are counted only in triangles that meet the box of the marks, and yet as many are
// found as by a plain loop. This holds for any box, also if values at the vertices lie on its edge and values
// between them, rounded, lie one step beyond.
TEST(Fill, CountsInTheBoxOfTheMarksWhatAllSamplesHave) {
  constexpr std::uint8_t kMark = 0, kFull = 200;
  std::vector<std::uint8_t> unmarked = randomTable(4);
  std::ranges::replace(unmarked, kMark, kFull);
  int meeting = 0, missing = 0, onTheEdge = 0;
  const Seeds seeds{8000};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    Triangles random{seed};
    const Triangle p = random.triangle(150, 60);
    std::vector<std::uint8_t> map = unmarked, plainly = unmarked;
    const int left = random.uniform(0, 255), right = random.uniform(left, 255);
    const int top = random.uniform(0, 255), bottom = random.uniform(top, 255);
    for (int row = top; row <= bottom; ++row)
      for (int column = left; column <= right; ++column)
        if (random.uniform(0, 3) != 0) map[256 * row + column] = kMark, plainly[256 * row + column] = kFull;
    const MapBox box{map, kMark};

    // Anywhere, or within the box, or beyond it with two vertices exactly at its edge.
    const auto steps = [&](int first, int last) {
      const auto value = [&](int low, int high) {
        const int place = std::clamp(random.uniform(std::min(low, high), high), 1, 254);
        return valueSteps(place + random.uniform(0, 255) / 256.0);
      };
      const std::uint32_t edge = valueSteps(std::clamp(last + 1, 1, 254));
      switch (random.uniform(0, 2)) {
        case 0:
          return std::array{value(1, 254), value(1, 254), value(1, 254)};
        case 1:
          return std::array{value(first, last), value(first, last), value(first, last)};
        default:
          return std::array{edge, edge, value(last + 1, 254)};
      }
    };
    const std::array u = steps(left, right), v = steps(top, bottom);
    const AffineOver over{p.data()};
    const AffineValue column = over(u.data()), row = over(v.data());

    std::int64_t counted = 0, expected = 0;
    IndexImage image{150, 60, kGround}, plain = image;
    const EnvironmentMap cells{column, row, map.data()};
    if (box.meets(u, v))
      fillConvex(image, p.data(), 3, Counted{cells, kMark, kFull, &counted});
    else
      fillConvex(image, p.data(), 3, cells);
    fillConvex(plain, p.data(), 3, EnvironmentMap{column, row, plainly.data()});
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 150; ++i)
        expected += owns(p, i, j) && map[256 * (row.at(i, j) >> 24) + (column.at(i, j) >> 24)] == kMark;
    ASSERT_EQ(counted, expected);
    ASSERT_EQ(image.pixels, plain.pixels);
    ++(box.meets(u, v) ? meeting : missing);
    const auto outside = [](const std::array<std::uint32_t, 3>& at, int first, int last) {
      const auto [least, most] = std::ranges::minmax(at);
      return static_cast<int>(most >> 24) < first || static_cast<int>(least >> 24) > last;
    };
    onTheEdge += expected > 0 && (outside(u, box.left, box.right) || outside(v, box.top, box.bottom));
  }
  if (!seeds.all()) return;
  EXPECT_GT(meeting, 1500);
  EXPECT_GT(missing, 500);
  EXPECT_GT(onTheEdge, 0);
}

// A sample faces away where the third value is below 128.
TEST(Fill, WhatFacesAwayIsDark) {
  const std::vector<std::uint8_t> map = randomTable(3);
  expectShader([&](Triangles& random, const Triangle& p) {
    const AffineValue u = affineOver(p.data(), random.values()), v = affineOver(p.data(), random.values()),
                      w = affineOver(p.data(), random.values());
    return std::pair{EitherSide<EnvironmentMap, FlatCell>{{u, v, map.data()}, {99}, w},
                     [&map, u, v, w](int i, int j) {
                       if (w.at(i, j) >> 24 < 128) return std::uint8_t{99};
                       return map[256 * (v.at(i, j) >> 24) + (u.at(i, j) >> 24)];
                     }};
  });
}

// The change of side is exact, also if the value is 128 at a sample, and whether it rises or falls, slowly or
// fast.
TEST(Fill, FacesFromExactly128On) {
  constexpr int kColumns = 40;
  constexpr std::uint32_t kTurn = 1u << 31;
  for (const std::uint32_t step : {1u, 2u, 3u, 1000u, 1u << 24, 1u << 25})
    for (int turn = -1; turn <= kColumns; ++turn)
      for (const std::uint32_t off : {0u, 1u, step - 1})
        for (const bool rises : {true, false}) {
          const std::uint32_t gx = rises ? step : 0 - step;
          const AffineValue facing{kTurn + off - static_cast<std::uint32_t>(turn) * gx, gx, 0};
          std::array<std::uint8_t, kColumns> cells{};
          EitherSide<FlatCell, FlatCell>{{200}, {99}, facing}.span(cells.data(), 0, 0, kColumns);
          for (int i = 0; i < kColumns; ++i)
            ASSERT_EQ(cells[i], facing.at(i, 0) >= kTurn ? 200 : 99) << step << ", " << turn << ", " << i;
        }
}

/// ---- Scanlines

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

// A span of any length fills its own cells and none next to them, also where stores overlap.
TEST(Scanline, SpansAreFilledToTheirEnds) {
  for (int count = 1; count <= 80; ++count) {
    std::array<std::uint8_t, 100> cells{};
    fillSpan(cells.data() + 10, count, 201);
    for (int i = 0; i < 100; ++i) ASSERT_EQ(cells[i], i >= 10 && i < 10 + count ? 201 : 0) << count;
  }
}

/// ---- Scan conversion as in the course

using Outline = std::vector<glm::ivec3>;

/// A convex polygon: the corners of a random box that a random line does not cut off, on a coarse or a fine
/// grid, so that samples on edges occur.
Outline randomOutline(std::mt19937& rng, int extent, int unit) {
  const auto coordinate = [&] { return static_cast<int>(rng() % (extent / unit)) * unit; };
  for (;;) {
    Outline p;
    for (int k = 0; k < 3; ++k) p.push_back({coordinate(), coordinate(), 0});
    const std::int64_t area = doubleArea(p.data(), 3);
    if (area == 0) continue;
    if (area < 0) std::swap(p[0], p[1]);
    // A fourth corner beyond the side from 2 to 0 makes a convex quadrilateral, if all turns are to the left.
    p.push_back({coordinate(), coordinate(), 0});
    const auto turns = [&](int a, int b, int c) {
      const Outline t{p[a], p[b], p[c]};
      return doubleArea(t.data(), 3) > 0;
    };
    if (!turns(1, 2, 3) || !turns(2, 3, 0) || !turns(3, 0, 1)) p.pop_back();
    return p;
  }
}

// The filler owns the samples that the edges, one by one, say: for large and small polygons, for corners on
// samples and far outside the picture.
TEST(ScanConversion, IsWhatTheFillerDoes) {
  std::mt19937 rng{1};
  int corners = 0, samples = 0;
  for (const auto& [pixels, unit] : {std::pair{40, 1}, {12, kGrid / 2}, {8192, 1}, {300, kGrid / 4}})
    for (int k = 0; k < (pixels > 1000 ? 20 : 2000); ++k) {
      Outline p = randomOutline(rng, pixels * kGrid, unit);
      for (glm::ivec3& v : p) v.x -= kGrid * (pixels / 4), v.y -= kGrid * (pixels / 4);
      const int side = pixels / 2;
      std::vector<std::array<int, 3>> byCourse, byFiller;  // a row, and from which column to which
      for (const ScanSpan& span : spansOf(edgesOf(p))) {
        const int from = std::max(0, span.from), to = std::min(side, span.to);
        if (span.row >= 0 && span.row < side && from < to) byCourse.push_back({span.row, from, to});
      }
      forEachSpan(p.data(), static_cast<int>(p.size()), side, side, [&](int row, int from, int to) {
        byFiller.push_back({row, from, to});
        samples += to - from;
      });
      ASSERT_EQ(byCourse, byFiller);
      corners += static_cast<int>(p.size());
    }
  EXPECT_GT(corners, 3 * 6'000 + 1'000) << "some have four corners";
  EXPECT_GT(samples, 1'000'000);
}

// The edges of a triangle of the book, by hand. Its corners are (1, 1), (1, 5) and (5, 1) in pixels.
TEST(ScanConversion, EdgesByHand) {
  const std::vector<ScanEdge> edges =
      edgesOf(Outline{{kGrid, kGrid, 0}, {kGrid, 5 * kGrid, 0}, {5 * kGrid, kGrid, 0}});
  ASSERT_EQ(edges.size(), 2u) << "the top side is horizontal";
  EXPECT_TRUE(edges[0].left);
  EXPECT_EQ(edges[0].step(), 0.0);
  EXPECT_EQ(edges[1].step(), -1.0);
  EXPECT_EQ(edges[1].x(1), 4.5);
}

/// ---- Additions from pixel to pixel

// With 24 bits the textbook's increments are the filler's, bit by bit, from slivers to the largest triangles
// and also where a rounding is a tie.
TEST(Stepping, IsTheFillersPlane) {
  RandomTriangles random{11};
  const int kRounds = kSanitized ? 500 : 4'000;
  int ties = 0;
  for (const double size : {0.001, 0.5, 3.0, 40.0, 2000.0, 8000.0})
    for (int k = 0; k < kRounds; ++k) {
      auto p = random.outline(size);
      std::array v{random.uniform(1, 255), random.uniform(1, 255), random.uniform(1, 255)};
      if (k % 3 == 0) {  // a right angle, sides that are powers of two, and odd differences of values
        const int side = kGrid << (k % 9);
        p[1] = p[0] + glm::ivec3{0, side, 0}, p[2] = p[0] + glm::ivec3{side, 0, 0};
        v[1] = v[0] + (k % 2) * 0x1p-24;
        ++ties;
      }
      if (doubleArea(p.data(), 3) <= 0) continue;
      const SteppedPlane plane = steppedOver(p, v, 24);
      const AffineValue fast = affineOver(p.data(), v);
      ASSERT_EQ(static_cast<std::uint32_t>(plane.c), fast.c) << size << ' ' << k;
      ASSERT_EQ(static_cast<std::uint32_t>(plane.perColumn), fast.gx) << size << ' ' << k;
      ASSERT_EQ(static_cast<std::uint32_t>(plane.perRow), fast.gy) << size << ' ' << k;
    }
  EXPECT_GT(ties, kRounds);
}

/// ---- Interpolation

// The weighted sum is the plane that the fillers evaluate, at any pixel and for any size of triangle.
TEST(Interpolation, IsTheFillersPlane) {
  RandomTriangles random{7};
  for (const double size : {0.5, 3.0, 40.0, 2000.0})
    for (int k = 0; k < 500; ++k) {
      const auto p = random.outline(size);
      const std::array v{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
      const PixelPlanes planes{p};
      const PixelPlane plane = planes(v);
      const int i = (p[0].x + p[1].x + p[2].x) / 3 / kGrid, j = (p[0].y + p[1].y + p[2].y) / 3 / kGrid;
      const double filled = plane.c + plane.gx * (i - planes.i0()) + plane.gy * (j - planes.j0());
      const Weights weights = weightsOnScreen(p, i, j);
      ASSERT_NEAR(weights[0] + weights[1] + weights[2], 1.0, 1e-9 * (1 + std::abs(filled)));
      ASSERT_NEAR(interpolated(weights, v), filled, 1e-7 * (1 + std::abs(filled)));
    }
}

}  // namespace

}  // namespace xnewell::THIS_FILE
