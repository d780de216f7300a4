#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/exact/plane.h"
#include "geometry/exact/scale.h"
#include "geometry/model/coplanar.h"
#include "geometry/model/solids.h"
#include "tests/support/extended.h"
#include "tests/support/random_wall.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- The best plane of rounded points

using std::abs;  // and that of two doubles

using Real = Extended;
using Vec = glm::vec<3, Real>;

/// As if the points, which are at most 2 from the origin, had been moved there from far away: e is 2^-18.
constexpr double kSide = 1.0, kMagnitude = 0x1p32, kCoarse = 1e-3;

/// r of a point, by the words of fit_plane.h.
Real roundingOf(const Vec& N, double u) {
  const Vec n = glm::abs(N);
  return u * (n.x + n.y + n.z) + 0x1p-46 * kSide + 0x1p-50 * kMagnitude;
}

/// The least h of any plane, with r as it is for the normal N. By Helly's theorem four of the points hold the
/// best plane. With the weights l of their only affine dependency, sum l = 0 and sum l p = 0 seen along N, it
/// has h = |sum l N.p| / sum |l| r: the best of four points is the worst of all fours.
Real leastOf(const std::vector<RoundedPoint>& points, const Vec& N) {
  const Vec axis = abs(N.x) < 0.5 ? Vec{1, 0, 0} : Vec{0, 1, 0}, T = glm::normalize(glm::cross(N, axis)),
            U = glm::cross(N, T);
  Real most = 0;
  std::vector<Vec> q;
  for (const RoundedPoint& p : points)
    q.push_back({glm::dot(T, Vec{p.p}), glm::dot(U, Vec{p.p}), glm::dot(N, Vec{p.p})});
  const auto area = [&](int a, int b, int c) {
    return (q[b].x - q[a].x) * (q[c].y - q[a].y) - (q[b].y - q[a].y) * (q[c].x - q[a].x);
  };
  const int n = static_cast<int>(points.size());
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b)
      for (int c = b + 1; c < n; ++c)
        for (int d = c + 1; d < n; ++d) {
          const Real la = area(b, c, d), lb = -area(a, c, d), lc = area(a, b, d), ld = -area(a, b, c);
          const Real sum = abs(la) * roundingOf(N, points[a].u) + abs(lb) * roundingOf(N, points[b].u) +
                           abs(lc) * roundingOf(N, points[c].u) + abs(ld) * roundingOf(N, points[d].u);
          if (sum > 0)
            most = std::max(most, abs(la * q[a].z + lb * q[b].z + lc * q[c].z + ld * q[d].z) / sum);
        }
  return most;
}

// The best plane is as good as fit_plane.h claims, however far it turns from the plane where the search
// starts: its h is at most 2^-9 of the least h above it. One point of every other set is exact, and its r is
// only e. Where all are rounded alike, a turn changes all r in the same way, and the h found is the least.
TEST(FitPlane, TheBestIsAsGoodAsClaimed) {
  double worst = 0;
  for (unsigned seed = 0; seed < 4'000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    std::uniform_real_distribution<double> share{0.0, 1.0};
    const bool alike = seed % 2 == 0;
    const double turn = 0x1p-10 * std::pow(10.0, 3 * share(rng) - 1.5), a = share(rng) * turn, b = turn - a;
    const glm::dvec3 start = seed % 3 == 0 ? glm::dvec3{0, 0, 1} : unit({share(rng), share(rng), 1});
    std::vector<RoundedPoint> points;
    const int count = 4 + static_cast<int>(rng() % 6);
    for (int k = 0; k < count; ++k) {
      const double x = share(rng), y = share(rng), off = 3 * kCoarse * (share(rng) - 0.5);
      points.push_back({{x, y, (a * x + b * y + off - start.x * x - start.y * y) / start.z},
                        alike || k > 0 ? kCoarse : 0.0});
    }
    const PlaneFit fit =
        fitPlane(points, {start, glm::dot(start, points[0].p)}, Rounding{kSide, kMagnitude}, FitGoal::Best);
    const double least = static_cast<double>(leastOf(points, glm::normalize(Vec{fit.plane.N})));
    const double arithmetic = 0x1p-46 / 0x1p-18;  // some roundings of places, over r
    ASSERT_LE(fit.h, least * (1 + (alike ? 1e-9 : 0x1p-9)) + arithmetic);
    if (!alike && least > 0.01) worst = std::max(worst, fit.h / least - 1);
  }
  EXPECT_GT(worst, 0x1p-13);  // the claim is needed
}

/// ---- Faces in one plane

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

