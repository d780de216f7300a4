#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/view/project.h"

namespace xnewell {

/// The order in which faces are painted, that is, the hidden-surface method.
enum class Order { Unsorted, ZMean, ZSort, Newell, Oracle };
struct OrderRow {
  Order id;
  std::string_view name, label, rule;
};
inline constexpr std::array kOrders{
    OrderRow{Order::Unsorted, "none", "none", "as the scene lists them"},
    OrderRow{Order::ZMean, "zmean", "z mean", "by the mean z of the vertices, farthest first"},
    OrderRow{Order::ZSort, "zsort", "z far", "by the farthest z, farthest first"},
    OrderRow{Order::Newell, "newell", "Newell",
             "by the depth sort; it splits polygons that have no order (depth_sort.h)"},
    OrderRow{Order::Oracle, "oracle", "oracle", "none: each sample finds its nearest face (oracle.h)"},
};

/// Indices into scene.faces in painting order, for the orders that sort by one key. At equal z the later face
/// in the scene is painted later, so it wins. Means are rounded to a z step before they are compared. The
/// sorts by z give a decent picture and no guarantee. @see Foley & van Dam 2e §15.5.1
[[nodiscard]] std::vector<int> paintingOrder(const SnappedScene& scene, Order order);

/// The indices 0..#keys-1 in ascending order of key; equal keys stay in order of index (a stable sort). It is
/// a radix sort with three passes of 11 bits. Work: linear in #keys.
[[nodiscard]] std::vector<int> sortedByKey(std::span<const std::uint32_t> keys);

}  // namespace xnewell
