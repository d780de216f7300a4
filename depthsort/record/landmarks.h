#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "depthsort/depth_sort.h"

namespace xnewell {

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
