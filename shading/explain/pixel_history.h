#pragma once

#include <vector>

#include "shading/laboratory/exactness.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// What was painted at one pixel, in which order, and which face should show there.

struct PaintedHere {
  Fragment fragment;  ///< a face, or a piece of one that the depth sort cut
  double z = 0;       ///< its depth at the sample, in pixels of the view plane; larger is nearer
};

struct PixelHistory {
  /// In the order of painting, so the last one shows. An order that decides each sample by itself paints one
  /// face alone; here are all the faces at the sample, as they were looked at, and `shown` says which won.
  std::vector<PaintedHere> painted;
  int shown = -1;  ///< index into `painted`; -1 if no face shows
  /// Faces at the sample that were not painted: the quick depth sort drops what shows nowhere.
  int notPainted = 0;
  SampleCheck check = SampleCheck::Nothing;  ///< is the right face shown?
  int nearest = -1;  ///< the face that should show, an index into snapped().faces; -1 if there is none
};

/// 0 <= i < width, 0 <= j < height. Work: about one edge test for each face of the picture.
[[nodiscard]] PixelHistory historyOf(const Picture& picture, int i, int j);

}  // namespace xnewell
