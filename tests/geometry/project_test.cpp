#include "geometry/view/project.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <utility>

namespace xnewell {

namespace {

/// Looks down the z axis at the square [-1, 1]^2 of the plane z = 0, from distance 4.
ViewSpec fromAbove(Projection projection) {
  return {projection, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0, 4}, {-1, -1}, {1, 1}, 3.75, -4};
}

SnappedScene projected(const Mesh& mesh, const ViewSpec& view, int size = 512, Cull cull = Cull::Keep) {
  return project(mesh, divideFaces(mesh), view, size, size, cull);
}

Mesh triangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  Mesh m;
  m.points = {a, b, c};
  const int corners[] = {0, 1, 2};
  m.addFace(corners, 0);
  return m;
}

}  // namespace

// Parallel view, 512 pixels for 2 units: (x, y) goes to 256 (1 + x), 256 (1 - y) pixels, and z to 256 (z -
// back).
TEST(Project, ParallelByHand) {
  const SnappedScene s =
      projected(triangle({-1, -1, 0}, {0.5, 0, 0}, {0, 1, 1}), fromAbove(Projection::Parallel));
  ASSERT_EQ(s.faces.size(), 1u);
  EXPECT_EQ(s.zShift, 0);
  EXPECT_EQ(s.vertices, (std::vector<glm::ivec3>{{0, 512 * kGrid, 1024 * kGrid},
                                                 {384 * kGrid, 256 * kGrid, 1024 * kGrid},
                                                 {256 * kGrid, 0, 1280 * kGrid}}));
  EXPECT_FALSE(s.faces[0].back);
}

// Perspective view from distance 4: at z = 2 everything is twice as large.
TEST(Project, PerspectiveByHand) {
  const SnappedScene s =
      projected(triangle({-0.5, -0.5, 2}, {0.5, -0.5, 0}, {0, 0.5, 2}), fromAbove(Projection::Perspective));
  ASSERT_EQ(s.faces.size(), 1u);
  const int expected[3][2] = {{0, 512}, {384, 384}, {256, 0}};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(s.vertices[i].x, expected[i][0] * kGrid);
    EXPECT_EQ(s.vertices[i].y, expected[i][1] * kGrid);
  }
  EXPECT_EQ(s.vertices[0].z, s.vertices[2].z);
  EXPECT_GT(s.vertices[0].z, s.vertices[1].z);  // larger is nearer
}

// Seen from behind, a face keeps its samples and its outline is reversed. Culling removes it and counts it.
TEST(Project, BackFaces) {
  const Mesh m = triangle({0, 0, 0}, {0, 1, 0}, {1, 0, 0});
  const SnappedScene kept = projected(m, fromAbove(Projection::Parallel));
  ASSERT_EQ(kept.faces.size(), 1u);
  EXPECT_TRUE(kept.faces[0].back);
  EXPECT_GT(doubleArea(kept.vertices.data(), 3), 0);
  const SnappedScene culled = projected(m, fromAbove(Projection::Parallel), 512, Cull::Back);
  EXPECT_TRUE(culled.faces.empty());
  EXPECT_EQ(culled.culled, 1);
}

// Faces without area on the grid are dropped and counted. The others keep their numbers.
TEST(Project, DropsAndCountsFacesWithoutArea) {
  Mesh m;
  m.points = {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e-9, 1e-9, 0}, {1e-9, 0, 0}};
  const std::vector<std::vector<int>> faces{{0, 1, 2}, {0, 0, 0}, {0, 4, 5}, {0, 2, 3}, {1, 3, 1}};
  for (const auto& f : faces) m.addFace(f, 0);
  const SnappedScene s = projected(m, fromAbove(Projection::Parallel));
  ASSERT_EQ(s.faces.size(), 1u);
  EXPECT_EQ(s.faces[0].number, 3);
  EXPECT_EQ(s.degenerate, 4);
}

