#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "depthsort/depth_sort.h"

namespace xnewell {

/// Convex regions of the screen as polygons with rational corners, computed in the plain way. Nothing is
/// filtered or rounded, and no line of depthsort/region.h is used. It is slow; it checks the quick way.

using Rational = boost::multiprecision::cpp_rational;

/// The line a x + b y + c = 0, in grid steps.
struct ExactLine {
  Rational a, b, c;
};
struct ExactPoint {
  Rational x, y;
};
[[nodiscard]] Rational valueAt(const ExactLine& line, const ExactPoint& p);

/// The line of the outline's edge from p to q. It is positive inside.
[[nodiscard]] ExactLine exactEdge(const glm::ivec3& p, const glm::ivec3& q);
/// zP - zQ, in depth steps.
[[nodiscard]] ExactLine exactDifference(const ScreenPlane& P, const ScreenPlane& Q);
[[nodiscard]] bool samePlane(const ScreenPlane& P, const ScreenPlane& Q);

/// Counter-clockwise as seen on the screen; empty if there is no area.
using ExactRegion = std::vector<ExactPoint>;

[[nodiscard]] ExactRegion exactOutline(const SnappedScene& scene, const SnappedFace& face);
/// The part of the face's outline inside all cuts of its piece.
[[nodiscard]] ExactRegion exactFragment(const SnappedScene& scene, const SortedScene& sorted,
                                        const Fragment& fragment);
/// The part of the region where the line is positive.
[[nodiscard]] ExactRegion clipped(const ExactRegion& region, const ExactLine& line);
[[nodiscard]] ExactRegion common(ExactRegion region, const ExactRegion& other);
/// The part of the region inside an area.
[[nodiscard]] ExactRegion within(ExactRegion region, const PixelArea& area);

[[nodiscard]] Rational exactDoubleArea(const ExactRegion& region);
/// The greatest value of a line in the region.
[[nodiscard]] Rational greatest(const ExactLine& line, const ExactRegion& region);
/// True if the region owns the sample of pixel (i, j), which is its centre moved by an infinitely small (e,
/// e^2).
[[nodiscard]] bool exactlyCovers(const ExactRegion& region, int i, int j);
/// True if the region owns a sample of the picture.
[[nodiscard]] bool exactlyOwnsSample(const ExactRegion& region, int width, int height);
/// Twice the area over the diameter, from the corners as doubles.
[[nodiscard]] double thickness(const ExactRegion& region);

}  // namespace xnewell
