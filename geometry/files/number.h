#pragma once

#include <array>
#include <string>
#include <string_view>

#include "geometry/files/text_file.h"

namespace xnewell {

/// The number that a word stands for: the double nearest to its decimal value, subnormals included. A value
/// nearer to 0 than to any other double is read as 0. The word is decimal, with an optional sign, point and
/// exponent: `-1.25`, `+2`, `1.`, `.5`, `1e3`. The locale has no effect.
/// Throws ParseError with the current line of `words` for anything else, for overflow, and, unless anything
/// `mayBe`, for NaN and infinity: some writers leave them in normals.
[[nodiscard]] double toNumber(const Words& words, std::string_view word, bool mayBe = false);

/// The number of decimals in the text of a well-formed number, trailing zeros included: 3 in `-1.250`, 4 in
/// `1.5e-3`, 1 in `1.25e1`, -3 in `1e3` but 0 in `1000`. The result is clamped to +-kMaxDecimals.
[[nodiscard]] int decimals(std::string_view number);
inline constexpr int kMaxDecimals = 400;  ///< 10^400 is infinite as a double, and its inverse is 0

/// Estimates from their texts how finely the numbers of a file are rounded: half a unit of the last decimal.
/// A writer may drop trailing zeros, so the most decimals count. But if one or two numbers have all the
/// digits of a double and the others have six, the others are not exact. So a tenth of the numbers may have
/// more decimals than the result says. Zeros tell nothing. A plain integer tells only that the unit's digit
/// is given. A program that prints 17 digits writes 0.1 as 0.10000000000000001, and 0.1 + 0.2 as
/// 0.30000000000000004. So the shortest number that is the same double counts, or one that ends three digits
/// before it, if that is a double next to it.
class RoundingOfNumbers {
 public:
  void add(std::string_view number, double value);
  [[nodiscard]] double rounding() const;
  /// A sentence if the numbers are written with more decimals than they hold; otherwise "". They are taken at
  /// their word, so faces that were made in one plane may count as two. It is seen in two cases, if there
  /// are at least 24 numbers: all are numbers of single precision; or all end in three zeros after at least
  /// three decimals. Of other numbers, such as results of arithmetic that loses digits, nothing can be seen.
  [[nodiscard]] std::string doubtful() const;

 private:
  std::array<int, 2 * kMaxDecimals + 1> count_{};
  int all_ = 0;
  int single_ = 0;            ///< numbers of single precision
  int finer_ = 0;             ///< numbers with more decimals than single precision holds at their size
  int used_ = -kMaxDecimals;  ///< the most decimals up to the last digit that is not 0
  bool integers_ = false;
};

}  // namespace xnewell
