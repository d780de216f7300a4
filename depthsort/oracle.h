#pragma once

#include <vector>

#include "geometry/view/project.h"

namespace xnewell {

/// Which face is seen at each sample, decided there and nowhere else: every face that covers the sample
/// is compared with the nearest so far, in exact arithmetic. No order of faces is made, so there is nothing
/// to sort, to cut or to get wrong; it shares the snapped scene and the sample rule with the painter, and no
/// code. Work: one comparison for every sample of every face.
///
/// Exact for the snapped scene, which is not the model: faces that only touch there are parted by the
/// rounding of the snap, and the oracle sees the parts. Only equal planes are ties: those of faces that
/// overlap in one plane of the model share a record (coplanar.h), others may be equal on the grid.
///
/// Returns an index into scene.faces for each sample, row by row from the top, or kNothing. Of faces in one
/// plane (the same on the grid) the later one of the scene wins.
inline constexpr int kNothing = -1;
[[nodiscard]] std::vector<int> visibleFaces(const SnappedScene& scene, int width, int height);

}  // namespace xnewell
