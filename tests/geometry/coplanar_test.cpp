#include "geometry/model/coplanar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "geometry/exact/plane.h"
#include "geometry/model/solids.h"
#include "tests/support/random_wall.h"

namespace xnewell::THIS_FILE {

namespace {

using Pts = std::vector<glm::dvec3>;

Mesh exactMesh() {
  Mesh mesh;
  mesh.groupNames = {""};
  return mesh;
}

Pts rectangle(glm::dvec3 corner, glm::dvec3 a, glm::dvec3 b) {
  return {corner, corner + a, corner + a + b, corner + b};
}

std::vector<int> classesOf(const Mesh& mesh) { return coplanarClasses(mesh, divideFaces(mesh)).plane; }

int countOf(const std::vector<int>& classes) {
  return classes.empty() ? 0 : 1 + *std::max_element(classes.begin(), classes.end());
}

Mesh scaledBy(Mesh mesh, double factor) {
  for (glm::dvec3& p : mesh.points) p *= factor;
  for (double& u : mesh.rounding) u *= factor;
  return mesh;
}

/// Adds a box whose six faces look outwards, with its lowest corner at `low`.
void addBox(Mesh& mesh, glm::dvec3 low, glm::dvec3 size) {
  const Mesh unit = cube();
  const int first = static_cast<int>(mesh.points.size());
  for (const glm::dvec3& p : unit.points) mesh.points.push_back(low + (p + 1.0) / 2.0 * size);
  for (int f = 0; f < 6; ++f) {
    std::vector<int> corners(unit.face(f).begin(), unit.face(f).end());
    for (int& c : corners) c += first;
    mesh.addFace(corners, 0);
  }
}

}  // namespace

// Faces that touch along edges and in corners are not united, whether exact, turned or rounded. The scenes
// are solids, and a tiled floor whose tiles meet in T-junctions and share no corner.
TEST(Coplanar, TouchingDoesNotUnite) {
  for (const Mesh& mesh : {cube(), sphere(24, 12), torus(32, 16)})
    for (const double scale : {1e-300, 1e-6, 1.0, 1e6, 1e300})
      EXPECT_EQ(countOf(classesOf(scaledBy(mesh, scale))), mesh.faceCount()) << scale;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const Frame frame = randomFrame(rng);
    Mesh floor = exactMesh();
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) {
        const glm::dvec3 corner = frame.at((j + (i % 2) * 0.37) / 6.0, i / 6.0);
        addRounded(floor, rectangle(corner, frame.a / 6.0, frame.b / 6.0), kDecimals[seed % 3]);
      }
    EXPECT_EQ(countOf(classesOf(floor)), 36);
  }
}

// Triangles that touch along an edge are not united, whichever way the edge runs. They lie in one plane, but
// rounding may move the ends of the edge apart.
TEST(Coplanar, NeighboursAcrossAnyEdge) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    std::uniform_real_distribution<double> unit{0.0, 1.0};
    const Frame frame = randomFrame(rng);
    const double s0 = unit(rng), s1 = unit(rng), t0 = unit(rng) / 12, t1 = unit(rng) / 12;
    const glm::dvec3 low = frame.at(0.1 + 0.3 * s0, t0), high = frame.at(0.6 + 0.3 * s1, t1);
    Mesh mesh = exactMesh();
    addRounded(mesh, {low, high, frame.at(unit(rng), 0.5 + unit(rng) / 2)}, kDecimals[seed % 3]);
    const glm::dvec3 along = high - low;  // the neighbour's edge is as long but starts elsewhere
    addRounded(mesh, {high + 0.05 * along, low + 0.05 * along, frame.at(unit(rng), -0.5 - unit(rng) / 2)},
               kDecimals[seed % 3]);
    EXPECT_EQ(countOf(classesOf(mesh)), 2);
  }
}

