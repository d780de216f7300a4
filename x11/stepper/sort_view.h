#pragma once

#include <optional>
#include <vector>

#include "depthsort/depth_sort.h"
#include "x11/stepper/sort_layout.h"

namespace xnewell {

/// What is shown of a run besides the run itself.
struct SortView {
  int step = 0;
  Landmark kind = Landmark::Failed;  ///< that is jumped to
  std::array<bool, kStops> stops{};  ///< as kToggleNames has them
  std::optional<int> polygon = {};   ///< face number that a stop looks for
  bool predict = false;
  bool asking = false;                    ///< the outcome of this step's comparison is hidden
  std::optional<Verdict> answer = {};     ///< of the learner, to the step that is shown
  int right = 0, asked = 0;               ///< answers so far
  double speed = kUsualSpeed;             ///< steps a second
  bool playing = false, dragged = false;  ///< dragged: the speed's thumb
  bool loupe = true;                      ///< over the picture
  bool numbered = false;                  ///< the boxes show the digits that tick them
  SortSpot hover = {};
  bool operator==(const SortView&) const = default;
};

/// What was drawn where, for who resolves clicks.
struct SortDrawn {
  Rect loupe;             ///< empty: none
  std::vector<int> rows;  ///< fragment id of each row of the list, -1 for none
};

}  // namespace xnewell
