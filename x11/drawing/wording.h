#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// Words and numbers for people.

inline constexpr std::string_view kNothingShows = "Nothing of the scene is in the picture.";

/// Breaks a text in UTF-8 into lines of at most `most` characters, at spaces where it can.
[[nodiscard]] std::vector<std::string> broken(std::string_view text, int most);

/// A number with a fixed number of decimals, so that columns align: 0.0042. -0.0 becomes 0.0.
[[nodiscard]] std::string fixed(double value, int decimals);
/// A number with this many decimals, or with fewer where it would be longer than `most` characters; in powers
/// of ten if even that does not fit, and "-" if it is not finite.
[[nodiscard]] std::string fitted(double value, int decimals, int most);
/// A number with so many significant digits, or fewer if they are enough: 1.25e-300. 17 tell every number.
[[nodiscard]] std::string significant(double value, int digits);
/// Milliseconds: with two decimals, and below 1 with three significant digits: 12.34, 0.0123.
[[nodiscard]] std::string msText(double ms);
/// 12,345.
[[nodiscard]] std::string grouped(std::int64_t value);
/// The size of a picture: `376 x 256`.
[[nodiscard]] std::string sizeText(int width, int height);
/// `1 cut`, `1,234 cuts`, `no cuts`.
[[nodiscard]] std::string counted(std::int64_t n, std::string_view what);

}  // namespace xnewell