// A box stands on a floor. Its bottom looks the other way but is in the floor's plane. Its sides only touch
// the floor.
TEST(Coplanar, BoxOnFloor) {
  Mesh mesh = exactMesh();
  addRounded(mesh, rectangle({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), 0);
  addBox(mesh, {-0.5, -0.25, 0}, {1, 0.5, 0.75});
  const std::vector<int> classes = classesOf(mesh);
  ASSERT_EQ(classes.size(), 7u);
  int withFloor = 0;
  for (int f = 1; f < 7; ++f) {
    const glm::dvec3 N = newellPlane(mesh.points, mesh.face(f)).N;
    EXPECT_EQ(classes[f] == classes[0], N.z == -1.0) << f;
    withFloor += classes[f] == classes[0];
  }
  EXPECT_EQ(withFloor, 1);
  EXPECT_EQ(countOf(classes), 6);
}

// Decals are always in the plane of their wall, at every scale. The wall stands anywhere. The file is exact
// or has 6 or 9 decimals of the wall's size, and faces are listed either way round. A decal that reaches over
// the wall's edge is in the plane too.
TEST(Coplanar, DecalsUniteWithTheirWall) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = scaledBy(wallWithDecals(seed), std::pow(10.0, static_cast<int>(seed % 13) - 6));
    const std::vector<int> classes = classesOf(mesh);
    ASSERT_EQ(classes.size(), static_cast<std::size_t>(mesh.faceCount()));
    EXPECT_EQ(countOf(classes), 1);
  }
}

// Sheets that are more than 2 |N|_1 units of the last decimal apart are never united, however many lie over
// one another. Sheets a quarter of a unit apart are united.
TEST(Coplanar, ParallelSheetsStayApart) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const Frame frame = randomFrame(rng);
    const double unit = 1e-6;
    const auto sheets = [&](double distance) {
      Mesh mesh = exactMesh();
      for (int k = 0; k < 5; ++k)
        addRounded(mesh, rectangle(frame.at(0, 0) + distance * k * frame.N, frame.a, frame.b), 6);
      return countOf(classesOf(mesh));
    };
    EXPECT_EQ(sheets(2.001 * unit * (std::abs(frame.N.x) + std::abs(frame.N.y) + std::abs(frame.N.z))), 5);
    EXPECT_LT(sheets(0.25 * unit), 5);
  }
}

// A staircase of sheets, each of which one plane explains with the next. A class spans no more than one plane
// explains, wherever the largest sheet lies. Few sheets are alone.
TEST(Coplanar, ChainsDoNotDrift) {
  constexpr double kU = 0.5e-6, kStep = 0.4 * kU;
  for (const int largest : {0, 10, 39}) {
    SCOPED_TRACE(largest);
    Mesh mesh = exactMesh();
    mesh.rounding = {kU};
    for (int k = 0; k < 40; ++k) {
      const double size = k == largest ? 1.0 : 0.9;
      addRounded(mesh, rectangle({0, 0, kStep * k}, {size, 0, 0}, {0, size, 0}), 0);
    }
    const std::vector<int> classes = classesOf(mesh);
    std::vector<int> low(countOf(classes), 99), high(countOf(classes), -1);
    for (int k = 0; k < 40; ++k) {
      low[classes[k]] = std::min(low[classes[k]], k);
      high[classes[k]] = std::max(high[classes[k]], k);
    }
    for (int c = 0; c < countOf(classes); ++c) EXPECT_LE(kStep * (high[c] - low[c]), 2.0001 * kU);
    EXPECT_LE(countOf(classes), 20);
  }
}

