#pragma once

#include <string>
#include <vector>

#include "shading/color/palette.h"
#include "x11/drawing/painter.h"
#include "x11/views/table_curves.h"

namespace xnewell {

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
