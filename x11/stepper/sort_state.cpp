#include "x11/stepper/sort_state.h"

#include <algorithm>
#include <cassert>

namespace xnewell {

SoFar::SoFar(const Picture& picture, const SortedScene& sorted, std::uint8_t ground, std::size_t bytes)
    : picture_{picture},
      sorted_{sorted},
      painter_{picture_.painter()},
      image_{picture.settings().width, picture.settings().height, ground},
      copies_{image_} {
  const int most = static_cast<int>(std::min<std::size_t>(kMostCopies, bytes / image_.pixels.size()));
  if (most > 0) space_ = static_cast<int>(sorted.fragments.size()) / most + 1;
}

const IndexImage& SoFar::at(int painted) {
  assert(painted >= 0 && painted <= static_cast<int>(sorted_.fragments.size()));
  const int copy = space_ == 0 ? 0 : std::min<int>(painted / space_, static_cast<int>(copies_.size()) - 1);
  if (painted < painted_ || copy * space_ > painted_) {
    image_ = copies_[copy];
    painted_ = copy * space_;
  }
  if (painted_ == painted) return image_;
  while (painted_ < painted) {
    painter_.paint(image_, sorted_, sorted_.fragments[painted_++]);
    if (space_ > 0 && painted_ == static_cast<int>(copies_.size()) * space_) copies_.push_back(image_);
  }
  return image_;
}

}  // namespace xnewell
