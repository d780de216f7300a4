#pragma once

#include <cstdint>
#include <vector>

#include "depthsort/box_grid.h"
#include "depthsort/region.h"

namespace xnewell {

/// How far a fragment reaches on the screen grid and in z: never less than it does, and at most a step more
/// where its corners or its depths are no integers.
struct Extents {
  ScreenBox box;
  int zFar = 0, zNear = 0;  ///< z steps, larger is nearer
};

/// How many faces lie in each plane: 0, 1, or 2 for more.
[[nodiscard]] std::vector<std::uint8_t> facesOfPlanes(const SnappedScene& scene);
/// Whether the plane passes through the face's vertices: it was made of these three alone.
[[nodiscard]] inline bool vertexDepthsAreExact(const SnappedFace& face,
                                               const std::vector<std::uint8_t>& facesOfPlane) {
  return face.count == 3 && facesOfPlane[face.plane] < 2;
}

[[nodiscard]] Extents extentsOf(const SnappedScene& scene, const SnappedFace& face, bool vertexDepths);
/// Of a piece of the face, whose parent's extents are given.
[[nodiscard]] Extents extentsOf(const SnappedScene& scene, const SnappedFace& face, const Region& piece,
                                const Extents& parent);

}  // namespace xnewell
