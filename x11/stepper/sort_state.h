#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "x11/homework/run_record.h"
#include "x11/kit/control.h"
#include "x11/kit/score.h"
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

}  // namespace xnewell
