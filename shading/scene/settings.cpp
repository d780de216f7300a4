#include "shading/scene/settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace xnewell {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool within(const ValueRange& range, double v) {
  return std::isfinite(v) &&
         (range.open ? v > range.low && v < range.high : v >= range.low && v <= range.high);
}

/// " from 0 to 1", " between 0 and 1", " above 0", " of at least 0".
std::string wordsOf(const ValueRange& range) {
  if (range.low == -kInfinity) return "";
  const std::string low = textOf(range.low), high = textOf(range.high);
  if (range.high == kInfinity) return (range.open ? " above " : " of at least ") + low;
  return range.open ? " between " + low + " and " + high : " from " + low + " to " + high;
}

/// A number with as many decimals as it needs, up to six.
std::string wordsOf(double v) {
  std::array<char, 400> text;
  for (int decimals = 0;; ++decimals) {
    const auto [end, error] = std::to_chars(text.begin(), text.end(), v, std::chars_format::fixed, decimals);
    double back = 0;
    std::from_chars(text.begin(), end, back);
    if (back == v || decimals == 6) return {text.begin(), end};
  }
}

std::string wordsOf(const Setting& setting, const Value& value) {
  if (const auto* v = std::get_if<glm::dvec3>(&value))
    return wordsOf(v->x) + ", " + wordsOf(v->y) + ", " + wordsOf(v->z);
  const auto* v = std::get_if<double>(&value);
  if (!v) return std::string{setting.initially};
  return setting.field.kind == ValueKind::Choice ? textOf(setting, value) : wordsOf(*v);
}

/// The words for a value that say it without the setting's name; "" if there are none.
std::string_view ownWords(const Setting& setting, const Value& value) {
  const auto* v = std::get_if<double>(&value);
  if (!v) return "";
  if (setting.field.kind == ValueKind::Flag) return setting.words.of(*v != 0.0);
  if (setting.field.kind == ValueKind::Choice)
    return setting.field.choices[static_cast<std::size_t>(*v)].words;
  return "";
}

}  // namespace

const Setting* settingOf(std::string_view option) {
  const auto row = std::ranges::find_if(
      settingRows(), [&](const Setting& s) { return s.option == option || s.alias == option; });
  return row == settingRows().end() ? nullptr : &*row;
}

const Setting* settingOf(char control) {
  const auto row = std::ranges::find(settingRows(), control, &Setting::control);
  return control == 0 || row == settingRows().end() ? nullptr : &*row;
}

PictureFacts factsOf(const PictureSettings& settings) {
  return {.settings = settings,
          .plan = settings.colors == ColorPlan::Needed ? ColorPlan::OneHue : settings.colors,
          .highlights = settings.light.ks > 0.0,
          .patches = false,
          .normals = false,
          .textures = false};
}

bool allows(const Setting& setting, const Value& value) {
  if (const auto* v = std::get_if<glm::dvec3>(&value)) {
    const bool inside =
        within(setting.range, v->x) && within(setting.range, v->y) && within(setting.range, v->z);
    return setting.field.kind == ValueKind::Triple && inside && (!setting.allowed || setting.allowed(*v));
  }
  const auto* v = std::get_if<double>(&value);
  if (!v || setting.field.kind == ValueKind::Triple) return false;
  if (setting.field.kind != ValueKind::Number && *v != std::floor(*v)) return false;
  if (setting.field.kind == ValueKind::Choice)
    return *v >= 0.0 && *v < static_cast<double>(setting.field.choices.size());
  return within(setting.range, *v);
}

std::string expected(const Setting& setting) {
  switch (setting.field.kind) {
    case ValueKind::Number:
      return "a number" + wordsOf(setting.range);
    case ValueKind::Whole:
      return "a whole number" + wordsOf(setting.range);
    case ValueKind::Flag:
      return "true or false";
    case ValueKind::Choice: {
      std::string all;
      for (const Choice& choice : setting.field.choices)
        all += (all.empty() ? "one of " : ", ") + std::string{choice.name};
      return all;
    }
    case ValueKind::Triple:
      return "three finite numbers " + std::string{setting.letters} + wordsOf(setting.range) +
             (setting.allowed ? ", " + std::string{setting.allowedAre} : "");
  }
  return "";
}

