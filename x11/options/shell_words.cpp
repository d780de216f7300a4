#include "x11/options/shell_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "x11/options/options.h"

namespace xnewell {

std::string quoted(const std::string& word) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view{"-_./,:=+"}.find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, plain)) return word;
  const bool control = visible(word) != word;
  std::string text;
  for (const char c : word)
    if (control && (c == '\'' || c == '\\'))
      text += std::string{'\\', c};
    else
      text += c == '\'' ? std::string{"'\\''"} : std::string{c};
  return (control ? "$'" : "'") + visible(text) + '\'';
}

std::optional<std::vector<std::string>> wordsOf(std::string_view command) {
  std::vector<std::string> words;
  enum class Quoting { No, Plain, Escapes } quoting = Quoting::No;
  bool inWord = false;
  for (std::size_t k = 0; k < command.size(); ++k) {
    char c = command[k];
    if (c == ' ' && quoting == Quoting::No) {
      inWord = false;
      continue;
    }
    if (!std::exchange(inWord, true)) words.emplace_back();
    if (quoting == Quoting::No && command.substr(k).starts_with("$'")) {
      quoting = Quoting::Escapes;
      ++k;
      continue;
    }
    if (c == '\'') {
      quoting = quoting == Quoting::No ? Quoting::Plain : Quoting::No;
      continue;
    }
    if (c == '\\' && quoting != Quoting::Plain) {
      if (++k == command.size()) return std::nullopt;
      c = command[k];
      if (quoting == Quoting::Escapes && (c == 'n' || c == 't')) c = c == 'n' ? '\n' : '\t';
      if (quoting == Quoting::Escapes && c == 'x') {
        unsigned byte = 0;
        const std::string_view digits = command.substr(k + 1, 2);
        const char* const end = digits.data() + digits.size();
        if (std::from_chars(digits.data(), end, byte, 16).ptr != end || byte == 0) return std::nullopt;
        c = static_cast<char>(byte);
        k += 2;
      }
    }
    words.back() += c;
  }
  if (quoting != Quoting::No) return std::nullopt;
  return words;
}

namespace {

bool isCommand(const std::string& word) {
  return std::ranges::find(kCommands, word, &CommandRow::name) != kCommands.end();
}

std::string decoded(std::string_view text) {
  std::string word;
  for (std::size_t k = 0; k < text.size(); ++k) {
    unsigned char byte = 0;
    const char* const digits = text.data() + k + 1;
    const bool escaped = text[k] == '%' && k + 2 < text.size() &&
                         std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    word += escaped ? static_cast<char>(byte) : text[k];
    if (escaped) k += 2;
  }
  return word;
}

std::string encoded(std::string_view word) {
  constexpr std::string_view kDigits = "0123456789ABCDEF", kPlain = "-_.,:/+";
  std::string text;
  for (const unsigned char c : word)
    if (std::isalnum(c) != 0 || kPlain.find(static_cast<char>(c)) != kPlain.npos)
      text += static_cast<char>(c);
    else
      text += {'%', kDigits[c / 16], kDigits[c % 16]};
  return text;
}

}  // namespace

std::vector<std::string> argumentsOf(std::string_view address) {
  std::vector<std::string> arguments;
  bool named = false;  // the scene or the lesson
  while (!address.empty()) {
    const std::string_view part = address.substr(0, address.find('&'));
    address.remove_prefix(std::min(address.size(), part.size() + 1));
    if (part.empty()) continue;
    const std::string word = decoded(part);
    const bool command = arguments.empty() && isCommand(word);
    const bool option = named || part.find('=') != part.npos;
    named = named || !command;
    arguments.push_back(option ? "--" + word : word);
  }
  return arguments;
}

std::string addressOf(std::string_view command) {
  constexpr std::array<std::string_view, 4> kOfThePicture{"-o", "--size", "--scale", "--whole-window"};
  const std::optional<std::vector<std::string>> words = wordsOf(command);
  if (!words || words->size() < 2) return "";
  const bool atPixel =
      std::ranges::find(*words, "--pixel") != words->end();  // it is one of a window of that size
  std::string address;
  for (std::size_t k = 1; k < words->size(); ++k) {
    const std::string& word = (*words)[k];
    const bool option = word.starts_with('-'), command1 = k == 1 && isCommand(word);
    const bool takes = option && word.find('=') == word.npos && k + 1 < words->size() &&
                       !(*words)[k + 1].starts_with("--") && (*words)[k + 1] != "-o";
    const bool left = std::ranges::find(kOfThePicture, word) != kOfThePicture.end() &&
                      !(atPixel && (word == "--size" || word == "--scale"));
    if (!left && !(command1 && word != "lesson" && word != "lecture")) {
      address += address.empty() ? "" : "&";
      const std::size_t equals = std::min(option ? word.find('=') : word.npos, word.size());
      address += encoded(word.substr(option ? 2 : 0, equals - (option ? 2 : 0)));
      if (equals < word.size()) address += '=' + encoded(word.substr(equals + 1));
      if (takes) address += '=' + encoded((*words)[k + 1]);
    }
    if (takes) ++k;
  }
  return address;
}

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
