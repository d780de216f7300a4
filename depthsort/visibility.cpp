#include "depthsort/visibility.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "depthsort/bsp_tree.h"
#include "depthsort/oracle.h"
#include "depthsort/z_buffer.h"
#include "geometry/view/scene_planes.h"

namespace xnewell {

namespace {

/// Whole faces, back to front, for an order that splits none.
SortedScene inOrder(const SnappedScene& scene, Order order) {
  SortedScene sorted;
  std::ranges::transform(paintingOrder(scene, order), std::back_inserter(sorted.fragments),
                         [](int face) { return Fragment{face}; });
  sorted.statistics.bytes = bytesOf(sorted);
  return sorted;
}

Visibility bySample(ZBuffer buffer) {
  Visibility result{{}, std::move(buffer.faces)};
  result.sorted.statistics.depthTests = buffer.tests;
  result.sorted.statistics.bytes = buffer.bytes;
  return result;
}

}  // namespace

Visibility visibilityOf(const SnappedScene& scene, const ViewSpec& view, Order order,
                        const SortSettings& settings) {
  if (settings.planes && order != Order::Newell && rowOf(order).exact) settings.planes->makeAll();
  switch (order) {
    case Order::Unsorted:
    case Order::ZMean:
    case Order::ZSort:
      break;
    case Order::Newell:
      return {depthSort(scene, settings), {}};
    case Order::Bsp:
      return {backToFront(bspTree(scene, settings)), {}};
    case Order::ZBuffer16:
    case Order::ZBuffer24:
    case Order::ZBuffer32:
      return bySample(zBuffer(scene, view, rowOf(order).bits, settings.width, settings.height));
    case Order::Oracle:
      return {{}, visibleFaces(scene, settings.width, settings.height)};
  }
  return {inOrder(scene, order), {}};
}

}  // namespace xnewell
