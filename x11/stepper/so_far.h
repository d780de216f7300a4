#pragma once

#include <cstddef>
#include <vector>

#include "shading/picture/picture.h"

namespace xnewell {

/// The picture of a run after any number of its fragments, whether the steps go forward or back.
class SoFar {
 public:
  /// A run over picture.snapped(), which outlives it. Within so many bytes it keeps copies of the image,
  /// evenly spaced along the run as at() passes there, so that going back paints at most a space again.
  SoFar(const Picture& picture, const SortedScene& sorted, std::uint8_t ground, std::size_t bytes);
  SoFar(const SoFar&) = delete;  // its painter refers to its picture
  SoFar& operator=(const SoFar&) = delete;
  ~SoFar() = default;

  /// Valid until the next call. 0 <= painted <= SortedScene::fragments.size().
  [[nodiscard]] const IndexImage& at(int painted);

 private:
  static constexpr int kMostCopies = 256;

  const Picture picture_;
  const SortedScene& sorted_;
  SurfacePainter painter_;
  IndexImage image_;
  int painted_ = 0;                 ///< fragments in image_
  int space_ = 0;                   ///< fragments from copy to copy; 0: no copies are kept
  std::vector<IndexImage> copies_;  ///< the k-th shows k space_ fragments
};

}  // namespace xnewell
