#pragma once

#include <string>

#include "geometry/files/visible.h"

namespace xnewell {

/// Turns a text into one line of bounded length, whatever names and words it quotes: a text of more than 800
/// bytes keeps its first 600 and its last 200, and all is visible.
[[nodiscard]] inline std::string oneLine(std::string text) {
  constexpr std::size_t kBegin = 600, kEnd = 200;
  if (text.size() > kBegin + kEnd) text.replace(kBegin, text.size() - kBegin - kEnd, "...");
  return visible(text);
}

}  // namespace xnewell
