#pragma once

#include <cstddef>
#include <vector>

#include "shading/picture/picture.h"

namespace xnewell {

/// The picture of a run as it is when so many of its fragments are painted, forward or back.
class SoFar {
 public:
  /// Picture and run outlive it; the picture may be made again, of the same polygons. Within so many bytes it
  /// keeps copies of the picture, evenly spaced along the run as at() passes there, so that going back paints
  /// at most a space again.
  SoFar(const Picture& picture, const SortedScene& sorted, std::uint8_t ground, std::size_t bytes);

  /// Valid until the next call. 0 <= painted <= SortedScene::fragments.size().
  [[nodiscard]] const IndexImage& at(int painted);

 private:
  static constexpr int kMostCopies = 256;

  const Picture& picture_;
  const SortedScene& sorted_;
  IndexImage image_;
  int painted_ = 0;                 ///< fragments in image_
  int space_ = 0;                   ///< fragments from copy to copy; 0: none are kept
  std::vector<IndexImage> copies_;  ///< the k-th after k space_ fragments
};

}  // namespace xnewell
