#pragma once

#include <string>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/picture/cell_use.h"
#include "x11/drawing/painter.h"

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

/// Curves over cells, with a left and a bottom axis and names at the ends of the curves.

struct Plot {
  CellRange cells;            ///< from the left end to the right end
  std::vector<double> ticks;  ///< ascending; the first is at the bottom, the last at the top
  bool logarithmic = false;
  std::vector<Curve> curves;  ///< values outside the plot are drawn at its edge
  /// A level with a name, drawn as a dashed line.
  std::optional<double> level = {};
  std::string levelName = {};
};

/// The space that labels need around the area of the curves.
inline constexpr int kPlotLeft = 44, kPlotRight = 64, kPlotBelow = 20;

/// 1, 3, 10, 30, ... from a value of at most `least` to one of at least `most`; both above 0.
[[nodiscard]] std::vector<double> logarithmicTicks(double least, double most);

/// Convert between a cell or a value and its place. `area` is that of the curves.
[[nodiscard]] int plotX(const Plot& plot, const Rect& area, int cell);
[[nodiscard]] int plotY(const Plot& plot, const Rect& area, double value);
[[nodiscard]] int cellAtX(const CellRange& cells, const Rect& area, int x);

void drawPlot(Painter paint, const CellPlan& plan, const Rect& area, const Plot& plot);

/// Repeats a row of a picture, pixel by pixel, over the height of the area.
void drawStrip(Painter paint, const Rect& area, const std::vector<std::uint8_t>& cells);

}  // namespace xnewell
