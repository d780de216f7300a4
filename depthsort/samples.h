#pragma once

#include "depthsort/box_grid.h"
#include "depthsort/region.h"

namespace xnewell {

/// Which regions own a sample of the picture, by the sample rule of scanline.h: the centre of a pixel moved
/// by (e, e^2) lies inside.

/// The sign of a line at pixel (i, j)'s sample; never 0.
[[nodiscard]] int signAtSample(const SnappedScene& scene, const Line& line, int i, int j);

/// Whether the region owns a sample of the picture. Exact. Work: its sides times its rows; for thin regions.
[[nodiscard]] bool ownsSample(const SnappedScene& scene, const Region& region, int width, int height);

/// Whether a face may own one: false only if it owns none, exactly asked where its box holds at most four.
[[nodiscard]] bool mayOwnSample(const SnappedScene& scene, const SnappedFace& face, const ScreenBox& box,
                                int width, int height);

/// Whether the face has an area when its vertices are rounded to pixels, as they are for XFillPolygon
/// (fill_polygons.h): such a face may show there without owning a sample.
[[nodiscard]] bool hasAreaInPixels(const SnappedScene& scene, const SnappedFace& face);

/// Twice the area over the diameter, more than kThin: what is thinner is a sliver that only the rounding of
/// the model's vertices makes. In doubles.
inline constexpr double kThin = 64.0;  // 1/1024 of a pixel
[[nodiscard]] bool isWide(const Region& region);

}  // namespace xnewell
