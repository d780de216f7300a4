#include "x11/options/read_value.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include "geometry/files/text_file.h"
#include "x11/options/options.h"
#include "x11/options/window_place.h"

namespace xnewell {

void refuse(const std::string& option, const std::string& text, const std::string& expected) {
  throw UsageError{option + ": " + inQuotes(text) + " is not " + expected};
}

std::vector<double> numbers(const std::string& option, const std::string& text, std::size_t count,
                            const std::string& expected) {
  std::vector<double> values;
  const char* p = text.data();
  const char* const end = p + text.size();
  for (;;) {
    double v = 0;
    if (p != end && *p == '+') ++p;
    const auto [next, error] = std::from_chars(p, end, v);
    if (error != std::errc{} || !std::isfinite(v)) refuse(option, text, expected);
    values.push_back(v);
    if (next == end) break;
    if (*next != ',') refuse(option, text, expected);
    p = next + 1;
  }
  if (values.size() != count) refuse(option, text, expected);
  return values;
}

Value valueOf(const Setting& setting, const std::string& text) {
  const std::string option{setting.option}, needed = expected(setting);
  Value value;
  if (setting.field.kind == ValueKind::Choice) {
    const std::optional<int> choice = choiceNamed(setting, text);
    if (!choice) refuse(option, text, needed);
    return static_cast<double>(*choice);
  }
  if (setting.field.kind == ValueKind::Flag) {
    if (text != "true" && text != "false") refuse(option, text, "true or false");
    return text == "true" ? 1.0 : 0.0;
  }
  if (setting.field.kind == ValueKind::Triple) {
    const std::vector<double> v = numbers(option, text, 3, needed);
    value = glm::dvec3{v[0], v[1], v[2]};
  } else {
    value = numbers(option, text, 1, needed)[0];
  }
  if (!allows(setting, value)) refuse(option, text, needed);
  return value;
}

glm::ivec2 pixelOf(const std::string& option, const std::string& text) {
  const std::string expected = "a pixel X,Y: two whole numbers from 0, counted from the top left";
  if (text.find_first_not_of("0123456789,") != std::string::npos) refuse(option, text, expected);
  const std::vector<double> v = numbers(option, text, 2, expected);
  for (const double x : v)
    if (x < 0 || x >= kMaxPicture || x != std::floor(x)) refuse(option, text, expected);
  return {static_cast<int>(v[0]), static_cast<int>(v[1])};
}

std::vector<std::string> commaWords(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream in{text};
  for (std::string word; std::getline(in, word, ',');) all.push_back(word);
  return all;
}

namespace {

constexpr std::string_view kSame = "same";

/// A setting may stay open where one of another kind takes its place. It is then written without a value.
Value besideValueOf(const Setting& setting, const std::string& text) {
  const Value initially = setting.field.get(PictureSettings{});
  if (text.empty() && std::holds_alternative<std::monostate>(initially)) return {};
  return valueOf(setting, text);
}

}  // namespace

std::string besideText(const std::vector<Override>& own) {
  std::string text;
  for (const Override& o : own)
    text += (text.empty() ? "" : " ") + std::string{o.setting->option.substr(2)} + '=' +
            textOf(*o.setting, o.value);
  return text.empty() ? std::string{kSame} : text;
}

std::vector<Override> besideOf(const std::string& text) {
  std::vector<Override> own;
  if (text == kSame) return own;
  std::istringstream words{text};
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const Setting* const setting = settingOf("--" + word.substr(0, equals));
    if (setting == nullptr || equals == std::string::npos || setting->key == "fill")
      refuse("--beside", word, "a setting with its value, such as order=none, or the word same");
    own.push_back({setting, besideValueOf(*setting, word.substr(equals + 1))});
  }
  if (own.empty())
    refuse("--beside", text, "settings with their values, such as order=none, or the word same");
  return own;
}

std::vector<std::pair<std::string, std::string>> optionsOf(const WindowPlace& at) {
  std::vector<std::pair<std::string, std::string>> options;
  if (at.step > 0 && at.run.empty()) options.emplace_back("--step", std::to_string(at.step));
  if (at.scanline) options.emplace_back("--scanline", std::to_string(*at.scanline));
  if (at.polygon) options.emplace_back("--scanline", *at.polygon);
  if (at.cell) options.emplace_back("--cell", std::to_string(*at.cell));
  if (at.pixel)
    options.emplace_back("--pixel", std::to_string(at.pixel->x) + ',' + std::to_string(at.pixel->y));
  if (at.vertex) options.emplace_back("--viewing", *at.vertex);
  if (at.controls) options.emplace_back("--controls", at.controls->empty() ? "none" : *at.controls);
  if (at.beside) options.emplace_back("--beside", besideText(*at.beside));
  if (at.difference != Unlike::Face) options.emplace_back("--difference", rowOf(at.difference).name);
  return options;
}

}  // namespace xnewell
