#pragma once

#include <string_view>

#include "geometry/text_file.h"

/// The number a word stands for, correctly rounded: the double nearest to its decimal value, subnormals
/// included; what is nearer to 0 than to any other double is read as 0. Decimal with an optional sign, point
/// and exponent: `-1.25`, `+2`, `1.`, `.5`, `1e3`; independent of the locale.
/// Throws ParseError at the words' line for anything else, for NaN and infinity, and for overflow.
[[nodiscard]] double toNumber(const Words& words, std::string_view word);

/// Decimals a well-formed number carries in its text, trailing zeros included: 3 in `-1.250`, 4 in `1.5e-3`,
/// 1 in `1.25e1`. Never below 0, so 0 in `1e3` as in `1000`, and never above kMaxDecimals.
[[nodiscard]] int decimals(std::string_view number);
inline constexpr int kMaxDecimals = 400;  ///< 10^400 is infinite as a double, and its inverse 0
