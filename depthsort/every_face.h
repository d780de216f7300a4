#pragma once

#include "depthsort/depth_sort.h"

namespace xnewell {

/// Sorts a scene for a figure, which has no samples: Newell's algorithm as in depthSort(), with every face of
/// the picture, also those without a sample. It divides no areas, as these are made of pixels.
/// @throws TooManyPieces
[[nodiscard]] SortedScene sortEveryFace(const SnappedScene& scene, int width, int height, int mostPieces);

}  // namespace xnewell
