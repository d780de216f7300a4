#include "depthsort/free_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/support/exact_region.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kSize = 24;

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

}  // namespace

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

// Where the farthest z of the later one is the nearest z of the other, they may touch there: a test decides.
// This holds for squares and for the triangles that are half of them.
TEST(FreePolygons, OneStepParts) {
  for (const int corners : {3, 4})
    for (const int step : {-1, 0, 1}) {
      SCOPED_TRACE(testing::Message() << corners << " corners, " << step << " steps apart");
      SnappedScene scene;
      for (int k = 0; k < 2; ++k) addSquare(scene, 4, 7, 100), scene.faces[k].count = corners;
      List list = listOf(scene);
      list.polygons[0].extents.zFar = 50, list.polygons[0].extents.zNear = 100;
      list.polygons[1].extents.zFar = 100 + step, list.polygons[1].extents.zNear = 150;
      EXPECT_EQ(freePolygons(scene, list.polygons, list.byDepth, kSize, kSize),
                (std::vector{step > 0, true}));
    }
}

// A few large polygons are compared at once.
TEST(FreePolygons, LargeOnesAreNotLookedAt) {
  SnappedScene scene;
  for (int k = 0; k < 4; ++k) addSquare(scene, 0, kSize, 100 * k);
  EXPECT_TRUE(freeOf(scene).empty());
}

}  // namespace xnewell::THIS_FILE
