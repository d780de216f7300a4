#include "geometry/model/coplanar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "geometry/exact/plane.h"
#include "geometry/exact/unit.h"
#include "geometry/model/solids.h"
#include "tests/support/random_wall.h"
#include "tests/support/seeds.h"

namespace xnewell {

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

std::vector<int> classesOf(const Mesh& mesh) { return coplanarClasses(mesh, divideFaces(mesh)); }

int countOf(const std::vector<int>& classes) {
  return classes.empty() ? 0 : 1 + *std::max_element(classes.begin(), classes.end());
}

Mesh scaledBy(Mesh mesh, double factor) {
  for (glm::dvec3& p : mesh.points) p *= factor;
  for (double& u : mesh.rounding) u *= factor;
  return mesh;
}

/// Six faces outwards, from `low` on.
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

/// The classes as coplanar.h defines them, from all pairs of pieces; for scenes where none leaves its class.
std::vector<int> classesOfAllPairs(const Mesh& mesh, const ConvexParts& pieces) {
  glm::dvec3 low = mesh.points[0], high = low;
  double magnitude = 0.0;
  for (const glm::dvec3& p : mesh.points)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]), high[axis] = std::max(high[axis], p[axis]);
      magnitude = std::max(magnitude, std::abs(p[axis]));
    }
  const double e = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const double u = mesh.rounding.empty() ? 0.0 : mesh.rounding[0];
  const double tol = std::min(7.0 * u, 3e-5 * e) + 0x1p-46 * e + 0x1p-50 * magnitude;

  std::vector<int> classes = pieces.plane;
  const auto whole = [&](int i) {
    const bool alone = std::count(pieces.plane.begin(), pieces.plane.end(), pieces.plane[i]) == 1;
    return alone ? pieces.piece(i) : mesh.face(pieces.face[i]);
  };
  std::vector<double> area;
  for (int i = 0; i < pieces.count(); ++i) area.push_back(glm::length(newellVector(mesh.points, whole(i))));
  const auto parted = [&](int i, int j, const glm::dvec3& axis) {
    const auto P = pieces.piece(i);
    const double turns = glm::dot(newellVector(mesh.points, P), axis) > 0.0 ? 1.0 : -1.0;
    for (std::size_t k = 0; k < P.size(); ++k) {
      const glm::dvec3 a = mesh.points[P[k]], edge = mesh.points[P[(k + 1) % P.size()]] - a;
      const glm::dvec3 inwards = turns * glm::cross(axis, edge);
      if (std::ranges::all_of(pieces.piece(j), [&](int c) {
            return glm::dot(inwards, mesh.points[c] - a) <= tol * glm::length(inwards);
          }))
        return true;
    }
    return false;
  };
  for (int i = 0; i < pieces.count(); ++i)
    for (int j = 0; j < pieces.count(); ++j) {
      if (classes[i] == classes[j] || area[i] < area[j]) continue;
      const Plane plane = newellPlane(mesh.points, whole(i));
      const glm::dvec3 N = glm::abs(plane.N);
      const glm::dvec3 axis = N.z >= N.x && N.z >= N.y ? glm::dvec3{0, 0, 1}
                              : N.y >= N.x             ? glm::dvec3{0, 1, 0}
                                                       : glm::dvec3{1, 0, 0};
      const bool coplanar = std::ranges::all_of(pieces.piece(j), [&](int c) {
        return std::abs(glm::dot(plane.N, mesh.points[c]) - plane.d) <= tol;
      });
      if (coplanar && !parted(i, j, axis) && !parted(j, i, axis))
        std::replace(classes.begin(), classes.end(), int{classes[j]}, int{classes[i]});
    }
  std::vector<int> seen;  // numbered in order of the first piece of each
  for (int& c : classes) {
    if (std::find(seen.begin(), seen.end(), c) == seen.end()) seen.push_back(c);
    c = static_cast<int>(std::find(seen.begin(), seen.end(), c) - seen.begin());
  }
  return classes;
}