// A mesh reaches through the front plane, behind the eye and a million pixels to the side. Both neighbours of
// every inner edge get the same clipped vertices. All vertices lie within the guard band.
TEST(Project, NeighboursShareClippedVertices) {
  int clippedEdges = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    std::uniform_real_distribution<double> wide{-40, 40}, deep{-3, 6};
    // Two triangles on the edge a b, listed in opposite directions as in a closed mesh.
    const glm::dvec3 a{wide(rng), wide(rng), deep(rng)}, b{wide(rng), wide(rng), deep(rng)};
    Mesh m;
    m.points = {a, b, {wide(rng), wide(rng), deep(rng)}, {wide(rng), wide(rng), deep(rng)}};
    const int first[] = {0, 1, 2}, second[] = {1, 0, 3};
    m.addFace(first, 0);
    m.addFace(second, 0);
    const SnappedScene s = projected(m, fromAbove(seed % 2 ? Projection::Perspective : Projection::Parallel));
    for (const glm::ivec3& v : s.vertices) {
      ASSERT_LE(std::abs(v.x), 1 << 29);
      ASSERT_LE(std::abs(v.y), 1 << 29);
      ASSERT_TRUE(v.z >= 0 && v.z <= 1 << 30);
    }
    if (s.faces.size() != 2) continue;
    // The visible part of the shared edge lies on both outlines, with the same two ends.
    const auto outline = [&](int f) {
      std::set<std::array<int, 3>> v;
      for (int i = 0; i < s.faces[f].count; ++i) {
        const glm::ivec3& p = s.vertices[s.faces[f].first + i];
        v.insert({p.x, p.y, p.z});
      }
      return v;
    };
    const auto one = outline(0), two = outline(1);
    int shared = 0;
    for (const auto& v : one) shared += static_cast<int>(two.count(v));
    // Clip the edge by itself, in the textbook's parametric form, to find out whether any of it is visible.
    const glm::dmat4 M =
        screenFromCanonical(fromAbove(seed % 2 ? Projection::Perspective : Projection::Parallel), 512, 512) *
        canonicalFromVrc(fromAbove(seed % 2 ? Projection::Perspective : Projection::Parallel));
    const glm::dvec4 A = M * glm::dvec4{a, 1}, B = M * glm::dvec4{b, 1};
    const double front =
        frontDepth(fromAbove(seed % 2 ? Projection::Perspective : Projection::Parallel), 512);
    double from = 0, to = 1;
    for (const auto& [ha, hb] : {std::pair{front * A.w - A.z, front * B.w - B.z},
                                 {A.z, B.z},
                                 {8192 * A.w + A.x, 8192 * B.w + B.x},
                                 {8192 * A.w - A.x, 8192 * B.w - B.x},
                                 {8192 * A.w + A.y, 8192 * B.w + B.y},
                                 {8192 * A.w - A.y, 8192 * B.w - B.y}}) {
      if (ha < 0 && hb < 0)
        to = -1;
      else if (ha < 0)
        from = std::max(from, ha / (ha - hb));
      else if (hb < 0)
        to = std::min(to, ha / (ha - hb));
    }
    if (to - from < 1e-6) continue;
    EXPECT_GE(shared, 2);
    clippedEdges += from > 0 || to < 1;
  }
  EXPECT_GT(clippedEdges, 30);
}

// A polygon with a million corners keeps its area: rounding its corners to the grid moves the outline by at
// most one step. Every part of it is convex and has a positive area.
TEST(Project, MillionCorners) {
  Mesh m;
  constexpr int kCorners = 1'000'000;
  std::vector<int> corners(kCorners);
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    m.points.push_back({0.8 * std::cos(angle), 0.8 * std::sin(angle), 0});
    corners[i] = i;
  }
  m.addFace(corners, 0);
  const SnappedScene s = projected(m, fromAbove(Projection::Parallel));
  double area = 0;
  for (const SnappedFace& f : s.faces) {
    ASSERT_EQ(f.number, 0);
    const std::int64_t twice = doubleArea(&s.vertices[f.first], f.count);
    ASSERT_GT(twice, 0);
    area += static_cast<double>(twice) / 2 / kGrid / kGrid;
  }
  const double radius = 0.8 * 256, perimeter = 2 * std::numbers::pi * radius;
  EXPECT_NEAR(area, std::numbers::pi * radius * radius, 2 * perimeter / kGrid);
}

