#include "geometry/exact/overlap.h"

#include <cmath>
#include <functional>

namespace xnewell {

// Do not inline this function. Compiled on its own, the loop becomes four vector comparisons; inlined, it
// does not.
[[gnu::noinline]] bool overlap(const ItemBox& P, const ItemBox& Q) {
  int apart = 0;  // no branches: no one can predict along which axis two boxes are apart
  for (int axis = 0; axis < 8; ++axis)
    apart |= int{P.low[axis] > Q.high[axis]} | int{Q.low[axis] > P.high[axis]};
  return apart == 0;
}

BoxCells::BoxCells(std::span<const ItemBox> sample, std::size_t boxes, double boxesWide) {
  const std::size_t count = sample.size();
  std::array<Axis, 6> all;
  std::array<double, 6> cells{};  // of the middle nine tenths of the boxes
  std::vector<float> centres(count), widths(count);
  for (int axis = 0; axis < 6; ++axis) {
    for (std::size_t s = 0; s < count; ++s) {
      const ItemBox& box = sample[s];
      centres[s] = (box.low[axis] + box.high[axis]) / 2.0f;
      widths[s] = box.high[axis] - box.low[axis];
    }
    std::ranges::sort(centres);
    std::ranges::nth_element(widths, widths.begin() + count / 2);
    const float from = centres[count / 20], to = centres[count - 1 - count / 20];
    const double width = boxesWide * widths[count / 2];
    all[axis] = {axis, 1, from, 0.0f};
    cells[axis] = width > 0.0 ? std::min(1024.0, (to - from) / width) : to > from ? 1024.0 : 1.0;
    if (cells[axis] >= 2.0) all[axis].perUnit = static_cast<float>(cells[axis] / (to - from));
  }
  std::ranges::sort(all, std::greater{}, [&](const Axis& a) { return cells[a.axis]; });
  std::copy_n(all.begin(), 3, axes_.begin());

  // No more cells than boxes: where there would be more, they are larger.
  double product = 1.0;
  for (const Axis& a : axes_) product *= std::max(1.0, cells[a.axis]);
  const double larger = std::max(1.0, std::cbrt(product / static_cast<double>(boxes)));
  for (Axis& a : axes_) {
    a.cells = static_cast<int>(std::max(1.0, cells[a.axis] / larger));
    a.perUnit = a.cells == 1 ? 0.0f : a.perUnit / static_cast<float>(larger);
  }
}

BoxCut chooseCut(std::span<const ItemBox> boxes) {
  constexpr std::size_t kSample = 17;
  if (boxes.size() <= kFewBoxes) return {};
  std::array<const ItemBox*, kSample> sample;
  for (std::size_t s = 0; s < kSample; ++s) sample[s] = &boxes[s * boxes.size() / kSample];
  std::ranges::sort(sample, {}, &ItemBox::group);
  // If the sample is of one group, few boxes are of others: then count all pairs.
  const bool oneGroup = sample.front()->group == sample.back()->group;
  const auto pairsAmong = [&](const auto& isIn) {
    std::size_t pairs = 0, seen = 0, seenOfOthers = 0;
    for (std::size_t s = 0; s < kSample; ++s) {
      if (s > 0 && (oneGroup || sample[s]->group != sample[s - 1]->group)) seenOfOthers = seen;
      if (isIn(*sample[s])) pairs += seenOfOthers, ++seen;
    }
    return pairs;
  };

  BoxCut best;
  const std::size_t all = pairsAmong([](const ItemBox&) { return true; });
  std::size_t fewest = all * 4 / 5;  // a cut must save a fifth of the pairs; it can save half at best
  for (int axis = 0; axis < 6 && fewest > all * 11 / 20; ++axis) {
    std::array<float, kSample> centre;
    for (std::size_t s = 0; s < kSample; ++s)
      centre[s] = (sample[s]->low[axis] + sample[s]->high[axis]) / 2.0f;
    const auto median = centre.begin() + kSample / 2;
    std::nth_element(centre.begin(), median, centre.end());
    const float at = *median;
    const std::size_t pairs = pairsAmong([&](const ItemBox& box) { return box.low[axis] < at; }) +
                              pairsAmong([&](const ItemBox& box) { return box.high[axis] >= at; });
    if (pairs < fewest) fewest = pairs, best = {axis, at};
  }
  return best;
}

}  // namespace xnewell
