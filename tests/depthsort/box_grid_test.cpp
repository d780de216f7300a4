#include "depthsort/box_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace xnewell::THIS_FILE {

namespace {

constexpr int kLimit = 1 << 29;

/// Boxes of one kind: any size, small, strips along x or y, all sizes mixed, points, at the limits.
std::vector<ScreenBox> randomBoxes(unsigned seed, int count) {
  std::mt19937 rng{seed};
  const auto uniform = [&](int low, int high) { return std::uniform_int_distribution{low, high}(rng); };
  const int kind = static_cast<int>(seed % 7), area = 1 << uniform(4, 29);
  std::vector<ScreenBox> boxes;
  while (static_cast<int>(boxes.size()) < count) {
    const auto length = [&](bool along) {
      switch (kind) {
        case 0:
          return uniform(0, 2 * area);
        case 1:
          return uniform(0, area / 16);
        case 2:
          return along ? area : uniform(0, area / 64);
        case 3:
          return along ? uniform(0, area / 64) : area;
        case 4:
          return uniform(0, 1 << uniform(0, 30));
        case 5:
          return 0;
        default:
          return uniform(0, 2) * kLimit;
      }
    };
    const int wide = length(true), high = length(false);
    const int x = kind == 6 ? -kLimit : uniform(-area, area), y = kind == 6 ? -kLimit : uniform(-area, area);
    const auto end = [](int from, int by) {
      return static_cast<int>(std::min<std::int64_t>(kLimit, std::int64_t{from} + by));
    };
    boxes.push_back({x, y, end(x, wide), end(y, high)});
  }
  return boxes;
}

ScreenBox within(const ScreenBox& b, std::mt19937& rng) {
  const auto uniform = [&](int low, int high) { return std::uniform_int_distribution{low, high}(rng); };
  const int x0 = uniform(b.x0, b.x1), y0 = uniform(b.y0, b.y1);
  return {x0, y0, uniform(x0, b.x1), uniform(y0, b.y1)};
}

}  // namespace

// A walk for a box visits no cell twice and reaches every box that overlaps it. If the box shrinks on the
// way, the walk reaches every box that overlaps what is left at the end.
TEST(BoxGrid, WalkFindsAllThatOverlap) {
  long long overlaps = 0, visited = 0, all = 0;
  std::size_t mostCells = 0;
  for (unsigned seed = 0; seed < 700; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const std::vector<ScreenBox> boxes = randomBoxes(seed, 1 + static_cast<int>(seed) % 150);
    for (const bool fine : {true, false}) {
      const BoxGrid grid{boxes, fine};
      mostCells = std::max(mostCells, static_cast<std::size_t>(grid.cells()));
      if (!fine) {
        ASSERT_EQ(grid.cells(), 1);
      }
      for (const ScreenBox& b : boxes) {
        ASSERT_GE(grid.cellOf(b), 0);
        ASSERT_LT(grid.cellOf(b), grid.cells());
      }
      for (const ScreenBox& whole : boxes)
        for (const bool shrinks : {false, true}) {
          std::vector<int> visits(grid.cells());
          ScreenBox box = whole;
          BoxGrid::Place place;
          while (grid.settle(box, place)) {
            ASSERT_LT(grid.cell(place), grid.cells());
            ++visits[grid.cell(place)];
            if (shrinks && rng() % 8 == 0) box = within(box, rng);
            ++place.column;
          }
          ASSERT_LE(*std::ranges::max_element(visits), 1);
          for (const ScreenBox& other : boxes) {
            const int found = visits[grid.cellOf(other)];
            if (box.overlaps(other)) {
              ASSERT_EQ(found, 1);
            }
            overlaps += box.overlaps(other);
            if (fine && !shrinks) visited += found, ++all;
          }
        }
    }
  }
  EXPECT_GT(overlaps, 100'000);
  EXPECT_GT(mostCells, 150u);
  EXPECT_LT(visited, all * 2 / 3);  // otherwise a single cell would do as well
}

}  // namespace xnewell::THIS_FILE
