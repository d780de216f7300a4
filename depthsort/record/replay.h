#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "depthsort/depth_sort.h"

namespace xnewell {

/// A recorded run that stands at one of its steps. It can go forward and back without sorting. Step n is the
/// run after its first n events; at step 0 nothing has happened.
///
/// All stacks of marked polygons share one tree. Each event that marks a polygon adds a node, whose parent is
/// the node below it in the stack. So the number of its top node stands for a whole stack. There is a
/// checkpoint every kCheckpoint events, so reaching a step replays at most that many events. Memory: 8 bytes
/// for each polygon marked, a quarter byte for each event, 8 bytes for each fragment.
class Replay {
 public:
  static constexpr int kCheckpoint = 64;  ///< events

  /// `sorted` must be recorded, and it must outlive the replay.
  Replay(const SnappedScene& scene, const SortedScene& sorted);

  [[nodiscard]] int steps() const { return static_cast<int>(sorted_->events.size()); }
  [[nodiscard]] int step() const { return step_; }
  /// Goes to a step in 0..steps().
  void goTo(int step);

  /// The last event so far, or null at step 0.
  [[nodiscard]] const Event* event() const { return step_ > 0 ? &sorted_->events[step_ - 1] : nullptr; }
  /// How many of SortedScene::fragments are painted so far.
  [[nodiscard]] int painted() const { return state_.painted; }
  /// The number of splits so far. Their pieces are the first 2 splits() of SortedScene::pieces.
  [[nodiscard]] int splits() const { return state_.splits; }
  /// The ids of the marked polygons, P first.
  [[nodiscard]] std::vector<int> marked() const;

  struct Listed {
    int fragment;
    bool marked;
    bool operator==(const Listed&) const = default;
  };
  /// The polygons that are neither painted nor split, at most `most` of them. The marked ones come first, P
  /// at their head, then the others in the order in which they will become P. In the textbook's run that is
  /// by farthest z; the pieces of a face stand in its place, the ones behind first. Work: #faces of the
  /// scene.
  [[nodiscard]] std::vector<Listed> list(int most) const;

 private:
  struct State {
    int top = -1;   ///< index into marks_
    int marks = 0;  ///< number made so far
    int painted = 0, splits = 0;
  };
  struct Mark {
    int fragment, below;  ///< below: index into marks_, or -1 at the bottom
  };
  /// Changes `state` by event `index`. Its marks are already in marks_.
  void advance(State& state, int index) const;
  [[nodiscard]] bool isThere(int fragment) const { return ended_[fragment] >= step_; }

  const SortedScene* sorted_;
  int faces_;
  std::vector<Mark> marks_;
  std::vector<State> checkpoints_;  ///< the state before each kCheckpoint-th event, from step 0 on
  std::vector<int> ended_;          ///< for each fragment: index of the event that paints or splits it
  std::vector<int> pieces_;         ///< for each fragment: id of its first piece, or -1
  int step_ = 0;
  State state_;
};

/// Which steps of a run to show.
enum class Every { Step, Paint, Move, Cycle, Cut };
struct EveryRow {
  Every id;
  std::string_view name;
  Event::Kind kind;  ///< unused for Step, which shows every kind
};
inline constexpr std::array kEvery{
    EveryRow{Every::Step, "step", {}},
    EveryRow{Every::Paint, "paint", Event::Kind::Paint},
    EveryRow{Every::Move, "move", Event::Kind::Move},
    EveryRow{Every::Cycle, "cycle", Event::Kind::Cycle},
    EveryRow{Every::Cut, "cut", Event::Kind::Split},
};
/// The steps of that kind, in ascending order.
[[nodiscard]] std::vector<int> stepsOf(const SortedScene& sorted, Every every);

/// The steps of a recorded run that interest a learner, and how many of them there are up to any step. Step n
/// is the run after its first n events, as in replay.h.

/// `Failed` is a pair for which tests 1 to 5 prove nothing in P's favour: Q goes first, or one of the two is
/// cut.
enum class Landmark { Failed, Move, Cycle, Cut, Paint };
struct LandmarkRow {
  Landmark id;
  std::string_view name;     ///< for one of them
  std::string_view several;  ///< for a count or a lane
};
inline constexpr std::array kLandmarks{
    LandmarkRow{Landmark::Failed, "failed", "failed tests"}, LandmarkRow{Landmark::Move, "move", "moves"},
    LandmarkRow{Landmark::Cycle, "cycle", "cycles"},         LandmarkRow{Landmark::Cut, "cut", "cuts"},
    LandmarkRow{Landmark::Paint, "paint", "painted"},
};

/// The kind of landmark that an event is, if any.
[[nodiscard]] std::optional<Landmark> landmarkOf(const Event& event);

/// The landmarks of a run. Memory: 4 bytes for each landmark.
class Landmarks {
 public:
  /// `sorted` must be recorded, and it must outlive this object. `failed`: the steps that failed, if somebody
  /// else has found them.
  explicit Landmarks(const SortedScene& sorted, std::optional<std::vector<int>> failed = {});

  /// All steps of a kind, ascending.
  [[nodiscard]] const std::vector<int>& steps(Landmark kind) const { return of_[static_cast<int>(kind)]; }
  /// The number of landmarks of a kind among steps 1..step.
  [[nodiscard]] int count(Landmark kind, int step) const;
  /// The number of pairs tested among steps 1..step.
  [[nodiscard]] int pairs(int step) const;
  /// The nearest landmark of a kind after the step, or before it.
  [[nodiscard]] std::optional<int> next(Landmark kind, int step) const;
  [[nodiscard]] std::optional<int> previous(Landmark kind, int step) const;
  /// The nearest later step whose P or Q is a part of the face with this number in the model.
  [[nodiscard]] std::optional<int> nextWith(const SnappedScene& scene, int number, int step) const;
  /// True if a step's P or Q is a part of that face.
  [[nodiscard]] bool has(const SnappedScene& scene, int number, int step) const;

 private:
  const SortedScene* sorted_;
  std::array<std::vector<int>, kLandmarks.size()> of_;
  /// The number of pairs tested before each kStride-th event. pairs() counts the rest.
  static constexpr int kStride = 1024;
  std::vector<int> pairs_;
};

/// The Compare event that led to a step. It is the step's own event, or the event of the same two polygons
/// right before a move, a cycle, a contact or a cut. Null if there is none.
[[nodiscard]] const Event* comparisonAt(const SortedScene& sorted, int step);

/// For a step that paints P: how many Q's each test settled since P was taken or moved, indexed by Test.
[[nodiscard]] std::array<int, kTests> settledFor(const SortedScene& sorted, int step);

}  // namespace xnewell
