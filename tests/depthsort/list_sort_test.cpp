#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <list>
#include <numeric>
#include <random>
#include <vector>

#include "depthsort/depth_sort.h"
#include "depthsort/free_polygons.h"
#include "depthsort/oracle.h"
#include "geometry/model/coplanar.h"
#include "tests/support/exact_region.h"
#include "tests/support/painted.h"
#include "tests/support/random_scenes.h"
#include "tests/support/random_wall.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- The sort with a list, as the textbook tells it

/// The depth sort as the textbook tells it, with a list, up to its first split. It is the reference from
/// which depthsort/depth_sort.h departs, for the reasons given there. The list is sorted by farthest z. P,
/// the first in it, is tested against the other Q's whose z-extents reach back to P's: 1, 2 extents in x and
/// y, 3 P behind Q's plane, 4 Q in front of P's plane, 5 the projections. If all fail, 3' and 4' follow with
/// P and Q exchanged. If one of these holds, Q is moved to the front of the list, is marked, and is the new
/// P. If none does, or if Q is marked already, P would be split by Q's plane. It uses rational arithmetic, so
/// that any error is the algorithm's.
/// @see Foley & van Dam 2e §15.5.1
struct ListPolygon {
  int face = 0;
  ExactRegion region;
  Rational zFar, zNear;
  bool marked = false;
};
struct ListSorted {
  std::vector<int> painted;
  int moves = 0;
  bool splits = false;  ///< the first split ended the run
};
Rational least(const ExactLine& l, const ExactRegion& region) {
  return -greatest({-l.a, -l.b, -l.c}, region);
}

class ListSort {
 public:
  explicit ListSort(const SnappedScene& scene) : scene_{scene} {
    for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f) {
      const ExactLine z = exactDifference(scene.planes[scene.faces[f].plane], {});
      ListPolygon P{f, exactOutline(scene, scene.faces[f]), 0, 0, false};
      P.zFar = least(z, P.region), P.zNear = greatest(z, P.region);
      list_.push_back(std::move(P));
    }
    list_.sort([](const ListPolygon& P, const ListPolygon& Q) { return P.zFar < Q.zFar; });
  }

  ListSorted run() {
    while (!list_.empty() && !sorted_.splits) step();
    return std::move(sorted_);
  }

 private:
  [[nodiscard]] const ScreenPlane& plane(const ListPolygon& P) const {
    return scene_.planes[scene_.faces[P.face].plane];
  }
  /// Tests 1 to 5: true if P may be painted before Q. In one plane the later face of the scene is in front.
  [[nodiscard]] bool mayGoFirst(const ListPolygon& P, const ListPolygon& Q) const {
    for (const ExactLine& along : {ExactLine{1, 0, 0}, ExactLine{0, 1, 0}})
      if (greatest(along, P.region) <= least(along, Q.region) ||
          greatest(along, Q.region) <= least(along, P.region))
        return true;
    return liesBehind(P, Q) || common(P.region, Q.region).empty();
  }
  /// Test 3 (P wholly behind Q's plane) or test 4 (Q wholly in front of P's plane). With P and Q exchanged
  /// they are 3' and 4'.
  [[nodiscard]] bool liesBehind(const ListPolygon& P, const ListPolygon& Q) const {
    const ExactLine ahead = exactDifference(plane(P), plane(Q));
    if (ahead.a == 0 && ahead.b == 0 && ahead.c == 0) return P.face <= Q.face;
    return greatest(ahead, P.region) <= 0 || greatest(ahead, Q.region) <= 0;
  }

  void step() {
    const auto P = list_.begin();
    for (auto Q = std::next(P); Q != list_.end(); ++Q) {
      if (Q->zFar > P->zNear || mayGoFirst(*P, *Q)) continue;
      sorted_.splits = Q->marked || !liesBehind(*Q, *P);
      if (sorted_.splits) return;
      Q->marked = true;
      list_.splice(list_.begin(), list_, Q);
      ++sorted_.moves;
      return;
    }
    sorted_.painted.push_back(P->face);
    list_.erase(P);
  }

  const SnappedScene& scene_;
  std::list<ListPolygon> list_;
  ListSorted sorted_;
};

