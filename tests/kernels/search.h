#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace xnewell {

/// A kernel is a small piece of the program's arithmetic whose header claims a bound for its error. Random
/// inputs hardly ever meet the few that round worst, so here we search for them. geometry_kernels.cpp and
/// shading_kernels.cpp have a row for each kernel.
///
/// The references are computed with 256 bits or with whole numbers of any length, by another formula where
/// there is one. They share no tolerance with the program.
///
/// The program rounds to nearest, and the bounds in the headers are for this mode. In the other modes a bound
/// counts Kernel::directed times. Where a header says "exact", it is exact in all four modes; only the whole
/// numbers of the snap and of valueSteps() may be the other neighbour. The compiler may compute constants of
/// the program's files to nearest in any mode, so no test expects the same bits in two modes.
///
/// A search does not find a needle in a place that nothing leads to. So it begins with worst_inputs.txt: what
/// some long searches saw, and inputs that are hard for another reason. A bound holds because its header
/// derives it; the search looks for a mistake in the derivation or in the code.

/// Half of a unit in the last place of 1: the most that a rounding to nearest changes a number, relatively.
inline constexpr double kU = 0x1p-53, kSingle = 0x1p-24;

using Numbers = std::vector<double>;
using In = const Numbers&;

/// One number of an input: its type, and the range in which the claim holds.
struct Coordinate {
  enum class Type { Double, Float, Integer } type = Type::Double;
  double low = 0, high = 0;  ///< both inside
  /// Numbers as integers in the same order: neighbouring numbers are neighbouring integers, so half way
  /// between two of them lies half way between the exponents. -0 and 0 are both 0.
  [[nodiscard]] std::int64_t encode(double v) const;
  [[nodiscard]] double decode(std::int64_t n) const;
};
using Inputs = std::vector<Coordinate>;
inline Inputs doubles(double low, double high) { return {{Coordinate::Type::Double, low, high}}; }
inline Inputs floats(double low, double high) { return {{Coordinate::Type::Float, low, high}}; }
inline Inputs integers(double low, double high) { return {{Coordinate::Type::Integer, low, high}}; }
template <class T>
std::vector<T> operator+(std::vector<T> a, const std::vector<T>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
inline Inputs operator*(int n, const Inputs& input) {
  Inputs all;
  for (; n > 0; --n) all = std::move(all) + input;
  return all;
}
inline int whole(double v) { return static_cast<int>(v); }
/// Some numbers of an input.
inline Numbers slice(In in, std::size_t from, std::size_t end) {
  return {in.begin() + static_cast<std::ptrdiff_t>(from), in.begin() + static_cast<std::ptrdiff_t>(end)};
}

struct Kernel {
  std::string name;
  std::string claim;  ///< the header, and its bound
  Inputs input = {};
  /// Makes what the program gets of an input, such as unit vectors of any vectors. It always rounds to
  /// nearest. An empty result stands for an input of which the header claims nothing. Without it, the program
  /// gets the input itself.
  Numbers (*prepare)(In) = nullptr;
  /// The program's own code. It runs in the rounding mode that is searched.
  Numbers (*run)(In prepared) = nullptr;
  /// The error, by another kind of arithmetic, as a share of the bound. A kernel that claims to be exact has
  /// a share above 1 where it is wrong; where it is right, the share says how near to wrong its estimate
  /// came. An input of which the header claims nothing has the share 0.
  double (*judge)(In prepared, In result) = nullptr;
  /// How many times the bound is when the processor does not round to nearest: each rounding may then be off
  /// by a whole last bit instead of half of one.
  double directed = 2;
  double effort = 1;  ///< evaluations, in those of an ordinary kernel
};
inline constexpr double kWrong = 1e9;  ///< the share of an exact kernel that is wrong

[[nodiscard]] std::vector<Kernel> geometryKernels();
[[nodiscard]] std::vector<Kernel> shadingKernels();

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
