#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "geometry/exact/int128.h"
#include "geometry/exact/overlap.h"
#include "geometry/exact/plane.h"
#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"
#include "geometry/exact/wide_int128.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Whole numbers of 128 bits

using Unbounded = boost::multiprecision::cpp_int;

/// A number of up to `bits` bits, often near a power of two, in all three types at once.
struct Number {
  Int128 own;
  WideInt128 wide;
  Unbounded exact;
};
Number randomNumber(std::mt19937& rng, unsigned bits) {
  const auto length = static_cast<unsigned>(rng() % (bits + 1));
  Number n{};
  for (unsigned at = 0; at < length; at += 16) {
    const unsigned digits = std::min(16U, length - at);
    const int kind = static_cast<int>(rng() % 3);
    const int digit = static_cast<int>(kind ? kind == 1 ? 0 : (1U << digits) - 1 : rng() % (1U << digits));
    n.own = (n.own << digits) + digit;
    n.wide = (n.wide << digits) + digit;
    n.exact = (n.exact << digits) + digit;
  }
  if (rng() % 2) n = {Int128{-n.own}, WideInt128{-n.wide}, Unbounded{-n.exact}};
  return n;
}

/// The bits of an integer as words of 32 bits, by division alone.
template <class Integer>
Unbounded exactly(Integer n) {
  const bool negative = n < 0;
  Unbounded sum = 0, unit = 1;
  for (; n != 0; n /= std::int64_t{1} << 32, unit <<= 32)
    sum += unit * static_cast<std::int64_t>(n % (std::int64_t{1} << 32));
  EXPECT_EQ(sum < 0, negative);
  return sum;
}

/// Whether what both types made of the same numbers is the exact result.
void same(const Int128& own, const WideInt128& wide, const Unbounded& exact) {
  ASSERT_EQ(exactly(own), exact);
  ASSERT_EQ(exactly(wide), exact);
  ASSERT_EQ(approximately(own), approximately(wide));
  ASSERT_LE(abs(Unbounded{approximately(own)} - exact), abs(exact) >> 52);
}

