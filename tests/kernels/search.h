#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
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

struct RoundingMode {
  int mode;  ///< as fesetround() takes it
  std::string_view name;
};
/// To nearest, up, down, to zero.
extern const std::array<RoundingMode, 4> kRoundingModes;

/// Judges the kernel at one input. Only Kernel::run is in that rounding mode. The result is a share of the
/// bound that holds in it. A result that is not a number counts as wrong.
[[nodiscard]] double shareAt(const Kernel& kernel, In input, const RoundingMode& mode);

struct Worst {
  double share = 0;
  Numbers input;
};

/// Begins with the given inputs, and goes on from the worst that it knows: it changes a few numbers, in their
/// encodings by powers of two, or to numbers that are hard for most kernels, or to those of another bad
/// input; or it steps along one number for as long as this makes the error larger. The same seed finds the
/// same.
[[nodiscard]] Worst searchWorst(const Kernel& kernel, const std::vector<Numbers>& start,
                                const RoundingMode& mode, int evaluations, std::uint64_t seed);

}  // namespace xnewell
