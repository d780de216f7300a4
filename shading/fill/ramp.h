#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/fill/affine.h"
#include "shading/fill/cells_by_key.h"
#include "shading/fill/lanes.h"

namespace xnewell {

class TableCells;

/// The cells for the intensities on a surface. An intensity in [low, high] has a place on the ramp, its
/// value, and the whole part of the value is one of `shades` cells from `first` on. If there is a table, the
/// place is only a measure of intensities that are interpolated, and the table has the cells.
struct Ramp {
  int first = 11, shades = 240;
  double low = 0, high = 1;
  const TableCells* table = nullptr;

  /// The place of an intensity, in [first + 1/2, first + shades - 1/2]. AffineOver interpolates it.
  [[nodiscard]] double value(double I) const;
  /// The intensity that has this value.
  [[nodiscard]] double intensity(double value) const {
    if (!(high > low)) return low;
    return std::clamp(low + (high - low) * (value - first - 0.5) / (shades - 1), 0.0, 1.0);
  }
  /// The cell of an intensity, as every filler chooses it.
  [[nodiscard]] std::uint8_t cell(double I) const;
};

/// A channel of a full-colour picture has 1 to 255. 0 is where nothing shows.
inline constexpr Ramp kChannelRamp{.first = 1, .shades = 255};

/// The places of intensities that a table measures: as precise as the fillers can interpolate them.
inline constexpr Ramp kTableRamp{.first = 0, .shades = 256};

/// How the fillers find the cells of a table that is not even. An intensity has the cell that
/// ColorTable::cell gives it, whatever number stands for the intensity:
/// - a double: flat shading, environment maps, and Phong shading with a large n;
/// - a float: Phong shading and textures;
/// - a value on kTableRamp in steps of 2^-24: Gouraud shading.
class TableCells {
 public:
  explicit TableCells(const ColorTable& table);

  /// If I is not a number, the cell is the lowest.
  [[nodiscard]] std::uint8_t cell(double I) const {
    return static_cast<std::uint8_t>(table_.cell(larger(I, 0.0)));
  }
  [[nodiscard]] const CellsByKey& bySteps() const { return bySteps_; }
  /// The cells of Lanes of floats.
  template <class Real>
  [[nodiscard, gnu::always_inline]] auto cells(const Real& I) const {
    Lanes<std::uint8_t, kLanes<Real>> cells;
    if constexpr (std::is_same_v<Number<Real>, float>) {
      const Real kept = smaller(larger(I, splat<Real>(below_)), splat<Real>(1.0));
      const auto keys = (std::bit_cast<Lanes<std::uint32_t, kLanes<Real>>>(kept) - bitsOf(below_)) << shift_;
      for (int k = 0; k < kLanes<Real>; ++k) cells[k] = byBits_(keys[k]);
    } else {
      for (int k = 0; k < kLanes<Real>; ++k) cells[k] = cell(I[k]);
    }
    return cells;
  }

 private:
  [[nodiscard]] static std::uint32_t bitsOf(float I) { return std::bit_cast<std::uint32_t>(I); }
  [[nodiscard]] static std::vector<std::uint32_t> stepsOf(const ColorTable& table);
  [[nodiscard]] std::vector<std::uint32_t> keysOf(const ColorTable& table) const;

  ColorTable table_;
  CellsByKey bySteps_;
  float below_;  ///< the largest float below the second cell. The bits of floats from it to 1 are keys,
  int shift_;    ///< relative to its own and shifted so that they fill 32 bits
  CellsByKey byBits_;
};

/// The one rule from an intensity to a value, for one number or for several at once. It gives a value in
/// [kLeastValue, kLargestValue], whose whole part is the cell unless the ramp has a table.
///
/// The fillers differ only in the precision of the value. Flat shading and environment maps use doubles,
/// Gouraud shading steps of 2^-24. Phong shading and textures use single precision, where the value is within
/// 2^-15 of the exact one: I, the product and the sum are rounded by 2^-24 each, and the value is below 256.
/// (The error is larger if [low, high] is narrow.)
template <class Real>
class ValueOnRamp {
 public:
  [[gnu::always_inline]] explicit ValueOnRamp(const Ramp& ramp) {
    const double rise = ramp.high > ramp.low ? (ramp.shades - 1) / (ramp.high - ramp.low) : 0.0;
    low_ = splat<Real>(ramp.low), high_ = splat<Real>(ramp.high);
    first_ = splat<Real>(ramp.first + 0.5 - rise * ramp.low), perIntensity_ = splat<Real>(rise);
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
    return table_ != nullptr ? table_->cell(I) : static_cast<std::uint8_t>(value_(I));
  }

 private:
  ValueOnRamp<double> value_;
  const TableCells* table_;
};

inline double Ramp::value(double I) const { return ValueOnRamp<double>{*this}(I); }
inline std::uint8_t Ramp::cell(double I) const { return CellOnRamp{*this}(I); }

}  // namespace xnewell
