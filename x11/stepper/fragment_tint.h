#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "depthsort/depth_sort.h"
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

}  // namespace xnewell
