#pragma once

#include <optional>
#include <string>

#include "shading/color/rgb_image.h"
#include "shading/trade/trade.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/rect.h"
#include "x11/views/views.h"

namespace xnewell {

/// Cost against error, as a chart: a mark for each combination, and the front as a staircase. Both axes are
/// logarithmic.

/// Where times and errors are in the chart.
class TradeScale {
 public:
  /// `area` is that of the marks. `trade` has a combination with a time.
  TradeScale(const Rect& area, const Trade& trade);

  [[nodiscard]] int x(double ms) const;
  [[nodiscard]] int y(double error) const;
  /// The error at a row of pixels.
  [[nodiscard]] double errorAt(int y) const;
  [[nodiscard]] const Rect& area() const { return area_; }
  [[nodiscard]] std::vector<double> ticksOfTime() const;
  [[nodiscard]] std::vector<double> ticksOfError() const;

 private:
  Rect area_;
  double ms0_, ms1_, error0_, error1_;
};

/// "Gouraud 12x12, z far": how a mark is called.
[[nodiscard]] std::string labelOf(const Configuration& configuration);

/// Draws axes, marks, the staircase and its labels. `chosen`, an index into trade.combinations, is ringed and
/// labelled in a box; -1 for none. `limit` is drawn as a dashed line.
void drawTradePlot(Painter paint, const CellPlan& plan, const TradeScale& scale, const Trade& trade,
                   int chosen = -1, std::optional<double> limit = {});

/// The chart as a picture of its own, with the front in numbers.
[[nodiscard]] ColoredImage drawTrade(const Trade& trade, const std::string& title);

}  // namespace xnewell
