#include "shading/scene/read_shading.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "shading/scene/settings.h"

namespace xnewell {

namespace {

/// The two parts of a key such as "table.i0", before and after the dot. `rest` is empty if there is no dot.
struct KeyPath {
  std::string_view first, rest;
};
KeyPath pathOf(std::string_view key) {
  const std::size_t dot = key.find('.');
  if (dot == std::string_view::npos) return {key, {}};
  return {key.substr(0, dot), key.substr(dot + 1)};
}

/// The value that `node` gives for a setting; nothing if it gives none.
std::optional<Node> findIn(const Node& node, const Setting& setting) {
  const KeyPath path = pathOf(setting.key);
  if (!node.has(path.first)) return std::nullopt;
  const Node found = node.at(path.first);
  if (path.rest.empty()) return found;
  return found.has(path.rest) ? std::optional{found.at(path.rest)} : std::nullopt;
}

/// Refuses all keys that are not keys of settings. @throws ParseError
void expectSettings(const Node& node) {
  std::vector<std::string_view> firsts;
  for (const Setting& setting : settingRows()) {
    const std::string_view first = pathOf(setting.key).first;
    if (std::ranges::find(firsts, first) == firsts.end()) firsts.push_back(first);
  }
  node.expectKeys(firsts);
  for (const std::string_view first : firsts) {
    std::vector<std::string_view> rests;
    for (const Setting& setting : settingRows())
      if (const KeyPath path = pathOf(setting.key); path.first == first && !path.rest.empty())
        rests.push_back(path.rest);
    if (!rests.empty() && node.has(first)) node.at(first).expectKeys(rests);
  }
}

Value valueOf(const Setting& setting, const Node& node) {
  switch (setting.field.kind) {
    case ValueKind::Number:
      return node.number();
    case ValueKind::Whole:
      return static_cast<double>(
          node.whole(static_cast<int>(setting.range.low), static_cast<int>(setting.range.high)));
    case ValueKind::Flag:
      return node.truth() ? 1.0 : 0.0;
    case ValueKind::Choice: {
      const std::string name = node.isNumber() ? textOf(node.number()) : node.text();
      const std::optional<int> choice = choiceNamed(setting, name);
      if (!choice) node.fail(inQuotes(name) + " is not " + expected(setting));
      return static_cast<double>(*choice);
    }
    case ValueKind::Triple:
      return node.point();
  }
  return {};
}

void expectEffect(const Setting& setting, const PictureSettings& settings, const Node& node) {
  if (!hasEffect(setting, factsOf(settings)))
    node.fail("this setting applies only to " + std::string{setting.need.appliesTo});
}

}  // namespace

void readShading(PictureSettings& settings, const Node& node) {
  expectSettings(node);
  std::vector<Override> overrides;
  for (const Setting& setting : settingRows()) {
    const std::optional<Node> found = findIn(node, setting);
    if (!found) continue;
    const Value value = valueOf(setting, *found);
    if (!allows(setting, value))
      found->fail(expected(setting) + (setting.letters.empty() ? " is" : " are") + " needed");
    overrides.push_back({&setting, value});
  }
  if (!applyOverrides(settings, overrides)) node.fail("Ia + Ip must not exceed 1");
}

void expectCounts(const PictureSettings& settings, const SceneLight& scene, const Node& node) {
  for (const Setting& setting : settingRows())
    if (setting.need.unmet == Need::Unmet::Refused)
      if (const std::optional<Node> found = findIn(node, setting)) expectEffect(setting, settings, *found);
  const Illumination& light = settings.light;
  if (node.has("attenuation") && light.attenuation != Attenuation::None && !light.lightPosition &&
      !scene.placed())
    node.at("attenuation")
        .fail("attenuation needs a point light: give light_at. " + std::string{kOwnAttenuation});
}

void expectDivides(const PictureSettings& settings, const Node& node) {
  for (const Setting& setting : settingRows())
    if (setting.need.unmet == Need::Unmet::RefusedOrKept)
      if (const std::optional<Node> found = findIn(node, setting)) expectEffect(setting, settings, *found);
}

}  // namespace xnewell
