#pragma once

#include "depthsort/box_grid.h"
#include "depthsort/region.h"

namespace xnewell {

/// How far a fragment reaches on the screen grid and in z. The extents never fall short. They are at most a
/// step too large where a corner or a depth is not an integer.
struct Extents {
  ScreenBox box;
  int zFar = 0, zNear = 0;  ///< z steps, larger is nearer
};

/// The extents of a face, which has its plane or is throughVertices.
[[nodiscard]] Extents extentsOf(const SnappedScene& scene, const SnappedFace& face);
/// The extents of a piece of the face, from those of its parent.
[[nodiscard]] Extents extentsOf(const SnappedScene& scene, const SnappedFace& face, const Region& piece,
                                const Extents& parent);

}  // namespace xnewell