constexpr int kSize = 24;

// Without splits, the list and the stack paint in the same order, face by face. Moving Q to the end and
// marking it is a depth-first search, and the stack holds the marks.
TEST(ListSort, WithoutSplitsPaintsInTheOrderOfTheStack) {
  const Seeds seeds{640};
  int same = 0, moves = 0, faces = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomScene(seed, 2 + static_cast<int>(seed / kSceneKinds.size()) % 8, kSize);
    const SortedScene stack = depthSort(scene, {kSize, kSize, true});
    const ListSorted list = ListSort{scene}.run();
    if (list.splits || stack.statistics.contacts > 0) continue;
    ++same;
    moves += list.moves;
    ASSERT_EQ(stack.statistics.splits, 0);
    ASSERT_EQ(stack.statistics.moves, list.moves);
    ASSERT_EQ(stack.fragments.size(), list.painted.size());
    for (std::size_t k = 0; k < list.painted.size(); ++k, ++faces)
      ASSERT_EQ(stack.fragments[k].face, list.painted[k]) << k;
  }
  if (!seeds.all()) return;
  EXPECT_GT(same, 200);
  EXPECT_GT(moves, 100);
  EXPECT_GT(faces, 1'000);
}

/// ---- Cycles

constexpr int kCycleSize = 64;

/// Four beams around a square. Each lies along one side, begins under the one before it and ends over the
/// next. `turns` says how often the first is turned by a quarter.
SnappedScene fourBeams(int length, int halfWidth, int slope, int turns) {
  constexpr int kMiddle = kCycleSize / 2 * kGrid, kSide = 16 * kGrid;
  SnappedScene scene;
  for (int k = turns; k < turns + 4; ++k) {
    std::vector<glm::ivec3> outline;
    for (const auto& [along, across] :
         {std::array{-length, -halfWidth}, {length, -halfWidth}, {length, halfWidth}, {-length, halfWidth}}) {
      glm::ivec2 p{along * kGrid, across * kGrid + kSide};
      for (int quarter = 0; quarter < k; ++quarter) p = {-p.y, p.x};
      outline.emplace_back(p.x + kMiddle, p.y + kMiddle, 1'000'000 + slope * along);
    }
    EXPECT_TRUE(addFace(scene, outline));
  }
  return scene;
}

// One split is enough for a cycle of four beams: at the plane of the beam on the other side. The neighbours'
// planes pass through a corner of an overlap, so a split by them leaves the cycle.
TEST(CycleSplit, OneIsEnoughForFourBeams) {
  for (const int length : {24, 28, 31})
    for (const int halfWidth : {1, 2, 4, 6})
      for (const int slope : {-300, -7, 7, 300})
        for (int turns = 0; turns < 4; ++turns) {
          SCOPED_TRACE(testing::Message() << length << " by " << halfWidth << ", slope " << slope
                                          << ", turned " << turns << " times");
          const SnappedScene scene = fourBeams(length, halfWidth, slope, turns);
          for (const bool textbook : {false, true}) {
            const SortedScene sorted =
                depthSort(scene, {.width = kCycleSize, .height = kCycleSize, .textbook = textbook});
            EXPECT_EQ(sorted.statistics.splits, 1);
            EXPECT_EQ(sorted.statistics.cycles, 1);
            EXPECT_EQ(sorted.fragments.size(), 5u);
            EXPECT_EQ(painted(scene, sorted, kCycleSize, kCycleSize),
                      visibleFaces(scene, kCycleSize, kCycleSize));
          }
        }
}

/// ---- Polygons that nothing hides

struct List {
  std::vector<Polygon> polygons;
  std::vector<int> byDepth;
};

/// The faces of a scene, and their order by farthest z.
List listOf(const SnappedScene& scene) {
  List list;
  for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f) {
    const SnappedFace& face = scene.faces[f];
    list.polygons.push_back({.extents = extentsOf(scene, face), .face = f});
  }
  list.byDepth.resize(list.polygons.size());
  std::iota(list.byDepth.begin(), list.byDepth.end(), 0);
  std::ranges::stable_sort(list.byDepth, {}, [&](int i) { return list.polygons[i].extents.zFar; });
  return list;
}

