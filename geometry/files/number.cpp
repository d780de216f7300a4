#include "geometry/files/number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "geometry/exact/power.h"

namespace xnewell {

namespace {

/// Removes a leading '+', which std::from_chars does not accept. It keeps the '+' of "+-", so that a second
/// sign is an error.
std::string_view withoutPlus(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  return word;
}

/// The value of an exponent's digits, clamped to +-10^18. No text has enough digits to make up for such an
/// exponent.
long long toExponent(std::string_view digits) {
  constexpr long long kFar = 1'000'000'000'000'000'000;
  digits = withoutPlus(digits);
  long long exponent = 0;
  const std::errc error = std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec;
  if (error == std::errc::result_out_of_range) return digits.starts_with('-') ? -kFar : kFar;
  return std::clamp(exponent, -kFar, kFar);
}

/// What the text of a well-formed number says besides its value.
struct Spelling {
  long long decimals = 0;  ///< trailing zeros included; not clamped
  int zeros = 0;           ///< at the end of the mantissa
  int digits = 0;          ///< of the mantissa, from the first that is not 0
  bool integer = true;     ///< there is no point and no exponent
};
Spelling spellingOf(std::string_view number) {
  std::size_t end = 0, point = number.npos, first = 0;  // the first digit that is not 0
  for (; end < number.size() && number[end] != 'e' && number[end] != 'E'; ++end)
    if (number[end] == '.') point = end;
  while (first < end && number[first] <= '0') ++first;
  Spelling s;
  while (s.zeros < static_cast<int>(end) && number[end - 1 - s.zeros] == '0') ++s.zeros;
  s.digits = static_cast<int>(end - first) - (first < end && point != number.npos && point > first);
  s.integer = point == number.npos && end == number.size();
  if (point != number.npos) s.decimals = static_cast<long long>(end - point) - 1;
  if (end < number.size()) s.decimals -= toExponent(number.substr(end + 1));
  return s;
}

int clampedDecimals(const Spelling& s) {
  return static_cast<int>(std::clamp<long long>(s.decimals, -kMaxDecimals, kMaxDecimals));
}

/// Half a unit of the last decimal: 5 10^-(d + 1) for d decimals.
double halfUnit(int d) {
  static const std::array<double, 2 * kMaxDecimals + 1> kHalfUnits = [] {
    std::array<double, 2 * kMaxDecimals + 1> units{};
    for (int k = -kMaxDecimals; k <= kMaxDecimals; ++k)
      units[kMaxDecimals + k] = k < 0 ? 0.5 * power(10.0, -k) : 0.5 / power(10.0, k);
    return units;
  }();
  return kHalfUnits[kMaxDecimals + d];
}

/// As RoundingOfNumbers reads it.
Spelling meant(std::string_view number, double value) {
  constexpr int kDigits = std::numeric_limits<double>::digits10, kZeros = 3;
  Spelling spelling = spellingOf(number);
  if (spelling.digits <= kDigits || spelling.zeros > 0) return spelling;
  std::array<char, 32> text;
  spelling = spellingOf({text.data(), std::to_chars(text.begin(), text.end(), value).ptr});
  const char* const end =
      std::to_chars(text.begin(), text.end(), value, std::chars_format::general, kDigits).ptr;
  double rounded = 0.0;
  std::from_chars(text.begin(), end, rounded);
  const Spelling fewer = spellingOf({text.data(), end});
  const bool isNear = std::abs(rounded - value) <= std::numeric_limits<double>::epsilon() * std::abs(value);
  return isNear && fewer.decimals + kZeros <= spelling.decimals ? fewer : spelling;
}

}  // namespace

double toNumber(const Words& words, std::string_view word, bool mayBe) {
  if (mayBe && word.find('#') != word.npos) return NAN;  // -1.#IND of an old writer
  const std::string_view number = withoutPlus(word);
  const char* const end = number.data() + number.size();
  double value = 0.0;
  const auto [stop, error] = std::from_chars(number.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) words.fail("malformed number " + inQuotes(word));
  if (error == std::errc::result_out_of_range) {
    // It is so for both too large and too small numbers, and the value is unchanged (LWG 3081).
    const Spelling spelling = spellingOf(number);
    if (spelling.digits > spelling.decimals) words.fail("number " + inQuotes(word) + " is too large");
    return number.starts_with('-') ? -0.0 : 0.0;
  }
  if (!mayBe && !std::isfinite(value)) words.fail("number " + inQuotes(word) + " is not finite");
  return value;
}

int decimals(std::string_view number) { return clampedDecimals(spellingOf(number)); }

void RoundingOfNumbers::add(std::string_view number, double value) {
  if (value == 0.0) return;
  const Spelling spelling = meant(number, value);
  if (spelling.integer) {
    integers_ = true;
    return;
  }
  const int d = clampedDecimals(spelling);
  ++count_[kMaxDecimals + d];
  ++all_;
  const double half = halfUnit(d), size = std::abs(value);
  const auto single = static_cast<float>(value);
  if (std::abs(single - value) <= half) ++single_;
  if (std::isfinite(single) && size * 0x1p-26 > half) ++finer_;
  used_ = std::max(used_, d - spelling.zeros);
}

std::string RoundingOfNumbers::doubtful() const {
  constexpr int kFewest = 24, kZeros = 3;
  if (all_ < kFewest) return "";
  const double written = -std::log10(2.0 * rounding());
  std::string holds;
  if (single_ == all_ && 10LL * finer_ >= 9LL * all_)
    holds = "are numbers of single precision";
  else if (used_ >= kZeros && written >= used_ + kZeros - 0.5)
    holds = "have no more than " + std::to_string(used_) + " that are not 0";
  if (holds.empty()) return "";
  return "the coordinates are written with " + std::to_string(std::lround(written)) + " decimals but " +
         holds + ": written with fewer, faces that were made in one plane would count as one plane";
}

double RoundingOfNumbers::rounding() const {
  int d = 0;
  if (all_ > 0) {
    d = -kMaxDecimals;
    for (int fit = count_[0]; 10LL * fit < 9LL * all_; fit += count_[kMaxDecimals + d]) ++d;
  }
  if (integers_) d = std::max(d, 0);
  return halfUnit(d);
}

}  // namespace xnewell
