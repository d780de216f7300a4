#pragma once

#include <string>
#include <vector>

#include "shading/color/palette.h"
#include "shading/picture/cell_use.h"

namespace xnewell {

/// Curves over the cells: what each holds, and how large the step to the next is.

/// The eye sees a step of 1 % or more from one shade to the next. A ramp with smaller steps looks continuous.
/// @see Foley & van Dam 2e §13.1.1, after Wyszecki & Stiles 1982
inline constexpr double kSeenStep = 1.0;  ///< per cent

struct Curve {
  std::string name;       ///< "" for a ramp among several
  int first = 0;          ///< cell of y[0]
  std::vector<double> y;  ///< NaN where there is nothing
  bool chosen = true;     ///< true: what the cells hold; false: another table, for comparison
};

/// The largest channel of each cell, of 255: one curve for each ramp. With one hue, also the curves of the
/// other tables, and of its own table if the cells hold something else. If cells hold single colours: their
/// luminance and their largest channel.
[[nodiscard]] std::vector<Curve> storedCurves(const Picture& picture, const Palette& palette);

/// For each such curve of a ramp: by how many per cent the next cell is brighter; NaN after black. If cells
/// hold single colours: how far the nearest other colour is, in CIEDE2000.
[[nodiscard]] std::vector<Curve> stepCurves(const Picture& picture, const Palette& palette);

/// How far the nearest other colour is from that of one cell, in CIEDE2000; NaN if there is no other.
[[nodiscard]] double nearestOther(const Palette& palette, const CellRange& cells, int cell);

/// How many different colours the table has if each value keeps only so many bits.
[[nodiscard]] int distinctLevels(TableSettings table, int bits);
/// How many different colours these cells hold, if each value, 0..65535, keeps only so many bits (8 or 16).
[[nodiscard]] int distinctColors(const Palette& palette, const CellRange& cells, int bits);

/// The ratio r of neighbouring intensities in a corrected table.
[[nodiscard]] double ratioOf(const ColorTable& table);

}  // namespace xnewell
