#include "x11/window/controls.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "geometry/exact/trig.h"
#include "geometry/exact/unit.h"

namespace xnewell {

namespace {

bool always(const Setup&) { return true; }
bool needsSpecular(const Setup& s) { return s.picture.light.ks > 0; }
bool corrected(const Setup& s) { return s.picture.table.kind == TableKind::Corrected; }

template <class Rows>
std::vector<std::string_view> labels(const Rows& rows) {
  std::vector<std::string_view> all;
  all.reserve(rows.size());
  for (const auto& row : rows) all.push_back(row.label);
  return all;
}

template <class Rows>
std::vector<std::string_view> names(const Rows& rows) {
  std::vector<std::string_view> all;
  all.reserve(rows.size());
  for (const auto& row : rows) all.push_back(row.name);
  return all;
}

bool isParallel(const CameraSettings& camera) { return camera.parallel || camera.oblique; }

}  // namespace

const std::array<SliderRow, 8> kSliders{{
    {'i', "Ia", "light that comes from everywhere alike", Section::Light, 0, 1, 0.01, false, 2,
     [](const Setup& s) { return s.picture.light.Ia; }, setIa, always},
    {'p', "Ip", "light of the source; Ia + Ip keep within 1", Section::Light, 0, 1, 0.01, false, 2,
     [](const Setup& s) { return s.picture.light.Ip; }, setIp, always},
    {'a', "ka", "how much of Ia the surface gives back", Section::Surface, 0, 1, 0.01, false, 2,
     [](const Setup& s) { return s.picture.light.ka; }, [](Setup& s, double v) { s.picture.light.ka = v; },
     always},
    {'d', "kd", "how much of Ip it scatters, times N.L", Section::Surface, 0, 1, 0.01, false, 2,
     [](const Setup& s) { return s.picture.light.kd; }, [](Setup& s, double v) { s.picture.light.kd = v; },
     always},
    {'s', "ks", "how much of Ip it mirrors: the highlight", Section::Surface, 0, 1, 0.01, false, 2,
     [](const Setup& s) { return s.picture.light.ks; }, [](Setup& s, double v) { s.picture.light.ks = v; },
     always},
    {'n', "n", "how sharp the highlight is: R.V to the n", Section::Surface, 1, 1000, 0.01, true, 0,
     [](const Setup& s) { return double(s.picture.light.n); },
     [](Setup& s, double v) { s.picture.light.n = static_cast<int>(v); }, needsSpecular,
     "n is the highlight's, and ks is 0: there is none."},
    {'c', "shades", "cells of the ramp from dark to bright", Section::ColourTable, 2, kMaxShades, 1, false, 0,
     [](const Setup& s) { return double(s.picture.table.shades); },
     [](Setup& s, double v) { s.picture.table.shades = static_cast<int>(v); }, always},
    {'0', "I0", "the darkest shade, also of what is darker; each next r times as bright",
     Section::ColourTable, 0.001, 0.5, 0.01, true, 3, [](const Setup& s) { return s.picture.table.I0; },
     [](Setup& s, double v) { s.picture.table.I0 = v; }, corrected,
     "I0 is for the corrected table: T goes through the tables."},
}};

const std::vector<ChoiceRow>& choices() {
  static const std::vector<ChoiceRow> rows{
      {'W', "show", "what is drawn of the scene", Section::Method, labels(kShows),
       [](const Setup& s) { return int(s.show); }, [](Setup& s, int i) { s.show = kShows[i].id; }},
      {'S', "shading", "where I is computed: a face, its corners, each pixel", Section::Method,
       labels(kShadings), [](const Setup& s) { return int(s.picture.shading); },
       [](Setup& s, int i) { s.picture.shading = kShadings[i].id; }},
      {'N', "normals", "how a vertex gets N from the faces around it", Section::Method, names(kNormalRules),
       [](const Setup& s) { return int(s.picture.normals); },
       [](Setup& s, int i) { s.picture.normals = kNormalRules[i].id; }},
      {'O', "order", "which is painted first; what comes later covers it", Section::Method, labels(kOrders),
       [](const Setup& s) { return int(s.picture.order); },
       [](Setup& s, int i) { s.picture.order = kOrders[i].id; }},
      {'F', "fill", "who finds the pixels of a polygon", Section::Method, labels(kFills),
       [](const Setup& s) { return int(s.fill); }, [](Setup& s, int i) { s.fill = kFills[i].id; }},
      {'P',
       "project",
       "whether what is far is smaller",
       Section::Method,
       {"parallel", "perspective"},
       [](const Setup& s) { return isParallel(s.picture.camera) ? 0 : 1; },
       [](Setup& s, int i) {
         CameraSettings& camera = s.picture.camera;
         camera.parallel = i == 0;
         camera.oblique.reset();
         camera.height.reset();
       }},
      {'K',
       "backs",
       "faces turned away: painted, or left out",
       Section::Method,
       {"keep", "cull"},
       [](const Setup& s) { return int(s.picture.cull); },
       [](Setup& s, int i) { s.picture.cull = i == 0 ? Cull::Keep : Cull::Back; }},
      {'T',
       "table",
       "which intensity the i-th shade stands for",
       Section::ColourTable,
       {kTables[0].name, kTables[1].name, kTables[2].name},
       [](const Setup& s) { return int(s.picture.table.kind); },
       [](Setup& s, int i) { s.picture.table.kind = kTables[i].id; }},
  };
  return rows;
}

std::string_view keepFillable(Setup& setup) {
  if (setup.fill != Fill::XFillPolygon) return {};
  const bool oracle = setup.picture.order == Order::Oracle;
  if (!oracle && !rowOf(setup.picture.shading).interpolates) return {};
  setup.fill = Fill::Scanline;
  return oracle ? "The oracle decides each sample by itself: there is no polygon for the server to fill."
                : "XFillPolygon gives a polygon one cell: the server cannot interpolate.";
}

const SliderRow* sliderOf(char key) {
  const auto* const row = std::ranges::find(kSliders, key, &SliderRow::key);
  return row == kSliders.end() ? nullptr : row;
}

std::string_view whatIs(char key) {
  if (key == 'l') return "where the light is: drag it on the ball";
  for (const SliderRow& row : kSliders)
    if (row.key == key) return row.tells;
  for (const ChoiceRow& row : choices())
    if (row.key == key) return row.tells;
  for (const ToggleRow& row : kToggles)
    if (row.key == key) return row.tells;
  return {};
}

void nextHue(Setup& setup) {
  const auto* const row = std::ranges::find(kHues, setup.picture.table.hue, &HueRow::hue);
  setup.picture.table.hue = row == kHues.end() || row + 1 == kHues.end() ? kHues[0].hue : row[1].hue;
}

double trackPosition(const SliderRow& row, double value) {
  const double v = std::clamp(value, row.low, row.high);
  return row.logarithmic ? std::log(v / row.low) / std::log(row.high / row.low)
                         : (v - row.low) / (row.high - row.low);
}

double trackValue(const SliderRow& row, double position) {
  const double p = std::clamp(position, 0.0, 1.0);
  const double v =
      row.logarithmic ? row.low * std::pow(row.high / row.low, p) : row.low + p * (row.high - row.low);
  const double unit = std::pow(10.0, row.decimals);
  return std::clamp(std::round(v * unit) / unit, row.low, row.high);
}

void step(Setup& setup, const SliderRow& row, int steps) {
  const double share = row.logarithmic ? row.step : row.step / (row.high - row.low);
  const double before = row.get(setup), unit = std::pow(10.0, -row.decimals);
  double after = trackValue(row, trackPosition(row, before) + steps * share);
  // On a logarithmic track a step may be less than the last decimal: move that at least.
  if (std::abs(after - before) < unit / 2)
    after = std::clamp(before + (steps > 0 ? unit : -unit), row.low, row.high);
  row.set(setup, after);
}

namespace {
/// 1 - v, without the dust that binary fractions leave: the sum may not exceed 1 either.
double complement(double v) { return std::floor((1.0 - v) * 1e9 + 0.5) / 1e9; }
}  // namespace

void setIa(Setup& setup, double Ia) {
  Illumination& light = setup.picture.light;
  light.Ia = Ia;
  if (light.Ia + light.Ip > 1.0) light.Ip = complement(Ia);
}

void setIp(Setup& setup, double Ip) {
  Illumination& light = setup.picture.light;
  light.Ip = Ip;
  if (light.Ia + light.Ip > 1.0) light.Ia = complement(Ip);
}

namespace {
/// Right, towards the viewer and up in the world, as the default view looks at a scene with this axis up.
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
    *light.lightPosition = centre + glm::length(*light.lightPosition - centre) * towards;
}

}  // namespace xnewell
