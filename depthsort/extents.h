#pragma once

#include <cstdint>
#include <vector>

#include "depthsort/box_grid.h"
#include "depthsort/region.h"

namespace xnewell {

/// How far a fragment reaches on the screen grid and in z. The extents never fall short. They are at most a
/// step too large where a corner or a depth is not an integer.
struct Extents {
  ScreenBox box;
  int zFar = 0, zNear = 0;  ///< z steps, larger is nearer
};

/// For each plane, how many faces lie in it: 0, 1, or 2 for two or more. A plane that comes from the model
/// counts as one of two or more: it does not go through vertices.
[[nodiscard]] std::vector<std::uint8_t> facesOfPlanes(const SnappedScene& scene);
/// True if the plane passes exactly through the face's vertices, because it was made of these three alone.
[[nodiscard]] inline bool vertexDepthsAreExact(const SnappedFace& face,
                                               const std::vector<std::uint8_t>& facesOfPlane) {
  return face.count == 3 && facesOfPlane[face.plane] < 2;
}

/// The extents of a face. If `vertexDepths` is true, the depths of its vertices are exact and are used.
[[nodiscard]] Extents extentsOf(const SnappedScene& scene, const SnappedFace& face, bool vertexDepths);
/// The extents of a piece of the face, from those of its parent.
[[nodiscard]] Extents extentsOf(const SnappedScene& scene, const SnappedFace& face, const Region& piece,
                                const Extents& parent);

}  // namespace xnewell
