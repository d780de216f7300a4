#pragma once

#include <span>
#include <vector>

#include "depthsort/newell_run.h"

namespace xnewell {

/// Finds the polygons that need no test. A polygon P of a list is free if at each of its samples every later
/// polygon of the list is wholly nearer: its farthest z is nearer than P's nearest. When P is the first of
/// the list that is left, a free P may be painted at once. For whatever else is left comes later, or is a
/// piece of what comes later; and where it shares a sample with P, it is nearer. In a closed surface of small
/// polygons nearly all are free.
///
/// One pass over the samples finds them, from the last polygon of the list to the first. Each sample keeps
/// the farthest z of the polygon that was entered there last. The list is sorted by that z, so it is the
/// farthest of all that were entered there.
///
/// @param byDepth  the list: indices into `polygons`, which are whole faces, by farthest z, farthest first
/// @return  for each place of the list, whether its polygon is free. Empty if such a pass takes longer than
///          tests would.
[[nodiscard]] std::vector<bool> freePolygons(const SnappedScene& scene, std::span<const Polygon> polygons,
                                             std::span<const int> byDepth, int width, int height);

}  // namespace xnewell
