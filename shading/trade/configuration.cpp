#include "shading/trade/configuration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/exact/box.h"
#include "shading/picture/facts.h"
#include "shading/scene/units.h"

namespace xnewell {

namespace {

constexpr std::array kDivisions{1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};

/// L is the same everywhere if all lights are at infinity. Then it is no short cut to take it as constant.
bool lightsHavePlaces(const Picture& picture) {
  const Scene& scene = picture.scene();
  return std::ranges::any_of(lightsOf(scene, picture.settings().light),
                             [](const Light& light) { return light.kind != LightKind::Directional; });
}

bool mayBeAnAxis(const Setting& setting, const Picture& picture) {
  if (!setting.role.isShortCut() || setting.key == "fill") return false;
  return setting.key != "constant_l" || lightsHavePlaces(picture);
}

std::vector<double> valuesOf(const Setting& setting) {
  if (setting.field.kind == ValueKind::Flag) return {0, 1};
  if (setting.field.kind != ValueKind::Choice) return setting.trials;
  std::vector<double> values;
  for (std::size_t k = 0; k < setting.field.choices.size(); ++k) values.push_back(static_cast<double>(k));
  return values;
}

std::string valueOf(const Change& change) {
  return change.setting ? textOf(*change.setting, change.value) : textOf(change.value);
}

}  // namespace

std::string Axis::text(double value) const { return valueOf({setting, value}); }

std::string Configuration::name() const {
  if (changes.empty()) return "as it is";
  std::string all;
  for (const Change& change : changes) {
    const std::string one = change.setting
                                ? phraseOf(*change.setting, settings)
                                : textOf(change.value) + (change.value == 1 ? " division" : " divisions");
    all += (all.empty() ? "" : ", ") + one;
  }
  return all;
}

std::string Configuration::options() const {
  std::string all;
  for (const Change& change : changes) {
    const bool flag = change.setting && change.setting->field.kind == ValueKind::Flag;
    if (flag && change.value == 0) continue;
    all += all.empty() ? "" : " ";
    all += change.setting ? change.setting->option : "--divisions";
    if (!flag) all += ' ' + valueOf(change);
  }
  return all;
}

std::vector<Axis> axesOf(const Picture& picture, Reach reach) {
  std::vector<Axis> axes;
  const Scene& scene = picture.scene();
  if (scene.divisions > 0) {
    axes.push_back({nullptr, static_cast<double>(scene.divisions), {}});
    for (const int n : kDivisions)
      if (n != scene.divisions) axes.back().others.push_back(n);
  }
  const PictureFacts facts = factsOf(picture);
  for (const Setting& setting : settingRows()) {
    if (!mayBeAnAxis(setting, picture) || (reach == Reach::Alone && !hasEffect(setting, facts))) continue;
    Axis axis{&setting, std::get<double>(setting.field.get(picture.settings())), valuesOf(setting)};
    std::erase(axis.others, axis.now);
    if (!axis.others.empty()) axes.push_back(std::move(axis));
  }
  return axes;
}

std::vector<std::string> choosableAxes(const Picture& picture) {
  std::vector<std::string> names;
  for (const Axis& axis : axesOf(picture, Reach::BesideOthers))
    if (axis.name() != "colors") names.emplace_back(axis.name());
  return names;
}

bool allHaveEffect(const Configuration& configuration, const Picture& asked) {
  const PictureFacts facts = factsOf(asked, configuration.settings);
  return std::ranges::all_of(configuration.changes, [&](const Change& change) {
    return !change.setting || hasEffect(*change.setting, facts);
  });
}

Configuration changed(Configuration configuration, const Axis& axis, double value) {
  if (axis.setting)
    (void)applyOverrides(configuration.settings, {{axis.setting, value}});
  else
    configuration.divisions = static_cast<int>(value);
  configuration.changes.push_back({axis.setting, value});
  return configuration;
}

CameraSettings heldCamera(const Picture& picture) {
  CameraSettings held = picture.settings().camera;
  if (held.window || held.vpn || held.prp) return held;  // it says all itself
  const CameraSettings placed = saidOf(picture.camera(), picture.scene());
  held.vrp = held.vup = std::nullopt;
  held.eye = placed.eye, held.lookAt = placed.lookAt, held.up = placed.up;
  held.parallel = placed.parallel;
  if (held.parallel) held.height = placed.height;
  return held;
}

}  // namespace xnewell
