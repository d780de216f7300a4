#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <glm/vec3.hpp>

namespace xnewell {

/// The references' arithmetic: 256 bits and any exponent, or whole numbers of any length.

using Big = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<256, boost::multiprecision::digit_base_2, void, std::int32_t,
                                         -1'000'000, 1'000'000>,
    boost::multiprecision::et_off>;
using Whole =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

[[nodiscard]] inline Big big(double v) { return Big{v}; }
[[nodiscard]] inline double toDouble(const Big& v) { return v.convert_to<double>(); }
[[nodiscard]] inline Big largerOf(const Big& a, const Big& b) { return a < b ? b : a; }
[[nodiscard]] inline Big smallerOf(const Big& a, const Big& b) { return a < b ? a : b; }

/// |result - exact| / bound. An error of 0 has the share 0, whatever the bound is.
[[nodiscard]] inline double shareOf(double result, const Big& exact, const Big& bound) {
  if (!std::isfinite(result)) return std::numeric_limits<double>::quiet_NaN();
  const Big error = abs(big(result) - exact);
  return error == 0 ? 0.0 : bound > 0 ? toDouble(error / bound) : 1e9;
}

struct BigVec {
  Big x, y, z;
};
[[nodiscard]] inline BigVec bigVec(const double* v) { return {big(v[0]), big(v[1]), big(v[2])}; }
[[nodiscard]] inline BigVec operator+(const BigVec& a, const BigVec& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] inline BigVec operator-(const BigVec& a, const BigVec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] inline BigVec operator*(const BigVec& a, const Big& s) { return {a.x * s, a.y * s, a.z * s}; }
[[nodiscard]] inline Big dot(const BigVec& a, const BigVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] inline BigVec cross(const BigVec& a, const BigVec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline Big lengthOf(const BigVec& v) { return sqrt(dot(v, v)); }
/// 0 for the zero vector.
[[nodiscard]] inline BigVec unitOf(const BigVec& v) {
  const Big length = lengthOf(v);
  return length == 0 ? v : v * (1 / length);
}
/// x^n by squaring.
[[nodiscard]] inline Big powerOf(Big x, int n) {
  Big result = 1;
  for (; n > 0; n >>= 1) {
    if (n & 1) result *= x;
    x *= x;
  }
  return result;
}
[[nodiscard]] inline Big degree() {
  static const Big d = boost::multiprecision::acos(Big{-1}) / 180;
  return d;
}

}  // namespace xnewell
