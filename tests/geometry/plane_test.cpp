#include "geometry/exact/plane.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace xnewell::THIS_FILE {

namespace {

using Rational = boost::multiprecision::cpp_rational;

std::vector<int> all(std::size_t count) {
  std::vector<int> corners(count);
  std::iota(corners.begin(), corners.end(), 0);
  return corners;
}

}  // namespace

// The unit square in the plane z = 2, counter-clockwise from above: N = +z, d = 2, vector area 2 * 1.
TEST(Plane, OfASquareByNewellsMethod) {
  const std::array<glm::dvec3, 4> p{{{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}}};
  const std::array corners{0, 1, 2, 3};
  EXPECT_EQ(newellVector(p, corners), glm::dvec3(0, 0, 2));
  EXPECT_EQ(newellPlane(p, corners).N, glm::dvec3(0, 0, 1));
  EXPECT_EQ(newellPlane(p, corners).d, 2.0);
}

// Corners on the sides of a polygon do not move its centroid: here four on one side of a square.
TEST(Centroid, CornersOnASideDoNotMoveIt) {
  const std::vector<glm::dvec3> p{{0, 0, 2},   {0.125, 0, 2}, {0.25, 0, 2}, {0.375, 0, 2},
                                  {0.5, 0, 2}, {1, 0, 2},     {1, 1, 2},    {0, 1, 2}};
  EXPECT_EQ(centroid(p, all(p.size())), glm::dvec3(0.5, 0.5, 2));
  EXPECT_EQ(centroid(p, std::array{0, 5, 6, 7}), glm::dvec3(0.5, 0.5, 2));
}

// An L of three unit squares: the centroid is the mean of their centres, whichever corner is the first.
TEST(Centroid, OfAConcavePolygon) {
  const std::vector<glm::dvec3> p{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  for (int first = 0; first < 6; ++first) {
    std::vector<int> corners(6);
    for (int k = 0; k < 6; ++k) corners[k] = (first + k) % 6;
    const glm::dvec3 c = centroid(p, corners);
    EXPECT_NEAR(c.x, 2.5 / 3, 1e-15) << first;
    EXPECT_NEAR(c.y, 2.5 / 3, 1e-15) << first;
    EXPECT_EQ(c.z, 0) << first;
  }
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

}  // namespace xnewell::THIS_FILE
