#pragma once

#include "depthsort/box_grid.h"
#include "depthsort/depth_sort.h"
#include "depthsort/region.h"

namespace xnewell {

/// Whose part a piece is.
struct PieceOf {
  int face;    ///< index into SnappedScene::faces
  int parent;  ///< fragment id of what was split
};

/// The rows of `area` that a polygon with this bounding box reaches. With its vertices rounded to pixels
/// (`inPixels`) it may reach others: then all of them.
[[nodiscard]] PixelArea rowsOf(const ScreenBox& box, const PixelArea& area, bool inPixels);

/// Appends a piece, with the cuts that bound its region, to what was sorted. `area` is where it may paint.
void enterPiece(SortedScene& sorted, const PieceOf& of, const Region& region, const PixelArea& area);

}  // namespace xnewell
