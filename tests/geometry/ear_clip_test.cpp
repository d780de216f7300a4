#include "geometry/model/ear_clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace xnewell::THIS_FILE {

namespace {

using Outline = std::vector<LatticePoint>;
using Triangles = std::vector<std::array<int, 3>>;

/// Twice the signed area of a closed outline.
Int128 area(const Outline& p) {
  Int128 sum = 0;
  for (std::size_t i = 2; i < p.size(); ++i) sum += turn(p[0], p[i - 1], p[i]);
  return sum;
}

/// How often the outline runs around q counter-clockwise. q must not be on an edge.
int windingNumber(const Outline& p, const LatticePoint& q) {
  int winding = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const LatticePoint &a = p[i], &b = p[(i + 1) % p.size()];
    if ((a.y <= q.y) == (b.y <= q.y)) continue;
    if (a.y <= q.y && turn(a, b, q) > 0) ++winding;
    if (b.y <= q.y && turn(a, b, q) < 0) --winding;
  }
  return winding;
}

bool onSegment(const LatticePoint& a, const LatticePoint& b, const LatticePoint& q) {
  return turn(a, b, q) == 0 && std::min(a.x, b.x) <= q.x && q.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= q.y && q.y <= std::max(a.y, b.y);
}

/// Expects n - 2 counter-clockwise triangles whose areas sum to the outline's. With this total, triangles can
/// overlap only if some area is left uncovered, so samples are checked too.
void expectTiling(const Outline& p, const Triangles& triangles, bool checkSamples) {
  ASSERT_EQ(triangles.size(), p.size() - 2);
  Int128 sum = 0;
  int backwards = 0;
  for (const auto& [a, b, c] : triangles) {
    const Int128 twice = turn(p[a], p[b], p[c]);
    backwards += twice <= 0;
    sum += twice;
  }
  EXPECT_EQ(backwards, 0);
  EXPECT_TRUE(sum == area(p));
  if (!checkSamples) return;
  // Samples lie off the lattice, because outlines are multiples of 6.
  LatticePoint low = p[0], high = p[0];
  for (const LatticePoint& q : p) {
    low = {std::min(low.x, q.x), std::min(low.y, q.y)};
    high = {std::max(high.x, q.x), std::max(high.y, q.y)};
  }
  int inside = 0;
  for (std::int64_t x = low.x + 1; x < high.x; x += 6)
    for (std::int64_t y = low.y + 2; y < high.y; y += 6) {
      const LatticePoint q{x, y};
      int holders = 0;
      bool onSide = false;
      for (const auto& t : triangles) {
        bool in = true;
        for (int i = 0; i < 3; ++i) {
          const LatticePoint &a = p[t[i]], &b = p[t[(i + 1) % 3]];
          onSide = onSide || onSegment(a, b, q);
          in = in && turn(a, b, q) > 0;
        }
        holders += in;
      }
      if (onSide) continue;
      const int expected = windingNumber(p, q);
      inside += expected;
      EXPECT_EQ(holders, expected) << x << ' ' << y;
    }
  EXPECT_GT(inside, 0);
}

/// Expects no corner of the outline in the middle of a triangle's side: neighbours would leave a gap there.
void expectNoCornerOnASide(const Outline& p, const Triangles& triangles) {
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const LatticePoint &a = p[t[i]], &b = p[t[(i + 1) % 3]];
      for (const LatticePoint& q : p) EXPECT_FALSE(onSegment(a, b, q) && q != a && q != b);
    }
}

/// A polygon around the origin with its corners sorted by direction. It is simple, because no two directions
/// are equal and no gap between them exceeds a right angle.
Outline randomStar(std::mt19937& rng, int wanted, int reach) {
  std::uniform_int_distribution<int> coordinate{-reach, reach};
  Outline p{{6 * reach, 0}, {0, 6 * reach}, {-6 * reach, 0}, {0, -6 * reach}};
  for (int i = 4; i < wanted; ++i) p.push_back({6 * coordinate(rng), 6 * coordinate(rng)});
  std::erase(p, LatticePoint{});
  const auto upper = [](const LatticePoint& q) { return q.y > 0 || (q.y == 0 && q.x > 0); };
  const LatticePoint O{};
  std::stable_sort(p.begin(), p.end(), [&](const LatticePoint& a, const LatticePoint& b) {
    return upper(a) != upper(b) ? upper(a) : turn(O, a, b) > 0;
  });
  p.erase(std::unique(p.begin(), p.end(),
                      [&](const LatticePoint& a, const LatticePoint& b) {
                        return upper(a) == upper(b) && turn(O, a, b) == 0;
                      }),
          p.end());
  return p;
}

