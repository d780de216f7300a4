#pragma once

#include <string_view>

#include "x11/drawing/sheet.h"
#include "x11/views/views.h"

namespace xnewell {

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
