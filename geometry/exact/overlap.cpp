#include "geometry/exact/overlap.h"

namespace xnewell {

// Do not inline this function. Compiled on its own, the loop becomes four vector comparisons; inlined, it
// does not.
[[gnu::noinline]] bool overlap(const ItemBox& P, const ItemBox& Q) {
  int apart = 0;  // no branches: no one can predict along which axis two boxes are apart
  for (int axis = 0; axis < 8; ++axis)
    apart |= int{P.low[axis] > Q.high[axis]} | int{Q.low[axis] > P.high[axis]};
  return apart == 0;
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
