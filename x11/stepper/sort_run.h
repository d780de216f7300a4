#pragma once

#include <optional>
#include <vector>

#include "depthsort/record/explain.h"
#include "depthsort/record/landmarks.h"
#include "depthsort/record/replay.h"
#include "x11/stepper/so_far.h"

namespace xnewell {

/// What a step is about, in terms that also fit the run of another view of the scene.
struct StepAbout {
  Event::Kind kind = Event::Kind::Take;
  int P = -1, Q = -1;  ///< numbers of faces; -1 if there is no Q
  bool operator==(const StepAbout&) const = default;
};

/// The recorded textbook run of a picture's depth sort, with all that the stepper asks about its steps.
class SortRun {
 public:
  /// A run with more steps is not shown. So many events take 48 megabytes.
  static constexpr std::size_t kMostEvents = std::size_t{1} << 22;
  static constexpr std::size_t kCopies = std::size_t{64} << 20;  ///< bytes for the copies of SoFar

  /// Sorts what the picture shows. @throws TooLongRun
  SortRun(const Picture& picture, std::uint8_t ground);
  /// A run that somebody else recorded over picture.snapped(), which has planes. It need not be finished.
  SortRun(const Picture& picture, SortedScene sorted, std::uint8_t ground);
  SortRun(const SortRun&) = delete;
  SortRun& operator=(const SortRun&) = delete;
  ~SortRun() = default;

  [[nodiscard]] const SnappedScene& scene() const { return picture_.snapped(); }
  [[nodiscard]] const Picture& picture() const { return picture_; }  ///< with planes
  [[nodiscard]] const SortedScene& sorted() const { return sorted_; }
  [[nodiscard]] const Explainer& explainer() const { return explainer_; }
  [[nodiscard]] const Fragments& fragments() const { return explainer_.fragments(); }
  [[nodiscard]] const Landmarks& landmarks() const { return landmarks_; }
  [[nodiscard]] const Replay& replay() const { return replay_; }
  [[nodiscard]] int steps() const { return replay_.steps(); }
  /// The event of the present step, with P and Q named as in the tests that led to it. Of two polygons that
  /// pass through each other the smaller is cut, and that may be the Q of the tests. Nothing at the start.
  [[nodiscard]] std::optional<Event> asTested() const;
  /// 0 <= step <= steps().
  void goTo(int step) { replay_.goTo(step); }
  [[nodiscard]] const IndexImage& soFar() { return soFar_.at(replay_.painted()); }

  /// The same as Explainer::zExtent(), kept for every fragment.
  [[nodiscard]] Range zExtent(int id) const { return zExtents_[id]; }
  /// The ids of the fragments that are left to paint at this step, the first of the list first.
  [[nodiscard]] std::vector<int> waiting() const;
  /// The id of the n-th fragment that is painted.
  [[nodiscard]] int paintedId(int n) const;
  /// What a step is about; 1 <= step <= steps().
  [[nodiscard]] StepAbout about(int step) const;
  /// The first step of the wanted kind with P and Q; or else of any kind with both; or else of any kind with
  /// P.
  [[nodiscard]] std::optional<int> stepAbout(const StepAbout& wanted) const;
  /// The id of the fragment that is visible at a sample now; or else of the next one that will be; or else
  /// -1.
  [[nodiscard]] int fragmentAt(int column, int row) const;

 private:
  SortRun(Picture withPlanes, std::optional<SortedScene> sorted, std::uint8_t ground, std::size_t copies);

  const Picture picture_;
  SortedScene sorted_;
  Explainer explainer_;
  Landmarks landmarks_;
  Replay replay_;
  SoFar soFar_;
  std::vector<Range> zExtents_;
};

}  // namespace xnewell
