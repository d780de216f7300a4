#pragma once

#include <cstddef>
#include <vector>

#include "shading/picture/picture.h"

namespace xnewell {

/// The picture of a run after any number of its fragments, whether the steps go forward or back.
class SoFar {
 public:
  /// Picture and run must outlive it; the picture may be made again if its polygons stay the same. When at()
  /// passes, it keeps copies of the picture at even spaces along the run, in at most `bytes` bytes. So going
  /// back paints at most one space again.
  SoFar(const Picture& picture, const SortedScene& sorted, std::uint8_t ground, std::size_t bytes);

  /// Valid until the next call. 0 <= painted <= SortedScene::fragments.size().
  [[nodiscard]] const IndexImage& at(int painted);

 private:
  static constexpr int kMostCopies = 256;

  const Picture& picture_;
  const SortedScene& sorted_;
  IndexImage image_;
  int painted_ = 0;                 ///< fragments in image_
  int space_ = 0;                   ///< fragments from copy to copy; 0: no copies are kept
  std::vector<IndexImage> copies_;  ///< the k-th shows k space_ fragments
};

}  // namespace xnewell
