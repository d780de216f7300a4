#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "depthsort/record/explain.h"
#include "depthsort/record/replay.h"
#include "x11/homework/judge_run.h"
#include "x11/stepper/sort_state.h"

namespace xnewell {

/// What a step is about, in terms that also fit the run of another view of the scene.
struct StepAbout {
  Event::Kind kind = Event::Kind::Take;
  int P = -1, Q = -1;  ///< numbers of faces; -1 if there is no Q
  bool operator==(const StepAbout&) const = default;
};

/// A polygon of a cycle, which must be painted before the next one; the last one before the first.
struct RingLink {
  int id;  ///< of a fragment
  /// What says so: a test of the run; or for a piece, which the run has not tested yet, the planes. Or the
  /// ring is open here: the cut is between two pieces, or a contact does not count.
  enum class By { Test, Planes, Open } by = By::Test;
  int step = 0;  ///< of the test; for a piece, of the polygon that was cut
  bool operator==(const RingLink&) const = default;
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
  /// The run of another program, as far as this picture of its view shows it.
  SortRun(const Picture& picture, std::shared_ptr<const JudgedRun> theirs, std::uint8_t ground);
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
  /// The cycle that the present step meets or breaks, from its P on; empty if it does neither.
  [[nodiscard]] std::vector<RingLink> ring() const;
  /// What another program has run; null if the run is ours, or made by hand.
  [[nodiscard]] const JudgedRun* theirs() const { return theirs_.get(); }
  /// What is false at the present step of their run. What may follow from another step comes last.
  [[nodiscard]] std::vector<const FalseStep*> wrong() const { return wrongAt(replay_.step()); }
  [[nodiscard]] std::vector<const FalseStep*> wrongAt(int step) const;
  /// Their file's line of the present step; 0 at the start.
  [[nodiscard]] int line() const { return replay_.step() > 0 ? named_->lines()[replay_.step() - 1] : 0; }
  /// The ids of the fragments that one of their polygons is here.
  [[nodiscard]] const std::vector<int>& partsOf(int polygon) const { return (*named_)[polygon].parts; }
  /// What two polygons are to each other, whatever a run says.
  [[nodiscard]] Event compared(int P, int Q) const;
  /// The samples where P hides Q.
  [[nodiscard]] Hidden hidden(int P, int Q) const { return named_->record.hidden(P, Q); }
  /// What becomes of the two polygons that this step compares.
  [[nodiscard]] Verdict verdict() const;
  /// A fragment's number and part in the list: those of Fragments, or what another program calls its piece.
  [[nodiscard]] std::string number(int id) const;
  [[nodiscard]] std::string part(int id) const;
  /// What the picture and the ring call it: its own name, or else its number.
  [[nodiscard]] std::string shortName(int id) const;
  /// What sentences call it: as judge does in another program's run, or else `85 body`.
  [[nodiscard]] std::string name(int id) const;
  /// True if no line of their run has this step: they have not written what they took.
  [[nodiscard]] bool isAdded() const;
  /// The height of their picture, with this one's as the unit: views scale by their heights.
  [[nodiscard]] double scale() const;
  /// 0 <= step <= steps().
  void goTo(int step) { replay_.goTo(step); }
  [[nodiscard]] const IndexImage& soFar() { return soFar_.at(replay_.painted()); }

  /// The same as Explainer::zExtent(), kept for every fragment.
  [[nodiscard]] Range zExtent(int id) const { return zExtents_[id]; }
  /// The ids of the fragments that are left to paint at this step, the first of the list first.
  [[nodiscard]] std::vector<int> waiting() const;
  /// The id of the n-th fragment that is painted.
  [[nodiscard]] int paintedId(int n) const;
  /// Where words of this size can stand on what the finished picture shows of a fragment, all in samples: the
  /// upper left corner that brings them nearest to its middle. Nothing if there is no room.
  [[nodiscard]] std::optional<glm::ivec2> roomFor(int id, glm::ivec2 size);
  /// What a step is about; 1 <= step <= steps().
  [[nodiscard]] StepAbout about(int step) const;
  /// The first step of the wanted kind with P and Q; or else of any kind with both; or else of any kind with
  /// P.
  [[nodiscard]] std::optional<int> stepAbout(const StepAbout& wanted) const;
  /// The id of the fragment that is visible at a sample now; or else of the next one that will be; or else
  /// -1.
  [[nodiscard]] int fragmentAt(int column, int row) const;

 private:
  /// The polygon of their run that a fragment is; null if there is none.
  [[nodiscard]] const NamedRun::Polygon* named(int id) const;
  SortRun(Picture withPlanes, std::optional<SortedScene> sorted, std::uint8_t ground, std::size_t copies,
          std::shared_ptr<const JudgedRun> theirs = {}, std::unique_ptr<NamedRun> named = {});
  /// The steps that are false, and do not follow from others; nothing if the run is ours.
  [[nodiscard]] std::optional<std::vector<int>> falseSteps();

  const Picture picture_;
  std::shared_ptr<const JudgedRun> theirs_;
  std::unique_ptr<NamedRun> named_;                  ///< what their run is in this picture
  std::multimap<int, const FalseStep*> wrong_ = {};  ///< by step
  SortedScene sorted_;
  Explainer explainer_;
  Landmarks landmarks_;
  Replay replay_;
  SoFar soFar_;
  std::vector<Range> zExtents_;
  std::vector<int> seen_;  ///< the face at each sample; made when it is first needed
  std::map<std::array<int, 3>, std::optional<glm::ivec2>> rooms_;  ///< of roomFor()
};

}  // namespace xnewell
