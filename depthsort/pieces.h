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

/// Appends a piece, with the cuts that bound its region, to what was sorted. `box` is its bounding box, and
/// `area` is where it may paint.
void enterPiece(SortedScene& sorted, const PieceOf& of, const Region& region, const ScreenBox& box,
                const PixelArea& area);

}  // namespace xnewell
