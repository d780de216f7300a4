#pragma once

#include <random>
#include <string>

namespace xnewell {

/// A whole number from 0 to n - 1.
[[nodiscard]] inline int below(int n, std::mt19937& rng) {
  return static_cast<int>(rng() % static_cast<unsigned>(n));
}

/// The text with a few of its numbers changed: to very large and very small ones, zeros, the negative, what
/// is no number, integers at the end of their range, and almost the same as itself or as another number of
/// the text. Sometimes a line is there twice.
[[nodiscard]] std::string withChangedNumbers(const std::string& text, std::mt19937& rng);

/// A number as above, by itself.
[[nodiscard]] std::string oddNumber(std::mt19937& rng);

}  // namespace xnewell