std::optional<int> choiceNamed(const Setting& setting, std::string_view name) {
  const std::vector<Choice>& choices = setting.field.choices;
  const auto choice = std::ranges::find(choices, name, &Choice::name);
  if (choice == choices.end()) return std::nullopt;
  return static_cast<int>(choice - choices.begin());
}

std::string textOf(double v) {
  std::array<char, 32> text;
  const bool plain = v == 0.0 || (std::abs(v) >= 1e-4 && std::abs(v) <= 1e9);
  const auto [end, error] = std::to_chars(text.begin(), text.end(), v,
                                          plain ? std::chars_format::fixed : std::chars_format::general);
  return {text.begin(), end};
}

std::string textOf(const Setting& setting, const Value& value) {
  if (const auto* v = std::get_if<glm::dvec3>(&value))
    return textOf(v->x) + "," + textOf(v->y) + "," + textOf(v->z);
  const auto* v = std::get_if<double>(&value);
  if (!v) return "";
  if (setting.field.kind == ValueKind::Choice)
    return std::string{setting.field.choices[static_cast<std::size_t>(*v)].name};
  if (setting.field.kind == ValueKind::Flag) return *v != 0.0 ? "true" : "false";
  return textOf(*v);
}

std::string phraseOf(const Setting& setting, const PictureSettings& settings) {
  const Value now = setting.field.get(settings);
  if (const std::string_view own = ownWords(setting, now); !own.empty()) return std::string{own};
  const std::string value = wordsOf(setting, now);
  if (const std::size_t at = setting.phrase.find("{}"); at != std::string_view::npos)
    return std::string{setting.phrase}.replace(at, 2, value);
  return std::string{setting.label} + ' ' + value +
         (setting.unit.empty() ? "" : ' ' + std::string{setting.unit});
}

PictureSettings withoutShortCuts(PictureSettings settings) {
  for (const Setting& setting : settingRows()) {
    if (!setting.role.isShortCut()) continue;
    const auto* choice = std::get_if<std::string_view>(&setting.role.exact());
    setting.field.set(settings, choice ? static_cast<double>(choiceNamed(setting, *choice).value())
                                       : std::get<double>(setting.role.exact()));
  }
  return settings;
}

bool hasEffect(const Setting& setting, const PictureFacts& facts) {
  return !setting.need.met || setting.need.met(facts);
}

std::string noEffect(std::string_view name, const Setting& setting, std::string_view where) {
  return std::string{name} + " has no effect " + std::string{where} + "; it applies to " +
         std::string{setting.need.appliesTo};
}

bool keepWithinOne(Illumination& light, bool IaSet, bool IpSet) {
  if (light.Ia + light.Ip <= 1.0) return true;
  if (IaSet && IpSet) return false;
  const double kept = IaSet ? light.Ia : light.Ip;
  // Rounds to nine decimals. This removes the error that 1 - 0.9 has as a binary fraction. The sum must still
  // not exceed 1.
  double rest = std::floor((1.0 - kept) * 1e9 + 0.5) / 1e9;
  if (kept + rest > 1.0) rest = 1.0 - kept;
  (IaSet ? light.Ip : light.Ia) = rest;
  return true;
}

bool applyOverrides(PictureSettings& settings, const std::vector<Override>& overrides) {
  const auto has = [&](std::string_view key) {
    return std::ranges::any_of(overrides, [&](const Override& o) { return o.setting->key == key; });
  };
  for (const Override& o : overrides) o.setting->field.set(settings, o.value);
  Illumination& light = settings.light;
  if (has("light") && !has("light_at")) {
    light.lightPosition.reset();
    if (!has("attenuation")) light.attenuation.reset();
  }
  if (has("attenuation") && !has("range")) light.range.reset();
  if (has("attenuation") && !has("c")) light.c.reset();
  return keepWithinOne(light, has("Ia"), has("Ip"));
}

}  // namespace xnewell
