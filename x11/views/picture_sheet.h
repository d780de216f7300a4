#pragma once

#include <array>
#include <span>
#include <string_view>

#include "shading/color/palette.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"
#include "x11/views/views.h"

namespace xnewell {

/// A legend in one line: what the steps of a map mean, on the background of the map.

struct LegendStep {
  Cell cell;
  std::string_view label;
};
/// Steps of differences. Each is twice as large as the one before; the first is a unit.
inline constexpr std::array kDoublingSteps{
    LegendStep{Cell::WellLine, "below 1"}, LegendStep{Cell::Soft, "1"},  LegendStep{Cell::Faint, "2"},
    LegendStep{Cell::WellText, "4"},       LegendStep{Cell::White, "8"}, LegendStep{Cell::Q, "16"},
};
/// The step that a difference belongs to: below the unit, below twice the unit, below four times the unit,
/// and so on; the last step has no limit, and any difference has it where the unit is 0. Both have the same
/// measure.
[[nodiscard]] const LegendStep& doublingStep(double difference, double unit);
/// Draws the legend from its upper left corner on, with `unit` after the steps.
void drawStepLegend(Painter painter, const CellPlan& plan, int x, int y, std::span<const LegendStep> steps,
                    std::string_view unit);

/// A view with a picture over the whole width of the sheet and a strip of numbers below it. The strip has two
/// columns: legend and table at the left, the finding at the right.
class PictureSheet {
 public:
  /// The strip has so many pixels, its section's line and name included.
  PictureSheet(const ViewSettings& settings, int strip);

  /// What such a sheet asks its picture for: the size that the strip leaves.
  [[nodiscard]] static PictureSettings picture(const ViewSettings& settings, int strip);

  /// The view's own image, of the picture's size.
  void place(const IndexImage& image) {
    sheet.painter().place(image, {0, 0, at.width, at.height}, at.x, at.y);
  }
  /// Begins the strip. Returns the y below its name.
  int section(std::string_view name) { return sheet.section(left, top_, width_, name); }
  void finding(int y, const Finding& found) { sheet.finding(right, y, column, found.bold, found.why); }
  /// Adds a row to the table. Returns the y below it.
  int row(int y, std::string_view label, const std::string& value) {
    return sheet.tableRow(left, y, label, {value}, {column});
  }

  Rect at;                           ///< the picture
  int left = Sheet::kMargin, right;  ///< where the columns begin
  int column;                        ///< how wide they are
  Sheet sheet;

 private:
  int top_, width_;
};

}  // namespace xnewell
