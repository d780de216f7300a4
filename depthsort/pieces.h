#pragma once

#include "depthsort/box_grid.h"
#include "depthsort/depth_sort.h"
#include "depthsort/region.h"

namespace xnewell {

/// How far a fragment reaches on the screen grid and in z. The extents never fall short. They are at most a
/// step too large where a corner or a depth is not an integer.
struct Extents {
  ScreenBox box;
  int zFar = 0, zNear = 0;  ///< z steps, larger is nearer
};

/// The extents of a face, which has its plane or is throughVertices.
[[nodiscard]] Extents extentsOf(const SnappedScene& scene, const SnappedFace& face);
/// The extents of a piece of the face, from those of its parent.
[[nodiscard]] Extents extentsOf(const SnappedScene& scene, const SnappedFace& face, const Region& piece,
                                const Extents& parent);

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
