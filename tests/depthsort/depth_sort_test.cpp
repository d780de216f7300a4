#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "depthsort/areas.h"
#include "depthsort/depth_sort.h"
#include "depthsort/oracle.h"
#include "depthsort/order.h"
#include "geometry/view/screen_plane.h"
#include "tests/support/exact_region.h"
#include "tests/support/painted.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- The depth sort against the oracle

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

/// ---- Scenes of areas

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

/// ---- The order

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

/// ---- Sorting by keys

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

SnappedScene facesAt(const std::vector<std::array<int, 3>>& z) {
  SnappedScene scene;
  for (const auto& triple : z) {
    scene.faces.push_back(
        {static_cast<int>(scene.vertices.size()), 3, static_cast<int>(scene.faces.size()), false});
    for (int i = 0; i < 3; ++i) scene.vertices.push_back({i * i, i, triple[i]});
  }
  return scene;
}

// The farthest face comes first, by the smallest z, by the mean z, or as listed. At equal z the order is that
// of the scene, so that the later face is painted later and wins.
TEST(Order, FarthestFirst) {
  const SnappedScene scene = facesAt({{5, 90, 90}, {40, 50, 60}, {4, 10, 10}, {5, 6, 7}, {60, 50, 40}});
  EXPECT_EQ(paintingOrder(scene, Order::ZSort), (std::vector{2, 0, 3, 1, 4}));
  EXPECT_EQ(paintingOrder(scene, Order::ZMean), (std::vector{3, 2, 1, 4, 0}));
  EXPECT_EQ(paintingOrder(scene, Order::Unsorted), (std::vector{0, 1, 2, 3, 4}));
}

/// ---- The oracle itself

/// The second oracle shares no line with the first.
int compare(const Perturbed& p, const Perturbed& q) {
  return Perturbed{p.value - q.value, p.first - q.first, p.second - q.second}.sign();
}

// The oracle agrees with a second one in rational arithmetic in every sample, ties included.
TEST(Oracle, AgreesWithRationalArithmetic) {
  const Seeds seeds{84};
  constexpr int kEdge = 12;
  long long contested = 0, ties = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomTriangles(seed, 12, kEdge);
    const std::vector<int> seen = visibleFaces(scene, kEdge, kEdge);
    std::vector<RationalFace> faces;
    for (const SnappedFace& f : scene.faces) faces.emplace_back(scene, f);
    for (int j = 0; j < kEdge; ++j)
      for (int i = 0; i < kEdge; ++i) {
        int best = kNothing, covering = 0;
        for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
          if (!faces[f].covers(i, j)) continue;
          ++covering;
          const int sign = best == kNothing ? 1 : compare(faces[f].depth(i, j), faces[best].depth(i, j));
          ties += best != kNothing && faces[f].depth(i, j).value == faces[best].depth(i, j).value;
          if (sign >= 0) best = f;
        }
        contested += covering > 1;
        ASSERT_EQ(seen[j * kEdge + i], best) << "sample " << i << ", " << j;
      }
  }
  if (!seeds.all()) return;
  EXPECT_GT(contested, 2500);
  EXPECT_GT(ties, 250);
}

// nearer() separates depths that differ far below a double's last bit. The slopes F(n-1)/F(n) of Fibonacci
// numbers up to 2^60 lie on alternating sides of the golden ratio, at a distance of 1/(F(n) F(n+1)) from each
// other (Cassini).
TEST(Oracle, NearerDecidesBeyondDoubles) {
  std::vector<std::int64_t> F{1, 1};
  while (F.size() < 87) F.push_back(F[F.size() - 1] + F[F.size() - 2]);
  EXPECT_GT(F.back(), std::int64_t{1} << 58);
  for (int n = 40; n + 1 < 87; ++n) {
    const ScreenPlane P{F[n - 1], 0, F[n]}, Q{F[n], 0, F[n + 1]};
    EXPECT_EQ(nearer(P, Q, 0, 0), n % 2 ? 1 : -1) << n;
    EXPECT_EQ(nearer(P, Q, 8191, 0), n % 2 ? 1 : -1) << n;
  }
}

}  // namespace

}  // namespace xnewell::THIS_FILE
