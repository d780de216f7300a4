#pragma once

#include "x11/drawing/sheet.h"
#include "x11/views/picture_sheet.h"

namespace xnewell {

/// The polygons as lines: every edge of every polygon, darker where it is hidden, and dashed where the depth
/// sort split a polygon. The picture itself decides what is hidden: an edge is visible at a pixel if one of
/// its polygons shows at a sample beside it.

struct Wireframe {
  IndexImage image;  ///< of the picture's size
  int polygons = 0;  ///< convex polygons in the view volume
  int back = 0;      ///< polygons seen from behind
  int edges = 0;     ///< an edge that polygons share counts once
  int cuts = 0;      ///< of the depth sort
};
/// `picture` is made.
[[nodiscard]] Wireframe wireframeOf(const Picture& picture, const CellPlan& plan);

[[nodiscard]] Finding findingOf(const Wireframe& wires, const Picture& picture);

/// Dashes count screen pixels along the longer axis, so that an edge that pieces share is dashed as one line.
inline constexpr int kDash = 3, kDashPeriod = 5;

/// The wireframe and its numbers.
[[nodiscard]] Lens wireframeLens(const Picture& picture, const CellPlan& plan, const Palette& palette);

}  // namespace xnewell
