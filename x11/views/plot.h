#pragma once

#include <string>
#include <vector>

#include "shading/color/palette.h"
#include "x11/drawing/painter.h"
#include "x11/views/table_curves.h"

namespace xnewell {

/// Curves over cells: a left and a bottom axis, names at the curves' ends.

struct Plot {
  CellRange cells;            ///< from the left end to the right
  std::vector<double> ticks;  ///< ascending; the first is the bottom, the last the top
  bool logarithmic = false;
  std::vector<Curve> curves;  ///< what leaves the plot runs along its edge
  /// A level with a name of its own, dashed.
  std::optional<double> level = {};
  std::string levelName = {};
};

/// What the labels need beside the curves' area.
inline constexpr int kPlotLeft = 44, kPlotRight = 64, kPlotBelow = 20;

/// 1, 3, 10, 30, ... from at most `least` to at least `most`, both above 0.
[[nodiscard]] std::vector<double> logarithmicTicks(double least, double most);

/// Between a cell or a value and its pixel; `area` is that of the curves.
[[nodiscard]] int plotX(const Plot& plot, const Rect& area, int cell);
[[nodiscard]] int plotY(const Plot& plot, const Rect& area, double value);
[[nodiscard]] int cellAtX(const CellRange& cells, const Rect& area, int x);

void drawPlot(Painter paint, const CellPlan& plan, const Rect& area, const Plot& plot);

}  // namespace xnewell
