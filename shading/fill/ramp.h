#pragma once

#include <cstdint>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/fill/affine.h"
#include "shading/fill/lanes.h"

namespace xnewell {

/// The cells for the intensities on a surface: either `shades` cells, evenly from `first` on, for [low,
/// high], or a table of 65,536 cells, the k-th for intensities in [k, k + 1) / 65536.
struct Ramp {
  int first = 11, shades = 240;
  double low = 0, high = 1;
  const std::uint8_t* table = nullptr;

  /// The intensity in cells, or in 256ths if there is a table. AffineOver interpolates it.
  [[nodiscard]] double value(double I) const;
  /// The cell of an intensity, as every filler chooses it.
  [[nodiscard]] std::uint8_t cell(double I) const;
};

/// The one rule from an intensity to a cell, for one number or for several at once. It gives a value in
/// [kLeastValue, kLargestValue]. The cell is the whole part of the value. If the ramp has a table, the index
/// into it is the whole part of 256 times the value: the upper 16 bits in 8.24 fixed point.
///
/// The fillers differ only in the precision of the value. Flat shading and environment maps use doubles,
/// Gouraud shading steps of 2^-24. Phong shading and textures use single precision, where the value is within
/// 2^-15 of the exact one: I, the product and the sum are rounded by 2^-24 each, and the value is below 256.
/// (The error is larger if [low, high] is narrow.) The index into a table is exact in all of them, because
/// 65536 I is exact.
template <class Real>
class ValueOnRamp {
 public:
  [[gnu::always_inline]] explicit ValueOnRamp(const Ramp& ramp) {
    if (ramp.table != nullptr) {
      low_ = splat<Real>(kLeastValue / 256.0), high_ = splat<Real>(kLargestValue / 256.0);
      first_ = splat<Real>(0.0), perIntensity_ = splat<Real>(256.0);
    } else {
      const double rise = ramp.high > ramp.low ? (ramp.shades - 1) / (ramp.high - ramp.low) : 0.0;
      low_ = splat<Real>(ramp.low), high_ = splat<Real>(ramp.high);
      first_ = splat<Real>(ramp.first + 0.5 - rise * ramp.low), perIntensity_ = splat<Real>(rise);
    }
  }
  /// If I is not a number, the value is that of `low`.
  [[nodiscard, gnu::always_inline]] Real operator()(const Real& I) const {
    return first_ + perIntensity_ * smaller(larger(I, low_), high_);
  }

 private:
  Real low_, high_, first_, perIntensity_;
};

/// Ramp::cell for many intensities: what depends only on the ramp is computed once.
class CellOnRamp {
 public:
  explicit CellOnRamp(const Ramp& ramp) : value_{ramp}, table_{ramp.table} {}
  [[nodiscard]] std::uint8_t operator()(double I) const {
    const double v = value_(I);
    return table_ != nullptr ? table_[static_cast<int>(v * 256.0)] : static_cast<std::uint8_t>(v);
  }

 private:
  ValueOnRamp<double> value_;
  const std::uint8_t* table_;
};

inline double Ramp::value(double I) const { return ValueOnRamp<double>{*this}(I); }
inline std::uint8_t Ramp::cell(double I) const { return CellOnRamp{*this}(I); }

/// A channel of a full-colour picture has 1 to 255. 0 is where nothing shows.
inline constexpr Ramp kChannelRamp{.first = 1, .shades = 255};

/// Ramp::table for a colour table: the k-th cell is that of the intensity (k + 1/2) / 65536. An X server
/// keeps sixteen bits of a colour, so intensities that share them look the same.
[[nodiscard]] std::vector<std::uint8_t> cellsBy16Bits(const ColorTable& table);

}  // namespace xnewell
