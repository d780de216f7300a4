#pragma once

#include <array>
#include <string_view>

#include "geometry/files/text_file.h"

namespace xnewell {

/// The number a word stands for, correctly rounded: the double nearest to its decimal value, subnormals
/// included; what is nearer to 0 than to any other double is read as 0. Decimal with an optional sign, point
/// and exponent: `-1.25`, `+2`, `1.`, `.5`, `1e3`; independent of the locale.
/// Throws ParseError at the words' line for anything else, for NaN and infinity, and for overflow.
[[nodiscard]] double toNumber(const Words& words, std::string_view word);

/// Decimals a well-formed number carries in its text, trailing zeros included: 3 in `-1.250`, 4 in `1.5e-3`,
/// 1 in `1.25e1`, -3 in `1e3` but 0 in `1000`. Within kMaxDecimals of 0.
[[nodiscard]] int decimals(std::string_view number);
inline constexpr int kMaxDecimals = 400;  ///< 10^400 is infinite as a double, and its inverse 0

/// How finely the numbers of a file are rounded, told from their texts: half a unit of the last decimal that
/// they carry. A writer may drop trailing zeros, so the most decimals tell; but a number or two with all the
/// digits of a double among others of six does not make those exact. So a tenth of the numbers may
/// carry more. Zeros tell nothing, and a plain integer that its units count.
class RoundingOfNumbers {
 public:
  void add(std::string_view number, double value) {
    if (value == 0.0) return;
    if (number.find_first_of(".eE") == std::string_view::npos) {
      integers_ = true;
      return;
    }
    ++count_[kMaxDecimals + decimals(number)];
    ++all_;
  }
  [[nodiscard]] double rounding() const;

 private:
  std::array<int, 2 * kMaxDecimals + 1> count_{};
  int all_ = 0;
  bool integers_ = false;
};

}  // namespace xnewell
