#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/color/images.h"
#include "shading/trade/trade.h"
#include "x11/drawing/painter.h"
#include "x11/kit/page.h"
#include "x11/views/views.h"

namespace xnewell {

/// Cost against error, as a chart: a mark for each combination, and the front as a staircase. Both axes are
/// logarithmic.

/// What the chart has from left to right, and from top to bottom.
enum class TradeCost { Time, Memory };
enum class TradeError { Rms, Largest, WrongFaces };
struct TradeCostRow {
  TradeCost id;
  std::string_view label, says;
};
inline constexpr std::array kTradeCosts{
    TradeCostRow{TradeCost::Time, "time", "time for one picture, ms (log)"},
    TradeCostRow{TradeCost::Memory, "memory", "memory that the picture holds, MB (log)"},
};
struct TradeErrorRow {
  TradeError id;
  std::string_view label, says;
  double least;  ///< what is less is drawn there: the scale is logarithmic
};
inline constexpr std::array kTradeErrors{
    TradeErrorRow{TradeError::Rms, "RMS", "error, root mean square of intensity (log)", 1e-6},
    TradeErrorRow{TradeError::Largest, "largest", "largest error of intensity (log)", 1e-6},
    TradeErrorRow{TradeError::WrongFaces, "wrong faces", "samples that show a wrong face (log)", 0.5},
};
struct TradeAxes {
  TradeCost cost = TradeCost::Time;
  TradeError error = TradeError::Rms;
  bool operator==(const TradeAxes&) const = default;

  /// Milliseconds, or millions of bytes.
  [[nodiscard]] double costOf(const Measured& one) const;
  [[nodiscard]] double errorOf(const Measured& one) const;
};
/// The combinations for which no other costs less and has a smaller error, the cheapest first. By time and
/// RMS it is Trade::front.
[[nodiscard]] std::vector<int> frontBy(const TradeAxes& axes, const Trade& trade);

/// Where costs and errors are in the chart.
class TradeScale {
 public:
  /// `area` is that of the marks. `trade` has a combination with a time.
  TradeScale(const Rect& area, const Trade& trade, const TradeAxes& axes = {});

  /// What is beyond the marks is put at the area's edge: a large limit keeps its handle in reach.
  [[nodiscard]] int x(double cost) const;
  [[nodiscard]] int y(double error) const;
  /// The error at a row of pixels.
  [[nodiscard]] double errorAt(int y) const;
  [[nodiscard]] const Rect& area() const { return area_; }
  [[nodiscard]] const TradeAxes& axes() const { return axes_; }
  [[nodiscard]] std::vector<double> ticksOfCost() const;
  [[nodiscard]] std::vector<double> ticksOfError() const;

 private:
  Rect area_;
  TradeAxes axes_;
  double cost0_, cost1_, error0_, error1_;
};

/// "Gouraud 12x12, z far": how a mark is called.
[[nodiscard]] std::string labelOf(const Configuration& configuration);

/// The handle of the limit's line, half of it beyond the right edge of the marks' area.
[[nodiscard]] Rect limitHandle(const TradeScale& scale, double limit);

/// Draws axes, marks, the staircase and its labels. `chosen`, an index into trade.combinations, is ringed and
/// labelled in a box; -1 for none. `limit` is drawn as a dashed line.
void drawTradePlot(Painter paint, const CellPlan& plan, const TradeScale& scale, const Trade& trade,
                   int chosen = -1, std::optional<double> limit = {});

/// The marks of the methods, and what each stands for. Returns where it ends.
int drawTradeLegend(Painter paint, const CellPlan& plan, int x, int y);

/// The chart as a picture of its own, with the front in numbers.
[[nodiscard]] ColoredImage drawTrade(const Trade& trade, const std::string& title);

/// The numbers of a trade as a table.

/// What an X server gets for the first picture of a window, on an 8-bit visual with a colormap of its own and
/// without shared memory: the cells in XStoreColors, the pixels in one XPutImage or more, and XCopyArea from
/// the pixmap to the window. It is computed, since a trade has no server. The image is the same size whatever
/// the short cuts are; only cells can be saved. `snapshot --stats` measures it.
struct ServerCost {
  std::int64_t requests = 0, bytes = 0;
};
[[nodiscard]] ServerCost serverCostOf(const Measured& one);

/// A table without rows. `what` names its first column.
[[nodiscard]] page::Table tradeTable(std::string what);
/// Adds a row: the times, the errors of the intensity, the samples with wrong faces, the errors of the
/// colour, the memory. What was not measured is a dash. `below` are lines under it.
void addNumbers(page::Table& table, std::string name, const Measured& one,
                const std::vector<std::string>& below = {});

/// All combinations, the fastest first. Those on the front have a star, and the options that make them.
[[nodiscard]] std::string tableOfCombinations(const Trade& trade);

/// "230 %": a ratio of two times.
[[nodiscard]] std::string percentOf(double ratio);

}  // namespace xnewell
