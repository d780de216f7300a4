#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

/// Which boxes overlap: the closed intervals do in all of six dimensions.
struct PlaceBox {
  int item = 0;
  std::array<double, 6> low, high;
};

/// Halves a set of boxes, those across the cut in both halves, until few are left or no cut parts them, and
/// then compares all pairs. Calls visit(item, item) for every pair that overlaps, now and then twice.
/// The cut is the median of a sample along the dimension where it leaves the fewest pairs to compare.
template <class Visit>
void forOverlappingBoxes(std::vector<PlaceBox> boxes, Visit&& visit) {
  constexpr std::size_t kFew = 24, kSample = 25;
  const auto pairs = [](std::size_t left, std::size_t right) {
    return static_cast<double>(left) * static_cast<double>(left) +
           static_cast<double>(right) * static_cast<double>(right);
  };
  constexpr double kGain = 0.8;  // of the pairs may be left by a cut that is worth its trouble

  std::vector<std::vector<PlaceBox>> sets;
  sets.push_back(std::move(boxes));
  while (!sets.empty()) {
    std::vector<PlaceBox> set = std::move(sets.back());
    sets.pop_back();
    int along = -1;
    double cut = 0.0;
    if (set.size() > kFew) {
      double fewest = kGain * pairs(kSample, 0);
      for (int axis = 0; axis < 6; ++axis) {
        std::array<const PlaceBox*, kSample> sample;
        for (std::size_t s = 0; s < kSample; ++s) sample[s] = &set[s * set.size() / kSample];
        std::array<double, kSample> centre;
        for (std::size_t s = 0; s < kSample; ++s) centre[s] = sample[s]->low[axis] + sample[s]->high[axis];
        std::nth_element(centre.begin(), centre.begin() + kSample / 2, centre.end());
        const double median = centre[kSample / 2] / 2.0;
        std::size_t left = 0, right = 0;
        for (const PlaceBox* box : sample)
          left += box->low[axis] < median, right += box->high[axis] >= median;
        if (pairs(left, right) < fewest) fewest = pairs(left, right), along = axis, cut = median;
      }
    }
    if (along >= 0) {
      std::vector<PlaceBox> left, right;
      for (const PlaceBox& box : set) {
        if (box.low[along] < cut) left.push_back(box);
        if (box.high[along] >= cut) right.push_back(box);
      }
      if (std::max(left.size(), right.size()) < set.size()) {
        sets.push_back(std::move(right));
        sets.push_back(std::move(left));
        continue;
      }
    }
    for (std::size_t i = 1; i < set.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const PlaceBox &P = set[j], &Q = set[i];
        bool apart = false;
        for (int axis = 0; axis < 6 && !apart; ++axis)
          apart = P.low[axis] > Q.high[axis] || Q.low[axis] > P.high[axis];
        if (!apart) visit(P.item, Q.item);
      }
  }
}
