#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "depthsort/depth_sort.h"

namespace xnewell {

/// The steps of a recorded run that a learner looks for, and how many of them there were by any step. Step n
/// is the run after its first n events, as in replay.h.

/// `Failed` is a pair for which tests 1 to 5 prove nothing in P's favour: Q goes first, or one is cut.
enum class Landmark { Failed, Move, Cycle, Cut, Paint };
struct LandmarkRow {
  Landmark id;
  std::string_view name;     ///< of one
  std::string_view several;  ///< of a count or a lane
};
inline constexpr std::array kLandmarks{
    LandmarkRow{Landmark::Failed, "failed", "failed tests"}, LandmarkRow{Landmark::Move, "move", "moves"},
    LandmarkRow{Landmark::Cycle, "cycle", "cycles"},         LandmarkRow{Landmark::Cut, "cut", "cuts"},
    LandmarkRow{Landmark::Paint, "paint", "painted"},
};

[[nodiscard]] std::optional<Landmark> landmarkOf(const Event& event);

/// Memory: 4 bytes for each step that is one.
class Landmarks {
 public:
  /// `sorted` was recorded and outlives this.
  explicit Landmarks(const SortedScene& sorted);

  /// All of a kind, ascending.
  [[nodiscard]] const std::vector<int>& steps(Landmark kind) const { return of_[static_cast<int>(kind)]; }
  /// How many there are among steps 1..step.
  [[nodiscard]] int count(Landmark kind, int step) const;
  /// Pairs tested by then.
  [[nodiscard]] int pairs(int step) const;
  /// The nearest one after the step, or before it.
  [[nodiscard]] std::optional<int> next(Landmark kind, int step) const;
  [[nodiscard]] std::optional<int> previous(Landmark kind, int step) const;
  /// The nearest step after this one whose P or Q is a part of the face with this number in the model.
  [[nodiscard]] std::optional<int> nextWith(const SnappedScene& scene, int number, int step) const;
  /// Whether a step's P or Q is a part of it.
  [[nodiscard]] bool has(const SnappedScene& scene, int number, int step) const;

 private:
  const SortedScene* sorted_;
  std::array<std::vector<int>, kLandmarks.size()> of_;
  /// Pairs tested before each kStride events: the rest is counted.
  static constexpr int kStride = 1024;
  std::vector<int> pairs_;
};

/// The Compare event that led to a step: its own, or that of the same two polygons right before a move, a
/// cycle, a contact or a cut. Null where there is none.
[[nodiscard]] const Event* comparisonAt(const SortedScene& sorted, int step);

/// Of a step that paints P: how many Q's each test settled since P was taken or moved, by Test.
[[nodiscard]] std::array<int, kTests> settledFor(const SortedScene& sorted, int step);

}  // namespace xnewell
