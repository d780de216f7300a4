#pragma once

#include "x11/lessons/lesson.h"
#include "x11/window/setting_controls.h"

namespace xnewell {

/// What the controls that only lessons have can change.
struct LessonState {
  Exhibit exhibit;            ///< the exhibit as it is shown now: names, wrong faces, effects
  int event = 1, events = 1;  ///< the step of the depth sort's run, and how many there are
  bool moving = false;        ///< the ramp moves
  bool late = true;           ///< the page does not show it yet
};

/// The controls of a step, in the step's order: those of the window, which change the host's setup, and a few
/// that only lessons have. `aspect` is that of the picture, width to height. State and host must outlive
/// them.
[[nodiscard]] Controls stepControls(const LessonStep& step, LessonState& state, Host& host, double aspect);

}  // namespace xnewell
