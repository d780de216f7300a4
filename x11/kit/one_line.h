#pragma once

#include <algorithm>
#include <string>

namespace xnewell {

/// Turns a text into one line of bounded length, whatever names and words it quotes. Control characters
/// become '?'. A text of more than 800 bytes keeps its first 600 and its last 200.
[[nodiscard]] inline std::string oneLine(std::string text) {
  constexpr std::size_t kBegin = 600, kEnd = 200;
  if (text.size() > kBegin + kEnd) text.replace(kBegin, text.size() - kBegin - kEnd, "...");
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < ' ' || c == 0x7F; }, '?');
  return text;
}

}  // namespace xnewell
