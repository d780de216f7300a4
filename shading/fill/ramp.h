#pragma once

#include <algorithm>
#include <cstdint>

#include "shading/fill/affine.h"

namespace xnewell {

/// From an intensity in [0, 1] to a cell where intensities are interpolated: either `shades` cells evenly
/// from `first` on for [low, high], or a table of 65,536 cells, the k-th for (k + 1/2) / 65536. Sixteen bits
/// are what an X server keeps of a colour: intensities that share them look the same.
struct Ramp {
  int first = 11, shades = 240;
  double low = 0, high = 1;
  const std::uint8_t* table = nullptr;

  /// The value whose whole part is the cell, or whose upper 16 bits are the index into the table: what
  /// AffineOver takes.
  [[nodiscard]] double value(double I) const {
    if (table != nullptr) return std::clamp(256.0 * I, kLeastValue, kLargestValue);
    return first + 0.5 + perIntensity() * (std::clamp(I, low, high) - low);
  }
  [[nodiscard]] std::uint8_t cell(double I) const {
    const double v = value(I);
    return table != nullptr ? table[static_cast<int>(v * 256.0)] : static_cast<std::uint8_t>(v);
  }
  [[nodiscard]] double perIntensity() const { return high > low ? (shades - 1) / (high - low) : 0.0; }
};

/// A channel of a full-colour picture: 1 to 255, for 0 is where nothing shows.
inline constexpr Ramp kChannelRamp{.first = 1, .shades = 255};

}  // namespace xnewell
