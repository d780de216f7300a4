#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace xnewell {

/// The closed intervals that an item occupies in six dimensions; single, for the search is bound by memory.
struct ItemBox {
  int item = 0;
  int group = 0;                       ///< pairs within a group are of no interest
  std::array<float, 8> low{}, high{};  ///< the last two are 0: eight are compared at once
};

[[nodiscard]] bool overlap(const ItemBox& P, const ItemBox& Q);

struct BoxCut {
  int axis = -1;  ///< -1: none is worth its trouble
  float at = 0.0f;
};

/// So many boxes are compared all with all sooner than cut.
constexpr std::size_t kFewBoxes = 64;

/// The median of a sample along the axis where it leaves the fewest pairs of two groups to compare.
[[nodiscard]] BoxCut chooseCut(std::span<const ItemBox> boxes);

/// Calls visit(item, item) for every pair of boxes of two groups that overlap, now and then twice. Halves the
/// set, boxes across the cut in both halves, until few are left or no cut parts them; then compares each with
/// all of other groups. `boxes` is used up.
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
  if (boxes.size() > kFewBoxes) std::ranges::sort(boxes, {}, &ItemBox::group);
  std::size_t run = 0;  // where the run of boxes of the same group as box i begins
  for (std::size_t i = 1; i < boxes.size(); ++i) {
    if (boxes[i].group != boxes[i - 1].group) run = i;
    for (std::size_t j = 0; j < run; ++j)
      if (overlap(boxes[j], boxes[i]) && boxes[j].group != boxes[i].group)
        visit(boxes[j].item, boxes[i].item);
  }
}

}  // namespace xnewell
