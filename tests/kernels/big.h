#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <glm/vec3.hpp>

namespace xnewell {

/// The references' arithmetic: 256 bits and any exponent, or whole numbers of any length.

namespace mp = boost::multiprecision;
using Big = mp::number<mp::cpp_bin_float<256, mp::digit_base_2, void, std::int32_t, -1'000'000, 1'000'000>,
                       mp::et_off>;
using Whole = mp::number<mp::cpp_int_backend<>, mp::et_off>;

inline Big big(double v) { return Big{v}; }
inline double toDouble(const Big& v) { return v.convert_to<double>(); }
inline Big largerOf(const Big& a, const Big& b) { return a < b ? b : a; }
inline Big smallerOf(const Big& a, const Big& b) { return a < b ? a : b; }

struct BigVec {
  Big x, y, z;
};
inline BigVec bigVec(const double* v) { return {big(v[0]), big(v[1]), big(v[2])}; }
inline glm::dvec3 glmOf(const double* v) { return {v[0], v[1], v[2]}; }
inline BigVec operator+(const BigVec& a, const BigVec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline BigVec operator-(const BigVec& a, const BigVec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline BigVec operator*(const BigVec& a, const Big& s) { return {a.x * s, a.y * s, a.z * s}; }
inline Big dot(const BigVec& a, const BigVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline BigVec cross(const BigVec& a, const BigVec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Big lengthOf(const BigVec& v) { return sqrt(dot(v, v)); }
inline BigVec absOf(const BigVec& v) { return {abs(v.x), abs(v.y), abs(v.z)}; }
inline Big sumOf(const BigVec& v) { return v.x + v.y + v.z; }
/// 0 for the zero vector.
inline BigVec unitOf(const BigVec& v) {
  const Big length = lengthOf(v);
  return length == 0 ? v : v * (1 / length);
}
/// x^n by squaring.
inline Big bigPower(Big x, int n) {
  Big result = 1;
  for (; n > 0; n >>= 1, x *= x)
    if (n & 1) result *= x;
  return result;
}
inline Big degree() {
  static const Big d = mp::acos(Big{-1}) / 180;
  return d;
}

/// |result - exact| / bound. An error of 0 has the share 0, whatever the bound is.
inline double shareOf(const Big& result, const Big& exact, const Big& bound) {
  const Big error = abs(result - exact);
  return error == 0 ? 0.0 : bound > 0 ? toDouble(error / bound) : 1e9;
}
inline double shareOf(double result, const Big& exact, const Big& bound) {
  return std::isfinite(result) ? shareOf(big(result), exact, bound) : NAN;
}
/// The largest share of three numbers.
inline double shareOf(const double* result, const BigVec& exact, const BigVec& bound) {
  return std::max({shareOf(result[0], exact.x, bound.x), shareOf(result[1], exact.y, bound.y),
                   shareOf(result[2], exact.z, bound.z)});
}

}  // namespace xnewell
