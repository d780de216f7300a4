#include "depthsort/order.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace xnewell {

std::vector<int> sortedByKey(std::span<const std::uint32_t> keys) {
  constexpr int kBits = 11, kDigits = 1 << kBits;
  const auto digit = [](std::uint32_t key, int pass) { return (key >> (pass * kBits)) & (kDigits - 1); };
  if (keys.size() < kDigits / 4) {  // counting would cost more
    std::vector<int> order(keys.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int i) { return keys[i]; });
    return order;
  }
  std::array<std::array<int, kDigits>, 3> count{};
  for (const std::uint32_t key : keys)
    for (int pass = 0; pass < 3; ++pass) ++count[pass][digit(key, pass)];

  std::vector<int> order(keys.size()), next(keys.size());
  std::iota(order.begin(), order.end(), 0);
  for (int pass = 0; pass < 3; ++pass) {
    int begin = 0;
    for (int& c : count[pass]) begin += std::exchange(c, begin);
    for (const int i : order) next[count[pass][digit(keys[i], pass)]++] = i;
    order.swap(next);
  }
  return order;
}

std::vector<int> paintingOrder(const SnappedScene& scene, Order order) {
  std::vector<std::uint32_t> keys(scene.faces.size());
  if (order == Order::ZMean || order == Order::ZSort) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const SnappedFace& face = scene.faces[i];
      std::int64_t sum = 0;
      std::int32_t farthest = scene.vertices[face.first].z;
      for (int v = face.first; v < face.first + face.count; ++v) {
        sum += scene.vertices[v].z;
        farthest = std::min(farthest, scene.vertices[v].z);
      }
      keys[i] =
          static_cast<std::uint32_t>(order == Order::ZSort ? farthest : (sum + face.count / 2) / face.count);
    }
  }
  return sortedByKey(keys);
}

}  // namespace xnewell
