#pragma once

#include "shading/views.h"

/// The colour table as a picture: the page of colors_page.h, all cells as a strip below it with how much the
/// picture uses each, and the number of levels that differ. The inspected cell is lit, in the grid, in the
/// strip and in the picture alike, for it is the cell that is stored.
[[nodiscard]] ColoredImage drawColors(Picture& picture, const ViewSettings& settings);