// A point very near the eye makes z steps coarser than those of x and y. z never needs more than 30 bits.
TEST(Project, DepthKeepsItsBits) {
  ViewSpec view = fromAbove(Projection::Perspective);
  view.front = 4 - 1e-6;
  const SnappedScene s = projected(triangle({0, 0, 0}, {1e-7, 0, 4 - 2e-6}, {0, 1e-7, 4 - 2e-6}), view);
  ASSERT_EQ(s.faces.size(), 1u);
  EXPECT_GT(s.zShift, 0);
  int largest = 0;
  for (const glm::ivec3& v : s.vertices) largest = std::max(largest, v.z);
  EXPECT_TRUE(largest <= 1 << 30 && largest > 1 << 29) << largest;
}

// ConvexParts of one plane share one record, and it comes from their farthest vertices: neither a small decal
// of the model's that lies a little off decides it, nor the order in which they are listed. Others keep their
// lies a little off does not decide it, nor does the order of the faces. Other parts keep their own records.
TEST(Project, OnePlaneHasOneRecord) {
  const auto projectedIn = [](bool decalFirst, Projection projection) {
    Mesh m;
    m.points = {{-0.9, -0.8, -1}, {0.9, -0.8, 0.8}, {0.9, 0.8, 0.8}, {-0.9, 0.8, -1}, {0, 0, -0.1001},
                {0.01, 0, -0.09}, {0, 0.01, -0.1},  {0, 0, 0.5},     {0.5, 0, 0.5},   {0, 0.5, 0.75}};
    const std::vector<std::vector<int>> faces =
        decalFirst ? std::vector<std::vector<int>>{{6, 5, 4}, {0, 1, 2, 3}, {7, 8, 9}}
                   : std::vector<std::vector<int>>{{0, 1, 2, 3}, {6, 5, 4}, {7, 8, 9}};
    for (const auto& f : faces) m.addFace(f, 0);
    ConvexParts parts = divideFaces(m);
    parts.plane = {0, 0, 1};
    return project(m, parts, fromAbove(projection), 512, 512, Cull::Keep);
  };
  for (const Projection projection : {Projection::Parallel, Projection::Perspective}) {
    const SnappedScene one = projectedIn(false, projection), two = projectedIn(true, projection);
    ASSERT_EQ(one.faces.size(), 3u);
    ASSERT_EQ(one.planes.size(), 2u);
    EXPECT_EQ(one.faces[0].plane, one.faces[1].plane);
    EXPECT_NE(one.faces[0].plane, one.faces[2].plane);
    EXPECT_EQ(one.planes[0], planeThrough(&one.vertices[one.faces[0].first], 4));
    EXPECT_EQ(one.planes, two.planes);
  }
}

// The doubt of a face's depth grows with the rounding of its own coordinates, not with that of others.
TEST(Project, DoubtIsByObject) {
  Mesh m;
  m.points = {{-0.9, -0.8, 0}, {0.9, -0.8, 0}, {0.9, 0.8, 0}};
  m.groupNames = {"exact", "rounded"};
  m.rounding = {0.0, 1e-7};
  const int corners[] = {0, 1, 2};
  m.addFace(corners, 0);
  m.addFace(corners, 1);
  const SnappedScene s = projected(m, fromAbove(Projection::Parallel));
  ASSERT_EQ(s.faces.size(), 2u);
  EXPECT_EQ(s.faces[0].doubt.at(0), 4 * 0.5);
  EXPECT_NEAR(s.faces[1].doubt.at(0), 4 * (0.5 + std::sqrt(3.0) * 1e-7 * 256 * kGrid), 1e-4);
}

}  // namespace xnewell
