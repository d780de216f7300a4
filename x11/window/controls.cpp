#include "x11/window/controls.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "geometry/exact/trig.h"
#include "geometry/exact/unit.h"

namespace xnewell {

namespace {

bool isParallel(const CameraSettings& camera) { return camera.parallel || camera.oblique; }

ChoiceRow choiceRow(const Setting& setting) {
  ChoiceRow row{.key = setting.control,
                .label = setting.label,
                .tells = setting.is,
                .section = setting.section,
                .options = {},
                .get = [&](const Setup& s) { return int(std::get<double>(setting.field.get(s.picture))); },
                .set =
                    [&](Setup& s, int i) {
                      (void)applyOverrides(s.picture, {{&setting, double(i)}});
                    }};
  for (const Choice& choice : setting.field.choices) row.options.push_back(choice.label);
  return row;
}

/// The terms of the equation share one option, the last; each choice of it goes on to the next term.
ChoiceRow showRow() {
  static const int terms = static_cast<int>(
      std::ranges::find_if(kShows, [](const ShowRow& show) { return show.term.has_value(); }) -
      kShows.begin());
  const auto isLast = [](Show show) { return show == kShows.back().id; };
  ChoiceRow row{.key = 'W',
                .label = "show",
                .tells = "what the picture shows",
                .section = Section::Method,
                .options = {},
                .get = [](const Setup& s) { return std::min(int(s.show), terms); },
                .set =
                    [isLast](Setup& s, int i) {
                      const bool goesOn = i == terms && rowOf(s.show).term && !isLast(s.show);
                      s.show = kShows[goesOn ? int(s.show) + 1 : i].id;
                    },
                .next = [isLast](const Setup& s) -> std::optional<int> {
                  if (rowOf(s.show).term && !isLast(s.show)) return terms;
                  return std::nullopt;
                }};
  for (int k = 0; k < terms; ++k) row.options.push_back(kShows[k].label);
  row.options.emplace_back("term");
  return row;
}

ChoiceRow projectionRow() {
  return {.key = 'P',
          .label = "project",
          .tells = "the projection: in perspective, distant things look smaller",
          .section = Section::Method,
          .options = {"parallel", "perspective"},
          .get = [](const Setup& s) { return isParallel(s.picture.camera) ? 0 : 1; },
          .set =
              [](Setup& s, int i) {
                CameraSettings& camera = s.picture.camera;
                camera.parallel = i == 0;
                camera.oblique.reset();
                camera.height.reset();
              }};
}

template <class Row>
const Row* withKey(const std::vector<Row>& rows, char key) {
  const auto row = std::ranges::find(rows, key, &Row::key);
  return row == rows.end() ? nullptr : &*row;
}

}  // namespace

double SliderRow::get(const Setup& setup) const {
  return std::get<double>(setting->field.get(setup.picture));
}

void SliderRow::set(Setup& setup, double value) const {
  (void)applyOverrides(setup.picture, {{setting, value}});
}

bool SliderRow::enabled(const Setup& setup) const { return hasEffect(*setting, factsOf(setup.picture)); }

bool ToggleRow::get(const Setup& setup) const {
  return std::get<double>(setting->field.get(setup.picture)) != 0.0;
}

const std::vector<SliderRow>& sliders() {
  static const std::vector<SliderRow> rows = [] {
    std::vector<SliderRow> all;
    for (const Setting& setting : settingRows())
      if (const auto& at = setting.slider)
        all.push_back({&setting, setting.control, setting.label, setting.section, at->low, at->high, at->step,
                       at->logarithmic, at->decimals});
    return all;
  }();
  return rows;
}

const std::vector<ChoiceRow>& choices() {
  static const std::vector<ChoiceRow> rows = [] {
    std::vector<ChoiceRow> all{showRow()};
    for (const Setting& setting : settingRows()) {
      if (setting.field.kind != ValueKind::Choice || setting.section == Section::Hidden) continue;
      all.push_back(choiceRow(setting));
      if (setting.key != "fill") continue;
      // In the setup the window keeps its own filler. The picture's setting is set only when a picture is
      // made for the server.
      all.back().get = [](const Setup& s) { return int(s.fill); };
      all.back().set = [](Setup& s, int i) { s.fill = static_cast<Fill>(i); };
      all.push_back(projectionRow());
    }
    return all;
  }();
  return rows;
}

const std::vector<ChoiceRow>& others() {
  static const std::vector<ChoiceRow> rows = [] {
    std::vector<ChoiceRow> all;
    for (const Setting& setting : settingRows())
      if (setting.control != 0 && setting.field.kind == ValueKind::Choice &&
          setting.section == Section::Hidden)
        all.push_back(choiceRow(setting));
    return all;
  }();
  return rows;
}

const std::vector<ToggleRow>& toggles() {
  static const std::vector<ToggleRow> rows = [] {
    std::vector<ToggleRow> all;
    for (const Setting& setting : settingRows())
      if (setting.control != 0 && setting.field.kind == ValueKind::Flag)
        all.push_back({&setting, setting.control, setting.label});
    return all;
  }();
  return rows;
}

const SliderRow* sliderOf(char key) { return withKey(sliders(), key); }

const ChoiceRow* choiceOf(char key) {
  const ChoiceRow* const row = withKey(choices(), key);
  return row ? row : withKey(others(), key);
}

const ToggleRow* toggleOf(char key) { return withKey(toggles(), key); }

std::string_view keepFillable(Setup& setup) {
  if (setup.fill != Fill::XFillPolygon) return {};
  const Order order = setup.picture.order;
  const bool bySample = rowOf(order).bySample;
  if (!bySample && !rowOf(setup.picture.shading).interpolates) return {};
  setup.fill = Fill::Scanline;
  return order == Order::Oracle
             ? "The oracle decides each sample by itself: there is no polygon for the server to fill."
         : bySample ? "A z-buffer decides each sample by itself: there is no polygon for the server to fill."
                    : "XFillPolygon gives a polygon one cell: the server cannot interpolate.";
}

namespace {
/// Axes of the world as the default view of a scene with this up axis sees them: right, towards the viewer,
/// up.
struct Horizon {
  glm::dvec3 right, towards, up;
};
Horizon horizon(UpAxis up) {
  if (up == UpAxis::Z) return {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  return {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
}
}  // namespace

glm::dvec3 towardsLight(const Illumination& light, glm::dvec3 centre) {
  return unit(light.lightPosition ? *light.lightPosition - centre : light.light);
}

LightAngles lightAngles(const Illumination& light, UpAxis up, glm::dvec3 centre) {
  const Horizon h = horizon(up);
  const glm::dvec3 L = towardsLight(light, centre);
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  return {std::atan2(glm::dot(L, h.right), glm::dot(L, h.towards)) * kDegrees,
          std::asin(std::clamp(glm::dot(L, h.up), -1.0, 1.0)) * kDegrees};
}

void turnLight(Illumination& light, UpAxis up, double azimuth, double elevation, glm::dvec3 centre) {
  const Horizon h = horizon(up);
  const LightAngles now = lightAngles(light, up, centre);
  const double e = std::clamp(std::round(now.elevation + elevation), -90.0, 90.0);
  double a = std::round(now.azimuth + azimuth);
  a -= 360.0 * std::floor((a + 180.0) / 360.0);
  const SinCos sa = sinCosDegrees(a), se = sinCosDegrees(e);
  aimLight(light, se.cos * (sa.sin * h.right + sa.cos * h.towards) + se.sin * h.up, centre);
}

void aimLight(Illumination& light, glm::dvec3 towards, glm::dvec3 centre) {
  light.light = towards;
  if (light.lightPosition)
    // Without squares: the file's units may be as large as 1e300.
    *light.lightPosition =
        centre + glm::dot(*light.lightPosition - centre, towardsLight(light, centre)) * towards;
}

}  // namespace xnewell
