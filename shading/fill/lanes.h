#pragma once

#include <cmath>
#include <type_traits>

namespace xnewell {

/// Arithmetic on one number, or on several at once, written once. A function over `Real` takes a float, a
/// double, or Lanes of them (GCC's and Clang's vector extension; any processor has it). The operators + - *
/// /, the comparisons and ?: work on each lane by itself and round as for one number, so all give the same
/// bits. `a < b ? c : d` evaluates both c and d.

template <class Number, int N>
struct LanesOf {
  using Type [[gnu::vector_size(N * sizeof(Number))]] = Number;
};
template <class Number, int N>
using Lanes = typename LanesOf<Number, N>::Type;

template <class Real>
struct NumberIn {
  using Type = std::remove_cvref_t<decltype(Real{}[0])>;
};
template <class Real>
requires std::is_floating_point_v<Real>
struct NumberIn<Real> {
  using Type = Real;
};
template <class Real>
using Number = typename NumberIn<Real>::Type;

template <class Real>
inline constexpr int kLanes = static_cast<int>(sizeof(Real) / sizeof(Number<Real>));

/// The same number in every lane.
template <class Real>
[[nodiscard, gnu::always_inline]] inline Real splat(double v) {
  return Real{} + static_cast<Number<Real>>(v);
}

/// The square root of v >= 0.
template <class Real>
[[nodiscard, gnu::always_inline]] inline Real root(const Real& v) {
  if constexpr (std::is_floating_point_v<Real>) {
    return std::sqrt(v);
  } else {
    Real r;
    for (int k = 0; k < kLanes<Real>; ++k) r[k] = std::sqrt(v[k]);
    return r;
  }
}

/// Where a is not a number the result is b, so larger(x, bound) and smaller(x, bound) keep to the bound for
/// every x.
template <class Real>
[[nodiscard, gnu::always_inline]] inline Real larger(const Real& a, const Real& b) {
  return a > b ? a : b;
}
template <class Real>
[[nodiscard, gnu::always_inline]] inline Real smaller(const Real& a, const Real& b) {
  return a < b ? a : b;
}

/// x^n by squaring. In doubles it gives the same bits as geometry/exact/power.h, without the products by 1.
/// In single precision the relative error is at most n 2^-24, n <= 1,024; a result below 2^-126 is off by up
/// to 2^-140 more.
template <class Real>
[[nodiscard, gnu::always_inline]] inline Real powerOf(Real x, int n) {
  if (n <= 0) return splat<Real>(1.0);
  for (; (n & 1) == 0; n >>= 1) x *= x;
  Real result = x;
  for (n >>= 1; n > 0; n >>= 1) {
    x *= x;
    if (n & 1) result *= x;
  }
  return result;
}

template <class Real>
struct Vec {
  Real x, y, z;
};

template <class Real>
[[nodiscard, gnu::always_inline]] inline Vec<Real> operator-(const Vec<Real>& a, const Vec<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
[[nodiscard, gnu::always_inline]] inline Vec<Real> operator+(const Vec<Real>& a, const Vec<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
[[nodiscard, gnu::always_inline]] inline Vec<Real> operator*(const Vec<Real>& a, const Real& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class Real>
[[nodiscard, gnu::always_inline]] inline Real dot(const Vec<Real>& a, const Vec<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// The same vector in every lane. V has x, y and z.
template <class Real, class V>
[[nodiscard, gnu::always_inline]] inline Vec<Real> splatVec(const V& v) {
  return {splat<Real>(v.x), splat<Real>(v.y), splat<Real>(v.z)};
}

/// v / |v|; 0 where |v|^2 is too small for the number type.
template <class Real>
[[nodiscard, gnu::always_inline]] inline Vec<Real> unitOf(const Vec<Real>& v) {
  constexpr double kLeast = sizeof(Number<Real>) == sizeof(float) ? 1e-37 : 1e-307;
  const Real square = dot(v, v);
  const Real some = square > splat<Real>(kLeast) ? square : splat<Real>(1.0);
  return v * (square > splat<Real>(kLeast) ? splat<Real>(1.0) / root(some) : splat<Real>(0.0));
}

}  // namespace xnewell
