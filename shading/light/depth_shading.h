#pragma once

#include <vector>

#include "geometry/view/project.h"
#include "geometry/view/view.h"

namespace xnewell {

/// Depth for intensity: color = max - (z1 + z2 + z3) / a. A face has the mean z of its corners, along the
/// viewing direction and from the nearest such mean; a makes the farthest 0, so the picture uses the whole
/// range. Of each of snapped.faces, in [0, 1]; all 1 where none is farther than another.
[[nodiscard]] std::vector<double> depthIntensities(const Mesh& mesh, const SnappedScene& snapped,
                                                   const ViewSpec& view);

}  // namespace xnewell
