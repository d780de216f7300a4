#pragma once

#include <optional>
#include <vector>

#include "depthsort/depth_sort.h"
#include "x11/kit/control.h"
#include "x11/kit/score.h"
#include "x11/stepper/sort_layout.h"

namespace xnewell {

/// The state of the page besides the run itself.
struct SortView {
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
  bool loupe = true;      ///< the loupe is shown over the picture
  bool code = false;      ///< the book's lines are shown, in place of side view and list
  bool numbered = false;  ///< the boxes show the digits that tick them
  bool operator==(const SortView&) const = default;
};

/// Where things were drawn, to resolve clicks.
struct SortDrawn {
  Rect loupe;             ///< empty if there is none
  std::vector<int> rows;  ///< fragment id of each row of the list, -1 for none
};

}  // namespace xnewell
