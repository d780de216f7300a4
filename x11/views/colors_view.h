#pragma once

#include "x11/views/views.h"

namespace xnewell {

/// The colour table as a picture: the page of colors_page.h, below it the strip of all cells with how much
/// the picture uses each, and the number of levels that differ. A lit cell is lit in the grid, in the strip
/// and in the picture, because the light is stored in the cell itself. It is also the inspected cell, unless
/// another is asked for.
[[nodiscard]] ColoredImage drawColors(const Picture& picture, const ViewSettings& settings);
[[nodiscard]] PictureSettings pictureForColors(const ViewSettings& settings);

}  // namespace xnewell
