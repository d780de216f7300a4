#pragma once

#include <compare>
#include <cstdint>
#include <limits>

namespace xnewell {

/// Extended for processors whose long double is another one: x86's format in whole numbers. Each operation is
/// rounded to the nearest, of two to the even one, so it has the same bits. It does not overflow or
/// underflow, which long double does beyond 2^16384 and below 2^-16382.
class SoftExtended {
 public:
  SoftExtended() = default;  ///< as of double: its value is not set
  SoftExtended(double v);    // NOLINT(google-explicit-constructor): as the compiler's own
  explicit operator double() const;

  friend SoftExtended operator+(const SoftExtended& a) { return a; }
  friend SoftExtended operator-(SoftExtended a) {
    a.negative_ = !a.negative_;
    return a;
  }
  friend SoftExtended operator+(const SoftExtended& a, const SoftExtended& b);
  friend SoftExtended operator-(const SoftExtended& a, const SoftExtended& b) { return a + -b; }
  friend SoftExtended operator*(const SoftExtended& a, const SoftExtended& b);
  friend SoftExtended operator/(const SoftExtended& a, const SoftExtended& b);
  SoftExtended& operator+=(const SoftExtended& b) { return *this = *this + b; }
  SoftExtended& operator-=(const SoftExtended& b) { return *this = *this - b; }
  SoftExtended& operator*=(const SoftExtended& b) { return *this = *this * b; }
  SoftExtended& operator/=(const SoftExtended& b) { return *this = *this / b; }
  friend std::partial_ordering operator<=>(const SoftExtended& a, const SoftExtended& b);
  friend bool operator==(const SoftExtended& a, const SoftExtended& b) { return (a <=> b) == 0; }

  friend SoftExtended abs(const SoftExtended& a) { return a.negative_ ? -a : a; }
  friend SoftExtended sqrt(const SoftExtended& a);
  friend bool isfinite(const SoftExtended& a) { return a.kind_ == Kind::Finite; }

 private:
  enum class Kind : std::uint8_t { Finite, Infinite, NotANumber };
  static SoftExtended rounded(bool negative, std::uint64_t high, std::uint64_t low, int exponent);
  static SoftExtended special(Kind kind, bool negative);

  std::uint64_t mantissa_;  ///< at least 2^63, or 0
  std::int32_t exponent_;   ///< the number is mantissa * 2^exponent
  bool negative_;
  Kind kind_;
};

}  // namespace xnewell

/// With it, GLM's vectors take these numbers.
template <>
struct std::numeric_limits<xnewell::SoftExtended> : std::numeric_limits<double> {
  static constexpr int digits = 64;
  static xnewell::SoftExtended infinity() { return std::numeric_limits<double>::infinity(); }
};
