#pragma once

#include <string>
#include <vector>

#include "shading/color/palette.h"
#include "shading/picture/cell_use.h"

namespace xnewell {

/// What the cells hold, as curves over the cells, and how far it is from each to the next.

/// From one shade to the next the eye sees a step of 1 % or more: below it a ramp is continuous.
/// @see Foley & van Dam 2e §13.1.1, after Wyszecki & Stiles 1982
inline constexpr double kSeenStep = 1.0;  ///< per cent

struct Curve {
  std::string name;       ///< "" for a ramp among several
  int first = 0;          ///< cell of y[0]
  std::vector<double> y;  ///< NaN where there is nothing
  bool chosen = true;     ///< of what the cells hold; else of another table, for comparison
};

/// The largest channel of 255, of the cells as they are: a curve a ramp. With one hue then those of the
/// other tables, and of its own where the cells hold something else. Where cells hold single colours: their
/// luminance, and the largest channel.
[[nodiscard]] std::vector<Curve> storedCurves(const Picture& picture, const Palette& palette);

/// Of each such curve of a ramp: by how many per cent the next cell is brighter; nothing after black.
/// Where cells hold single colours: how far the nearest other one is, in CIEDE2000.
[[nodiscard]] std::vector<Curve> stepCurves(const Picture& picture, const Palette& palette);

/// The same of one such cell; NaN where there is no other.
[[nodiscard]] double nearestOther(const Palette& palette, const CellRange& cells, int cell);

/// How many different colours a table has that keeps so many bits of each value.
[[nodiscard]] int distinctLevels(TableSettings table, int bits);

/// The quotient of neighbouring intensities of a corrected table.
[[nodiscard]] double ratioOf(const ColorTable& table);

}  // namespace xnewell