// The compiler's integer and the one for compilers without any give the exact results of sums, products,
// quotients, shifts and masks, wherever these fit. So do their casts.
TEST(Int128, BothAreExact) {
  int below = 0;
  for (unsigned seed = 0; seed < 20'000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const Number a = randomNumber(rng, 126), b = randomNumber(rng, 126), c = randomNumber(rng, 63);
    same(a.own, a.wide, a.exact);
    same(a.own + b.own, a.wide + b.wide, a.exact + b.exact);
    same(a.own - b.own, a.wide - b.wide, a.exact - b.exact);
    const auto narrow = static_cast<std::int64_t>(c.own);
    ASSERT_EQ(narrow, static_cast<std::int64_t>(c.wide));
    ASSERT_EQ(narrow, static_cast<std::int64_t>(c.exact));
    const Number d = randomNumber(rng, 63);
    same(d.own * narrow, d.wide * narrow, d.exact * c.exact);
    same(Int128{narrow} * d.own, WideInt128{narrow} * d.wide, c.exact * d.exact);
    if (narrow != 0) {
      same(a.own / narrow, a.wide / narrow, a.exact / narrow);
      same(a.own % narrow, a.wide % narrow, a.exact % narrow);
    }
    const int shift = static_cast<int>(rng() % 100);
    const Unbounded unit = Unbounded{1} << shift, down = a.exact / unit - (a.exact % unit < 0 ? 1 : 0);
    same(a.own >> shift, a.wide >> shift, down);
    below += a.exact % unit < 0;
    const int up = static_cast<int>(rng() % 63);
    same(c.own << up, c.wide << up, c.exact * (Unbounded{1} << up));
    const Unbounded whole = Unbounded{1} << 64;
    const Unbounded masked = a.exact % whole + (a.exact % whole < 0 ? whole : Unbounded{0});
    same(a.own & ((Int128{1} << 64) - 1), a.wide & ((WideInt128{1} << 64) - 1), masked);
    ASSERT_EQ(a.own < b.own, a.exact < b.exact);
    ASSERT_EQ(a.wide < b.wide, a.exact < b.exact);
    ASSERT_EQ(a.own == b.own, a.wide == b.wide);
  }
  EXPECT_GT(below, 5'000);  // shifts of negative numbers that are no multiples
}

/// ---- Sines, cosines and angles

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

// The size of the pair does not matter. A reflection changes the angle as it should. Multiples of 45 degrees
// are exact. The kernels' search shows how near the angle comes, and the sine and the cosine above.
TEST(Trig, DegreesOfASineAndACosine) {
  std::mt19937 rng{91};
  std::uniform_real_distribution<double> coordinate{-1.0, 1.0};
  for (int i = 0; i < 10'000; ++i) {
    const double s = coordinate(rng), c = coordinate(rng), degrees = degreesOf(s, c);
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

/// ---- Planes and centroids by Newell's method

using Rational = boost::multiprecision::cpp_rational;

std::vector<int> all(std::size_t count) {
  std::vector<int> corners(count);
  std::iota(corners.begin(), corners.end(), 0);
  return corners;
}

// Against fractions: Green's formula in the coordinates of the plane. The polygons are stars, most of them
// concave, in planes of any slope and up to 2^40 of their sizes away from the origin; all their coordinates
// are whole numbers. A star is about 200 wide, so the result is the nearest double to within the rounding of
// its own coordinates, and of arithmetic on numbers below 2^12.
TEST(Centroid, IsThatOfTheAreaHoweverFarAway) {
  int concave = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const auto whole = [&](int low, int high) { return std::uniform_int_distribution<int>{low, high}(rng); };
    const int count = whole(4, 20);
    std::vector<std::array<std::int64_t, 2>> uv;
    for (int k = 0; k < count; ++k) {
      const double turn = 2 * 3.14159265358979 * (k + 0.4 * whole(0, 100) / 100.0) / count;
      const double radius = whole(20, 100);
      uv.push_back({std::llround(radius * std::cos(turn)), std::llround(radius * std::sin(turn))});
    }
    const std::int64_t far = seed % 3 == 0 ? 0 : std::int64_t{1} << whole(1, 47);
    std::array<std::array<std::int64_t, 3>, 3> axes;  // two directions, and the place of (0, 0)
    for (auto& axis : axes)
      for (auto& v : axis) v = whole(-4, 4);
    axes[0][seed % 3] = 7, axes[1][(seed + 1) % 3] = 9;
    for (auto& v : axes[2]) v += whole(0, 1) ? far : -far;

    std::vector<glm::dvec3> p;
    for (const auto& [u, v] : uv) {
      auto& corner = p.emplace_back();
      for (int axis = 0; axis < 3; ++axis)
        corner[axis] = static_cast<double>(axes[2][axis] + u * axes[0][axis] + v * axes[1][axis]);
    }
    Rational area = 0, sumU = 0, sumV = 0;
    bool turnsBack = false;
    for (int k = 0; k < count; ++k) {
      const auto &a = uv[k], &b = uv[(k + 1) % count], &c = uv[(k + 2) % count];
      const std::int64_t cross = a[0] * b[1] - b[0] * a[1];
      area += cross, sumU += (a[0] + b[0]) * cross, sumV += (a[1] + b[1]) * cross;
      turnsBack |= (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) < 0;
    }
    concave += turnsBack;
    const glm::dvec3 is = centroid(p, all(p.size()));
    for (int axis = 0; axis < 3; ++axis) {
      const Rational wanted = axes[2][axis] + (sumU * axes[0][axis] + sumV * axes[1][axis]) / (3 * area);
      const double off = static_cast<double>(Rational{is[axis]} - wanted);
      EXPECT_LE(std::abs(off), std::ldexp(std::abs(is[axis]), -53) + 0x1p-38);
    }
  }
  EXPECT_GT(concave, 1000);
}

// A triangle has the mean of its corners, to the bit; and so has a polygon without area. A polygon that
// crosses itself has no centroid to speak of, but the place is among its corners.
TEST(Centroid, OfTrianglesAndOfPolygonsWithoutArea) {
  std::mt19937 rng{4};
  std::uniform_real_distribution<double> any{-1, 1};
  for (int k = 0; k < 1000; ++k) {
    std::vector<glm::dvec3> p(4);
    for (glm::dvec3& corner : p) corner = {any(rng), any(rng), any(rng)};
    EXPECT_EQ(centroid(p, std::array{0, 1, 2}), p[0] + (p[1] - p[0] + (p[2] - p[0])) / 3.0);
    const glm::dvec3 bow = centroid(p, std::array{0, 2, 1, 3});
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(bow[axis], std::max({p[0][axis], p[1][axis], p[2][axis], p[3][axis]}) + 1e-15);
      EXPECT_GE(bow[axis], std::min({p[0][axis], p[1][axis], p[2][axis], p[3][axis]}) - 1e-15);
    }
  }
  const std::vector<glm::dvec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 0, 0}};
  EXPECT_EQ(centroid(line, all(4)), glm::dvec3(2, 0, 0));
}

