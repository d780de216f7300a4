#include "depthsort/record/replay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/random_scenes.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kSize = 40, kAll = 1 << 20;

SortedScene recorded(const SnappedScene& scene, bool textbook) {
  SortSettings settings{kSize, kSize, textbook};
  settings.record = true;
  return depthSort(scene, settings);
}

/// What a step looks like.
struct Seen {
  std::vector<int> marked;
  int painted = 0, splits = 0;
  std::vector<Replay::Listed> list;
  bool operator==(const Seen&) const = default;
};

Seen seenBy(const Replay& replay) {
  return {replay.marked(), replay.painted(), replay.splits(), replay.list(kAll)};
}

/// The states of all steps by the plain words of Event::Kind. The stack is a vector, and in the list pieces
/// replace the polygon that was split.
std::vector<Seen> literally(const SnappedScene& scene, const SortedScene& sorted) {
  std::vector<int> stack, list = sorted.list;
  int painted = 0, splits = 0;
  std::vector<Seen> all;
  const auto see = [&] {
    Seen seen{{stack.rbegin(), stack.rend()}, painted, splits, {}};
    for (const int id : seen.marked) seen.list.push_back({id, true});
    for (const int id : list)
      if (std::ranges::find(stack, id) == stack.end()) seen.list.push_back({id, false});
    all.push_back(seen);
  };
  see();
  for (const Event& e : sorted.events) {
    const auto place = std::ranges::find(stack, e.P);
    switch (e.kind) {
      case Event::Kind::Take:
        stack.push_back(e.P);
        break;
      case Event::Kind::Move:
        stack.push_back(e.Q);
        break;
      case Event::Kind::Void:
        stack.erase(place + 1, stack.end());
        break;
      case Event::Kind::Split: {
        stack.erase(place, stack.end());
        const int piece = static_cast<int>(scene.faces.size()) + 2 * splits++;
        const auto at = list.erase(std::ranges::find(list, e.P));
        list.insert(at, {piece, piece + 1});
        break;
      }
      case Event::Kind::Paint:
        EXPECT_EQ(stack.back(), e.P);
        stack.pop_back();
        list.erase(std::ranges::find(list, e.P));
        ++painted;
        break;
      default:
        break;
    }
    see();
  }
  return all;
}

}  // namespace

// Every step looks as in the literal replay from the start, whether it is reached forward, back or by a jump
// from anywhere.
TEST(Replay, AnyStepIsReachedFromAnyOther) {
  int farBack = 0, splits = 0, voids = 0, unmarked = 0;
  for (unsigned seed = 0; seed < 140; ++seed)
    for (const bool textbook : {false, true}) {
      SCOPED_TRACE(seed);
      const SnappedScene scene = randomScene(seed, 2 + seed % 17, kSize);
      const SortedScene sorted = recorded(scene, textbook);
      const std::vector<Seen> expected = literally(scene, sorted);
      Replay replay{scene, sorted};
      ASSERT_EQ(std::ssize(expected), replay.steps() + 1);
      const auto check = [&](int step) {
        replay.goTo(step);
        EXPECT_EQ(replay.step(), step);
        EXPECT_EQ(replay.event(), step == 0 ? nullptr : &sorted.events[step - 1]);
        return seenBy(replay) == expected[step];
      };
      for (int step = 0; step <= replay.steps(); ++step) {
        ASSERT_TRUE(check(step)) << step;
      }
      for (int step = replay.steps(); step >= 0; --step) {
        ASSERT_TRUE(check(step)) << step;
      }
      std::mt19937 rng{seed};
      for (int leap = 0; leap < 100; ++leap) {
        const int from = replay.step(), to = static_cast<int>(rng() % expected.size());
        ASSERT_TRUE(check(to)) << from << " to " << to;
        farBack += from - to > Replay::kCheckpoint;
      }
      splits += static_cast<int>(sorted.statistics.splits);
      voids += static_cast<int>(sorted.statistics.voids);
      for (std::size_t k = 1; k < sorted.events.size(); ++k)
        unmarked +=
            sorted.events[k].kind == Event::Kind::Split && expected[k].marked.front() == sorted.events[k].Q;
    }
  EXPECT_GT(farBack, 1000);
  EXPECT_GT(splits, 1000);
  EXPECT_GT(voids, 0);
  EXPECT_GT(unmarked, 100);
}

// The paint events in their order are the fragments of the run, and at the end nothing is left. So replaying
// them paints the same picture.
TEST(Replay, PaintsTheFragmentsInTheirOrder) {
  int pieces = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomScene(seed, 2 + seed % 17, kSize);
    const SortedScene sorted = recorded(scene, seed % 2 == 0);
    Replay replay{scene, sorted};
    const int faces = static_cast<int>(scene.faces.size());
    for (int step = 1; step <= replay.steps(); ++step) {
      replay.goTo(step);
      if (replay.event()->kind != Event::Kind::Paint) continue;
      const Fragment& fragment = sorted.fragments[replay.painted() - 1];
      EXPECT_EQ(replay.event()->P, fragment.piece < 0 ? fragment.face : faces + fragment.piece);
      pieces += fragment.piece >= 0;
    }
    EXPECT_EQ(replay.painted(), std::ssize(sorted.fragments));
    EXPECT_EQ(2 * replay.splits(), std::ssize(sorted.pieces));
    EXPECT_TRUE(replay.list(kAll).empty());
  }
  EXPECT_GT(pieces, 1000);
}

// P is always taken from the head of the list, which is sorted by farthest z, in both runs.
TEST(Replay, TheNextPIsTheFirstOfTheList) {
  int taken = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const SnappedScene scene =
        randomScene(kSceneKinds[seed % kTriangleKinds].id, seed, 2 + seed / 2 % 17, kSize);
    const SortedScene sorted = recorded(scene, /*textbook=*/seed % 2 == 0);
    const auto farthest = [&](int face) {
      const glm::ivec3* v = &scene.vertices[scene.faces[face].first];
      return std::min({v[0].z, v[1].z, v[2].z});
    };
    EXPECT_TRUE(std::ranges::is_sorted(sorted.list, {}, farthest));
    Replay replay{scene, sorted};
    for (int k = 0; k < replay.steps(); ++k) {
      if (sorted.events[k].kind != Event::Kind::Take) continue;
      replay.goTo(k);
      const auto list = replay.list(1);
      ASSERT_EQ(list.size(), 1u);
      EXPECT_EQ(list[0], (Replay::Listed{sorted.events[k].P, false}));
      ++taken;
    }
  }
  EXPECT_GT(taken, 500);
}

// A run with more events than allowed throws instead of keeping them. A run with exactly as many does not
// throw, nor does one that is not recorded.
TEST(Replay, TooManyEventsAreRefused) {
  const SnappedScene scene = randomScene(0, 12, kSize);
  const std::size_t count = recorded(scene, true).events.size();
  SortSettings settings{kSize, kSize, true};
  settings.mostEvents = count - 1;
  EXPECT_NO_THROW(static_cast<void>(depthSort(scene, settings)));
  settings.record = true;
  EXPECT_THROW(static_cast<void>(depthSort(scene, settings)), TooManyEvents);
  settings.mostEvents = count;
  EXPECT_EQ(depthSort(scene, settings).events.size(), count);
}

}  // namespace xnewell::THIS_FILE
