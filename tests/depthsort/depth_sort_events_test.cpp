#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "depthsort/depth_sort.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// Follows the events of a run with nothing but the textbook's marks, and checks whether each event may
/// happen.
class Replay {
 public:
  Replay(const SnappedScene& scene, const SortedScene& sorted)
      : sorted_{sorted},
        faces_{static_cast<int>(scene.faces.size())},
        state_(faces_ + sorted.pieces.size()) {}

  void follow() {
    for (const Event& event : sorted_.events) {
      SCOPED_TRACE(testing::Message() << "event " << at_ << ", P " << event.P << ", Q " << event.Q);
      step(event);
      if (testing::Test::HasFatalFailure()) return;
      ++at_;
    }
    EXPECT_TRUE(marked_.empty());
    EXPECT_EQ(painted_, static_cast<int>(sorted_.fragments.size()));
    EXPECT_EQ(sorted_.pieces.size(), 2u * statistics.splits);
  }

  SortStatistics statistics;

 private:
  enum class State { Waiting, Marked, Split, Painted };
  using Kind = Event::Kind;

  [[nodiscard]] int faceOf(int id) const { return id < faces_ ? id : sorted_.pieces[id - faces_].face; }
  [[nodiscard]] bool open(int id) const {
    return state_[id] == State::Waiting || state_[id] == State::Marked;
  }
  [[nodiscard]] bool exists(int id) const {
    return id >= 0 && id < faces_ + 2 * static_cast<int>(statistics.splits);
  }
  void mark(int id) {
    ASSERT_EQ(state_[id], State::Waiting);
    state_[id] = State::Marked;
    marked_.push_back(id);
    statistics.deepest = std::max(statistics.deepest, static_cast<int>(marked_.size()));
  }
  void unmarkFrom(std::vector<int>::const_iterator first) {
    for (auto id = first; id != marked_.end(); ++id) state_[*id] = State::Waiting;
    marked_.erase(first, marked_.end());
  }
  /// True if the polygon is marked and not below the polygon that closed the last cycle.
  [[nodiscard]] bool inCycle(int id) const { return std::find(cycle_, marked_.end(), id) != marked_.end(); }
  void step(const Event& event);

  const SortedScene& sorted_;
  int faces_, at_ = 0, painted_ = 0;
  std::vector<State> state_;
  std::vector<int> marked_;
  std::vector<int>::const_iterator cycle_;
  Event last_{};
};