// A floor below many tiles that are just too far away to be in its plane. Decals on it stay in its plane if a
// plane between the two explains both, as long as no more than 63 tiles are tried in vain; and if the floor's
// own plane explains them, however many there are.
TEST(Coplanar, ManyTilesCloseAboveTheFloor) {
  constexpr double kU = 0.5e-6;
  const auto lost = [](int tiles, double height) {
    Mesh mesh = exactMesh();
    mesh.rounding = {kU};
    addRounded(mesh, rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0);
    constexpr double kPitch = 1.0 / 20;
    std::vector<int> decals;
    for (int k = 0; k < 400; ++k) {
      const bool decal = k % 25 == 12;
      if (!decal && (tiles == 0 || k % 25 > 12)) continue;  // the tiles and the decals lie among one another
      if (!decal) --tiles;
      if (decal) decals.push_back(mesh.faceCount());
      addRounded(mesh,
                 rectangle({(k % 20 + 0.1) * kPitch, (k / 20 + 0.1) * kPitch, decal ? height : 2.5 * kU},
                           {0.8 * kPitch, 0, 0}, {0, 0.8 * kPitch, 0}),
                 0);
    }
    EXPECT_EQ(tiles, 0);
    const std::vector<int> classes = classesOf(mesh);
    return std::ranges::count_if(decals, [&](int k) { return classes[k] != classes[0]; });
  };
  EXPECT_EQ(lost(0, 1.5 * kU), 0);
  EXPECT_EQ(lost(63, 1.5 * kU), 0);
  EXPECT_EQ(lost(190, 0.99 * kU), 0);
}

// What rounding explains is that of each face's object. A coarse object lends nothing to others.
TEST(Coplanar, RoundingByObject) {
  const auto united = [](double height, double u, double v) {
    Mesh mesh = exactMesh();
    mesh.groupNames = {"", ""};
    mesh.rounding = {u, v};
    addRounded(mesh, rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0);
    addRounded(mesh, rectangle({0.25, 0.25, height}, {0.5, 0, 0}, {0, 0.5, 0}), 0);
    mesh.group[1] = 1;
    return countOf(classesOf(mesh)) == 1;
  };
  EXPECT_TRUE(united(0.099, 0.5e-1, 0.5e-1));
  EXPECT_FALSE(united(0.101, 0.5e-1, 0.5e-1));
  EXPECT_TRUE(united(0.99e-6, 1e-6, 0));
  EXPECT_TRUE(united(0.99e-6, 0, 1e-6));
  EXPECT_FALSE(united(1.01e-6, 1e-6, 0));
  EXPECT_TRUE(united(1.99e-6, 1e-6, 1e-6));
  EXPECT_FALSE(united(2.01e-6, 1e-6, 1e-6));
  EXPECT_TRUE(united(0x1p-45, 0, 0));
  EXPECT_FALSE(united(0x1p-44, 0, 0));
}

// Far from the origin, the rounding of coordinates to doubles counts: 2^-50 of the largest for each face.
TEST(Coplanar, RoundingOfDoublesFarAway) {
  const auto united = [](double height) {
    constexpr double kFar = 0x1p20;
    Mesh mesh = exactMesh();
    addRounded(mesh, rectangle({0, 0, kFar}, {1, 0, 0}, {0, 1, 0}), 0);
    addRounded(mesh, rectangle({0.25, 0.25, kFar + height}, {0.5, 0, 0}, {0, 0.5, 0}), 0);
    return countOf(classesOf(mesh)) == 1;
  };
  EXPECT_TRUE(united(0x1p-29));
  EXPECT_FALSE(united(0x1p-29 + 0x1p-31));
}

// A long narrow decal is in the plane of its wall, although rounding tilts it by as much as it can.
TEST(Coplanar, NarrowDecalsUniteWithTheirWall) {
  constexpr double kU = 1e-5;
  for (const double low : {0.05, 0.5, 0.9}) {
    Mesh mesh = exactMesh();
    mesh.rounding = {kU};
    addRounded(mesh, rectangle({0, 0, 0}, {0.99, 0, 0}, {0, 0.99, 0}), 0);
    addRounded(mesh, rectangle({0, low, -kU}, {0.9, 0, 0}, {0, 0.01, 2 * kU}), 0);
    EXPECT_EQ(countOf(classesOf(mesh)), 1) << low;
  }
}

