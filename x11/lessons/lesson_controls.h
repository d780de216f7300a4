#pragma once

#include <glm/vec3.hpp>

#include "x11/lessons/lesson.h"
#include "x11/lessons/lesson_page.h"
#include "x11/window/controls.h"

namespace xnewell {

/// The controls of a step of a lesson: controls of the window, under the letters of a lesson, and a few that
/// only lessons have.

/// What the controls that only lessons have can change.
struct LessonState {
  Exhibit exhibit;            ///< the exhibit as it is shown now: names, wrong faces, effects
  int event = 1, events = 1;  ///< the step of the depth sort's run, and how many there are
  bool moving = false;        ///< the ramp moves
};

/// The row of a control on the page. `first` is the setup with which the step began.
[[nodiscard]] PageControl pageControl(LessonControl control, const Setup& now, const Setup& first,
                                      const LessonState& state);

/// True if arrows change the control, so that it takes the keyboard. Otherwise its letter changes it.
[[nodiscard]] bool takesArrows(LessonControl control);

/// True if only lessons have the control: it changes a LessonState, not a setup.
[[nodiscard]] bool isLessonsOwn(LessonControl control);

/// Presses the letter of a control of the setup: takes the next option or the other value; or the given
/// option.
void actOn(Setup& setup, LessonControl control, std::optional<int> option = {});
/// The same for a control that only lessons have.
void actOn(LessonState& state, LessonControl control, std::optional<int> option = {});

/// Presses arrows on a control that takes them, except the lesson's event.
void move(Setup& setup, LessonControl control, int along, int up, const Scene& scene, double aspect);
/// Moves a slider to a share of its track.
void moveTo(Setup& setup, LessonControl control, double share);
/// Moves a slider to its lower or upper end.
void moveToEnd(Setup& setup, LessonControl control, bool high);

}  // namespace xnewell
