#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "shading/figure/figure.h"

namespace xnewell {

/// Convex parts of the page, in the steps of a figure; counter-clockwise as seen (y down).
using ConvexPart = std::vector<glm::dvec2>;

/// Positive if b points to the left of a as seen.
[[nodiscard]] inline double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.y * b.x - a.x * b.y; }

/// Sets `to` to what lies to the left of the line through a along `side` (sign 1), or to its right (-1).
void clipPart(const ConvexPart& part, const glm::dvec2& a, const glm::dvec2& side, double sign,
              ConvexPart& to);

/// Sets `to` to what a part has in common with a convex polygon.
void common(const ConvexPart& part, const FigureLoop& q, ConvexPart& to);

/// Twice the area of a loop; positive if it runs counter-clockwise as seen.
[[nodiscard]] std::int64_t doubleArea(const FigureLoop& loop);

/// True if the part is thinner than the rounding of corners may make it.
[[nodiscard]] bool isSliver(const ConvexPart& part);

/// Takes the polygon q away from the parts. What is left of those that it cuts comes last.
void takeAway(const FigureLoop& q, std::vector<ConvexPart>& parts);

/// True if the polygons overlap by more than the rounding of their corners may make them.
[[nodiscard]] bool overlap(const FigureLoop& p, const FigureLoop& q);

}  // namespace xnewell