/// A simple polygon without any order. It starts from random points and exchanges crossing edges until none
/// cross (each exchange shortens the tour, so this ends). No three points are in line.
Outline randomTangle(std::mt19937& rng, int n) {
  std::uniform_int_distribution<int> coordinate{0, 40};
  Outline p;
  while (static_cast<int>(p.size()) < n) {
    const LatticePoint q{6 * coordinate(rng), 6 * coordinate(rng)};
    bool inLine = false;
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) inLine = inLine || turn(p[i], p[j], q) == 0;
    if (!inLine && (p.empty() || q != p[0])) p.push_back(q);
  }
  const auto left = [](const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
    return turn(a, b, c) > 0;
  };
  for (bool crossed = true; crossed;) {
    crossed = false;
    for (int i = 0; i + 2 < n; ++i)
      for (int j = i + 2; j < n; ++j) {
        const LatticePoint &a = p[i], &b = p[i + 1], &c = p[j], &d = p[(j + 1) % n];
        if (a == d || left(a, b, c) == left(a, b, d) || left(c, d, a) == left(c, d, b)) continue;
        std::reverse(p.begin() + i + 1, p.begin() + j + 1);
        crossed = true;
      }
  }
  if (area(p) < 0) std::reverse(p.begin(), p.end());
  return p;
}

/// Teeth of random height over a base line. Many corners are in line, also on the base.
Outline randomHistogram(std::mt19937& rng, int columns) {
  std::uniform_int_distribution<int> height{1, 4};
  Outline p;
  for (int x = 0; x <= columns; ++x) p.push_back({6 * x, 0});
  for (int x = columns - 1; x >= 0; --x) {
    const int h = 6 * height(rng);
    p.push_back({6 * (x + 1), h});
    p.push_back({6 * x, h});
  }
  p.erase(std::unique(p.begin(), p.end()), p.end());
  return p;
}

/// n needles on a spine.
Outline comb(int n) {
  Outline p{{0, -1}, {4 * n, -1}};
  for (int i = n - 1; i >= 0; --i) {
    p.push_back({4 * i + 3, 0});
    p.push_back({4 * i + 2, 1'000'000});
    p.push_back({4 * i + 1, 0});
  }
  return p;
}

/// A band that winds `turns` times about the origin, 2 n corners.
Outline spiral(int n, int turns) {
  Outline p(2 * n);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.141592653589793 * turns * i / n, r = 1e6 + 1e6 * turns * i / n;
    const double x = std::cos(angle), y = std::sin(angle);
    p[i] = {std::lround((r + 4e5) * x), std::lround((r + 4e5) * y)};
    p[2 * n - 1 - i] = {std::lround(r * x), std::lround(r * y)};
  }
  return p;
}

/// A star with n tips and inner corners at a random radius. `crowd` squeezes half of them into a millionth of
/// the turn.
Outline star(int n, bool crowd) {
  std::mt19937 rng{1};
  std::uniform_real_distribution<double> radius{0.2, 0.9};
  Outline p;
  for (int i = 0; i < n; ++i) {
    double turnPart = static_cast<double>(i) / n;
    if (crowd) turnPart = turnPart < 0.5 ? turnPart * 1e-6 : turnPart * 2 - 1;
    if (crowd && i >= n / 2) turnPart = 1e-6 + turnPart * (1 - 1e-6);
    const double angle = 2 * 3.141592653589793 * turnPart, r = 0x1p48 * (i % 2 ? radius(rng) : 1.0);
    p.push_back({std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))});
  }
  return p;
}

}  // namespace

