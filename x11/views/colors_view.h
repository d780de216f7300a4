#pragma once

#include "x11/views/views.h"

namespace xnewell {

/// The colour table as a picture: the page of colors_page.h, all cells as a strip below it with how much the
/// picture uses each, and the number of levels that differ. Where a cell is lit, it is so in the grid, in the
/// strip and in the picture alike, for it is the cell that is stored; it is then the inspected one, if no
/// other is asked for.
[[nodiscard]] ColoredImage drawColors(const Picture& picture, const ViewSettings& settings);
[[nodiscard]] PictureSettings pictureForColors(const ViewSettings& settings);

}  // namespace xnewell
