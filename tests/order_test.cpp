#include "depthsort/order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

// The radix sort is std::stable_sort by key: same order, equal keys by index.
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