/// True if plane Q is nearer than plane P at the centre of pixel (i, j).
bool isNearer(const ScreenPlane& Q, const ScreenPlane& P, int i, int j) {
  const ExactPoint centre{Rational{i * kGrid + kGrid / 2}, Rational{j * kGrid + kGrid / 2}};
  return valueAt(exactDifference(Q, P), centre) > 0;
}

/// A square parallel to the screen, from pixel (at, at) on.
void addSquare(SnappedScene& scene, int at, int side, int z) {
  const int a = at * kGrid, b = (at + side) * kGrid, first = static_cast<int>(scene.vertices.size());
  scene.vertices.insert(scene.vertices.end(), {{a, a, z}, {a, b, z}, {b, b, z}, {b, a, z}});
  SnappedFace face;
  face.first = first, face.count = 4, face.number = face.plane = static_cast<int>(scene.faces.size());
  scene.faces.push_back(face);
  scene.planes.add(planeThrough(&scene.vertices[first], 4));
}

std::vector<bool> freeOf(const SnappedScene& scene) {
  const List list = listOf(scene);
  return freePolygons(scene, list.polygons, list.byDepth, kSize, kSize);
}

// At every sample that a free polygon shares with a later one of the list, the later one is nearer, by
// rational arithmetic.
TEST(FreePolygons, LaterOnesAreNearerAtTheirSamples) {
  const Seeds seeds{120};
  int shared = 0, freeOnes = 0, others = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(testing::Message() << "XNEWELL_SEED=" << seed);
    const SnappedScene scene = randomScene(seed, 12, kSize);
    const List list = listOf(scene);
    const std::vector<bool> free = freePolygons(scene, list.polygons, list.byDepth, kSize, kSize);
    if (free.empty()) continue;
    std::vector<ExactRegion> outlines;
    for (const SnappedFace& face : scene.faces) outlines.push_back(exactOutline(scene, face));
    for (std::size_t k = 0; k < free.size(); ++k) {
      ++(free[k] ? freeOnes : others);
      if (!free[k]) continue;
      const int P = list.byDepth[k];
      for (std::size_t later = k + 1; later < free.size(); ++later) {
        const int Q = list.byDepth[later];
        const ExactRegion both = common(outlines[P], outlines[Q]);
        if (both.empty()) continue;
        for (int j = 0; j < kSize; ++j)
          for (int i = 0; i < kSize; ++i) {
            if (!exactlyCovers(both, i, j)) continue;
            ++shared;
            ASSERT_TRUE(
                isNearer(scene.planes[scene.faces[Q].plane], scene.planes[scene.faces[P].plane], i, j))
                << P << " before " << Q << " at " << i << ", " << j;
          }
      }
    }
  }
  if (!seeds.all()) return;
  EXPECT_GT(shared, 1'000);
  EXPECT_GT(freeOnes, 200);
  EXPECT_GT(others, 200);
}

// Two squares that share a sample have an order by z alone, or need a test. If they share none, they need
// none.
TEST(FreePolygons, TwoSquares) {
  SnappedScene apart;
  addSquare(apart, 1, 8, 100);
  addSquare(apart, 9, 8, 100);
  EXPECT_EQ(freeOf(apart), (std::vector{true, true}));
  SnappedScene behind;
  addSquare(behind, 1, 8, 100);
  addSquare(behind, 8, 8, 103);
  EXPECT_EQ(freeOf(behind), (std::vector{true, true}));
  SnappedScene inOnePlane;
  addSquare(inOnePlane, 1, 8, 100);
  addSquare(inOnePlane, 8, 8, 100);
  EXPECT_EQ(freeOf(inOnePlane), (std::vector{false, true}));
}

// A few large polygons are compared at once.
TEST(FreePolygons, LargeOnesAreNotLookedAt) {
  SnappedScene scene;
  for (int k = 0; k < 4; ++k) addSquare(scene, 0, kSize, 100 * k);
  EXPECT_TRUE(freeOf(scene).empty());
}

/// ---- Decals

constexpr int kWallSize = 160;

