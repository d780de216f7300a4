#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "depthsort/depth_sort.h"

namespace xnewell {

/// Convex regions of the screen as polygons with rational corners, the plain way: nothing is filtered,
/// nothing rounded and no line of depthsort/region.h is shared. Slow; it judges what the quick way says.

using Rational = boost::multiprecision::cpp_rational;

/// a x + b y + c, in grid steps.
struct ExactLine {
  Rational a, b, c;
};
struct ExactPoint {
  Rational x, y;
};
[[nodiscard]] Rational valueAt(const ExactLine& line, const ExactPoint& p);

/// Positive inside the outline's edge from p to q.
[[nodiscard]] ExactLine exactEdge(const glm::ivec3& p, const glm::ivec3& q);
/// zP - zQ, in depth steps.
[[nodiscard]] ExactLine exactDifference(const ScreenPlane& P, const ScreenPlane& Q);
[[nodiscard]] bool samePlane(const ScreenPlane& P, const ScreenPlane& Q);

/// Counter-clockwise as seen. Without an area: empty.
using ExactRegion = std::vector<ExactPoint>;

[[nodiscard]] ExactRegion exactOutline(const SnappedScene& scene, const SnappedFace& face);
/// The outline within all the cuts of its piece.
[[nodiscard]] ExactRegion exactFragment(const SnappedScene& scene, const SortedScene& sorted,
                                        const Fragment& fragment);
/// Its part where the line is positive.
[[nodiscard]] ExactRegion clipped(const ExactRegion& region, const ExactLine& line);
[[nodiscard]] ExactRegion common(ExactRegion region, const ExactRegion& other);
/// Its part within the picture.
[[nodiscard]] ExactRegion withinPicture(ExactRegion region, int width, int height);

[[nodiscard]] Rational exactDoubleArea(const ExactRegion& region);
/// The greatest value of a line in the region.
[[nodiscard]] Rational greatest(const ExactLine& line, const ExactRegion& region);
/// Whether it owns the sample of pixel (i, j): its centre moved by (e, e^2).
[[nodiscard]] bool exactlyCovers(const ExactRegion& region, int i, int j);
/// Whether it owns a sample of the picture.
[[nodiscard]] bool exactlyOwnsSample(const ExactRegion& region, int width, int height);
/// Twice the area over the diameter, of the corners in doubles.
[[nodiscard]] double thickness(const ExactRegion& region);

}  // namespace xnewell
