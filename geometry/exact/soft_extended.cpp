#include "geometry/exact/soft_extended.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace xnewell {

namespace {

/// A whole number below 2^128.
struct Wide {
  std::uint64_t high, low;
};

Wide product(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kHalf = 0xffffffff;
  const std::uint64_t a1 = a >> 32, a0 = a & kHalf, b1 = b >> 32, b0 = b & kHalf;
  const std::uint64_t low = a0 * b0, middle = a1 * b0 + (low >> 32), other = a0 * b1 + (middle & kHalf);
  return {a1 * b1 + (middle >> 32) + (other >> 32), other << 32 | (low & kHalf)};
}

/// n / 2^by. The lowest bit is set if any bit is lost.
Wide shiftedDown(Wide n, int by) {
  if (by == 0) return n;
  if (by >= 128) return {0, (n.high | n.low) != 0};
  if (by >= 64) {
    const bool lost = n.low != 0;
    n = shiftedDown({0, n.high}, by - 64);
    return {0, n.low | (lost ? 1U : 0U)};
  }
  const bool lost = n.low << (64 - by) != 0;
  return {n.high >> by, n.high << (64 - by) | n.low >> by | (lost ? 1U : 0U)};
}

Wide shiftedUp(const Wide& n, int by) {
  if (by == 0) return n;
  if (by >= 64) return {n.low << (by - 64), 0};
  return {n.high << by | n.low >> (64 - by), n.low << by};
}

}  // namespace

SoftExtended::SoftExtended(double v)
    : mantissa_{0}, exponent_{0}, negative_{std::signbit(v)}, kind_{Kind::Finite} {
  if (!std::isfinite(v)) {
    kind_ = std::isnan(v) ? Kind::NotANumber : Kind::Infinite;
  } else if (v != 0) {
    const double fraction = std::frexp(std::abs(v), &exponent_);  // 53 bits
    mantissa_ = static_cast<std::uint64_t>(std::ldexp(fraction, 53)) << 11;
    exponent_ -= 64;
  }
}

SoftExtended SoftExtended::special(Kind kind, bool negative) {
  SoftExtended result{};
  result.kind_ = kind, result.negative_ = negative;
  return result;
}

/// (high + low / 2^64) 2^exponent as the nearest number; high >= 2^63.
SoftExtended SoftExtended::rounded(bool negative, std::uint64_t high, std::uint64_t low, int exponent) {
  constexpr std::uint64_t kTop = std::uint64_t{1} << 63;
  SoftExtended result{};
  result.negative_ = negative, result.mantissa_ = high, result.exponent_ = exponent;
  if (low > kTop || (low == kTop && (high & 1) != 0))
    if (++result.mantissa_ == 0) result.mantissa_ = kTop, ++result.exponent_;
  return result;
}

SoftExtended::operator double() const {
  if (kind_ == Kind::NotANumber) return std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  if (kind_ == Kind::Infinite) return negative_ ? -infinity : infinity;
  // Below 2^-1022, doubles have fewer than 53 bits.
  const int kept = std::min(53, exponent_ + 64 + 1074);
  double result = 0;
  if (mantissa_ != 0 && kept >= 0) {
    const Wide parts = shiftedDown({mantissa_, 0}, 64 - kept);
    const bool up =
        parts.low > std::uint64_t{1} << 63 || (parts.low == std::uint64_t{1} << 63 && (parts.high & 1) != 0);
    result =
        std::ldexp(static_cast<double>(parts.high + (up ? 1 : 0)), std::min(exponent_, 2000) + 64 - kept);
  }
  return negative_ ? -result : result;
}

std::partial_ordering operator<=>(const SoftExtended& a, const SoftExtended& b) {
  using Kind = SoftExtended::Kind;
  if (a.kind_ == Kind::NotANumber || b.kind_ == Kind::NotANumber) return std::partial_ordering::unordered;
  const auto sign = [](const SoftExtended& n) {
    return n.kind_ == Kind::Finite && n.mantissa_ == 0 ? 0 : n.negative_ ? -1 : 1;
  };
  if (sign(a) != sign(b) || sign(a) == 0) return sign(a) <=> sign(b);
  const SoftExtended &low = sign(a) > 0 ? a : b, &high = sign(a) > 0 ? b : a;  // by magnitude
  if (low.kind_ != high.kind_)
    return low.kind_ == Kind::Finite ? std::partial_ordering::less : std::partial_ordering::greater;
  if (low.exponent_ != high.exponent_) return low.exponent_ <=> high.exponent_;
  return low.mantissa_ <=> high.mantissa_;
}

