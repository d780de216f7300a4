#include "depthsort/bsp_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "depthsort/oracle.h"
#include "geometry/model/solids.h"
#include "geometry/view/camera.h"
#include "tests/bench/triangulated.h"
#include "tests/support/painted.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// For each face, how often each of its samples is painted.
std::vector<std::vector<int>> timesPainted(const SnappedScene& scene, const SortedScene& sorted, int size) {
  std::vector<std::vector<int>> times(scene.faces.size(), std::vector<int>(std::size_t(size) * size));
  for (const Fragment& fragment : sorted.fragments)
    forEachSpan(scene, sorted, fragment, size, size, [&](int row, int from, int to) {
      for (int i = from; i < to; ++i) ++times[fragment.face][std::size_t(row) * size + i];
    });
  return times;
}

SnappedScene seen(Mesh mesh, int width, int height) {
  const Camera camera = placeCamera({}, mesh.points, UpAxis::Z, static_cast<double>(width) / height);
  return project(mesh, divideFaces(mesh), camera.view, width, height, Cull::Keep);
}

}  // namespace

// The picture shows the oracle's face at every sample, in every kind of scene, contacts included. Each sample
// of a face belongs to exactly one of its fragments, unless the face is left out because it owns none.
TEST(BspTree, ShowsTheNearestFaceAtEverySample) {
  const Seeds seeds{1600};
  constexpr int kSize = 24;
  std::int64_t splits = 0, together = 0, covered = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomScene(seed, 4 + static_cast<int>(seed % 17), kSize);
    const BspTree tree = bspTree(scene, {.width = kSize, .height = kSize});
    const SortedScene sorted = backToFront(tree);
    const std::vector<int> shown = painted(scene, sorted, kSize, kSize),
                           visible = visibleFaces(scene, kSize, kSize);
    for (std::size_t k = 0; k < shown.size(); ++k)
      ASSERT_EQ(shown[k], visible[k]) << "sample " << k % kSize << ", " << k / kSize;
    const std::vector<std::vector<int>> times = timesPainted(scene, sorted, kSize);
    for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f) {
      const SnappedFace& face = scene.faces[f];
      std::vector<int> owned(times[f].size());
      forEachSpan(&scene.vertices[face.first], face.count, kSize, kSize, [&](int row, int from, int to) {
        for (int i = from; i < to; ++i) owned[std::size_t(row) * kSize + i] = 1;
      });
      ASSERT_EQ(times[f], owned) << "face " << f;
      covered += std::accumulate(owned.begin(), owned.end(), 0);
    }
    splits += sorted.statistics.splits;
    for (const BspNode& node : tree.nodes) together += node.count > 1;
  }
  if (!seeds.all()) return;
  EXPECT_GT(splits, 5'000);
  EXPECT_GT(together, 1'000);
  EXPECT_GT(covered, 100'000);
}

// Nothing, and one face, and many copies of one face.
TEST(BspTree, DegenerateScenes) {
  const SortSettings settings{.width = 16, .height = 16};
  SnappedScene scene;
  EXPECT_TRUE(bspTree(scene, settings).nodes.empty());
  EXPECT_TRUE(backToFront(bspTree(scene, settings)).fragments.empty());

  // A triangle that owns no sample is left out.
  ASSERT_TRUE(addFace(scene, {{100, 100, 5}, {200, 100, 5}, {100, 200, 5}}));
  EXPECT_TRUE(bspTree(scene, settings).nodes.empty());

  scene = {};
  ASSERT_TRUE(addFace(scene, {{0, 0, 5}, {0, 16 * kGrid, 9}, {16 * kGrid, 0, 7}}));
  BspTree tree = bspTree(scene, settings);
  ASSERT_EQ(tree.nodes.size(), 1u);
  EXPECT_EQ(tree.nodes[0].count, 1);
  EXPECT_EQ(tree.sorted.statistics.deepest, 1);

  for (int copies = 0; copies < 999; ++copies) addCopy(scene, 0);
  tree = bspTree(scene, settings);
  ASSERT_EQ(tree.nodes.size(), 1u);  // all lie in one plane
  EXPECT_EQ(tree.nodes[0].count, 1000);
  const SortedScene sorted = backToFront(tree);
  for (int k = 0; k < 1000; ++k) ASSERT_EQ(sorted.fragments[k].face, k);
  EXPECT_EQ(sorted.statistics.bytes, 1000 * std::int64_t{sizeof(Fragment)} + std::int64_t{sizeof(BspNode)});
}

// Two faces that cross are cut once, and a scene whose polygons cross each other's planes again and again
// ends with an error instead of filling the memory.
TEST(BspTree, HasAtMostSoManyPieces) {
  SnappedScene scene;
  ASSERT_TRUE(addFace(scene, {{0, 0, 0}, {0, 16 * kGrid, 0}, {16 * kGrid, 0, 1000}}));
  ASSERT_TRUE(addFace(scene, {{0, 0, 1000}, {0, 16 * kGrid, 1000}, {16 * kGrid, 0, 0}}));
  EXPECT_EQ(bspTree(scene, {.width = 16, .height = 16, .mostPieces = 2}).sorted.statistics.splits, 1);
  EXPECT_THROW(bspTree(scene, {.width = 16, .height = 16, .mostPieces = 1}), TooManyPieces);

  const SnappedScene many = randomScene(SceneKind::BigTriangles, 7, 200, 32);
  try {
    (void)bspTree(many, {.width = 32, .height = 32, .mostPieces = 500});
    ADD_FAILURE() << "no error";
  } catch (const TooManyPieces& e) {
    EXPECT_EQ(e.what(),
              std::string{"the BSP tree needs more than 500 pieces, for the polygons cross too often; "
                          "--max-fragments allows more, and --order oracle needs none"});
  }
}

// A torus of 64,800 triangles, and a sphere: a convex solid has no plane that divides it, so its tree is
// nearly a list. There is no recursion that could overflow.
TEST(BspTree, ManyPolygons) {
  for (const bool convex : {false, true}) {
    SCOPED_TRACE(convex);
    constexpr int kWidth = 800, kHeight = 600;
    const int side = kSanitized ? 40 : convex ? 100 : 180;
    const SnappedScene scene =
        seen(triangulated(convex ? sphere(side, side) : torus(side, side)), kWidth, kHeight);
    const SortSettings settings{.width = kWidth, .height = kHeight};
    const BspTree tree = bspTree(scene, settings);
    if (convex) {
      EXPECT_GT(tree.sorted.statistics.deepest, side * side / 2);
    }
    const SortedScene sorted = backToFront(tree);
    EXPECT_EQ(sorted.fragments.size(), tree.sorted.fragments.size());
    EXPECT_EQ(painted(scene, sorted, kWidth, kHeight), visibleFaces(scene, kWidth, kHeight));
  }
}

// A plane that crosses a face only between samples does not split it, as at the common edge of two faces
// after their corners were rounded. Here each plane of a valley, or of a ridge, crosses the other face, at
// one end of the edge.
TEST(BspTree, SplitsOffNothingThatOwnsNoSample) {
  constexpr int kHalf = 8 * kGrid, kEnd = 16 * kGrid;
  for (const int side : {200, 0})
    for (const int off : {1, 30}) {  // the part is at most a twelfth of a pixel wide, or two pixels
      SnappedScene scene;
      ASSERT_TRUE(addFace(scene, {{0, kHalf, side}, {kHalf, kEnd, 100 + off}, {kHalf, 0, 100 - off}}));
      ASSERT_TRUE(addFace(scene, {{kEnd, kHalf, side}, {kHalf, 0, 100 + off}, {kHalf, kEnd, 100 - off}}));
      const BspTree tree = bspTree(scene, {.width = 16, .height = 16});
      EXPECT_EQ(tree.sorted.statistics.splits, off == 1 ? 0 : 1);
      EXPECT_EQ(painted(scene, backToFront(tree), 16, 16), visibleFaces(scene, 16, 16));
    }
}

// In pixels, faces without a sample stay in the tree, as in the depth sort.
TEST(BspTree, KeepsWhatShowsInPixels) {
  SnappedScene scene;
  // It misses the centres of all pixels, but its corners are rounded to three pixels.
  const auto tenth = [](int n) { return n * kGrid / 10; };
  ASSERT_TRUE(
      addFace(scene, {{tenth(16), tenth(11), 5}, {tenth(16), tenth(24), 5}, {tenth(24), tenth(11), 5}}));
  EXPECT_EQ(visibleFaces(scene, 8, 8), std::vector<int>(64, kNothing));
  EXPECT_EQ(bspTree(scene, {.width = 8, .height = 8}).nodes.size(), 0u);
  EXPECT_EQ(bspTree(scene, {.width = 8, .height = 8, .inPixels = true}).nodes.size(), 1u);
}

}  // namespace xnewell::THIS_FILE
