#pragma once

#include <cstdint>

#include "geometry/model/mesh.h"

namespace xnewell {

/// How the faces of a mesh meet. Corners at one place count as one, whatever their indices: many writers
/// repeat a vertex for each face. An edge without a length does not count.
struct EdgeCounts {
  std::int64_t open = 0;     ///< edges of one face alone: there the surface has a border
  std::int64_t turned = 0;   ///< edges of two faces that both follow in the same direction: seen from one
                             ///< side, one of them is counter-clockwise and the other clockwise
  std::int64_t crowded = 0;  ///< edges of three faces or more
};
/// Growth: n for n corners and points, n log n if most edges meet in one point.
[[nodiscard]] EdgeCounts countEdges(const Mesh& mesh);

}  // namespace xnewell
