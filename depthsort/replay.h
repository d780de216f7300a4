#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "depthsort/depth_sort.h"

namespace xnewell {

/// A recorded run that stands at any of its steps, and goes forward or back without sorting. Step n is the
/// run after its first n events; at step 0 nothing has happened.
///
/// The stack of marked polygons is kept for all steps at once: each event that marks one adds a place to a
/// tree, whose parent is the place below it in the stack. So a stack is one number, its top, and with a
/// checkpoint every kCheckpoint events a step is reached by replaying at most so many. Memory: 8 bytes for
/// each polygon marked, a quarter byte an event, 8 bytes a fragment.
class Replay {
 public:
  static constexpr int kCheckpoint = 64;  ///< events

  /// `sorted` was recorded and outlives the replay.
  Replay(const SnappedScene& scene, const SortedScene& sorted);

  [[nodiscard]] int steps() const { return static_cast<int>(sorted_->events.size()); }
  [[nodiscard]] int step() const { return step_; }
  /// 0 <= step <= steps().
  void goTo(int step);

  /// What happened last, or null at step 0.
  [[nodiscard]] const Event* event() const { return step_ > 0 ? &sorted_->events[step_ - 1] : nullptr; }
  /// How many of SortedScene::fragments are painted.
  [[nodiscard]] int painted() const { return state_.painted; }
  /// How many splits there were: their pieces are the first 2 splits() of SortedScene::pieces.
  [[nodiscard]] int splits() const { return state_.splits; }
  /// Ids of the marked polygons, P first.
  [[nodiscard]] std::vector<int> marked() const;

  struct Listed {
    int fragment;
    bool marked;
    bool operator==(const Listed&) const = default;
  };
  /// What is neither painted nor split, at most so many: the marked ones, P first, then the others in the
  /// order in which P's are taken. In the textbook's run that is by farthest z, the pieces of a face standing
  /// in its place, the ones behind first. Work: #faces of the scene.
  [[nodiscard]] std::vector<Listed> list(int most) const;

 private:
  struct State {
    int top = -1;   ///< index into marks_
    int marks = 0;  ///< made so far
    int painted = 0, splits = 0;
  };
  struct Mark {
    int fragment, below;  ///< below: index into marks_, or -1
  };
  /// `state` after event `index`. Marks were made before.
  void advance(State& state, int index) const;
  [[nodiscard]] bool isThere(int fragment) const { return ended_[fragment] >= step_; }

  const SortedScene* sorted_;
  int faces_;
  std::vector<Mark> marks_;
  std::vector<State> checkpoints_;  ///< after each kCheckpoint events, from step 0 on
  std::vector<int> ended_;          ///< of each fragment: index of the event that paints or splits it
  std::vector<int> pieces_;         ///< of each fragment: id of its first piece, or -1
  int step_ = 0;
  State state_;
};

/// Which steps of a run are to be shown.
enum class Every { Step, Paint, Move, Cycle, Cut };
struct EveryRow {
  Every id;
  std::string_view name;
  Event::Kind kind;  ///< not of Step, which is every kind
};
inline constexpr std::array kEvery{
    EveryRow{Every::Step, "step", {}},
    EveryRow{Every::Paint, "paint", Event::Kind::Paint},
    EveryRow{Every::Move, "move", Event::Kind::Move},
    EveryRow{Every::Cycle, "cycle", Event::Kind::Cycle},
    EveryRow{Every::Cut, "cut", Event::Kind::Split},
};
/// In ascending order.
[[nodiscard]] std::vector<int> stepsOf(const SortedScene& sorted, Every every);

}  // namespace xnewell