SoftExtended operator+(const SoftExtended& a, const SoftExtended& b) {
  using Kind = SoftExtended::Kind;
  if (a.kind_ != Kind::Finite || b.kind_ != Kind::Finite) {
    const bool opposite = a.kind_ == b.kind_ && a.negative_ != b.negative_;
    if (a.kind_ == Kind::NotANumber || b.kind_ == Kind::NotANumber || opposite)
      return SoftExtended::special(Kind::NotANumber, false);
    return a.kind_ == Kind::Infinite ? a : b;
  }
  if (a.mantissa_ == 0 || b.mantissa_ == 0) {
    if (a.mantissa_ != b.mantissa_) return a.mantissa_ == 0 ? b : a;
    return SoftExtended::special(Kind::Finite, a.negative_ && b.negative_);
  }
  const bool aIsLarger = a.exponent_ != b.exponent_ ? a.exponent_ > b.exponent_ : a.mantissa_ >= b.mantissa_;
  const SoftExtended &large = aIsLarger ? a : b, &small = aIsLarger ? b : a;
  // The larger one with 64 bits after the point; those of the other one that do not fit leave their mark.
  const std::int64_t apart = std::int64_t{large.exponent_} - small.exponent_;
  const Wide other = shiftedDown({small.mantissa_, 0}, static_cast<int>(std::min<std::int64_t>(apart, 128)));
  if (large.negative_ == small.negative_) {
    Wide sum{large.mantissa_ + other.high, other.low};
    int exponent = large.exponent_;
    if (sum.high < other.high) {
      sum = shiftedDown(sum, 1);
      sum.high |= std::uint64_t{1} << 63, ++exponent;
    }
    return SoftExtended::rounded(large.negative_, sum.high, sum.low, exponent);
  }
  const Wide rest{large.mantissa_ - other.high - (other.low != 0 ? 1 : 0), 0 - other.low};
  if (rest.high == 0 && rest.low == 0) return 0.0;
  const int up = rest.high != 0 ? std::countl_zero(rest.high) : 64 + std::countl_zero(rest.low);
  const Wide normal = shiftedUp(rest, up);
  return SoftExtended::rounded(large.negative_, normal.high, normal.low, large.exponent_ - up);
}

SoftExtended operator*(const SoftExtended& a, const SoftExtended& b) {
  using Kind = SoftExtended::Kind;
  const bool negative = a.negative_ != b.negative_;
  if (a.kind_ != Kind::Finite || b.kind_ != Kind::Finite) {
    const auto isZero = [](const SoftExtended& n) { return n.kind_ == Kind::Finite && n.mantissa_ == 0; };
    const bool none = a.kind_ == Kind::NotANumber || b.kind_ == Kind::NotANumber || isZero(a) || isZero(b);
    return SoftExtended::special(none ? Kind::NotANumber : Kind::Infinite, negative);
  }
  if (a.mantissa_ == 0 || b.mantissa_ == 0) return SoftExtended::special(Kind::Finite, negative);
  Wide n = product(a.mantissa_, b.mantissa_);
  const int up = n.high >> 63 == 0 ? 1 : 0;
  n = shiftedUp(n, up);
  return SoftExtended::rounded(negative, n.high, n.low, a.exponent_ + b.exponent_ + 64 - up);
}

SoftExtended operator/(const SoftExtended& a, const SoftExtended& b) {
  using Kind = SoftExtended::Kind;
  const bool negative = a.negative_ != b.negative_;
  const bool zero = a.kind_ == Kind::Finite && a.mantissa_ == 0,
             byZero = b.kind_ == Kind::Finite && b.mantissa_ == 0;
  if (a.kind_ == Kind::NotANumber || b.kind_ == Kind::NotANumber || (zero && byZero) ||
      (a.kind_ == Kind::Infinite && b.kind_ == Kind::Infinite))
    return SoftExtended::special(Kind::NotANumber, false);
  if (a.kind_ == Kind::Infinite || byZero) return SoftExtended::special(Kind::Infinite, negative);
  if (b.kind_ == Kind::Infinite || zero) return SoftExtended::special(Kind::Finite, negative);
  // Long division, a bit at a time. The first bit is 1, since the rest before it is at least the divisor.
  const std::uint64_t divisor = b.mantissa_;
  bool carry = a.mantissa_ < divisor;
  const int up = carry ? 1 : 0;
  std::uint64_t rest = carry ? a.mantissa_ << 1 : a.mantissa_, quotient = 0;
  for (int bit = 0;; ++bit) {
    const bool one = carry || rest >= divisor;
    if (one) rest -= divisor;
    quotient = quotient << 1 | (one ? 1U : 0U);
    if (bit == 63) break;
    carry = rest >> 63 != 0;
    rest <<= 1;
  }
  // Half of the divisor decides the rounding: twice the rest against it.
  const bool more = rest > divisor - rest, half = rest == divisor - rest;
  const std::uint64_t low = more ? ~std::uint64_t{0} : half ? std::uint64_t{1} << 63 : rest != 0 ? 1 : 0;
  return SoftExtended::rounded(negative, quotient, low, a.exponent_ - b.exponent_ - 63 - up);
}

SoftExtended sqrt(const SoftExtended& a) {
  using Kind = SoftExtended::Kind;
  if (a.kind_ == Kind::NotANumber || (a.negative_ && (a.mantissa_ != 0 || a.kind_ == Kind::Infinite)))
    return SoftExtended::special(Kind::NotANumber, false);
  if (a.kind_ == Kind::Infinite || a.mantissa_ == 0) return a;
  // The root of N = mantissa * 2^64 or 2^63, where the exponent is even, lies in [2^63, 2^64).
  const bool odd = (a.exponent_ & 1) != 0;
  const Wide N = odd ? Wide{a.mantissa_ >> 1, a.mantissa_ << 63} : Wide{a.mantissa_, 0};
  std::uint64_t root = 0;
  for (int bit = 63; bit >= 0; --bit) {
    const std::uint64_t more = root | std::uint64_t{1} << bit;
    const Wide square = product(more, more);
    if (square.high < N.high || (square.high == N.high && square.low <= N.low)) root = more;
  }
  // (root + 1/2)^2 = root^2 + root + 1/4 is no whole number, so there are no ties.
  const Wide square = product(root, root);
  const Wide rest{N.high - square.high - (N.low < square.low ? 1 : 0), N.low - square.low};
  const bool more = rest.high != 0 || rest.low > root;
  return SoftExtended::rounded(false, root, more ? ~std::uint64_t{0} : 0,
                               (a.exponent_ - (odd ? -1 : 0) - 64) / 2);
}

}  // namespace xnewell