// The triangles tile a simple polygon: the number of triangles that hold a sample is the winding number.
TEST(ClipEars, TilesRandomStars) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const Outline p = randomStar(rng, 4 + static_cast<int>(seed % 40), 3 + static_cast<int>(seed % 9));
    const Triangles triangles = clipEars(p);
    expectTiling(p, triangles, true);
    expectNoCornerOnASide(p, triangles);
  }
}

// The same for outlines without any order.
TEST(ClipEars, TilesRandomTangles) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const Outline p = randomTangle(rng, 4 + static_cast<int>(seed % 30));
    expectTiling(p, clipEars(p), seed % 10 == 0);
  }
}

// The same where many corners are in line. Each of them is used.
TEST(ClipEars, UsesCornersOnStraightSides) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const Outline p = randomHistogram(rng, 2 + static_cast<int>(seed % 12));
    const Triangles triangles = clipEars(p);
    expectTiling(p, triangles, true);
    expectNoCornerOnASide(p, triangles);
  }
}

// A triangle with k corners on each side has no reflex corner, but it must not be cut along a side.
TEST(ClipEars, TriangleWithCornersOnItsSides) {
  for (int k = 1; k < 12; ++k) {
    Outline p;
    for (int i = 0; i < k; ++i) p.push_back({6 * i, 0});
    for (int i = 0; i < k; ++i) p.push_back({6 * k, 6 * i});
    for (int i = k; i > 0; --i) p.push_back({6 * i, 6 * i});
    const Triangles triangles = clipEars(p);
    expectTiling(p, triangles, k > 1);
    expectNoCornerOnASide(p, triangles);
  }
}

// A hole that is joined to the outside by an edge, run along twice, is left out.
TEST(ClipEars, LeavesOutAHoleJoinedByABridge) {
  const Outline p{{0, 0},   {60, 0},  {60, 60}, {0, 60},  {0, 0},
                  {18, 18}, {18, 42}, {42, 36}, {36, 18}, {18, 18}};
  const Outline hole{{18, 18}, {36, 18}, {42, 36}, {18, 42}};
  EXPECT_TRUE(area(p) == 2 * 60 * 60 - area(hole));
  expectTiling(p, clipEars(p), true);
}

// At the largest coordinates the cuts are the same as at a small scale.
TEST(ClipEars, IsExactAtTheLimits) {
  const std::int64_t k = std::int64_t{1} << 58;
  std::mt19937 rng{58};
  for (int round = 0; round < 50; ++round) {
    const Outline p = randomHistogram(rng, 5);  // at most 30 steps wide
    Outline huge;
    for (const LatticePoint& q : p) huge.push_back({q.x / 6 * (k / 8), q.y / 6 * (k / 8)});
    EXPECT_EQ(clipEars(p), clipEars(huge));
  }
}

// For every outline the function ends with n - 2 triangles of three different corners each.
TEST(ClipEars, EndsOnOutlinesThatCrossThemselves) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    std::mt19937 rng{seed};
    std::uniform_int_distribution<int> coordinate{0, seed % 3 ? 4 : 1000};
    Outline p(3 + seed % 30);
    for (LatticePoint& q : p) q = {coordinate(rng), seed % 5 ? coordinate(rng) : 0};
    const Triangles triangles = clipEars(p);
    ASSERT_EQ(triangles.size(), p.size() - 2);
    std::vector<int> uses(p.size(), 0);
    for (const auto& [a, b, c] : triangles) {
      EXPECT_TRUE(a != b && b != c && c != a);
      for (const int corner : {a, b, c}) ++uses[corner];
    }
    EXPECT_EQ(std::count(uses.begin(), uses.end(), 0), 0);
  }
}

// Large outlines of the shapes that make naive clipping quadratic. The tiling is right, and the test ends
// within its time limit.
TEST(ClipEars, LargeCombSpiralAndStars) {
  for (const Outline& p :
       {comb(33'333), spiral(50'000, 10), spiral(50'000, 500), star(100'000, false), star(100'000, true)})
    expectTiling(p, clipEars(p), false);
}

}  // namespace xnewell::THIS_FILE
