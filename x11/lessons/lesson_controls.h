#pragma once

#include <glm/vec3.hpp>

#include "x11/lessons/lesson.h"
#include "x11/lessons/lesson_page.h"
#include "x11/window/controls.h"

namespace xnewell {

/// The controls of a lesson's step: rows of the window's controls under the letters that a lesson has for
/// them, and a few of the lesson's own.

/// What the lesson's own controls change.
struct LessonState {
  Exhibit exhibit;            ///< as it is shown now: names, wrong faces, effects
  int event = 1, events = 1;  ///< step of the depth sort's run
  bool moving = false;        ///< the ramp
};

/// The row on the page. `first` is the setup that the step began with.
[[nodiscard]] PageControl pageControl(LessonControl control, const Setup& now, const Setup& first,
                                      const LessonState& state);

/// Whether arrows change it: it takes the keyboard. Else its letter acts.
[[nodiscard]] bool takesArrows(LessonControl control);

/// Whether it is one of the lesson's own, which actOn() and moveTo() change and no setup.
[[nodiscard]] bool isLessonsOwn(LessonControl control);

/// The letter of a control that acts, on the setup: the next option, the other value; or that option.
void actOn(Setup& setup, LessonControl control, std::optional<int> option = {});
/// The same of the lesson's own.
void actOn(LessonState& state, LessonControl control, std::optional<int> option = {});

/// Arrows on a control that takes them, the lesson's own event aside.
void move(Setup& setup, LessonControl control, int along, int up, const Scene& scene, double aspect);
/// A slider to a share of its track.
void moveTo(Setup& setup, LessonControl control, double share);
/// A slider to its lower or upper end.
void moveToEnd(Setup& setup, LessonControl control, bool high);

}  // namespace xnewell
