#include "depthsort/order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace xnewell::THIS_FILE {

// The radix sort gives the result of std::stable_sort by key: equal keys stay in order of index.
TEST(Order, RadixSortIsTheStableSort) {
  std::mt19937 rng{1972};
  for (const std::uint32_t range : {3u, 5000u, 0xFFFFFFFFu}) {
    std::vector<std::uint32_t> keys(10'000);
    for (auto& k : keys) k = std::uniform_int_distribution<std::uint32_t>{0, range}(rng);
    std::vector<int> expected(keys.size());
    std::iota(expected.begin(), expected.end(), 0);
    std::stable_sort(expected.begin(), expected.end(), [&](int a, int b) { return keys[a] < keys[b]; });
    EXPECT_EQ(sortedByKey(keys), expected);
  }
  EXPECT_TRUE(sortedByKey({}).empty());
}

namespace {

SnappedScene facesAt(const std::vector<std::array<int, 3>>& z) {
  SnappedScene scene;
  for (const auto& triple : z) {
    scene.faces.push_back(
        {static_cast<int>(scene.vertices.size()), 3, static_cast<int>(scene.faces.size()), false});
    for (int i = 0; i < 3; ++i) scene.vertices.push_back({i * i, i, triple[i]});
  }
  return scene;
}

}  // namespace

// The farthest face comes first, by the smallest z, by the mean z, or as listed. At equal z the order is that
// of the scene, so that the later face is painted later and wins.
TEST(Order, FarthestFirst) {
  const SnappedScene scene = facesAt({{5, 90, 90}, {40, 50, 60}, {4, 10, 10}, {5, 6, 7}, {60, 50, 40}});
  EXPECT_EQ(paintingOrder(scene, Order::ZSort), (std::vector{2, 0, 3, 1, 4}));
  EXPECT_EQ(paintingOrder(scene, Order::ZMean), (std::vector{3, 2, 1, 4, 0}));
  EXPECT_EQ(paintingOrder(scene, Order::Unsorted), (std::vector{0, 1, 2, 3, 4}));
}

}  // namespace xnewell::THIS_FILE
