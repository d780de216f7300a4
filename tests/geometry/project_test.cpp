#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "geometry/model/coplanar.h"
#include "geometry/model/sheets.h"
#include "geometry/view/project.h"
#include "geometry/view/scene_planes.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Projection onto the grid

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

// The window may be vastly smaller than the faces: every snapped vertex lies in the guard band and between
// the front and the back plane.
TEST(Project, StaysInTheGuardBand) {
  std::mt19937 rng{7};
  std::uniform_real_distribution<double> coordinate{-1.0, 1.0};
  const auto point = [&] { return glm::dvec3{coordinate(rng), coordinate(rng), coordinate(rng)}; };
  std::size_t cut = 0;
  for (const Projection projection : {Projection::Parallel, Projection::Perspective})
    for (double size = 1.0; size > 1e-300; size *= 1e-3)
      for (int k = 0; k < 50; ++k) {
        SCOPED_TRACE(size);
        ViewSpec view = fromAbove(projection);
        view.windowMin = {-size, -size}, view.windowMax = {size, size};
        if (projection == Projection::Perspective) view.prp.z = 2.0 * size, view.front = size, view.back = -2;
        const SnappedScene s = projected(triangle(point(), point(), point()), view);
        cut += s.between.size();
        for (const glm::ivec3& v : s.vertices) {
          ASSERT_LE(std::abs(std::int64_t{v.x}), kMaxPicture * kGrid);
          ASSERT_LE(std::abs(std::int64_t{v.y}), kMaxPicture * kGrid);
          ASSERT_GE(v.z, 0);
          ASSERT_LE(v.z, 1 << 30);
        }
      }
  EXPECT_GT(cut, 1'000u);
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

// Parts of one plane share one record, which is that of the plane of the model: a small decal of the model's
// that lies a little off does not tilt it, nor does a clip point. At each vertex the record has the depth of
// the plane in long double, to a fraction of a step and of what the snap moves. Other parts keep their own
// records.
TEST(Project, OnePlaneHasOneRecord) {
  for (const Projection projection : {Projection::Parallel, Projection::Perspective})
    for (const bool decalFirst : {false, true})
      for (const double far : {0.9, 9.0}) {  // the second is clipped by the guard band and by the front plane
        Mesh m;
        m.points = {{-0.9, -0.8, -1},  {far, -0.8, -0.1 + far}, {far, 0.8, -0.1 + far}, {-0.9, 0.8, -1},
                    {0, 0, -0.100001}, {0.01, 0, -0.09},        {0, 0.01, -0.1},        {0, 0, 0.5},
                    {0.5, 0, 0.5},     {0, 0.5, 0.75}};
        m.rounding = {0.5e-6};
        m.groupNames = {""};
        const std::vector<std::vector<int>> faces =
            decalFirst ? std::vector<std::vector<int>>{{6, 5, 4}, {0, 1, 2, 3}, {7, 8, 9}}
                       : std::vector<std::vector<int>>{{0, 1, 2, 3}, {6, 5, 4}, {7, 8, 9}};
        for (const auto& f : faces) m.addFace(f, 0);
        ConvexParts parts = divideFaces(m);
        uniteCoplanar(m, parts);
        ASSERT_EQ(parts.plane, (std::vector<int>{0, 0, 1}));
        const ViewSpec view = fromAbove(projection);
        const SnappedScene s = project(m, parts, view, 512, 512, Cull::Keep);
        ASSERT_EQ(s.faces.size(), 3u);
        ASSERT_EQ(s.planes.size(), 2u);
        EXPECT_EQ(s.faces[0].plane, s.faces[1].plane);
        EXPECT_NE(s.faces[0].plane, s.faces[2].plane);
        SnappedScene some = snap(m, parts, view, 512, 512, Cull::Keep);
        ScenePlanes planes{some, m, parts, view, 512, 512};
        planes.make(some.faces[1]);  // not the first of its plane
        EXPECT_EQ(some.planes.made(), 1);
        EXPECT_EQ(some.planes[0], s.planes[0]);
        EXPECT_FALSE(some.planes.has(1));
        EXPECT_THROW((void)some.planes[1], std::logic_error);
        EXPECT_THROW((void)some.doubtOf(some.faces[2]), std::logic_error);
        EXPECT_EQ(some.doubtOf(some.faces[0]).atBack, s.doubtOf(s.faces[0]).atBack);
        const auto [N, at] = planeOf(m, parts, 0);
        for (const glm::ivec3& v : {s.vertices[s.faces[0].first], s.vertices[s.faces[1].first + 1]}) {
          const long double u = v.x / (256.0L * kGrid) - 1, w = 1 - v.y / (256.0L * kGrid);
          const long double c = static_cast<long double>(N.x) * at.x + static_cast<long double>(N.y) * at.y +
                                static_cast<long double>(N.z) * at.z;
          long double z = (c - N.x * u - N.y * w) / N.z + 4;  // parallel: z - back
          if (projection == Projection::Perspective)          // N.(0, 0, 4) + d N.(u / 4, w / 4, -1) = c
            z = 16 * ((N.x * u / 4 + N.y * w / 4 - N.z) / (c - 4 * N.z) - 1 / 8.0L);
          const auto inSteps = static_cast<double>(z * 256 * kGrid / std::exp2(s.zShift));
          EXPECT_NEAR(depthAt(s.planes[0], v.x, v.y), inSteps, 1e-3);
          EXPECT_NEAR(v.z, inSteps, s.doubtOf(s.faces[0]).at(v.z));
        }
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
  const double perUnit = 256 * kGrid;
  const SnappedScene s = projected(m, fromAbove(Projection::Parallel));
  ASSERT_EQ(s.faces.size(), 2u);
  EXPECT_NEAR(s.doubtOf(s.faces[0]).at(0), 0.5, 1e-6);
  EXPECT_NEAR(s.doubtOf(s.faces[1]).at(0), 0.5 + 1e-7 * perUnit, 1e-4);
}

/// ---- Corners far from the others

void add(Mesh& mesh, const std::vector<glm::dvec3>& corners) {
  std::vector<int> face(corners.size());
  std::iota(face.begin(), face.end(), static_cast<int>(mesh.points.size()));
  mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
  mesh.addFace(face, 0);
}

/// A wavy sheet of n x n faces, about 1 long, with decals on every eighth of them, and one long face that
/// makes the scene 1 / share as large.
Mesh sheetBesideFarCorner(int n, double share, unsigned seed) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  Mesh mesh;
  mesh.groupNames = {""};
  const auto at = [&](double i, double j) {
    return glm::dvec3{i / n, j / n, 0.1 * std::sin(7.0 * i / n) + 0.2 * std::cos(5.0 * j / n)};
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const glm::dvec3 a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1);
      add(mesh, {a, b, c});
      if (unit(rng) > 0.125) continue;
      const auto inside = [&](double s, double t) { return a + s * (b - a) + t * (c - b); };
      add(mesh, {a, b, c});
      add(mesh, {inside(0.5, 0.1), inside(0.9, 0.1), inside(0.9, 0.4)});
    }
  const double far = (seed % 2 == 0 ? 1.0 : -1.0) / share;
  add(mesh, {{0.3, 0.3, 0.0}, {0.6, far, 0.0}, {0.6, 0.4, 0.01}});
  add(mesh, {{0.2, 0.2, 0.1}, {0.7, 0.2, 0.15}, {0.7, 0.8, 0.1}});
  return mesh;
}

using Pairs = std::set<std::pair<int, int>>;

Pairs nearPairs(const Sheets& sheets) {
  Pairs visited;
  sheets.forAllNear(
      [&](const SheetPart& P, const SheetPart& Q) { visited.insert(std::minmax(P.part, Q.part)); });
  return visited;
}

/// True if two parts overlap in area and one plane explains both, without a search for near ones.
bool inOnePlane(const Sheets& model, int i, int j) {
  const ModelSheet P = model.sheet(i), Q = model.sheet(j);
  const ModelSheet& larger = P.area > Q.area ? P : Q;
  if (model.parted({i, P}, {j, Q}, larger.plane.N)) return false;
  std::vector<RoundedPoint> both;
  for (const int sheet : {i, j})
    for (const int c : model.corners(sheet)) both.push_back({model.box.points[c], model.roundingOf(sheet)});
  return fitPlane(both, larger.plane, model.rounding, FitGoal::Explain).explains();
}

/// How many pairs of parts lie in one plane. The test fails if a search does not find all of them near.
std::size_t joinedPairs(const Mesh& mesh) {
  const ConvexParts parts = divideFaces(mesh);
  const Sheets sheets{mesh, parts};
  const Pairs near = nearPairs(sheets);
  std::size_t joined = 0;
  for (int i = 0; i < parts.count(); ++i)
    for (int j = i + 1; j < parts.count(); ++j) {
      const bool covers = sheets.sheet(i).area > 0.0 && sheets.sheet(j).area > 0.0;
      if (!covers || !inOnePlane(sheets, i, j)) continue;
      ++joined;
      EXPECT_TRUE(near.contains({i, j})) << i << ' ' << j;
    }
  EXPECT_LT(near.size(), static_cast<std::size_t>(parts.count()) * parts.count() / 4);
  return joined;
}

// A scene may be so large that a detailed object is a speck in it, down to the size of rounding. No pair of
// faces that lies in one plane is missed.
TEST(FarCorner, NoPairIsMissed) {
  std::size_t joined = 0;
  unsigned seed = 0;
  for (const double share : {1e-3, 1e-6, 1e-8, 1e-10, 1e-11, 3e-12, 1e-12, 3e-13, 1e-13, 1e-14, 1e-30})
    for (const double u : {0.0, 1e-4, 1.0}) {
      SCOPED_TRACE(testing::Message() << share << ' ' << u);
      Mesh mesh = sheetBesideFarCorner(34, share, seed++);
      if (u > 0.0) mesh.rounding = {u};
      joined += joinedPairs(mesh);
    }
  EXPECT_GT(joined, 1'000u);
}

// Whether a model is searched cell by cell or as a whole, the same pairs lie in one plane.
TEST(FarCorner, CellsMissNoPair) {
  std::size_t joined = 0;
  for (const double share : {1.0, 0.3, 1e-2, 1e-7, 1e-14}) {
    SCOPED_TRACE(share);
    Mesh mesh = sheetBesideFarCorner(75, share, 7);
    mesh.rounding = {1e-5};
    const ConvexParts parts = divideFaces(mesh);
    ASSERT_GT(static_cast<std::size_t>(parts.count()), kManyBoxes);
    const Sheets sheets{mesh, parts};
    Pairs byCells, asAWhole;
    const auto addTo = [&](Pairs& pairs) {
      return [&](const SheetPart& P, const SheetPart& Q) {
        if (!sheets.tooFar(P, Q)) pairs.insert(std::minmax(P.part, Q.part));
      };
    };
    sheets.forAllNear(addTo(byCells));
    std::vector<int> all(parts.count());
    std::iota(all.begin(), all.end(), 0);
    sheets.forNear(all, addTo(asAWhole));
    std::erase_if(byCells, [&](const auto& pair) { return !inOnePlane(sheets, pair.first, pair.second); });
    std::erase_if(asAWhole, [&](const auto& pair) { return !inOnePlane(sheets, pair.first, pair.second); });
    EXPECT_EQ(byCells, asAWhole);
    joined += byCells.size();
  }
  EXPECT_GT(joined, 5'000u);
}

// Specks that are smaller than the rounding still lie in the plane of the floor under them. A needle has no
// room for them, however long it is.
TEST(FarCorner, SpecksLieOnTheFloor) {
  std::size_t joined = 0;
  for (const double share : {1e-3, 1e-13, 1e-14, 1e-16, 1e-30, 1e-200}) {
    SCOPED_TRACE(share);
    Mesh mesh = sheetBesideFarCorner(20, share, 4);
    const double far = 1.0 / share;
    add(mesh, {{-far, -far, 0.0}, {far, -far, 0.0}, {0.0, far, 0.0}});
    add(mesh, {{-far, 0.0, 0.1}, {far, 0.0, 0.1}, {0.0, 0.6, 0.1}});
    joined += joinedPairs(mesh);
  }
  EXPECT_GT(joined, 1'000u);
}

// One far corner of a patch makes needles of that patch's faces, and specks of all others. Each speck lies
// within the rounding of each needle's end.
TEST(FarCorner, SpecksAreNotComparedWithNeedles) {
  Mesh mesh = sheetBesideFarCorner(60, 1e-20, 6);
  for (int i = 0; i < 2'000; ++i)
    add(mesh, {{0.5, 0.001 * i, 0.0}, {0.5, 0.001 * i + 0.1, 0.0}, {0.5, 0.001 * i, 1e20 + 1e16 * i}});
  const ConvexParts parts = divideFaces(mesh);
  std::size_t withSpecks = 0;
  const int firstNeedle = parts.count() - 2'000;
  Sheets{mesh, parts}.forAllNear([&](const SheetPart& P, const SheetPart& Q) {
    withSpecks += std::min(P.part, Q.part) < firstNeedle - 2 && std::max(P.part, Q.part) >= firstNeedle;
  });
  EXPECT_EQ(withSpecks, 0u);
}

// The work grows with the number of faces, however large the scene is beside them. Faces that are not dust
// are at least about delta long here, and a place reaches two roundings further on each side. So about 10 x
// 10 faces are near, with their decals, and each pair may be visited twice.
TEST(FarCorner, FewPairsAreCompared) {
  for (double share = 1.0; share > 1e-20; share /= 7.0) {
    SCOPED_TRACE(share);
    const Mesh mesh = sheetBesideFarCorner(150, share, 5);
    const ConvexParts parts = divideFaces(mesh);
    std::size_t visits = 0;
    Sheets{mesh, parts}.forAllNear([&](const SheetPart&, const SheetPart&) { ++visits; });
    EXPECT_LT(visits, 300u * static_cast<std::size_t>(parts.count()));
  }
}

}  // namespace

}  // namespace xnewell::THIS_FILE