/// A view from any side of the wall, from far away to as near as a fifth of a decal, steep or slanted.
/// Parallel and perspective views take turns.
ViewSpec randomView(const Mesh& mesh, unsigned seed) {
  std::mt19937 rng{seed + 1};
  std::uniform_real_distribution<double> component{-1.0, 1.0};
  const auto corner = [&](int f, int c) { return mesh.points[mesh.face(f)[c]]; };
  const glm::dvec3 target = (corner(1 + seed % 4, 0) + corner(1 + seed % 4, 2)) / 2.0;
  glm::dvec3 towards;
  do towards = {component(rng), component(rng), component(rng)};
  while (glm::length(towards) < 0.1);
  const bool near = seed / 2 % 2;
  const double scale = glm::length(corner(0, 1) - corner(0, 0));
  const double distance = scale * (near ? 0.02 : 1.5), window = scale * (near ? 0.02 : 0.6);
  return {seed % 2 ? Projection::Perspective : Projection::Parallel,
          target,
          towards,
          {0.3, 0.2, 0.9},
          {0, 0, distance},
          glm::dvec2{-window},
          glm::dvec2{window},
          distance * 0.999,
          -3 * scale};
}

Mesh normalised(Mesh mesh, double scale) {
  for (glm::dvec3& p : mesh.points) p *= scale;
  for (double& u : mesh.rounding) u *= scale;
  double largest = 0.0;
  for (const glm::dvec3& p : mesh.points)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (glm::dvec3& p : mesh.points)
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::ldexp(p[axis], -exponent);
  for (double& u : mesh.rounding) u = std::ldexp(u, -exponent);
  return mesh;
}

/// Which face covers each sample last, for faces without depth.
std::vector<int> lastFaces(SnappedScene scene) {
  scene.planes = {};
  scene.planes.add({});
  for (SnappedFace& face : scene.faces) face.plane = 0;
  return visibleFaces(scene, kWallSize, kWallSize);
}

constexpr int kPlates = 5;  ///< number of the first plate, after the wall and its decals

/// Adds two plates that pass through the wall and its decals, near the middle of the decal that the view
/// looks at. They are rounded as the wall and the decals are.
void addCrossingPlates(Mesh& mesh, unsigned seed) {
  std::mt19937 rng{seed + 2};
  std::uniform_real_distribution<double> component{-1.0, 1.0};
  const auto corner = [&](int f, int c) { return mesh.points[mesh.face(f)[c]]; };
  const int decal = 1 + static_cast<int>(seed % 4);
  const glm::dvec3 a = glm::normalize(corner(0, 1) - corner(0, 0)),
                   N = glm::normalize(glm::cross(a, corner(0, 3) - corner(0, 0))), b = glm::cross(N, a);
  const glm::dvec3 middle = (corner(decal, 0) + corner(decal, 2)) / 2.0;
  for (int k = 0; k < 2; ++k) {
    const double angle = 3.0 * component(rng);
    const glm::dvec3 at = middle + 0.01 * (component(rng) * a + component(rng) * b);
    const glm::dvec3 along = std::cos(angle) * a + std::sin(angle) * b;
    const glm::dvec3 through = glm::normalize(N + component(rng) * glm::cross(N, along));
    addRounded(mesh,
               {at - 0.2 * along - 0.1 * through, at + 0.2 * along - 0.1 * through,
                at + 0.2 * along + 0.1 * through, at - 0.2 * along + 0.1 * through},
               kDecimals[seed % kDecimals.size()]);
  }
}

/// The number of the face of the wall or its decals that covers each sample last, as if there were no plates.
std::vector<int> lastOfWall(SnappedScene scene) {
  std::erase_if(scene.faces, [](const SnappedFace& face) { return face.number >= kPlates; });
  std::vector<int> last = lastFaces(scene);
  for (int& face : last)
    if (face != kNothing) face = scene.faces[face].number;
  return last;
}

