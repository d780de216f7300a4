#pragma once

#include <string_view>

#include "x11/drawing/wording.h"
#include "x11/scanline/scanline_page.h"

namespace xnewell {

/// What the parts of the page of view 0 are drawn with; only for the source files of that page.

/// Writes the numbers from top to bottom.
struct ScanlinePen : Pen {
  const ScanlineLayout& at;
  const ScanlinePage& page;
  const ScanSample* sample;  ///< of the step; at the start the first one, which is not filled yet
  bool filled;               ///< whether it is filled
  int y;

  [[nodiscard]] int x() const { return at.column.x; }
  [[nodiscard]] int right() const { return at.column.x + at.column.width; }
  /// A place so many parts of 404 from the left edge of the column.
  [[nodiscard]] int along(int parts) const { return at.column.x + at.column.width * parts / 404; }
  void section(std::string_view name, std::string_view aside) {
    y += at.line / 3;
    rule(x(), y - at.line + 2, at.column.width);
    caps(x(), y + 1, name);
    if (textWidth(aside) + textWidth(name, Voice::Caps) + 12 <= at.column.width)
      softRight(right(), y + 1, aside);
    y += at.line;
  }
  /// A white row for what counts.
  void white() {
    paint.fillRect({x() - 4, y - at.line + 4, at.column.width + 8, at.line}, (*this)(Cell::White));
  }
};

/// The grid with its numbers, and the charts under it.
void drawScanlineGrid(ScanlinePen& pen);

}  // namespace xnewell
