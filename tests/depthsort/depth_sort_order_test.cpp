#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "depthsort/samples.h"
#include "tests/support/exact_region.h"
#include "tests/support/painted.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kSize = 24;

struct Counts {
  int overlaps = 0, inOnePlane = 0, pieces = 0, slivers = 0, shallow = 0;
};

/// Sorts a scene for every place, not for samples alone.
SortedScene sortedEverywhere(const SnappedScene& scene, bool textbook) {
  return depthSort(scene, {.width = kSize, .height = kSize, .textbook = textbook, .samples = false});
}

/// For every two overlapping fragments, the one painted first is nowhere nearer than the other in their whole
/// common area in the picture, not just at samples. The sort may ignore a part that is no deeper than the
/// doubt of both, or a part that is thin and has no sample. Later splits may have made the part that it
/// ignored smaller. So the part is at most twice as thick (2 area / diameter of a convex region is one to two
/// times its width). The sort measures depth at corners rounded to the grid, which allows half a step's slope
/// more.
void expectOrder(const SnappedScene& scene, const SortedScene& sorted, Counts& counts) {
  struct Painted {
    ExactRegion region;
    double x0, y0, x1, y1;
  };
  std::vector<Painted> all;
  for (const Fragment& fragment : sorted.fragments) {
    Painted p{exactFragment(scene, sorted, fragment), 1e99, 1e99, -1e99, -1e99};
    p.region = fragment.piece < 0 ? within(p.region, {0, 0, kSize, kSize})
                                  : within(p.region, sorted.pieces[fragment.piece].area);
    for (const ExactPoint& corner : p.region) {
      const double x = corner.x.convert_to<double>(), y = corner.y.convert_to<double>();
      p.x0 = std::min(p.x0, x - 1), p.x1 = std::max(p.x1, x + 1);
      p.y0 = std::min(p.y0, y - 1), p.y1 = std::max(p.y1, y + 1);
    }
    counts.pieces += fragment.piece >= 0;
    all.push_back(std::move(p));
  }
  for (std::size_t later = 0; later < all.size(); ++later)
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      const Painted &P = all[earlier], &Q = all[later];
      if (P.x1 < Q.x0 || Q.x1 < P.x0 || P.y1 < Q.y0 || Q.y1 < P.y0) continue;
      const ExactRegion both = common(P.region, Q.region);
      if (both.empty()) continue;
      ++counts.overlaps;
      const int p = sorted.fragments[earlier].face, q = sorted.fragments[later].face;
      ASSERT_NE(p, q) << "pieces of one face overlap";
      const ScreenPlane &planeP = scene.planes[scene.faces[p].plane],
                        &planeQ = scene.planes[scene.faces[q].plane];
      const ExactLine above = exactDifference(planeP, planeQ);
      const bool one = samePlane(planeP, planeQ);
      counts.inOnePlane += one;
      const ExactRegion wrong = one ? (p > q ? both : ExactRegion{}) : clipped(both, above);
      if (wrong.empty()) continue;
      SCOPED_TRACE(testing::Message()
                   << "fragments " << earlier << " (face " << p << "), " << later << " (face " << q << ")");
      const double doubt =
          double{scene.doubtOf(scene.faces[p]).atBack} + scene.doubtOf(scene.faces[q]).atBack;
      const double depth = greatest(above, wrong).convert_to<double>();
      const double slope = std::abs(above.a.convert_to<double>()) + std::abs(above.b.convert_to<double>());
      if (!one && doubt > 0.0 && depth <= doubt + 0.5 * slope) {
        ++counts.shallow;
        continue;
      }
      ++counts.slivers;
      ASSERT_LE(thickness(wrong), 2.0 * kThin) << "above by " << depth << ", doubt " << doubt;
      ASSERT_FALSE(exactlyOwnsSample(wrong, kSize, kSize)) << "above by " << depth << ", doubt " << doubt;
    }
}

}  // namespace

// Scenes that are given on the grid have no doubt.
TEST(DepthSortOrder, NothingIsPaintedOverWhatIsNearer) {
  const Seeds seeds{192};
  Counts counts;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    const SnappedScene scene = randomScene(seed, 2 + static_cast<int>(seed / kSceneKinds.size()) % 12, kSize);
    SCOPED_TRACE(testing::Message() << "XNEWELL_SEED=" << seed);
    expectOrder(scene, sortedEverywhere(scene, seed % 3 == 0), counts);
    if (HasFatalFailure()) return;
  }
  if (!seeds.all()) return;
  EXPECT_GT(counts.overlaps, 4'000);
  EXPECT_GT(counts.inOnePlane, 300);
  EXPECT_GT(counts.pieces, 800);
  EXPECT_GT(counts.slivers, 0);
}

// Without the polygons that one face hides, the picture is the same, and the rest is in order.
TEST(DepthSortOrder, WhatIsHiddenMayBeLeftOut) {
  const Seeds seeds{192};
  Counts counts;
  std::int64_t hidden = 0;
  std::size_t all = 0, left = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(testing::Message() << "XNEWELL_SEED=" << seed);
    const SnappedScene scene = randomScene(seed, 12, kSize);
    SortSettings settings{.width = kSize, .height = kSize, .samples = false, .areas = false};
    const SortedScene whole = depthSort(scene, settings);
    settings.keepHidden = -1;
    const SortedScene shown = depthSort(scene, settings);
    EXPECT_EQ(painted(scene, shown, kSize, kSize), painted(scene, whole, kSize, kSize));
    expectOrder(scene, shown, counts);
    if (HasFatalFailure()) return;
    hidden += shown.statistics.hidden;
    all += whole.fragments.size(), left += shown.fragments.size();
  }
  if (!seeds.all()) return;
  EXPECT_GT(hidden, 300);
  EXPECT_LT(left + 300, all);
}

// With doubts of one step to many, contacts leave polygons whole. This is most frequent for nearly coplanar
// ones.
TEST(DepthSortOrder, NothingIsPaintedOverWhatIsNearerBeyondDoubt) {
  const Seeds seeds{192};
  Counts counts;
  SortStatistics exact, doubtful;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SnappedScene scene = randomScene(seed, 2 + static_cast<int>(seed / kSceneKinds.size()) % 12, kSize);
    exact.splits += depthSort(scene, {kSize, kSize}).statistics.splits;
    std::mt19937 rng{seed};
    const double reach = std::uniform_real_distribution{0.0, 20.0}(rng);
    for (int f = 0; f < std::ssize(scene.faces); ++f)
      scene.planes.setDoubt(f,
                            {static_cast<float>(std::exp2(std::uniform_real_distribution{0.0, reach}(rng)))},
                            scene.faces.size());
    SCOPED_TRACE(testing::Message() << "XNEWELL_SEED=" << seed);
    const SortedScene sorted = sortedEverywhere(scene, seed % 3 == 0);
    doubtful.splits += sorted.statistics.splits;
    doubtful.voids += sorted.statistics.voids;
    doubtful.contacts += sorted.statistics.contacts;
    expectOrder(scene, sorted, counts);
    if (HasFatalFailure()) return;
  }
  if (!seeds.all()) return;
  EXPECT_GT(counts.overlaps, 3'000);
  EXPECT_GT(counts.inOnePlane, 300);
  EXPECT_GT(counts.pieces, 500);
  EXPECT_GT(counts.shallow, 150);
  EXPECT_GT(doubtful.voids, 50);
  EXPECT_GT(doubtful.contacts, 200);
  EXPECT_LT(doubtful.splits, exact.splits);  // contacts cause no split
}

}  // namespace xnewell::THIS_FILE