// A decal that reaches onto the wall by more than rounding can move an edge and the decal, 2 sqrt 2 u
// together, is in its plane; one that reaches less far may only touch it.
TEST(Coplanar, OverlapBeginsBeyondRounding) {
  constexpr double kU = 0.5e-6, kReach = std::numbers::sqrt2 * kU;
  const auto united = [](double overlap) {
    Mesh mesh = exactMesh();
    mesh.rounding = {kU};
    addRounded(mesh, rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0);
    addRounded(mesh, rectangle({1 - overlap, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0);
    return countOf(classesOf(mesh)) == 1;
  };
  EXPECT_FALSE(united(0));
  EXPECT_FALSE(united(1.99 * kReach));
  EXPECT_TRUE(united(2.01 * kReach + 1e-13));
}

// The parts of a concave planar face lie in one plane, with the decals on any of its arms. The parts of a
// bent face lie in several planes.
TEST(Coplanar, PartsOfOneFace) {
  Mesh mesh = exactMesh();
  addRounded(mesh, {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}, 0);
  addRounded(mesh, rectangle({0.25, 2, 0}, {0.5, 0, 0}, {0, 0.5, 0}), 0);
  addRounded(mesh, rectangle({2, 0.25, 0}, {0, 0.5, 0}, {0.5, 0, 0}), 0);
  addRounded(mesh, rectangle({1, 1, 0}, {2, 0, 0}, {0, 2, 0}), 0);  // in the notch: only touches
  addRounded(mesh, {{5, 0, 0}, {6, 0, 0}, {6, 1, 0.5}, {5, 1, 0}}, 0);
  const ConvexParts parts = divideFaces(mesh);
  const std::vector<int> classes = coplanarClasses(mesh, parts).plane;
  EXPECT_GE(parts.count(), 4 + 1 + 1 + 1 + 2);
  std::vector<int> ofFace(5, -1), seen;
  for (int k = 0; k < parts.count(); ++k) {
    const int f = parts.face[k];
    if (f < 4 && ofFace[f] >= 0) {
      EXPECT_EQ(classes[k], ofFace[f]);
    }
    ofFace[f] = classes[k];
    if (std::find(seen.begin(), seen.end(), classes[k]) == seen.end()) {
      EXPECT_EQ(classes[k], static_cast<int>(seen.size())) << "dense, in order of the first member";
      seen.push_back(classes[k]);
    }
  }
  EXPECT_EQ(ofFace[1], ofFace[0]);
  EXPECT_EQ(ofFace[2], ofFace[0]);
  EXPECT_NE(ofFace[3], ofFace[0]);
  EXPECT_EQ(countOf(classes), 4);
}

// A floor of many tiles, each with a decal turned a little, and a rug over nine of them. Every tile is in one
// plane with its own decal only, except for the tiles that the rug joins.
TEST(Coplanar, FloorsOfManyDecals) {
  constexpr int kSide = 100;
  Mesh mesh = exactMesh();
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) addRounded(mesh, rectangle({i, j, 0}, {1, 0, 0}, {0, 1, 0}), 6);
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j)
      addRounded(mesh, rectangle({i + 0.3, j + 0.3, 0}, {0.4, 0.1, 0}, {-0.1, 0.4, 0}), 6);
  addRounded(mesh, rectangle({10.5, 20.5, 0}, {2, 0, 0}, {0, 2, 0}), 6);
  const std::vector<int> classes = classesOf(mesh);
  const int rug = classes.back();
  EXPECT_EQ(countOf(classes), kSide * kSide - 8);
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const int tile = i * kSide + j;
      ASSERT_EQ(classes[tile], classes[tile + kSide * kSide]) << i << ' ' << j;
      ASSERT_EQ(classes[tile] == rug, i >= 10 && i <= 12 && j >= 20 && j <= 22) << i << ' ' << j;
    }
}

// Faces without area have planes of their own, even in a mesh that has no other faces.
TEST(Coplanar, WithoutArea) {
  Mesh mesh = exactMesh();
  addRounded(mesh, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, 0);
  EXPECT_EQ(countOf(classesOf(mesh)), 1);
  addRounded(mesh, rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0);
  addRounded(mesh, {{0.25, 0.25, 0}, {0.5, 0.5, 0}, {0.75, 0.75, 0}}, 0);
  EXPECT_EQ(countOf(classesOf(mesh)), 3);
  EXPECT_TRUE(coplanarClasses(Mesh{}, ConvexParts{}).plane.empty());
}

}  // namespace xnewell::THIS_FILE
