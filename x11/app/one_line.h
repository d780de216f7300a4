#pragma once

#include <algorithm>
#include <string>

namespace xnewell {

/// One line of bounded length, whatever names and words it quotes: control characters become '?', and a
/// very long text keeps its two ends.
[[nodiscard]] inline std::string oneLine(std::string text) {
  constexpr std::size_t kBegin = 600, kEnd = 200;
  if (text.size() > kBegin + kEnd) text.replace(kBegin, text.size() - kBegin - kEnd, "...");
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < ' ' || c == 0x7F; }, '?');
  return text;
}

}  // namespace xnewell
