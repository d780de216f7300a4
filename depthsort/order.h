#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/view/project.h"

namespace xnewell {

/// The order in which faces are painted, that is, the hidden-surface method.
enum class Order { Unsorted, ZMean, ZSort, Newell, Bsp, ZBuffer16, ZBuffer24, ZBuffer32, Oracle };
struct OrderRow {
  Order id;
  std::string_view name, label, rule;
  std::string_view text;   ///< for a caption
  std::string_view words;  ///< where two set-ups are compared
  /// True if every sample shows the right face of the snapped scene, except at contacts (depth_sort.h). These
  /// methods compare planes (scene_planes.h); the others need no planes.
  bool exact = false;
  /// True if it finds the face of each sample by itself. Then there is no painting order, and no polygon for
  /// an X server to fill.
  bool bySample = false;
  int bits = 0;  ///< of a depth in a z-buffer; 0 for the other methods
};
inline constexpr std::array kOrders{
    OrderRow{Order::Unsorted, "none", "none", "as the scene lists them", "not sorted", "unsorted"},
    OrderRow{Order::ZMean, "zmean", "z mean", "by the mean z of the vertices, farthest first",
             "sorted by mean z", "z-sort by mean z"},
    OrderRow{Order::ZSort, "zsort", "z far", "by the farthest z, farthest first", "sorted by farthest z",
             "z-sort by farthest z"},
    OrderRow{Order::Newell, "newell", "Newell",
             "by the depth sort; it splits polygons that have no order (depth_sort.h)",
             "sorted by depth (Newell)", "Newell", /*exact=*/true},
    OrderRow{Order::Bsp, "bsp", "BSP",
             "by a BSP tree; it splits polygons by the planes of others (bsp_tree.h)",
             "walked through a BSP tree", "BSP tree", /*exact=*/true},
    OrderRow{Order::ZBuffer16, "zbuffer16", "z-buf 16",
             "none: each sample keeps the face of largest depth, in 16 bits (z_buffer.h)",
             "z-buffer of 16 bits", "16-bit z-buffer", false, /*bySample=*/true, 16},
    OrderRow{Order::ZBuffer24, "zbuffer24", "z-buf 24", "the same in 24 bits", "z-buffer of 24 bits",
             "24-bit z-buffer", false, /*bySample=*/true, 24},
    OrderRow{Order::ZBuffer32, "zbuffer32", "z-buf 32", "the same in 32 bits", "z-buffer of 32 bits",
             "32-bit z-buffer", false, /*bySample=*/true, 32},
    OrderRow{Order::Oracle, "oracle", "oracle", "none: each sample finds its nearest face (oracle.h)",
             "nearest face at each sample", "oracle", /*exact=*/true, /*bySample=*/true},
};
[[nodiscard]] constexpr const OrderRow& rowOf(Order order) { return kOrders[static_cast<int>(order)]; }

/// Indices into scene.faces in painting order, for the orders that sort by one key. At equal z the later face
/// in the scene is painted later, so it wins. Means are rounded to a z step before they are compared. The
/// sorts by z give a decent picture and no guarantee. @see Foley & van Dam 2e §15.5.1
[[nodiscard]] std::vector<int> paintingOrder(const SnappedScene& scene, Order order);

/// The indices 0..#keys-1 in ascending order of key; equal keys stay in order of index (a stable sort). It is
/// a radix sort with three passes of 11 bits. Work: linear in #keys.
[[nodiscard]] std::vector<int> sortedByKey(std::span<const std::uint32_t> keys);

}  // namespace xnewell