void Replay::step(const Event& event) {
  const auto [kind, test, verdict, contact, P, Q] = event;
  ASSERT_TRUE(exists(P));
  ASSERT_EQ(Q >= 0, kind != Kind::Take && kind != Kind::Paint);
  if (Q >= 0) {
    ASSERT_TRUE(exists(Q));
    ASSERT_NE(faceOf(P), faceOf(Q)) << "of one face";
    ASSERT_TRUE(open(P));
    ASSERT_TRUE(open(Q));
  }
  const bool qFirst =
      last_.kind == Kind::Compare && last_.verdict == Verdict::QFirst && last_.P == P && last_.Q == Q;
  switch (kind) {
    case Kind::Take:
      ASSERT_TRUE(marked_.empty());
      mark(P);
      break;
    case Kind::Compare:
      ASSERT_EQ(P, marked_.back());
      ++statistics.settled[static_cast<int>(test)];
      statistics.contacts += contact;
      if (test != xnewell::Test::Overlap) {
        ASSERT_FALSE(contact);
        ASSERT_NE(verdict, Verdict::Crossing);
        const bool canOnlyPass = test >= xnewell::Test::XExtents && test <= xnewell::Test::Projections;
        const bool canOnlyFail = test == xnewell::Test::QBehindP || test == xnewell::Test::PInFrontOfQ;
        ASSERT_FALSE(canOnlyPass && verdict != Verdict::PFirst);
        ASSERT_FALSE(canOnlyFail && verdict != Verdict::QFirst);
      }
      break;
    case Kind::Move:
      ASSERT_TRUE(qFirst);
      ++statistics.moves;
      mark(Q);
      break;
    case Kind::Cycle:
      ASSERT_TRUE(qFirst);
      ASSERT_EQ(state_[Q], State::Marked);
      ++statistics.cycles;
      cycle_ = std::ranges::find(marked_, Q);
      break;
    case Kind::Impossible:
    case Kind::Vain:
      ASSERT_TRUE(last_.kind == Kind::Cycle || last_.kind == Kind::Impossible || last_.kind == Kind::Vain);
      ASSERT_TRUE(inCycle(P) && inCycle(Q));
      ++(kind == Kind::Vain ? statistics.vain : statistics.impossible);
      break;
    case Kind::Void: {
      ASSERT_EQ(last_.kind, Kind::Cycle);
      ASSERT_TRUE(inCycle(P));
      const auto above = std::ranges::find(marked_, P) + 1;
      ASSERT_EQ(Q, above == marked_.end() ? *cycle_ : *above) << "no edge of the cycle";
      ++statistics.voids;
      unmarkFrom(above);
      break;
    }
    case Kind::Split:
      if (last_.kind == Kind::Compare) {
        ASSERT_EQ(last_.verdict, Verdict::Crossing);
        ASSERT_EQ(std::minmax(P, Q), std::minmax(last_.P, last_.Q));
      } else {
        ASSERT_TRUE(last_.kind == Kind::Cycle || last_.kind == Kind::Impossible || last_.kind == Kind::Vain);
        ASSERT_TRUE(inCycle(P) && inCycle(Q));
      }
      ++statistics.splits;
      unmarkFrom(std::ranges::find(marked_, P));
      state_[P] = State::Split;
      break;
    case Kind::Paint: {
      ASSERT_EQ(P, marked_.back());
      const Fragment& fragment = sorted_.fragments.at(painted_++);
      ASSERT_EQ(P, fragment.piece < 0 ? fragment.face : faces_ + fragment.piece);
      ASSERT_EQ(fragment.face, faceOf(P));
      marked_.pop_back();
      state_[P] = State::Painted;
      break;
    }
  }
  last_ = event;
}

}  // namespace

// The recorded events are those of the algorithm. Marks come and go as in the textbook. Only polygons that
// are left are compared, split or found to be contacts. Every split has its reason. The painted polygons are
// the fragments in their order. All counts are those of the statistics.
TEST(Events, TellTheRun) {
  const Seeds seeds{960};
  SortStatistics sum;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(testing::Message() << "XNEWELL_SEED=" << seed);
    const SnappedScene scene = randomScene(seed, 3 + static_cast<int>(seed / kSceneKinds.size()) % 16, 32);
    SortSettings settings{.width = 32, .height = 32, .textbook = seed % 2 == 0, .areas = false};
    const SortedScene silent = depthSort(scene, settings);
    settings.record = true;
    const SortedScene sorted = depthSort(scene, settings);
    Replay replay{scene, sorted};
    replay.follow();
    if (HasFatalFailure()) return;
    const SortStatistics &told = replay.statistics, &counted = sorted.statistics;
    EXPECT_EQ(told.settled, counted.settled);
    EXPECT_EQ(told.moves, counted.moves);
    EXPECT_EQ(told.cycles, counted.cycles);
    EXPECT_EQ(told.impossible, counted.impossible);
    EXPECT_EQ(told.vain, counted.vain);
    EXPECT_EQ(told.splits, counted.splits);
    EXPECT_EQ(told.voids, counted.voids);
    EXPECT_EQ(told.contacts, counted.contacts);
    EXPECT_EQ(told.deepest, counted.deepest);
    EXPECT_TRUE(silent.events.empty());
    EXPECT_EQ(silent.statistics.settled, counted.settled);
    EXPECT_EQ(silent.fragments.size(), sorted.fragments.size());
    sum.voids += told.voids, sum.cycles += told.cycles, sum.splits += told.splits;
    sum.impossible += told.impossible, sum.vain += told.vain;
  }
  if (!seeds.all()) return;
  EXPECT_GT(sum.voids, 10);
  EXPECT_GT(sum.cycles, 1'000);
  EXPECT_GT(sum.impossible, 2'000);
  EXPECT_GT(sum.vain, 200);
  EXPECT_GT(sum.splits, 4'000);
}

}  // namespace xnewell::THIS_FILE
