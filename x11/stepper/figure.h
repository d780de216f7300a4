#pragma once

#include <optional>
#include <vector>

#include "depthsort/explain.h"
#include "x11/drawing/painter.h"

namespace xnewell {

/// Convex figures in pixels: what polygons look like on the screen, under a loupe or from the side. Whatever
/// their size, only what is near the image is drawn.

using Figure = std::vector<Place>;

[[nodiscard]] Figure figureOf(const Region& region);

/// Of its corners; of none, the origin.
[[nodiscard]] Place middleOf(const Figure& figure);

/// From one place to the other, the pixels that hold them included; both within +-1e12.
void segment(Painter& painter, Place from, Place to, std::uint8_t cell, const LineStyle& style = {});
/// The figure's sides.
void outline(Painter& painter, const Figure& figure, std::uint8_t cell, const LineStyle& style = {});
/// The pixels of the area whose centres lie within.
void tint(Painter& painter, const Rect& area, const Figure& figure, Stipple stipple, std::uint8_t cell);

/// Where the values at a figure's corners, growing evenly between them, are 0: the line across it, or nothing
/// where they have one sign. One value a corner.
struct Chord {
  Place from, to;
};
[[nodiscard]] std::optional<Chord> zeroLine(const Figure& figure, const std::vector<double>& values);

}  // namespace xnewell
