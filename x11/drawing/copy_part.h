#pragma once

#include <algorithm>

#include "shading/color/index_image.h"
#include "x11/drawing/rect.h"

namespace xnewell {

/// Copies a part of one image into another, where its upper left pixel becomes (x, y). Pixels that the first
/// image does not have are left out; the second has room for the rest.
inline void copyPart(const IndexImage& from, const Rect& part, IndexImage& to, int x, int y) {
  const Rect r = intersection(part, {0, 0, from.width, from.height});
  for (int j = 0; j < r.height; ++j) std::copy_n(from.row(r.y + j) + r.x, r.width, to.row(y + j) + x);
}

}  // namespace xnewell
