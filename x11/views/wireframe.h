#pragma once

#include "x11/drawing/sheet.h"
#include "x11/views/views.h"

namespace xnewell {

/// The polygons as lines: every edge of every polygon, hidden ones darker, and dashed where the depth sort
/// split one. What is hidden is decided by the picture itself: an edge shows at a pixel where one of its
/// polygons shows at a sample beside it.

struct Wireframe {
  IndexImage image;  ///< of the picture's size
  int polygons = 0;  ///< in the view volume, convex
  int back = 0;      ///< of them, seen from behind
  int edges = 0;     ///< one that polygons share counts once
  int cuts = 0;      ///< of the depth sort
};
/// `picture` is made.
[[nodiscard]] Wireframe wireframeOf(const Picture& picture, const CellPlan& plan);

[[nodiscard]] Finding findingOf(const Wireframe& wires, const Picture& picture);

/// On screen a dash goes by pixel along the longer axis, so that what pieces share is dashed as one.
inline constexpr int kDash = 3, kDashPeriod = 5;

/// The wireframe and its numbers.
[[nodiscard]] ColoredImage drawWireframe(const Picture& picture, const ViewSettings& settings);
[[nodiscard]] PictureSettings pictureForWireframe(const ViewSettings& settings);

}  // namespace xnewell
