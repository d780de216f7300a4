#pragma once

#include <vector>

#include "geometry/view/project.h"
#include "geometry/view/view.h"

namespace xnewell {

/// Intensities by depth: color = max - (z1 + z2 + z3) / a. The z of a face is the mean of its corners' z,
/// along the viewing direction. It is measured from the nearest face, which has the intensity 1. The constant
/// a gives the farthest face the intensity 0, so the picture uses the whole range. Returns one intensity in
/// [0, 1] for each of snapped.faces; all are 1 if all faces have the same depth.
[[nodiscard]] std::vector<double> depthIntensities(const Mesh& mesh, const SnappedScene& snapped,
                                                   const ViewSpec& view);

}  // namespace xnewell
