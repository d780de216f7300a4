#include "shading/color/nearest_color.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace xnewell {

// A palette colour can be left out of a block's list if its least distance to the block is greater than the
// greatest distance of another colour: the other is then nearer everywhere in the block.
int NearestColor::candidates(glm::u8vec3 color) {
  assert(!palette_.empty() && palette_.size() <= 255);
  constexpr int kSide = 1 << kBits;
  std::array<int, 255> nearest;  // squared distance from each palette colour to the block
  int bound = 1 << 20;           // the least of the greatest distances
  for (std::size_t k = 0; k < palette_.size(); ++k) {
    int least = 0, greatest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int low = color[axis] & ~(kSide - 1), value = palette_[k][axis];
      const int below = low - value, above = value - (low + kSide - 1);
      const int outside = std::max({below, above, 0}), across = std::max(-below, -above);
      least += outside * outside;
      greatest += across * across;
    }
    nearest[k] = least;
    bound = std::min(bound, greatest);
  }
  const int list = static_cast<int>(candidates_.size());
  candidates_.push_back(0);
  for (std::size_t k = 0; k < palette_.size(); ++k)
    if (nearest[k] <= bound) candidates_.push_back(static_cast<std::uint8_t>(k));
  candidates_[list] = static_cast<std::uint8_t>(candidates_.size() - list - 1);
  return list;
}

}  // namespace xnewell
