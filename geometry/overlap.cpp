#include "geometry/overlap.h"

BoxCut chooseCut(std::span<const ItemBox> boxes) {
  constexpr std::size_t kFew = 16, kSample = 17;
  if (boxes.size() <= kFew) return {};
  std::array<const ItemBox*, kSample> sample;
  for (std::size_t s = 0; s < kSample; ++s) sample[s] = &boxes[s * boxes.size() / kSample];

  BoxCut best;
  constexpr std::size_t kAll = kSample * kSample;
  std::size_t fewest = kAll * 4 / 5;  // a cut must spare a fifth of the pairs; half is the best there is
  for (int axis = 0; axis < 6 && fewest > kAll * 11 / 20; ++axis) {
    std::array<double, kSample> twiceCentre;
    for (std::size_t s = 0; s < kSample; ++s) twiceCentre[s] = sample[s]->low[axis] + sample[s]->high[axis];
    const auto median = twiceCentre.begin() + kSample / 2;
    std::nth_element(twiceCentre.begin(), median, twiceCentre.end());
    const double at = *median / 2.0;
    std::size_t below = 0, above = 0;
    for (const ItemBox* box : sample) {
      below += box->low[axis] < at;
      above += box->high[axis] >= at;
    }
    const std::size_t pairs = below * below + above * above;
    if (pairs < fewest) fewest = pairs, best = {axis, at};
  }
  return best;
}
