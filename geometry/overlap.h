#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

/// The closed intervals that an item occupies in six dimensions.
struct ItemBox {
  int item = 0;
  std::array<double, 6> low, high;
};

[[nodiscard]] inline bool overlap(const ItemBox& P, const ItemBox& Q) {
  bool apart = false;  // without branches: which axis parts two is anyone's guess
  for (int axis = 0; axis < 6; ++axis) apart |= (P.low[axis] > Q.high[axis]) | (Q.low[axis] > P.high[axis]);
  return !apart;
}

struct BoxCut {
  int axis = -1;  ///< -1: none is worth its trouble
  double at = 0.0;
};

/// The median of a sample along the axis where it leaves the fewest pairs to compare.
[[nodiscard]] BoxCut chooseCut(std::span<const ItemBox> boxes);

/// Calls visit(item, item) for every pair of boxes that overlap, now and then twice. Halves the set, boxes
/// across the cut in both halves, until few are left or no cut parts them; then compares all pairs.
/// `boxes` is used up.
template <class Visit>
void forOverlapping(std::span<ItemBox> boxes, const Visit& visit) {
  const BoxCut cut = chooseCut(boxes);
  if (cut.axis >= 0) {
    // Below the cut, above it, across it. The last two are one half; the place of those above is then free
    // for those across, to make the other.
    const auto above = std::partition(boxes.begin(), boxes.end(),
                                      [&](const ItemBox& box) { return box.high[cut.axis] < cut.at; });
    const auto across =
        std::partition(above, boxes.end(), [&](const ItemBox& box) { return box.low[cut.axis] >= cut.at; });
    // What the sample promised the whole set must keep in part, or the halves might not get smaller.
    const auto few = static_cast<std::ptrdiff_t>(boxes.size() / 20);
    if (above - boxes.begin() > few && across - above > few) {
      const std::vector<ItemBox> both(across, boxes.end());
      forOverlapping(std::span<ItemBox>(above, boxes.end()), visit);
      forOverlapping(std::span<ItemBox>(boxes.begin(), std::copy(both.begin(), both.end(), above)), visit);
      return;
    }
  }
  for (std::size_t i = 1; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (overlap(boxes[j], boxes[i])) visit(boxes[j].item, boxes[i].item);
}