/// A comb of 60 long teeth, one concave face of which most pieces' boxes overlap; decals on its plane, on a
/// tooth or in a gap, over several or behind its back; and triangles through it.
Mesh combWithDecals(unsigned seed) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  const Frame frame = randomFrame(rng);
  const int decimals = kDecimals[seed % kDecimals.size()];
  constexpr int kTeeth = 60;
  Mesh mesh = exactMesh();
  Pts comb{frame.at(0, 0), frame.at(1, 0)};
  for (int tooth = kTeeth - 1; tooth >= 0; --tooth) {
    comb.push_back(frame.at((tooth + 0.5) / kTeeth, 1.0));
    comb.push_back(frame.at((tooth + 0.0) / kTeeth, 0.1));
  }
  addRounded(mesh, comb, decimals);
  for (int k = 0; k < 120; ++k) {
    const glm::dvec3 off = k % 4 == 0 ? 0.01 * frame.N : glm::dvec3{0.0};
    const double size = k % 8 == 1 ? 0.1 : 0.002;
    addRounded(mesh, rectangle(frame.at(unit(rng), unit(rng)) + off, size * frame.a, size * frame.b),
               decimals);
  }
  for (int k = 0; k < 60; ++k) {
    const auto point = [&] { return frame.at(unit(rng), unit(rng)) + (unit(rng) - 0.5) * frame.N; };
    addRounded(mesh, {point(), point(), point()}, decimals);
  }
  return mesh;
}

}  // namespace

// Faces that touch along edges and in corners are not united, exact, turned or rounded: solids, and a tiled
// floor whose tiles meet T-wise and share no corner.
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

// Triangles that touch along an edge, its ends rounded apart, are not united although they lie in one plane,
// whichever way the edge runs.
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
    const glm::dvec3 along = high - low;  // the neighbour's edge is as long, but starts elsewhere
    addRounded(mesh, {high + 0.05 * along, low + 0.05 * along, frame.at(unit(rng), -0.5 - unit(rng) / 2)},
               kDecimals[seed % 3]);
    EXPECT_EQ(countOf(classesOf(mesh)), 2);
  }
}

// A box that stands on a floor: its bottom looks the other way and is in the floor's plane, its sides only
// touch it.
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

// Decals on a wall that stands anywhere, written with 6 or 9 decimals of its size or exactly, listed either
// way round, are always in its plane, at every scale; so is a decal that reaches over the wall's edge.
TEST(Coplanar, DecalsUniteWithTheirWall) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = scaledBy(wallWithDecals(seed), std::pow(10.0, static_cast<int>(seed % 13) - 6));
    const std::vector<int> classes = classesOf(mesh);
    ASSERT_EQ(classes.size(), static_cast<std::size_t>(mesh.faceCount()));
    EXPECT_EQ(countOf(classes), 1);
  }
}

// Sheets ten tolerances apart are never united, however many lie over one another; sheets half a tolerance
// apart are.
TEST(Coplanar, ParallelSheetsStayApart) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const Frame frame = randomFrame(rng);
    const double tol = 7 * 0.5e-6;
    const auto sheets = [&](double distance) {
      Mesh mesh = exactMesh();
      for (int k = 0; k < 5; ++k)
        addRounded(mesh, rectangle(frame.at(0, 0) + distance * k * frame.N, frame.a, frame.b), 6);
      return countOf(classesOf(mesh));
    };
    EXPECT_EQ(sheets(10 * tol), 5);
    EXPECT_LT(sheets(0.5 * tol), 5);
  }
}

// A staircase of sheets, each within the tolerance of the next: members of a class lie within three
// tolerances of the largest, and the others leave it.
TEST(Coplanar, ChainsDoNotDrift) {
  constexpr double kTol = 7 * 0.5e-6;
  for (const int largest : {0, 10, 39}) {
    SCOPED_TRACE(largest);
    Mesh mesh = exactMesh();
    mesh.rounding = {0.5e-6};
    for (int k = 0; k < 40; ++k) {
      const double size = k == largest ? 1.0 : 0.9;
      addRounded(mesh, rectangle({0, 0, 0.9 * kTol * k}, {size, 0, 0}, {0, size, 0}), 0);
    }
    const std::vector<int> classes = classesOf(mesh);
    int stayed = 0;
    for (int k = 0; k < 40; ++k) {
      EXPECT_EQ(classes[k] == classes[largest], std::abs(k - largest) * 0.9 <= 3.0) << k;
      stayed += classes[k] == classes[largest];
    }
    EXPECT_GE(stayed, 4);
    EXPECT_EQ(countOf(classes), 41 - stayed);
  }
}

