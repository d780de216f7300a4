#pragma once

#include "shading/color/images.h"
#include "x11/drawing/sheet.h"
#include "x11/views/views.h"

namespace xnewell {

/// The normals that the shading uses, shown as colours: those of the faces, or interpolated ones. Red, green
/// and blue are (N + 1) / 2 of x to the right, y up and z towards the viewer. On a coarse grid they are drawn
/// as needles too, foreshortened as seen.

/// (N + 1) / 2 for each sample that shows a face, black elsewhere.
[[nodiscard]] RgbImage normalColors(const Picture& picture);

/// The normals as an image of the picture's size, with needles, on the plan's dark background. The image has
/// colours of its own in the scene's cells; the rest of its palette is `palette`.
[[nodiscard]] ColoredImage normalsImage(const Picture& picture, const CellPlan& plan, const Palette& palette,
                                        int unit = 1);

/// The picture of normals, a ball that explains its colours, and what they mean in words.
[[nodiscard]] ColoredImage drawNormals(const Picture& picture, const ViewSettings& settings);
[[nodiscard]] PictureSettings pictureForNormals(const ViewSettings& settings);

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
