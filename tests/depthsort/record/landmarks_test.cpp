#include "depthsort/record/landmarks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/random_scenes.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kSize = 40;

SortedScene recorded(const SnappedScene& scene) {
  SortSettings settings{kSize, kSize, true};
  settings.record = true;
  return depthSort(scene, settings);
}

}  // namespace

// The counts, next() and previous() agree with a walk over all events, at every step.
TEST(Landmarks, AgreeWithAWalk) {
  std::array<int, kLandmarks.size()> seen{};
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomScene(seed, 30, kSize);
    const SortedScene sorted = recorded(scene);
    const Landmarks landmarks{sorted};
    const int steps = static_cast<int>(sorted.events.size());
    for (const LandmarkRow& row : kLandmarks) {
      int count = 0, pairs = 0, last = 0;
      for (int step = 0; step <= steps; ++step) {
        const bool is = step > 0 && landmarkOf(sorted.events[step - 1]) == row.id;
        pairs += step > 0 && sorted.events[step - 1].kind == Event::Kind::Compare;
        ASSERT_EQ(landmarks.previous(row.id, step), last ? std::optional{last} : std::nullopt);
        if (is) {
          ++count;
          if (step > last + 1) {
            ASSERT_EQ(landmarks.next(row.id, last), step);
          }
          last = step;
        }
        ASSERT_EQ(landmarks.count(row.id, step), count);
        ASSERT_EQ(landmarks.pairs(step), pairs);
      }
      ASSERT_EQ(landmarks.next(row.id, last), std::nullopt);
      seen[static_cast<int>(row.id)] += count;
    }
    ASSERT_EQ(landmarks.count(Landmark::Move, steps), sorted.statistics.moves);
    ASSERT_EQ(landmarks.count(Landmark::Cut, steps), sorted.statistics.splits);
    ASSERT_EQ(landmarks.pairs(steps), sorted.statistics.pairs());
  }
  for (const int count : seen) EXPECT_GT(count, 20);
}

// The comparison of a step is about its two polygons. For a failed test it is the step itself.
TEST(Landmarks, TheComparisonIsOfTheSamePair) {
  int moves = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const SnappedScene scene = randomScene(seed, 30, kSize);
    const SortedScene sorted = recorded(scene);
    for (int step = 1; step <= static_cast<int>(sorted.events.size()); ++step) {
      const Event& e = sorted.events[step - 1];
      const Event* const compare = comparisonAt(sorted, step);
      if (e.kind == Event::Kind::Compare) {
        ASSERT_EQ(compare, &e);
      }
      if (e.kind == Event::Kind::Take || e.kind == Event::Kind::Paint) {
        ASSERT_EQ(compare, nullptr);
      }
      if (e.kind != Event::Kind::Move) continue;
      ASSERT_NE(compare, nullptr);
      ASSERT_EQ(compare->P, e.P);
      ASSERT_EQ(compare->Q, e.Q);
      ASSERT_EQ(compare->verdict, Verdict::QFirst);
      ++moves;
    }
  }
  EXPECT_GT(moves, 100);
}

// For a painted polygon, all tests that settled it since it was taken are counted, and none of another P.
TEST(Landmarks, CountWhatSettledAPolygon) {
  int pairs = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const SortedScene sorted = recorded(randomScene(seed, 30, kSize));
    for (int step = 1; step <= static_cast<int>(sorted.events.size()); ++step) {
      const Event& painted = sorted.events[step - 1];
      if (painted.kind != Event::Kind::Paint) continue;
      int sum = 0, expected = 0;
      for (const int count : settledFor(sorted, step)) sum += count;
      for (int k = step - 1; k-- > 0;) {
        const Event& e = sorted.events[k];
        expected += e.kind == Event::Kind::Compare && e.P == painted.P;
        if (e.kind == Event::Kind::Take && e.P == painted.P) break;
        if (e.kind == Event::Kind::Move && e.Q == painted.P) break;
      }
      ASSERT_EQ(sum, expected);
      pairs += sum;
    }
  }
  EXPECT_GT(pairs, 500);
}

}  // namespace xnewell::THIS_FILE
