#include <gtest/gtest.h>

#include <array>

#include "tests/support/painted.h"
#include "tests/support/random_scenes.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kSize = 64;

/// Four beams around a square. Each lies along one side, begins under the one before it and ends over the
/// next. `turns` says how often the first is turned by a quarter.
SnappedScene fourBeams(int length, int halfWidth, int slope, int turns) {
  constexpr int kMiddle = kSize / 2 * kGrid, kSide = 16 * kGrid;
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

}  // namespace

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
                depthSort(scene, {.width = kSize, .height = kSize, .textbook = textbook});
            EXPECT_EQ(sorted.statistics.splits, 1);
            EXPECT_EQ(sorted.statistics.cycles, 1);
            EXPECT_EQ(sorted.fragments.size(), 5u);
            EXPECT_EQ(painted(scene, sorted, kSize, kSize), visibleFaces(scene, kSize, kSize));
          }
        }
}

}  // namespace xnewell::THIS_FILE
