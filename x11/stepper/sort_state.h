#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "shading/picture/picture.h"
#include "x11/homework/run_record.h"
#include "x11/kit/control.h"
#include "x11/kit/quiz.h"
#include "x11/stepper/sort_layout.h"

namespace xnewell {

/// The state of the page while the student sorts (own_sort.h).
struct OwnState {
  int P = -1, Q = -1;  ///< ids of the chosen polygons; -1 if none is left
  /// Of tests 1 to 5 on P and Q: what is known since the student named it.
  std::array<std::optional<bool>, kOwnTests> passed{};
  bool naming = false;   ///< the next digit names a test
  bool clicksQ = false;  ///< a click chooses Q, not P
  std::string bold = {}, why = {};
  bool alarm = false;
  Score score = {};                    ///< of the steps so far: how many of them were valid
  std::vector<SampleRow> spoilt = {};  ///< samples that will show a polygon that is not the nearest
  bool operator==(const OwnState&) const = default;
};

/// The state of the page besides the run itself.
struct SortState {
  int step = 0;
  Landmark kind = Landmark::Failed;  ///< the kind of step to jump to
  std::array<bool, kStops> stops{};  ///< in the order of kToggleNames
  std::optional<int> polygon = {};   ///< the face number to stop at
  bool predict = false;
  bool asking = false;                 ///< the outcome of this comparison is hidden
  std::optional<Verdict> answer = {};  ///< the learner's answer to the question of this step
  Score score = {};                    ///< of the answers so far
  double speed = kUsualSpeed;          ///< steps a second
  bool playing = false;
  bool loupe = true;                 ///< the loupe is shown over the picture
  bool code = false;                 ///< the book's lines are shown, in place of side view and list
  bool numbered = false;             ///< the boxes show the digits that tick them
  bool theirs = false;               ///< the run is that of another program
  std::optional<OwnState> own = {};  ///< the student sorts
  bool operator==(const SortState&) const = default;
};

/// A name on the ring of a cycle, or an arrow that leads to the step of a test.
struct RingPlace {
  Rect area;
  int id, step;  ///< of a name: the fragment; of an arrow: -1, and the step
};
/// Where things were drawn, to resolve clicks.
struct SortDrawn {
  Rect loupe;             ///< empty if there is none
  std::vector<int> rows;  ///< fragment id of each row of the list, -1 for none
  std::vector<RingPlace> ring = {};
};

/// The picture of a run after any number of its fragments, whether the steps go forward or back.
class SoFar {
 public:
  /// A run over picture.snapped(), which outlives it. Within so many bytes it keeps copies of the image,
  /// evenly spaced along the run as at() passes there, so that going back paints at most a space again.
  SoFar(const Picture& picture, const SortedScene& sorted, std::uint8_t ground, std::size_t bytes);
  SoFar(const SoFar&) = delete;  // its painter refers to its picture
  SoFar& operator=(const SoFar&) = delete;
  ~SoFar() = default;

  /// Valid until the next call. 0 <= painted <= SortedScene::fragments.size().
  [[nodiscard]] const IndexImage& at(int painted);

 private:
  static constexpr int kMostCopies = 256;

  const Picture picture_;
  const SortedScene& sorted_;
  SurfacePainter painter_;
  IndexImage image_;
  int painted_ = 0;                 ///< fragments in image_
  int space_ = 0;                   ///< fragments from copy to copy; 0: no copies are kept
  std::vector<IndexImage> copies_;  ///< the k-th shows k space_ fragments
};

}  // namespace xnewell
