#include "depthsort/depth_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/support/painted.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

void add(SortStatistics& sum, const SortStatistics& s) {
  for (int t = 0; t < kTests; ++t) sum.settled[t] += s.settled[t];
  sum.moves += s.moves, sum.cycles += s.cycles, sum.impossible += s.impossible, sum.splits += s.splits;
  sum.vain += s.vain;
  sum.voids += s.voids, sum.contacts += s.contacts, sum.areas += s.areas, sum.hidden += s.hidden;
  sum.free += s.free;
  sum.deepest = std::max(sum.deepest, s.deepest);
}

struct Way {
  const char* name;
  bool textbook, grid, areas;
  SortSettings::Split crossing;
};
using enum SortSettings::Split;
constexpr std::array kWays{
    Way{"quick", false, true, true, Smaller},
    Way{"quick, first", false, true, true, First},
    Way{"quick, second", false, true, true, Second},
    Way{"one area", false, true, false, Smaller},
    Way{"one area, second", false, true, false, Second},
    Way{"one list", false, false, false, Smaller},
    Way{"textbook", true, false, false, Smaller},
    Way{"textbook, first", true, false, false, First},
    Way{"textbook, second", true, false, false, Second},
};

}  // namespace

// Painting in the order of the depth sort shows what the oracle sees, in every sample. This holds for scenes
// of every kind, for both runs, for every choice of the polygon to split, and for every size of the picture.
// The scenes are made for 32 by 32 pixels, so the other pictures cut them off or show them in a corner.
TEST(DepthSort, PaintsWhatTheOracleSees) {
  struct Size {
    int width, height;
  };
  constexpr std::array kSizes{Size{32, 32}, Size{1, 1}, Size{40, 11}, Size{7, 48}};
  const Seeds seeds{1600};
  SortStatistics quick, textbook;
  std::array<int, kSceneKinds.size()> covered{};  ///< number of samples, by kind of scene
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    const SnappedScene scene = randomScene(seed, 2 + static_cast<int>(seed / kSceneKinds.size()) % 17, 32);
    for (std::size_t s = 0; s < kSizes.size(); ++s) {
      const auto [width, height] = kSizes[s];
      const std::vector<int> seen = visibleFaces(scene, width, height);
      for (const Way& way : kWays) {
        // every run in the first size, one run in the other sizes
        if (s > 0 && &way != &kWays[seed % kWays.size()]) continue;
        SCOPED_TRACE(testing::Message()
                     << "XNEWELL_SEED=" << seed << ", " << way.name << ", " << width << " by " << height);
        const SortedScene sorted = depthSort(scene, {.width = width,
                                                     .height = height,
                                                     .textbook = way.textbook,
                                                     .grid = way.grid,
                                                     .areas = way.areas,
                                                     .crossing = way.crossing});
        const std::vector<int> shown = painted(scene, sorted, width, height);
        for (int k = 0; k < width * height; ++k) {
          covered[seed % covered.size()] += seen[k] != kNothing;
          ASSERT_EQ(shown[k], seen[k]) << "sample " << k % width << ", " << k / width;
        }
        add(way.textbook ? textbook : quick, sorted.statistics);
      }
    }
  }
  if (!seeds.all()) return;
  // The property was really tested: every test settled pairs, and every kind of event happened.
  for (int t = 0; t < kTests; ++t) {
    const bool extents =
        kTestRows[t].id == xnewell::Test::XExtents || kTestRows[t].id == xnewell::Test::YExtents;
    EXPECT_GT(textbook.settled[t], 10'000) << kTestRows[t].name;
    if (extents) {
      EXPECT_EQ(quick.settled[t], 0) << "the quick run compares boxes before";
    } else {
      EXPECT_GT(quick.settled[t], 10'000) << kTestRows[t].name;
    }
  }
  for (const SortStatistics& s : {quick, textbook}) {
    EXPECT_GT(s.moves, 100'000);
    EXPECT_GT(s.cycles, 9'000);
    EXPECT_GT(s.impossible, 15'000);
    EXPECT_GT(s.vain, 2'000);
    EXPECT_GT(s.splits, 50'000);
    EXPECT_GT(s.voids, 100);
    EXPECT_GT(s.contacts, 400);
    EXPECT_GE(s.deepest, 12);
  }
  EXPECT_GT(quick.areas, 10'000);
  EXPECT_GT(quick.hidden, 10'000);
  EXPECT_GT(quick.free, 10'000);
  EXPECT_EQ(textbook.free, 0);
  EXPECT_EQ(textbook.areas, 0);
  for (std::size_t k = 0; k < covered.size(); ++k) EXPECT_GT(covered[k], 1'000) << kSceneKinds[k].name;
}

// The parts of one face in one plane need no order among themselves, however many there are: no pair of them
// is even looked at. With another face beside them the picture is as ever.
TEST(DepthSort, AsksNothingWithinOneSurface) {
  constexpr int kSize = 64, kSide = kSize * kGrid;
  SnappedScene scene;
  for (int k = 0; k < 2000; ++k) {  // needles across the picture, in one plane
    const int x = k * (kSide / 2000);
    ASSERT_TRUE(
        addFace(scene, {{x, 0, 500}, {x, kSide, 500}, {kSide - x / 2, kSide / 2, 500}}, k == 0 ? -1 : 0));
    scene.faces.back().number = 0;
  }
  const SortSettings settings{.width = kSize, .height = kSize};
  const SortedScene alone = depthSort(scene, settings);
  EXPECT_EQ(alone.statistics.pairs(), 0);
  EXPECT_EQ(alone.statistics.boxesApart, (decltype(alone.statistics.boxesApart){}));
  EXPECT_GT(alone.fragments.size(), 1000u);

  ASSERT_TRUE(addFace(scene, {{0, 0, 0}, {0, kSide, 1000}, {kSide, 0, 1000}}));
  const SortedScene both = depthSort(scene, settings);
  EXPECT_GT(both.statistics.pairs(), 0);
  const std::vector<int> seen = visibleFaces(scene, kSize, kSize), shown = painted(scene, both, kSize, kSize);
  for (std::size_t k = 0; k < seen.size(); ++k) ASSERT_EQ(seen[k] == 2000, shown[k] == 2000) << k;
}

}  // namespace xnewell::THIS_FILE