// Coarse files are taken at their word: the tolerance is never more than 3e-5 of the scene, and the coarse
// object of a scene lends its own to those it meets only.
TEST(Coplanar, RoundingByObjectAndCapped) {
  const auto united = [](double height, double u, double v) {
    Mesh mesh = exactMesh();
    mesh.groupNames = {"", ""};
    mesh.rounding = {u, v};
    addRounded(mesh, rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0);
    addRounded(mesh, rectangle({0.25, 0.25, height}, {0.5, 0, 0}, {0, 0.5, 0}), 0);
    mesh.group[1] = 1;
    return countOf(classesOf(mesh)) == 1;
  };
  EXPECT_TRUE(united(2.9e-5, 0.5e-1, 0));
  EXPECT_FALSE(united(3.1e-5, 0.5e-1, 0));
  EXPECT_TRUE(united(6.9e-6, 1e-6, 0));
  EXPECT_TRUE(united(6.9e-6, 0, 1e-6));
  EXPECT_FALSE(united(7.1e-6, 1e-6, 1e-6));
  EXPECT_TRUE(united(0x1p-47, 0, 0));
  EXPECT_FALSE(united(0x1p-45, 0, 0));
}

// The pieces of a concave planar face are one plane, with the decals on any of its arms; those of a bent
// face are several.
TEST(Coplanar, PiecesOfOneFace) {
  Mesh mesh = exactMesh();
  addRounded(mesh, {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}, 0);
  addRounded(mesh, rectangle({0.25, 2, 0}, {0.5, 0, 0}, {0, 0.5, 0}), 0);
  addRounded(mesh, rectangle({2, 0.25, 0}, {0, 0.5, 0}, {0.5, 0, 0}), 0);
  addRounded(mesh, rectangle({1, 1, 0}, {2, 0, 0}, {0, 2, 0}), 0);  // in the notch: only touches
  addRounded(mesh, {{5, 0, 0}, {6, 0, 0}, {6, 1, 0.5}, {5, 1, 0}}, 0);
  const ConvexParts pieces = divideFaces(mesh);
  const std::vector<int> classes = coplanarClasses(mesh, pieces);
  EXPECT_GE(pieces.count(), 4 + 1 + 1 + 1 + 2);
  std::vector<int> ofFace(5, -1), seen;
  for (int k = 0; k < pieces.count(); ++k) {
    const int f = pieces.face[k];
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

// A comb, what lies in its plane and what does not: the classes are those that comparing all pairs of pieces
// gives, and the comb's pieces are always of one.
TEST(Coplanar, CombsAsAllPairsGiveThem) {
  const Seeds seeds{30};
  int onComb = 0, inGaps = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = combWithDecals(seed);
    const ConvexParts pieces = divideFaces(mesh);
    const std::vector<int> classes = coplanarClasses(mesh, pieces);
    ASSERT_EQ(classes, classesOfAllPairs(mesh, pieces));
    const auto combPieces = std::count(pieces.face.begin(), pieces.face.end(), 0);
    ASSERT_GT(combPieces, 100);
    EXPECT_EQ(std::count(classes.begin(), classes.begin() + combPieces, 0), combPieces);
    for (int k = 0; k < 120; ++k) {
      const int decal = static_cast<int>(combPieces) + k;
      onComb += classes[decal] == 0;
      inGaps += k % 4 != 0 && classes[decal] != 0;
    }
  }
  if (!seeds.all()) return;
  EXPECT_GT(onComb, 500);
  EXPECT_GT(inGaps, 500);
}

// A floor of many tiles, each with a decal turned a little, and a rug over nine of them: every tile is in one
// plane with its own decal only, but for those that the rug joins.
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

// Faces without area, and a mesh of nothing else, have planes of their own.
TEST(Coplanar, WithoutArea) {
  Mesh mesh = exactMesh();
  addRounded(mesh, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, 0);
  EXPECT_EQ(countOf(classesOf(mesh)), 1);
  addRounded(mesh, rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0);
  addRounded(mesh, {{0.25, 0.25, 0}, {0.5, 0.5, 0}, {0.75, 0.75, 0}}, 0);
  EXPECT_EQ(countOf(classesOf(mesh)), 3);
  EXPECT_TRUE(coplanarClasses(Mesh{}, ConvexParts{}).empty());
}

}  // namespace xnewell
