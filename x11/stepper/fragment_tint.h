#pragma once

#include <optional>

#include "depthsort/depth_sort.h"
#include "x11/drawing/painter.h"

namespace xnewell {

/// The samples of a fragment in a picture that stands in a larger image.

struct Samples {
  std::int64_t count = 0;
  int x = 0, y = 0;  ///< about their middle, in the image
};
/// Tints them, or only counts them. `at` is where the picture stands, all of it in the image; `id` a fragment
/// of the run.
Samples tintFragment(IndexImage& image, const Rect& at, const SnappedScene& scene, const SortedScene& sorted,
                     int id, std::optional<Stipple> tint, std::uint8_t cell);

/// How many of its samples lie in an area of the picture, which has no place outside it.
[[nodiscard]] std::int64_t samplesWithin(const SnappedScene& scene, const SortedScene& sorted, int id,
                                         const Rect& area);

/// Whether a fragment owns the sample of this pixel of the picture.
[[nodiscard]] bool owns(const SnappedScene& scene, const SortedScene& sorted, const Fragment& fragment,
                        int column, int row);

/// An id as Event has it, as what is painted.
[[nodiscard]] Fragment fragmentOf(const SnappedScene& scene, const SortedScene& sorted, int id);

}  // namespace xnewell
