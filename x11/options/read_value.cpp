#include "x11/options/read_value.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include "geometry/files/text_file.h"
#include "x11/options/options.h"

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

}  // namespace xnewell
