#include "geometry/exact/overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "geometry/exact/unit.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// Boxes of one kind: all sizes, or flat along some axes and large along others, on a lattice so that ends
/// meet, or many equal along one axis or along all. Groups have two boxes each, or most boxes are in one
/// large group.
std::vector<ItemBox> randomBoxes(unsigned seed) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<float> unit{0.0f, 1.0f};
  const unsigned kind = seed % 5;
  const bool large = seed % 2 == 0;
  std::vector<ItemBox> boxes;
  const int count = 10 + static_cast<int>(unit(rng) * 600.0f);
  for (int i = 0; i < count; ++i) {
    ItemBox& box = boxes.emplace_back(ItemBox{i, large && unit(rng) < 0.9f ? 0 : i / 2, {}, {}});
    for (int axis = 0; axis < 6; ++axis) {
      float low = unit(rng), length = 0.5f * unit(rng);
      if (kind == 1) length *= axis < 3 ? 1e-9f : 2.0f;
      if (kind == 2) low = std::floor(8.0f * low), length = std::floor(8.0f * length);
      if (kind == 3 && axis != 4) low = length = 0.0f;
      if (kind == 4) low = length = 0.25f;
      box.low[axis] = low, box.high[axis] = low + length;
    }
  }
  return boxes;
}

/// Small boxes along a surface, as those of a mesh are. One in a thousand is large.
std::vector<ItemBox> boxesOfASurface(unsigned seed) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<float> unit{0.0f, 1.0f};
  std::vector<ItemBox> boxes;
  for (int i = 0; i < static_cast<int>(kManyBoxes); ++i) {
    ItemBox& box = boxes.emplace_back(ItemBox{i, i / 2, {}, {}});
    const float s = unit(rng), t = unit(rng), length = unit(rng) < 1e-3f ? 0.5f : 0.02f;
    for (int axis = 0; axis < 6; ++axis) {
      box.low[axis] = std::sin(static_cast<float>(axis + 1) * s + 2.0f * static_cast<float>(axis % 2) * t);
      box.high[axis] = box.low[axis] + length * unit(rng);
    }
  }
  return boxes;
}

using Pairs = std::set<std::pair<int, int>>;

/// A comparison of every box with all boxes of other groups.
Pairs overlapping(std::span<const ItemBox> boxes) {
  Pairs pairs;
  for (const ItemBox& P : boxes)
    for (const ItemBox& Q : boxes)
      if (P.item < Q.item && P.group != Q.group && overlap(P, Q)) pairs.insert({P.item, Q.item});
  return pairs;
}

Pairs visited(std::vector<ItemBox> boxes) {
  Pairs pairs;
  forOverlapping(std::span{boxes}, [&](int i, int j) {
    ASSERT_NE(i, j);
    pairs.insert(std::minmax(i, j));
  });
  return pairs;
}

}  // namespace

// The function finds exactly the pairs that a comparison of every box with all boxes of other groups finds.
TEST(Overlap, FindsEveryPair) {
  const Seeds seeds{200};
  std::size_t found = 0, apart = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<ItemBox> boxes = randomBoxes(seed);
    const Pairs expected = overlapping(boxes);
    apart += boxes.size() * (boxes.size() - 1) / 2 - expected.size();
    EXPECT_EQ(visited(boxes), expected);
    found += expected.size();
  }
  if (!seeds.all()) return;
  EXPECT_GT(found, 100'000u);
  EXPECT_GT(apart, 100'000u);
}

// It finds them among so many boxes that they are put into cells, too. Some boxes reach across many cells.
TEST(Overlap, FindsEveryPairInCells) {
  const Seeds seeds{8};
  int cells = 0;
  std::size_t found = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<ItemBox> boxes = boxesOfASurface(seed);
    const Pairs expected = overlapping(boxes);
    EXPECT_EQ(visited(boxes), expected);
    found += expected.size();
    const auto boxAt = [&](std::size_t k) { return boxes[k]; };
    cells += BoxCells{boxes.size(), boxAt}.lists(boxes.size(), boxAt).cells();
  }
  if (!seeds.all()) return;
  EXPECT_GT(found, 1'000u);
  EXPECT_GT(cells, 1'000);
}

}  // namespace xnewell::THIS_FILE
