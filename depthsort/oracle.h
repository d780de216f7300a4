#pragma once

#include <vector>

#include "geometry/view/project.h"

namespace xnewell {

/// Finds which face is seen at each sample. It decides each sample by itself: it compares every face that
/// covers the sample with the nearest face so far, in exact arithmetic. It makes no order of faces, so it
/// cannot sort or cut wrongly. It shares the snapped scene and the sample rule with the painter, but no code.
/// Work: one comparison for every sample of every face.
///
/// The result is exact for the snapped scene, which is not the model. Faces that only touch in the model are
/// separated by the rounding of the snap, and the oracle sees them apart. Only equal planes tie. Faces that
/// overlap in one plane of the model share one plane record (coplanar.h); other planes may happen to be equal
/// on the grid.
///
/// Returns for each sample an index into scene.faces or kNothing, row by row from the top. In a tie the later
/// face of the scene wins.
inline constexpr int kNothing = -1;
[[nodiscard]] std::vector<int> visibleFaces(const SnappedScene& scene, int width, int height);

}  // namespace xnewell