/// Whether two faces lie in one plane, the coordinates of the first being off by u and those of the other by
/// v.
bool united(const Pts& first, const Pts& other, double u = 0, double v = 0) {
  Mesh mesh = exactMesh();
  mesh.groupNames = {"", ""};
  mesh.rounding = {u, v};
  addRounded(mesh, first, 0);
  addRounded(mesh, other, 0);
  mesh.group[1] = 1;
  return countOf(classesOf(mesh)) == 1;
}
const Pts kSquare = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});

Mesh scaledBy(Mesh mesh, double factor) {
  for (glm::dvec3& p : mesh.points) p *= factor;
  for (double& u : mesh.rounding) u *= factor;
  return mesh;
}

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
  const auto unitedAt = [](double height, double u, double v) {
    return united(kSquare, rectangle({0.25, 0.25, height}, {0.5, 0, 0}, {0, 0.5, 0}), u, v);
  };
  EXPECT_TRUE(unitedAt(0.099, 0.5e-1, 0.5e-1));
  EXPECT_FALSE(unitedAt(0.101, 0.5e-1, 0.5e-1));
  EXPECT_TRUE(unitedAt(0.99e-6, 1e-6, 0));
  EXPECT_TRUE(unitedAt(0.99e-6, 0, 1e-6));
  EXPECT_FALSE(unitedAt(1.01e-6, 1e-6, 0));
  EXPECT_TRUE(unitedAt(1.99e-6, 1e-6, 1e-6));
  EXPECT_FALSE(unitedAt(2.01e-6, 1e-6, 1e-6));
  EXPECT_TRUE(unitedAt(0x1p-45, 0, 0));
  EXPECT_FALSE(unitedAt(0x1p-44, 0, 0));
}

// Far from the origin, the rounding of coordinates to doubles counts: 2^-50 of the largest for each face.
TEST(Coplanar, RoundingOfDoublesFarAway) {
  constexpr double kFar = 0x1p20;
  for (const double height : {0x1p-29, 0x1p-29 + 0x1p-31})
    EXPECT_EQ(united(rectangle({0, 0, kFar}, {1, 0, 0}, {0, 1, 0}),
                     rectangle({0.25, 0.25, kFar + height}, {0.5, 0, 0}, {0, 0.5, 0})),
              height == 0x1p-29);
}

// A long narrow decal is in the plane of its wall, although rounding tilts it by as much as it can.
TEST(Coplanar, NarrowDecalsUniteWithTheirWall) {
  constexpr double kU = 1e-5;
  for (const double low : {0.05, 0.5, 0.9})
    EXPECT_TRUE(united(rectangle({0, 0, 0}, {0.99, 0, 0}, {0, 0.99, 0}),
                       rectangle({0, low, -kU}, {0.9, 0, 0}, {0, 0.01, 2 * kU}), kU, kU))
        << low;
}

