#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "depthsort/depth_sort.h"
#include "depthsort/record/explain.h"
#include "x11/drawing/painter.h"

namespace xnewell {

/// The samples of a fragment, in a picture that is part of a larger image.

struct Samples {
  std::int64_t count = 0;
  int x = 0, y = 0;  ///< near their middle, in units of the image
};
/// Tints the samples of fragment `id` of the run, or only counts them as pixels of the image. `at` is the
/// area of the picture, which has this size in samples.
Samples tintFragment(Painter paint, const Rect& at, glm::ivec2 size, const SnappedScene& scene,
                     const SortedScene& sorted, int id, std::optional<Stipple> tint, std::uint8_t cell);

/// How many samples of the fragment lie in an area, which lies inside the picture.
[[nodiscard]] std::int64_t samplesWithin(const SnappedScene& scene, const SortedScene& sorted, int id,
                                         const Rect& area);

/// True if the fragment owns the sample of this pixel of the picture.
[[nodiscard]] bool owns(const SnappedScene& scene, const SortedScene& sorted, const Fragment& fragment,
                        int column, int row);

/// The fragment for an id of an Event.
[[nodiscard]] Fragment fragmentOf(const SnappedScene& scene, const SortedScene& sorted, int id);

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
