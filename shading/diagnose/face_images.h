#pragma once

#include <vector>

#include "depthsort/order.h"
#include "geometry/view/project.h"
#include "shading/diagnose/approach.h"

namespace xnewell {

/// The face that each sample shows, an index into scene.faces or kNothing, row by row from the top.

/// As a program paints that works in some way. The scene has planes.
[[nodiscard]] std::vector<int> facesShown(const SnappedScene& scene, int width, int height, PaintWay way);

/// These faces, painted one over the other in this order.
[[nodiscard]] std::vector<int> paintedOver(const SnappedScene& scene, int width, int height,
                                           const std::vector<int>& order);

}  // namespace xnewell