// A decal that reaches onto the wall by more than rounding can move an edge and the decal, 2 sqrt 2 u
// together, is in its plane; one that reaches less far may only touch it.
TEST(Coplanar, OverlapBeginsBeyondRounding) {
  constexpr double kU = 0.5e-6, kReach = std::numbers::sqrt2 * kU;
  for (const double overlap : {0.0, 1.99 * kReach, 2.01 * kReach + 1e-13})
    EXPECT_EQ(united(kSquare, rectangle({1 - overlap, 0, 0}, {1, 0, 0}, {0, 1, 0}), kU, kU),
              overlap > 2 * kReach);
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

/// ---- Two faces in one plane

/// The classes as coplanar.h defines them, from all pairs of parts. It is for scenes where one plane explains
/// those parts and only those that were made in one plane, `madeIn` by face (-1 for none).
std::vector<int> classesOfAllPairs(const Mesh& mesh, const ConvexParts& parts,
                                   const std::vector<int>& madeIn) {
  const double u = mesh.rounding.empty() ? 0.0 : mesh.rounding[0];
  std::vector<int> classes = parts.plane;
  const auto parted = [&](int i, int j, const glm::dvec3& axis) {
    const auto P = parts.part(i);
    const double turns = glm::dot(newellVector(mesh.points, P), axis) > 0.0 ? 1.0 : -1.0;
    for (std::size_t k = 0; k < P.size(); ++k) {
      const glm::dvec3 a = mesh.points[P[k]], b = mesh.points[P[(k + 1) % P.size()]];
      const glm::dvec3 along = b - a - axis * glm::dot(axis, b - a);
      const double length = glm::length(along);
      const glm::dvec3 inwards = turns * glm::cross(axis, along) / length;
      if (std::ranges::all_of(parts.part(j), [&](int c) {
            const double beyond = std::abs(glm::dot(along, 2.0 * mesh.points[c] - a - b)) / (length * length);
            return glm::dot(inwards, mesh.points[c] - a) <=
                   (std::sqrt(2.0) * u + 1e-14) * (1.0 + std::clamp(beyond, 1.0, 3.0));
          }))
        return true;
    }
    return false;
  };
  for (int i = 0; i < parts.count(); ++i)
    for (int j = 0; j < i; ++j) {
      const int plane = madeIn[parts.face[i]];
      if (classes[i] == classes[j] || plane < 0 || plane != madeIn[parts.face[j]]) continue;
      const glm::dvec3 N = glm::abs(newellPlane(mesh.points, mesh.face(parts.face[j])).N);
      const glm::dvec3 axis = N.z >= N.x && N.z >= N.y ? glm::dvec3{0, 0, 1}
                              : N.y >= N.x             ? glm::dvec3{0, 1, 0}
                                                       : glm::dvec3{1, 0, 0};
      if (!parted(i, j, axis) && !parted(j, i, axis))
        std::replace(classes.begin(), classes.end(), int{classes[j]}, int{classes[i]});
    }
  std::vector<int> seen;  // numbered in order of the first part of each
  for (int& c : classes) {
    if (std::find(seen.begin(), seen.end(), c) == seen.end()) seen.push_back(c);
    c = static_cast<int>(std::find(seen.begin(), seen.end(), c) - seen.begin());
  }
  return classes;
}

/// A comb of 60 long teeth: one concave face, and the boxes of most of its parts overlap. Decals lie in its
/// plane, on a tooth, in a gap, over several teeth or behind its back. Triangles pass through it.
Mesh combWithDecals(unsigned seed) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  const Frame frame = randomFrame(rng);
  const int decimals = kDecimals[seed % kDecimals.size()];
  constexpr int kTeeth = 60;
  Mesh mesh;
  mesh.groupNames = {""};
  Pts comb{frame.at(0, 0), frame.at(1, 0)};
  for (int tooth = kTeeth - 1; tooth >= 0; --tooth) {
    comb.push_back(frame.at((tooth + 0.5) / kTeeth, 1.0));
    comb.push_back(frame.at((tooth + 0.0) / kTeeth, 0.1));
  }
  addRounded(mesh, comb, decimals);
  for (int k = 0; k < 120; ++k) {
    const glm::dvec3 off = k % 4 == 0 ? 0.01 * frame.N : glm::dvec3{0.0};
    const double size = k % 8 == 1 ? 0.1 : 0.002;
    const glm::dvec3 corner = frame.at(unit(rng), unit(rng)) + off, a = size * frame.a, b = size * frame.b;
    addRounded(mesh, {corner, corner + a, corner + a + b, corner + b}, decimals);
  }
  for (int k = 0; k < 60; ++k) {
    const auto point = [&] { return frame.at(unit(rng), unit(rng)) + (unit(rng) - 0.5) * frame.N; };
    addRounded(mesh, {point(), point(), point()}, decimals);
  }
  return mesh;
}

// For a comb, decals in its plane and triangles across it, the classes are those that a comparison of all
// pairs of parts gives. The comb's parts are always in one class.
TEST(Coplanar, CombsAsAllPairsGiveThem) {
  const Seeds seeds{30};
  int onComb = 0, inGaps = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = combWithDecals(seed);
    const ConvexParts parts = divideFaces(mesh);
    const std::vector<int> classes = coplanarClasses(mesh, parts).plane;
    std::vector<int> madeIn(mesh.faceCount(), -1);
    madeIn[0] = 0;
    for (int k = 0; k < 120; ++k) madeIn[k + 1] = k % 4 == 0 ? 1 : 0;
    ASSERT_EQ(classes, classesOfAllPairs(mesh, parts, madeIn));
    const auto combParts = std::count(parts.face.begin(), parts.face.end(), 0);
    ASSERT_GT(combParts, 100);
    EXPECT_EQ(std::count(classes.begin(), classes.begin() + combParts, 0), combParts);
    for (int k = 0; k < 120; ++k) {
      const int decal = static_cast<int>(combParts) + k;
      onComb += classes[decal] == 0;
      inGaps += k % 4 != 0 && classes[decal] != 0;
    }
  }
  if (!seeds.all()) return;
  EXPECT_GT(onComb, 500);
  EXPECT_GT(inGaps, 500);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
