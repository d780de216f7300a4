#pragma once

#include <optional>
#include <vector>

#include "depthsort/record/explain.h"
#include "x11/drawing/painter.h"

namespace xnewell {

/// Convex figures in the painter's coordinates: polygons on the screen, under a loupe or from the side. They
/// may have any size; only the part near the image is drawn.

using Outline = std::vector<Place>;

[[nodiscard]] Outline outlineOf(const Region& region);

/// The mean of its corners; the origin if there are none.
[[nodiscard]] Place middleOf(const Outline& figure);

/// Draws a line from one place to the other, with both ends; both lie within +-1e12.
void segment(Painter& painter, Place from, Place to, std::uint8_t cell, const LineStyle& style = {});
/// Draws the sides of the figure.
void outline(Painter& painter, const Outline& figure, std::uint8_t cell, const LineStyle& style = {});
/// Tints the units of the area whose centres lie inside the figure.
void tint(Painter& painter, const Rect& area, const Outline& figure, Stipple stipple, std::uint8_t cell);

/// The line across a figure where a value is 0, or nothing if it has one sign everywhere. `values` has one
/// value for each corner; between corners it is linear.
struct Chord {
  Place from, to;
};
[[nodiscard]] std::optional<Chord> zeroLine(const Outline& figure, const std::vector<double>& values);

}  // namespace xnewell
