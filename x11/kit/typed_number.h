#pragma once

#include <charconv>
#include <optional>
#include <string>

namespace xnewell {

/// The whole number that `text` spells; nothing if it has any other character.
inline std::optional<int> wholeNumber(const std::string& text) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && at == end && !text.empty() ? std::optional{value} : std::nullopt;
}

/// The number that `text` spells, perhaps with a plus and with blanks around it; nothing if it has any other
/// character.
inline std::optional<double> typedNumber(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  text.erase(0, text.find_first_not_of(' '));
  if (text.starts_with('+') && !text.starts_with("+-")) text.erase(0, 1);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && at == end && !text.empty() ? std::optional{value} : std::nullopt;
}

}  // namespace xnewell
