#include "depthsort/pair_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "depthsort/box_grid.h"
#include "depthsort/depth_sort.h"
#include "depthsort/order.h"
#include "tests/support/painted.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// Whole faces, painted in this order.
std::vector<int> paintedIn(const SnappedScene& scene, const std::vector<int>& order, int size) {
  SortedScene sorted;
  for (const int face : order) sorted.fragments.push_back({.face = face});
  return painted(scene, sorted, size, size);
}

}  // namespace

// If the pairs prove an order, every sample shows its nearest face. The judge is the oracle.
TEST(PairCheck, ProvesOnlyOrdersThatAreRight) {
  constexpr int kSize = 48;
  const Seeds seeds{1200};
  int proved = 0, refuted = 0, pairs = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    const SnappedScene scene = randomScene(seed, 2 + static_cast<int>(seed % 7), kSize);
    for (const Order method : {Order::Unsorted, Order::ZMean, Order::ZSort}) {
      SCOPED_TRACE(seed);
      const std::vector<int> order = paintingOrder(scene, method);
      const PairCheck check = checkPairs(scene, order, kSize, kSize);
      EXPECT_TRUE(check.complete);
      const bool right = paintedIn(scene, order, kSize) == visibleFaces(scene, kSize, kSize);
      if (check.proves()) {
        EXPECT_TRUE(right);
      }
      proved += check.proves() && check.pairs > 0, refuted += check.outOfOrder > 0;
      pairs += static_cast<int>(check.pairs);
    }
  }
  if (seeds.all()) {
    EXPECT_GT(proved, 300);
    EXPECT_GT(refuted, 300);
    EXPECT_GT(pairs, 3000);
  }
}

// The pairs are those whose boxes overlap, each once.
TEST(PairCheck, LooksAtEveryPairOnce) {
  constexpr int kSize = 48;
  const SnappedScene scene = randomScene(SceneKind::BigTriangles, 5, 40, kSize);
  std::vector<int> order(scene.faces.size());
  std::iota(order.begin(), order.end(), 0);
  const auto boxOf = [&](const SnappedFace& face) {
    ScreenBox box{scene.vertices[face.first].x, scene.vertices[face.first].y, scene.vertices[face.first].x,
                  scene.vertices[face.first].y};
    for (int v = face.first; v < face.first + face.count; ++v) {
      const glm::ivec3& at = scene.vertices[v];
      box = {std::min(box.x0, at.x), std::min(box.y0, at.y), std::max(box.x1, at.x), std::max(box.y1, at.y)};
    }
    return box;
  };
  std::int64_t pairs = 0;
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) pairs += boxOf(scene.faces[a]).overlaps(boxOf(scene.faces[b]));
  EXPECT_EQ(checkPairs(scene, order, kSize, kSize).pairs, pairs);
  const PairCheck some = checkPairs(scene, order, kSize, kSize, pairs - 1);
  EXPECT_FALSE(some.complete);
  EXPECT_FALSE(some.proves());
  EXPECT_TRUE(checkPairs(scene, order, kSize, kSize, pairs).complete);
}

}  // namespace xnewell::THIS_FILE
