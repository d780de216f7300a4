#include "depthsort/areas.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "depthsort/oracle.h"
#include "tests/support/painted.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

// The areas into which the picture is divided where polygons cross too often.

// Scenes of many crossing polygons, in pictures of many areas, show what the oracle sees.
TEST(Areas, PaintWhatTheOracleSees) {
  constexpr int kSize = 96;
  const Seeds seeds{400};
  std::int64_t areas = 0, hidden = 0, covered = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(testing::Message() << "XNEWELL_SEED=" << seed);
    const SnappedScene scene = randomScene(seed, 20 + static_cast<int>(seed) % 40, kSize);
    const SortedScene sorted = depthSort(scene, {kSize, kSize});
    const std::vector<int> seen = visibleFaces(scene, kSize, kSize),
                           shown = painted(scene, sorted, kSize, kSize);
    for (int k = 0; k < kSize * kSize; ++k) {
      covered += seen[k] != kNothing;
      ASSERT_EQ(shown[k], seen[k]) << "sample " << k % kSize << ", " << k / kSize;
    }
    areas += sorted.statistics.areas, hidden += sorted.statistics.hidden;
  }
  if (!seeds.all()) return;
  EXPECT_GT(areas, 5'000);
  EXPECT_GT(hidden, 20'000);
  EXPECT_GT(covered, 1'000'000);
}

// No sample is painted by two fragments of one face, and none lies outside the area of its piece.
TEST(Areas, ShareOutTheSamplesOfAFace) {
  constexpr int kSize = 48;
  std::int64_t pieces = 0;
  for (unsigned seed = 0; seed < 160; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SnappedScene scene = randomScene(seed, 24, kSize);
    const SortedScene sorted = depthSort(scene, {kSize, kSize});
    // Each split made two pieces; those of runs that gave up are gone, and so are their splits.
    EXPECT_LE(2 * sorted.statistics.splits, std::ssize(sorted.pieces));
    std::vector<std::vector<bool>> taken(scene.faces.size(), std::vector<bool>(kSize * kSize));
    for (const Fragment& fragment : sorted.fragments)
      forEachSpan(scene, sorted, fragment, kSize, kSize, [&](int row, int from, int to) {
        if (fragment.piece >= 0) {
          const PixelArea& area = sorted.pieces[fragment.piece].area;
          ++pieces;
          EXPECT_TRUE(area.top <= row && row < area.bottom && area.left <= from && to <= area.right);
        }
        for (int i = from; i < to; ++i) {
          EXPECT_FALSE(taken[fragment.face][row * kSize + i]);
          taken[fragment.face][row * kSize + i] = true;
        }
      });
  }
  EXPECT_GT(pieces, 10'000);
}

// What is hidden makes no splits: with more triangles through the picture, there are hardly more of them.
TEST(Areas, SplitLittleMoreThanShows) {
  constexpr int kSize = 200;
  std::array<std::int64_t, 2> splits{};
  for (const int k : {0, 1}) {
    const SnappedScene scene = randomScene(SceneKind::BigTriangles, 7, k == 0 ? 60 : 240, kSize);
    const SortedScene sorted = depthSort(scene, {kSize, kSize});
    EXPECT_GT(sorted.statistics.areas, 0);
    splits[k] = sorted.statistics.splits;
  }
  EXPECT_LT(splits[1], 4 * splits[0]);  // in one area, they grow with the third power
}

// Two sheets cross each other by less than their doubt, so the later one shows, and neither is cut. This
// holds in an area too. Large triangles on the left are why there are areas.
TEST(Areas, CutNothingByWhatItMayTouch) {
  constexpr int kSize = 96, kSide = kSize * kGrid, kFar = 1000;
  SnappedScene scene;
  for (const int tilt : {-20, 20})
    ASSERT_TRUE(addFace(scene, {{0, 0, kFar - tilt},
                                {0, kSide, kFar - tilt},
                                {kSide, kSide, kFar + tilt},
                                {kSide, 0, kFar + tilt}}));
  std::mt19937 random{1};
  const auto below = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int k = 0; k < 40; ++k) {
    std::vector<glm::ivec3> corners;
    for (int i = 0; i < 3; ++i)
      corners.emplace_back(below(kSide / 3), below(kSide), 100 * kFar + below(kSide));
    addFace(scene, corners);
  }
  const std::size_t faces = scene.faces.size();
  for (int f = 0; f < std::ssize(scene.faces); ++f) scene.planes.setDoubt(f, {.atBack = 30}, faces);
  const SortedScene sorted = depthSort(scene, {kSize, kSize});
  EXPECT_GT(sorted.statistics.areas, 9);
  const std::vector<int> shown = painted(scene, sorted, kSize, kSize);
  for (int j = 0; j < kSize; ++j)
    for (int i = kSize / 3; i < 2 * kSize / 3; ++i) ASSERT_EQ(shown[j * kSize + i], 1) << i << ", " << j;
}

// A run makes no more pieces than it may, with areas and without.
TEST(Areas, MakeAtMostSoManyPieces) {
  const SnappedScene scene = randomScene(SceneKind::BigTriangles, 7, 60, 64);
  for (const bool areas : {false, true}) {
    SortSettings settings{.width = 64, .height = 64, .areas = areas};
    settings.mostPieces = static_cast<int>(depthSort(scene, settings).pieces.size());
    EXPECT_GT(settings.mostPieces, 100);
    EXPECT_NO_THROW(static_cast<void>(depthSort(scene, settings)));
    settings.mostPieces /= 2;
    EXPECT_THROW(static_cast<void>(depthSort(scene, settings)), TooManyPieces);
  }
}

// The statistics are of the runs that painted. Here the run of the whole picture gives up. Each of the nine
// areas is a pixel, where no run is made, so there is nothing to count but the areas and what is hidden.
TEST(Areas, CountNothingOfARunThatGaveUp) {
  constexpr SortSettings kSettings{.width = 3, .height = 3};
  int divided = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SnappedScene scene = randomScene(SceneKind::BigTriangles, seed, 60, 3);
    const SortStatistics s = depthSort(scene, kSettings).statistics;
    if (s.areas == 0) continue;
    ++divided;
    EXPECT_LE(s.areas, 9);
    EXPECT_EQ(s.pairs(), 0);
    EXPECT_EQ(s.boxesApart, (decltype(s.boxesApart){}));
    EXPECT_EQ(s.moves + s.cycles + s.impossible + s.vain + s.splits + s.voids + s.contacts, 0);
    EXPECT_EQ(s.deepest, 0);
  }
  EXPECT_GT(divided, 10);
}

// Scenes without crossings are one area.
TEST(Areas, AreMadeOnlyWherePolygonsCross) {
  for (const SceneKind kind : {SceneKind::EqualZ, SceneKind::Coplanar, SceneKind::Tiny}) {
    const SortedScene sorted = depthSort(randomScene(kind, 3, 200, 64), {64, 64});
    EXPECT_EQ(sorted.statistics.areas, 0);
    EXPECT_EQ(sorted.statistics.hidden, 0);
  }
}

// A recorded run and the textbook's have one area.
TEST(Areas, AreOfTheQuietQuickRun) {
  const SnappedScene scene = randomScene(SceneKind::BigTriangles, 5, 40, 64);
  EXPECT_GT(depthSort(scene, {64, 64}).statistics.areas, 0);
  for (const SortSettings& settings : {SortSettings{.width = 64, .height = 64, .textbook = true},
                                       SortSettings{.width = 64, .height = 64, .record = true},
                                       SortSettings{.width = 64, .height = 64, .areas = false}})
    EXPECT_EQ(depthSort(scene, settings).statistics.areas, 0);
}

}  // namespace xnewell::THIS_FILE
