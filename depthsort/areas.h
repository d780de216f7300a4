#pragma once

#include "depthsort/newell_run.h"

namespace xnewell {

/// Area subdivision (Warnock 1969; Foley & van Dam 2e §15.7.1) around Newell's algorithm. Where many polygons
/// cross each other, most pieces of most splits are hidden. So a run that makes more than a few splits gives
/// up. Then the picture is divided into three by three areas, and each area has a list of its own, and is
/// divided again if it must. A polygon enters the list of an area only if it may show there:
///
/// - A polygon that covers the whole area hides what is behind it. This is cut off, or left out, before
///   anything is split by it.
/// - In an area of one pixel, the nearest polygon at its sample is painted, and no other. (For polygons that
///   are painted with rounded vertices there is no such sample. There the run goes on to its end.)
///
/// Why it is right. Each sample is in one area, and a polygon is left out there only where a nearer one, or a
/// later one in the same plane, covers it. So the polygon that shows at a sample is never left out, even if
/// some of those that hide others are themselves hidden. A polygon is not cut by one that it may only touch.
///
/// Appends what is painted to `sorted`. The samples of the list lie in `area`.
void sortByAreas(const PolygonList& list, const SnappedScene& scene, const SortSettings& settings,
                 const PixelArea& area, PairTests& tests, SortedScene& sorted);

}  // namespace xnewell
