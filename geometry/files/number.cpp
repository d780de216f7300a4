#include "geometry/files/number.h"

#include <algorithm>
#include <charconv>
#include <cmath>

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

/// True if a well-formed number other than 0 is at least 1 in magnitude. std::from_chars reports "out of
/// range" for both too large and too small numbers and leaves the value unchanged (LWG 3081). This function
/// tells them apart.
bool isAtLeastOne(std::string_view number) {
  long long power = -1;  // power of ten of the first digit that is not 0
  bool fraction = false, leading = true;
  for (std::size_t i = 0; i < number.size(); ++i) {
    const char c = number[i];
    if (c == 'e' || c == 'E') return power + toExponent(number.substr(i + 1)) >= 0;
    if (c == '.') {
      fraction = true;
    } else if (c != '-') {
      leading = leading && c == '0';
      if (!fraction && !leading) ++power;
      if (fraction && leading) --power;
    }
  }
  return power >= 0;
}

}  // namespace

double toNumber(const Words& words, std::string_view word) {
  const std::string_view number = withoutPlus(word);
  const char* const end = number.data() + number.size();
  double value = 0.0;
  const auto [stop, error] = std::from_chars(number.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) words.fail("malformed number " + inQuotes(word));
  if (error == std::errc::result_out_of_range) {
    if (isAtLeastOne(number)) words.fail("number " + inQuotes(word) + " is too large");
    return number.starts_with('-') ? -0.0 : 0.0;
  }
  if (!std::isfinite(value)) words.fail("number " + inQuotes(word) + " is not finite");
  return value;
}

int decimals(std::string_view number) {
  long long count = 0;
  bool fraction = false;
  for (std::size_t i = 0; i < number.size(); ++i) {
    const char c = number[i];
    if (c == 'e' || c == 'E') {
      count -= toExponent(number.substr(i + 1));
      break;
    }
    count += fraction;
    fraction |= c == '.';
  }
  return static_cast<int>(std::clamp<long long>(count, -kMaxDecimals, kMaxDecimals));
}

void RoundingOfNumbers::noteWhatItHolds(std::string_view number, double value, int decimals) {
  const double half = 0.5 * std::pow(10.0, -decimals);
  const auto single = static_cast<float>(value);
  if (std::abs(single - value) <= half) ++single_;
  if (std::ldexp(std::abs(value), -53) >= 32.0 * 2.0 * half) ++beyond_;
  if (std::isfinite(single) && std::ldexp(std::abs(value), -26) > half) ++finer_;
  const std::string_view mantissa = number.substr(0, number.find_first_of("eE"));
  const std::size_t last = mantissa.find_last_not_of('0');
  used_ = std::max(used_, decimals - static_cast<int>(mantissa.size() - 1 - last));
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
  else if (10LL * beyond_ >= 9LL * all_)
    holds = "are so large that doubles do not hold them";
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
  return d < 0 ? 0.5 * power(10.0, -d) : 0.5 / power(10.0, d);
}

}  // namespace xnewell
