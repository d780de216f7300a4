#pragma once

#include "shading/color/index_image.h"
#include "shading/color/palette.h"

namespace xnewell {

/// An index image together with the colours of its cells.
struct ColoredImage {
  IndexImage image;
  Palette palette;
};

}  // namespace xnewell
