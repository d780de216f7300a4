#pragma once

#include <vector>

#include "depthsort/depth_sort.h"
#include "depthsort/order.h"
#include "geometry/view/view.h"

namespace xnewell {

/// What decides what is seen in a picture: the fragments back to front, or, for orders by sample, the visible
/// face at each sample, row by row, or kNothing (oracle.h). The other one is empty.
struct Visibility {
  SortedScene sorted;
  std::vector<int> faces;
};

/// Applies any of kOrders. For the exact ones the scene has planes (scene_planes.h); `view` is its view.
/// @throws what depthSort() and bspTree() throw
[[nodiscard]] Visibility visibilityOf(const SnappedScene& scene, const ViewSpec& view, Order order,
                                      const SortSettings& settings);

}  // namespace xnewell
