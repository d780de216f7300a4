#include "depthsort/samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "depthsort/fragment_spans.h"
#include "tests/support/exact_region.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// The sign by the definition of the sample rule, in rational arithmetic.
int exactSignAtSample(const ExactLine& line, int i, int j) {
  const Rational value = valueAt(line, {Rational{2 * i + 1, 2} * kGrid, Rational{2 * j + 1, 2} * kGrid});
  return (value != 0 ? value : line.a != 0 ? line.a : line.b).sign();
}

}  // namespace

// The sides of samples, and their owners, agree with rational arithmetic. The regions are parts of faces
// clipped by the planes of others, many of them thin, in pictures that do not show them whole.
TEST(Samples, AreOwnedByTheRule) {
  const Seeds seeds{1600};
  int owning = 0, empty = 0, ties = 0, asked = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const int width = 1 + static_cast<int>(rng() % 12), height = 1 + static_cast<int>(rng() % 12);
    const SnappedScene scene = randomScene(seed, 5, 12);
    const Regions regions{scene};
    Region region;
    regions.outline(scene.faces[0], region);
    ExactRegion exact = exactOutline(scene, scene.faces[0]);
    for (std::size_t f = 0; f < scene.faces.size() && !region.empty(); ++f) {
      const int over = scene.faces[0].plane, under = scene.faces[f].plane;
      if (!regions.samePlane(over, under)) {
        const Line cut = regions.cut(over, under);
        const ExactLine exactCut = exactDifference(scene.planes[over], scene.planes[under]);
        for (int k = 0; k < 4; ++k) {
          const int i = static_cast<int>(rng() % 12), j = static_cast<int>(rng() % 12);
          ASSERT_EQ(signAtSample(scene, cut, i, j), exactSignAtSample(exactCut, i, j));
          ties += valueAt(exactCut, {Rational{2 * i + 1, 2} * kGrid, Rational{2 * j + 1, 2} * kGrid}) == 0;
          ++asked;
        }
        const bool flip = rng() % 2;
        regions.clip(region, flip ? Regions::flipped(cut) : cut);
        exact = clipped(exact, flip ? exactDifference(scene.planes[under], scene.planes[over]) : exactCut);
      }
      if (region.empty()) break;
      const bool owns = exactlyOwnsSample(exact, width, height);
      ASSERT_EQ(ownsSample(scene, region, width, height), owns);
      ++(owns ? owning : empty);
    }
  }
  if (!seeds.all()) return;
  EXPECT_GT(owning, 1'500);
  EXPECT_GT(empty, 500);
  EXPECT_GT(asked, 8'000);
  EXPECT_GT(ties, 20);
}

// A face that is left out owns no sample. Every face that owns no sample, and whose box has at most four
// samples, is left out.
TEST(Samples, MayOwnIsFalseOnlyWhereNoneIsOwned) {
  const Seeds seeds{3200};
  int may = 0, none = 0, needless = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const int width = 1 + static_cast<int>(seed % 10), height = 1 + static_cast<int>(seed % 9);
    for (const SnappedScene& scene : {randomScene(seed, 3, 10), randomScene(SceneKind::Tiny, seed, 3, 10)})
      for (const SnappedFace& face : scene.faces) {
        const glm::ivec3* const v = &scene.vertices[face.first];
        const auto [x0, x1] =
            std::minmax_element(v, v + face.count, [](auto& a, auto& b) { return a.x < b.x; });
        const auto [y0, y1] =
            std::minmax_element(v, v + face.count, [](auto& a, auto& b) { return a.y < b.y; });
        const bool owns = exactlyOwnsSample(exactOutline(scene, face), width, height);
        const bool mayOwn = mayOwnSample(scene, face, {x0->x, y0->y, x1->x, y1->y}, width, height);
        ASSERT_TRUE(mayOwn || !owns);
        if (x1->x - x0->x < 2 * kGrid && y1->y - y0->y < 2 * kGrid) {
          ASSERT_EQ(mayOwn, owns);
        }
        ++(mayOwn ? may : none);
        needless += mayOwn && !owns;
      }
  }
  if (!seeds.all()) return;
  EXPECT_GT(may, 5'000);
  EXPECT_GT(none, 2'000);
  EXPECT_GT(needless, 0);
}

// A region is thick if 2 area / diameter is more than 64 steps.
TEST(Samples, WideIsThickerThanTheBound) {
  const auto rectangle = [](int wide, int high) {
    SnappedScene scene;
    addFace(scene, {{0, 0, 0}, {0, high, 0}, {wide, high, 0}, {wide, 0, 0}});
    Region region;
    Regions{scene}.outline(scene.faces[0], region);
    return region;
  };
  EXPECT_FALSE(isWide(rectangle(1 << 20, 31)));
  EXPECT_FALSE(isWide(rectangle(31, 1 << 20)));
  EXPECT_TRUE(isWide(rectangle(1 << 20, 33)));
  EXPECT_TRUE(isWide(rectangle(33, 1 << 20)));
}

// A walk along a cut leaves the columns of a row that are on its side, in rational arithmetic too.
TEST(FragmentSpans, CutWalkLeavesWhatIsOnItsSide) {
  const Seeds seeds{800};
  int some = 0, allOrNone = 0, level = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomScene(seed, 4, 40);
    for (int p = 0; p < static_cast<int>(scene.planes.size()); ++p)
      for (int q = 0; q < static_cast<int>(scene.planes.size()); ++q) {
        const ExactLine difference = exactDifference(scene.planes[p], scene.planes[q]);
        if (difference.a == 0 && difference.b == 0) continue;
        const CutWalk walk{scene, {p, q}};
        for (int row = 0; row < 40; row += 7) {
          const Columns all{row / 3, 40 - row / 2};
          Columns kept = all;
          walk.clip(row, kept);
          for (int i = all.from; i < all.to; ++i)
            ASSERT_EQ(kept.from <= i && i<kept.to, exactSignAtSample(difference, i, row)> 0)
                << "row " << row << ", column " << i;
          const int count = std::max(0, kept.to - kept.from);
          ++(count > 0 && count < all.to - all.from ? some : allOrNone);
          level += difference.a == 0;
        }
      }
  }
  if (!seeds.all()) return;
  EXPECT_GT(some, 2'000);
  EXPECT_GT(allOrNone, 2'000);
  EXPECT_GT(level, 100);
}

}  // namespace xnewell::THIS_FILE
