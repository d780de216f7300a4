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

/// The number that `text` spells; nothing if it has any other character.
inline std::optional<double> typedNumber(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && at == end && !text.empty() ? std::optional{value} : std::nullopt;
}

}  // namespace xnewell
