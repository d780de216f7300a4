#pragma once

#include <optional>

#include "shading/color/colored_image.h"
#include "shading/color/palette.h"
#include "shading/color/rgb_image.h"

namespace xnewell {

/// A picture of at most 256 colours as cells: its own colours, ascending by red, green and blue, in cells 0
/// and up, the others black. Nothing where it has more.
[[nodiscard]] std::optional<ColoredImage> inFewColors(const RgbImage& picture);

}  // namespace xnewell