/// ---- Boxes that overlap

/// Boxes of one kind: all sizes, or flat along some axes and large along others, on a lattice so that ends
/// meet, or many equal along one axis or along all. Groups have two boxes each, or most boxes are in one
/// large group.
std::vector<ItemBox> randomBoxes(unsigned seed) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<float> unit{0.0f, 1.0f};
  const unsigned kind = seed % 5;
  const bool large = seed % 2 == 0;
  std::vector<ItemBox> boxes;
  const int count = 10 + static_cast<int>(unit(rng) * 600.0f);
  for (int i = 0; i < count; ++i) {
    ItemBox& box = boxes.emplace_back(ItemBox{i, large && unit(rng) < 0.9f ? 0 : i / 2, {}, {}});
    for (int axis = 0; axis < 6; ++axis) {
      float low = unit(rng), length = 0.5f * unit(rng);
      if (kind == 1) length *= axis < 3 ? 1e-9f : 2.0f;
      if (kind == 2) low = std::floor(8.0f * low), length = std::floor(8.0f * length);
      if (kind == 3 && axis != 4) low = length = 0.0f;
      if (kind == 4) low = length = 0.25f;
      box.low[axis] = low, box.high[axis] = low + length;
    }
  }
  return boxes;
}

/// Small boxes along a surface, as those of a mesh are. One in a thousand is large.
std::vector<ItemBox> boxesOfASurface(unsigned seed) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<float> unit{0.0f, 1.0f};
  std::vector<ItemBox> boxes;
  for (int i = 0; i < static_cast<int>(kManyBoxes); ++i) {
    ItemBox& box = boxes.emplace_back(ItemBox{i, i / 2, {}, {}});
    const float s = unit(rng), t = unit(rng), length = unit(rng) < 1e-3f ? 0.5f : 0.02f;
    for (int axis = 0; axis < 6; ++axis) {
      box.low[axis] = std::sin(static_cast<float>(axis + 1) * s + 2.0f * static_cast<float>(axis % 2) * t);
      box.high[axis] = box.low[axis] + length * unit(rng);
    }
  }
  return boxes;
}

using Pairs = std::set<std::pair<int, int>>;

/// A comparison of every box with all boxes of other groups.
Pairs overlapping(std::span<const ItemBox> boxes) {
  Pairs pairs;
  for (const ItemBox& P : boxes)
    for (const ItemBox& Q : boxes)
      if (P.item < Q.item && P.group != Q.group && overlap(P, Q)) pairs.insert({P.item, Q.item});
  return pairs;
}

Pairs visited(std::vector<ItemBox> boxes) {
  Pairs pairs;
  forOverlapping(std::span{boxes}, [&](int i, int j) {
    ASSERT_NE(i, j);
    pairs.insert(std::minmax(i, j));
  });
  return pairs;
}

// The function finds exactly the pairs that a comparison of every box with all boxes of other groups finds.
TEST(Overlap, FindsEveryPair) {
  const Seeds seeds{200};
  std::size_t found = 0, apart = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<ItemBox> boxes = randomBoxes(seed);
    const Pairs expected = overlapping(boxes);
    apart += boxes.size() * (boxes.size() - 1) / 2 - expected.size();
    EXPECT_EQ(visited(boxes), expected);
    found += expected.size();
  }
  if (!seeds.all()) return;
  EXPECT_GT(found, 100'000u);
  EXPECT_GT(apart, 100'000u);
}

// It finds them among so many boxes that they are put into cells, too. Some boxes reach across many cells.
TEST(Overlap, FindsEveryPairInCells) {
  const Seeds seeds{8};
  int cells = 0;
  std::size_t found = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<ItemBox> boxes = boxesOfASurface(seed);
    const Pairs expected = overlapping(boxes);
    EXPECT_EQ(visited(boxes), expected);
    found += expected.size();
    const auto boxAt = [&](std::size_t k) { return boxes[k]; };
    cells += BoxCells{boxes.size(), boxAt}.lists(boxes.size(), boxAt).cells();
  }
  if (!seeds.all()) return;
  EXPECT_GT(found, 1'000u);
  EXPECT_GT(cells, 1'000);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