// Faces in one plane are seen in the order of the scene, in every sample of every view. If each face has its
// own plane, thousands of samples are wrong.
TEST(Decals, TheLaterIsSeen) {
  long decalSamples = 0, nearSamples = 0, lostWithout = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = normalised(wallWithDecals(seed), std::pow(10.0, static_cast<int>(seed % 13) - 6));
    ConvexParts parts = divideFaces(mesh);
    const std::vector<int> ownPlanes = parts.plane;
    uniteCoplanar(mesh, parts);
    const ViewSpec view = randomView(mesh, seed);
    const SnappedScene scene = project(mesh, parts, view, kWallSize, kWallSize, Cull::Keep);
    const std::vector<int> seen = visibleFaces(scene, kWallSize, kWallSize), last = lastFaces(scene);
    int lost = 0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      lost += seen[k] != last[k];
      const bool decal = last[k] != kNothing && scene.faces[last[k]].number > 0;
      decalSamples += decal;
      nearSamples += decal && seed / 2 % 2;
    }
    EXPECT_EQ(lost, 0);
    EXPECT_LE(scene.planes.size(), 1u);
    parts.plane = ownPlanes, parts.planes = {}, parts.own = {}, parts.frame.reset();
    const std::vector<int> without =
        visibleFaces(project(mesh, parts, view, kWallSize, kWallSize, Cull::Keep), kWallSize, kWallSize);
    for (std::size_t k = 0; k < seen.size(); ++k) lostWithout += without[k] != last[k];
  }
  EXPECT_GT(decalSamples, 1'000'000);
  EXPECT_GT(nearSamples, 300'000);
  EXPECT_GT(lostWithout, 100'000);
}

// The depth sort loses none of a decal's pixels to the face under it, even if both are split. Two plates pass
// through the wall and its decals, and each choice of the polygon to split is tried.
TEST(Decals, KeepTheirPixelsWhenSplit) {
  constexpr std::array kSplits{SortSettings::Split::Smaller, SortSettings::Split::First,
                               SortSettings::Split::Second};
  long plateSamples = 0, wallPieces = 0, decalPieces = 0, platePieces = 0;
  std::array<long, 2> decalSamples{};  // for parallel and for perspective views
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    const double scale = std::pow(10.0, static_cast<int>(seed % 13) - 6);
    Mesh mesh = wallWithDecals(seed);
    addCrossingPlates(mesh, seed);
    mesh = normalised(mesh, scale);
    ConvexParts parts = divideFaces(mesh);
    uniteCoplanar(mesh, parts);
    const ViewSpec view = randomView(mesh, seed);
    const SnappedScene scene = project(mesh, parts, view, kWallSize, kWallSize, Cull::Keep);
    const std::vector<int> last = lastOfWall(scene), seen = visibleFaces(scene, kWallSize, kWallSize);
    for (const bool textbook : {false, true}) {
      SortSettings settings{kWallSize, kWallSize, textbook};
      settings.crossing = kSplits[seed % kSplits.size()];
      const SortedScene sorted = depthSort(scene, settings);
      const std::vector<int> shown = painted(scene, sorted, kWallSize, kWallSize);
      int lost = 0, wrong = 0;
      for (std::size_t k = 0; k < shown.size(); ++k) {
        wrong += shown[k] != seen[k] && !mayTouch(scene, shown[k], seen[k], static_cast<int>(k), kWallSize);
        if (shown[k] == kNothing) continue;
        const bool plate = scene.faces[shown[k]].number >= kPlates;
        plateSamples += plate;
        if (plate) continue;
        lost += scene.faces[shown[k]].number != last[k];
        decalSamples[seed % 2] += last[k] > 0;
      }
      EXPECT_EQ(lost, 0);
      EXPECT_EQ(wrong, 0);
      for (const Fragment& fragment : sorted.fragments) {
        const int number = scene.faces[fragment.face].number;
        if (fragment.piece >= 0) ++(number == 0 ? wallPieces : number < kPlates ? decalPieces : platePieces);
      }
    }
  }
  EXPECT_GT(decalSamples[0], 1'000'000);
  EXPECT_GT(decalSamples[1], 1'000'000);
  EXPECT_GT(plateSamples, 1'000'000);
  EXPECT_GT(wallPieces, 500);
  EXPECT_GT(decalPieces, 500);
  EXPECT_GT(platePieces, 1'000);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
