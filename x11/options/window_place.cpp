#include "x11/options/window_place.h"

#include <sstream>

#include "x11/options/read_value.h"

namespace xnewell {

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
