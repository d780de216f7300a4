#include "x11/lessons/lesson_controls.h"

#include <algorithm>
#include <cmath>

#include "geometry/exact/box.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

const SliderRow* slider(LessonControl control) { return sliderOf(rowOf(control).window); }

const ChoiceRow* choice(LessonControl control) { return choiceOf(rowOf(control).window); }

const ToggleRow* toggle(LessonControl control) { return toggleOf(rowOf(control).window); }

bool* toggle(LessonState& state, LessonControl control) {
  if (control == LessonControl::Names) return &state.exhibit.named;
  if (control == LessonControl::Wrong) return &state.exhibit.wrongMarked;
  return control == LessonControl::Rotate ? &state.moving : nullptr;
}

/// The words beside a tick.
std::string_view wordsOf(LessonControl control) {
  switch (control) {
    case LessonControl::ConstantL:
      return "the light is far away";
    case LessonControl::ConstantV:
      return "the viewer is far away";
    case LessonControl::Names:
      return "name the polygons";
    case LessonControl::Wrong:
      return "mark them in the picture";
    default:
      return "move the ramp through its cells";
  }
}

std::string_view labelOf(LessonControl control) {
  switch (control) {
    case LessonControl::Projection:
      return "project";
    case LessonControl::ConstantL:
      return "L const.";
    case LessonControl::ConstantV:
      return "V const.";
    case LessonControl::Event:
      return "step";
    default:
      return rowOf(control).name;
  }
}

int indexOf(double gamma) {
  const auto* const g = std::ranges::find(kGammas, gamma);
  return g == kGammas.end() ? -1 : static_cast<int>(g - kGammas.begin());
}

int indexOfHue(const Setup& setup) {
  const auto* const h = std::ranges::find(kHues, setup.picture.table.hue, &HueRow::hue);
  return h == kHues.end() ? -1 : static_cast<int>(h - kHues.begin());
}

}  // namespace

bool takesArrows(LessonControl control) {
  switch (control) {
    case LessonControl::Light:
    case LessonControl::Turn:
    case LessonControl::Zoom:
    case LessonControl::Event:
      return true;
    default:
      return slider(control) != nullptr;
  }
}

bool isLessonsOwn(LessonControl control) { return rowOf(control).window == 0; }

PageControl pageControl(LessonControl control, const Setup& now, const Setup& first,
                        const LessonState& state) {
  PageControl row{.key = rowOf(control).key, .label = std::string{labelOf(control)}};
  const auto ticked = [&](bool on) { row.toggle = true, row.chosen = on, row.value = wordsOf(control); };
  if (const SliderRow* s = slider(control)) {
    row.track = trackPosition(*s, s->get(now));
    row.usual = trackPosition(*s, s->get(first));
    row.value = fixed(s->get(now), s->decimals);
    row.enabled = s->enabled(now);
  } else if (const ChoiceRow* c = choice(control)) {
    row.options.assign(c->options.begin(), c->options.end());
    row.chosen = c->get(now);
  } else if (const ToggleRow* t = toggle(control)) {
    ticked(t->get(now));
  } else if (LessonState copy = state; const bool* on = toggle(copy, control)) {
    ticked(*on);
  } else if (control == LessonControl::Hue) {
    for (const HueRow& hue : kHues) row.options.emplace_back(hue.name);
    row.chosen = indexOfHue(now);
  } else if (control == LessonControl::Gamma) {
    for (const double g : kGammas) row.options.push_back(fixed(g, 1));
    row.chosen = indexOf(state.exhibit.effects.gamma);
  } else if (control == LessonControl::Light) {
    const LightAngles at = lightAngles(now.picture.light, state.exhibit.scene->up);
    row.value = "azimuth " + fixed(at.azimuth, 0) + "\u00B0, elevation " + fixed(at.elevation, 0) + "\u00B0";
  } else if (control == LessonControl::Event) {
    row.value = std::to_string(state.event) + " of " + std::to_string(state.events);
  } else {
    row.value = control == LessonControl::Turn ? "arrows, or drag the picture" : "arrows up and down";
  }
  return row;
}

void actOn(Setup& setup, LessonControl control, std::optional<int> option) {
  const auto next = [&](int now, int count) { return option.value_or((now + 1) % count); };
  if (const ChoiceRow* c = choice(control))
    c->set(setup, next(c->get(setup), static_cast<int>(c->options.size())));
  else if (const ToggleRow* t = toggle(control))
    t->flip(setup);
  else if (control == LessonControl::Hue)
    setup.picture.table.hue =
        kHues[static_cast<std::size_t>(next(indexOfHue(setup), static_cast<int>(kHues.size())))].hue;
}

void actOn(LessonState& state, LessonControl control, std::optional<int> option) {
  if (bool* on = toggle(state, control)) *on = !*on;
  if (control == LessonControl::Rotate && !state.moving) state.exhibit.effects.rotate = 0;
  if (control != LessonControl::Gamma) return;
  const int count = static_cast<int>(kGammas.size());
  double& gamma = state.exhibit.effects.gamma;
  gamma = kGammas[static_cast<std::size_t>(option.value_or((indexOf(gamma) + 1) % count))];
}

void move(Setup& setup, LessonControl control, int along, int up, const Scene& scene, double aspect) {
  if (const SliderRow* s = slider(control)) return step(setup, *s, along + up);
  const auto& points = scene.mesh.points;
  if (control == LessonControl::Light)
    return turnLight(setup.picture.light, scene.up, along, up, boxOf(points).centre());
  CameraSettings& camera = setup.picture.camera;
  const Camera placed = placeCamera(camera, points, scene.up, aspect);
  if (control == LessonControl::Turn) camera = moved(camera, placed, -2.0 * along, -2.0 * up, 1.0);
  if (control == LessonControl::Zoom) camera = moved(camera, placed, 0, 0, std::pow(1.02, along + up));
}

void moveTo(Setup& setup, LessonControl control, double share) {
  if (const SliderRow* s = slider(control)) s->set(setup, trackValue(*s, share));
}

void moveToEnd(Setup& setup, LessonControl control, bool high) {
  if (const SliderRow* s = slider(control)) s->set(setup, high ? s->high : s->low);
}

}  // namespace xnewell
