#include "x11/lessons/lesson_controls.h"

#include <algorithm>

#include "geometry/exact/box.h"
#include "shading/scene/units.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

using Kind = Control::Kind;

Control toggle(bool& on, LessonState& state) {
  return {.kind = Kind::Toggle, .value = on ? 1.0 : 0.0, .set = [&](double value) {
            on = value != 0;
            state.late = true;
          }};
}

Control rotateControl(LessonState& state) {
  Control control = toggle(state.moving, state);
  control.set = [&state, set = control.set](double value) {
    set(value);
    if (!state.moving) state.exhibit.effects.rotate = 0;
  };
  return control;
}

Control eventControl(LessonState& state) {
  const auto go = [&state](int event) {
    state.event = std::clamp(event, 1, state.events);
    state.late = true;
  };
  return {.kind = Kind::Own,
          .value = static_cast<double>(state.event),
          .range = {1, static_cast<double>(state.events), 1, false, 0},
          .words = std::to_string(state.event) + " of " + std::to_string(state.events),
          .set = [go](double event) { go(static_cast<int>(event)); },
          .move = [&state, go](int along, int up) { go(state.event + along + up); }};
}

Control plainControl(char key, LessonState& state, Host& host, double aspect) {
  const ChangeSetup change = [&host](char control, const auto& edit) { host.change(control, edit); };
  const Scene& scene = *state.exhibit.scene;
  const Subject subject{scene, centreOf(scene), aspect};
  if (key == 'M') return toggle(state.exhibit.named, state);
  if (key == 'W') return toggle(state.exhibit.wrongMarked, state);
  if (key == 'm') return rotateControl(state);
  if (key == 'v') return eventControl(state);
  if (key == 'g')
    return gammaControl(state.exhibit.effects.gamma, [&state](double gamma) {
      state.exhibit.effects.gamma = gamma;
      state.late = true;
    });
  if (key == 'l') return lightControl(host.setup(), subject, change);
  const Controls camera = cameraControls(host.setup(), subject, change);
  const auto own = std::ranges::find(camera, key, &Control::key);
  return own != camera.end() ? *own : settingControl(key, host.setup(), host.defaults(), change);
}

/// The key in a step where `key` chooses an answer, `a` to `d`.
char spareOf(char key) { return key == 'a' ? 'k' : key == 'c' ? 'x' : key == 'd' ? 'f' : key; }

}  // namespace

Controls stepControls(const LessonStep& step, LessonState& state, Host& host, double aspect) {
  const std::size_t answers = step.question ? step.question->answers.size() : 0;
  Controls all;
  for (const char key : step.controls) {
    const LessonControl& row = *std::ranges::find(lessonControls(), key, &LessonControl::id);
    Control control = plainControl(key, state, host, aspect);
    const bool answer = key >= 'a' && static_cast<std::size_t>(key - 'a') < answers;
    control.key = answer ? spareOf(key) : key;
    control.label = row.label;
    if (!row.is.empty()) control.is = row.is;
    if (!row.words.empty()) control.words = row.words;
    all.push_back(std::move(control));
  }
  return all;
}

}  // namespace xnewell
