#pragma once

#include <array>
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

}  // namespace xnewell
