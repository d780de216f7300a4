#pragma once

#include <optional>

#include "shading/color/colored_image.h"
#include "shading/color/palette.h"
#include "shading/color/rgb_image.h"

namespace xnewell {

/// Converts a picture of at most 256 colours to an index image. Its colours fill cells 0 and up, in ascending
/// order of red, then green, then blue; the other cells are black. Returns nothing if the picture has more
/// than 256 colours.
[[nodiscard]] std::optional<ColoredImage> inFewColors(const RgbImage& picture);

}  // namespace xnewell
