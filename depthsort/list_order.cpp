#include "depthsort/list_order.h"

#include <algorithm>
#include <numeric>

#include "depthsort/order.h"

namespace xnewell {

ListOrder listOrder(const SnappedScene& scene, std::span<const Polygon> polygons, bool fine) {
  std::vector<ScreenBox> boxes;
  boxes.reserve(polygons.size());
  for (const Polygon& P : polygons) boxes.push_back(P.extents.box);
  ListOrder order{BoxGrid{boxes, fine}, {}, {}, {}, std::vector<int>(polygons.size()), {}};
  order.cellBegin.assign(order.grid.cells() + 1, 0);
  for (std::size_t i = 0; i < polygons.size(); ++i)
    ++order.cellBegin[(order.place[i] = order.grid.cellOf(boxes[i])) + 1];
  std::partial_sum(order.cellBegin.begin(), order.cellBegin.end(), order.cellBegin.begin());

  std::vector<std::uint32_t> keys(polygons.size());
  std::ranges::transform(polygons, keys.begin(), [](const Polygon& P) {
    return static_cast<std::uint32_t>(P.extents.zFar) ^ 0x80000000u;
  });
  order.byDepth = sortedByKey(keys);
  std::vector<int> next = order.cellBegin;
  order.turns.reserve(polygons.size());
  for (const int i : order.byDepth)
    order.turns.push_back(order.place[i] = next[order.place[i]]++);  // the place was the cell until here

  constexpr int kNone = -1;
  order.cellSurface.assign(order.grid.cells(), kNone);
  std::vector<int> inList(polygons.size());
  for (std::size_t i = 0; i < polygons.size(); ++i) inList[order.place[i]] = polygons[i].face;
  for (int c = 0; c < order.grid.cells(); ++c) {
    const auto begin = inList.begin() + order.cellBegin[c], end = inList.begin() + order.cellBegin[c + 1];
    if (begin != end && std::all_of(begin, end, [&](int f) { return oneSurface(scene, f, *begin); }))
      order.cellSurface[c] = *begin;
  }
  return order;
}

}  // namespace xnewell
