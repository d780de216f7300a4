#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shading/color/palette.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/rect.h"

namespace xnewell {

/// Places labels beside their points in a chart, where they cover neither a mark nor another label. A point
/// for whose label there is no room has none.
class Labels {
 public:
  static constexpr int kGap = 8;  ///< pixels between two labels in a line

  Labels(Painter paint, const CellPlan& plan, const Rect& area) : paint_{paint}, plan_{plan}, area_{area} {}

  /// No label will cover this.
  void avoid(const Rect& mark) { taken_.push_back(mark); }
  /// Takes the first of these places that lies in the area and covers nothing, if there is one.
  std::optional<Rect> take(std::span<const Rect> places);
  /// Draws a label beside the point (x, y), boxed or as it is. Returns its place, if there was room.
  std::optional<Rect> place(int x, int y, const std::string& text, bool boxed);

 private:
  Painter paint_;
  const CellPlan& plan_;
  Rect area_;
  std::vector<Rect> taken_;
};

}  // namespace xnewell
