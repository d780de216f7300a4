#pragma once

#include "depthsort/box_grid.h"
#include "depthsort/region.h"

namespace xnewell {

/// Finds which regions own a sample of the picture. The sample rule is that of scanline.h: the centre of a
/// pixel, moved by an infinitely small (e, e^2), lies inside.

/// The sign of a line at the sample of pixel (i, j). It is never 0.
[[nodiscard]] int signAtSample(const SnappedScene& scene, const Line& line, int i, int j);

/// True if the region owns a sample of the picture. Exact. Work: #sides times #rows, so use it for thin
/// regions.
[[nodiscard]] bool ownsSample(const SnappedScene& scene, const Region& region, int width, int height);

/// False only if the face owns no sample. The answer is exact if the face's box holds at most four samples;
/// for a larger box it is true.
[[nodiscard]] bool mayOwnSample(const SnappedScene& scene, const SnappedFace& face, const ScreenBox& box,
                                int width, int height);
/// The same for a region.
[[nodiscard]] bool mayOwnSample(const SnappedScene& scene, const Region& region, const ScreenBox& box,
                                int width, int height);

/// False only if the face shows nowhere in the picture. `inPixels` is true if faces are painted with their
/// vertices rounded to pixels; then a face without a sample may show.
[[nodiscard]] bool mayShow(const SnappedScene& scene, const SnappedFace& face, const ScreenBox& box,
                           int width, int height, bool inPixels);

/// True if the face has an area after its vertices are rounded to pixels, as they are for XFillPolygon
/// (fill_polygons.h). Such a face may show there without owning a sample.
[[nodiscard]] bool hasAreaInPixels(const SnappedScene& scene, const SnappedFace& face);

/// True if twice the area over the diameter is more than kThin. A thinner region is a sliver that only the
/// rounding of the model's vertices makes. Computed in doubles.
inline constexpr double kThin = 64.0;  // in grid steps: 1/1024 of a pixel
[[nodiscard]] bool isWide(const Region& region);

}  // namespace xnewell
