#include "x11/lessons/lesson_controls.h"

#include <algorithm>

#include "geometry/exact/box.h"
#include "shading/scene/units.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

using Kind = Control::Kind;

/// Words that differ from those of the views, where there are any.
struct WordsRow {
  LessonControl id;
  std::string_view label, is, words;
};
constexpr std::array kWords{
    WordsRow{LessonControl::Light, "light", "turn the light with the arrows", ""},
    WordsRow{LessonControl::Turn, "turn", "turn the scene with the arrows", "arrows, or drag the picture"},
    WordsRow{LessonControl::Zoom, "zoom", "come nearer or go away with the arrows", "arrows up and down"},
    WordsRow{LessonControl::Pick, "nearest", "", ""},
    WordsRow{LessonControl::ConstantL, "L const.", "", "the light is far away"},
    WordsRow{LessonControl::ConstantV, "V const.", "", "the viewer is far away"},
    WordsRow{LessonControl::Names, "names", "", "name the polygons"},
    WordsRow{LessonControl::Wrong, "wrong", "", "mark them in the picture"},
    WordsRow{LessonControl::Event, "step", "go through the run with the arrows", ""},
    WordsRow{LessonControl::Rotate, "rotate", "", "move the ramp through its cells"},
    WordsRow{LessonControl::Gamma, "gamma", "", ""},
};

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

Control plainControl(const LessonControlRow& row, LessonState& state, Host& host, double aspect) {
  const ChangeSetup change = [&host](char control, const auto& edit) { host.change(control, edit); };
  const Scene& scene = *state.exhibit.scene;
  const Subject subject{scene, centreOf(scene), aspect};
  switch (row.id) {
    case LessonControl::Names:
      return toggle(state.exhibit.named, state);
    case LessonControl::Wrong:
      return toggle(state.exhibit.wrongMarked, state);
    case LessonControl::Rotate:
      return rotateControl(state);
    case LessonControl::Event:
      return eventControl(state);
    case LessonControl::Gamma:
      return gammaControl(state.exhibit.effects.gamma, [&state](double gamma) {
        state.exhibit.effects.gamma = gamma;
        state.late = true;
      });
    case LessonControl::Light:
      return lightControl(host.setup(), subject, change);
    case LessonControl::Turn:
    case LessonControl::Zoom: {
      const Controls camera = cameraControls(host.setup(), subject, change);
      return *std::ranges::find(camera, row.key, &Control::key);
    }
    default:
      return settingControl(row.key, host.setup(), host.defaults(), change);
  }
}

}  // namespace

Controls stepControls(const LessonStep& step, LessonState& state, Host& host, double aspect) {
  const std::size_t answers = step.question ? step.question->answers.size() : 0;
  Controls all;
  for (const LessonControl id : step.controls) {
    const LessonControlRow& row = rowOf(id);
    Control control = plainControl(row, state, host, aspect);
    const bool answer = row.spare != 0 && static_cast<std::size_t>(row.key - 'a') < answers;
    control.key = answer ? row.spare : row.key;
    if (const auto* const words = std::ranges::find(kWords, id, &WordsRow::id); words != kWords.end()) {
      control.label = words->label;
      if (!words->is.empty()) control.is = words->is;
      if (!words->words.empty()) control.words = words->words;
    }
    all.push_back(std::move(control));
  }
  return all;
}

}  // namespace xnewell
