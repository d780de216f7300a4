#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace xnewell {

/// Scan conversion of a convex polygon, as the textbook teaches it: the edges, those that are active in a
/// row, the spans between them, and the samples of a span. It is written to be read. The filler steps along
/// the edges by additions (geometry/view/scanline.h); tests hold it against this file, sample by sample.
/// Space: screen, x right, y down. Vertices are on the grid of 1/65536 pixel, |x|, |y| <= 2^29; the outline
///        runs counter-clockwise as seen on the screen. The sample of pixel (i, j) is its centre, (i + 1/2,
///        j + 1/2). A sample on a left or a top edge belongs to the polygon, one on a right or a bottom edge
///        does not: so neighbours share no sample and leave none out.
/// @see Foley & van Dam 2e §3.6

/// An edge that spans at least one row of samples. Horizontal edges span none.
struct ScanEdge {
  int from = 0, to = 0;          ///< its vertices, indices into the outline, as the outline runs
  glm::ivec2 top{0}, bottom{0};  ///< its ends on the grid, top.y < bottom.y
  int firstRow = 0, endRow = 0;  ///< it spans the rows [firstRow, endRow)
  /// How far x moves to the right from one row to the next, in pixels.
  [[nodiscard]] double step() const;
  /// Where the edge crosses the samples of a row, in pixels; off by at most 2^-37 in the picture.
  [[nodiscard]] double x(int row) const;
  /// The first sample of a row on the edge or to the right of it. Exact.
  [[nodiscard]] int firstColumn(int row) const;

  bool left = false;  ///< the polygon is to the right of it
};

/// The edges in the order of their first rows; of two with the same, the left one first.
[[nodiscard]] std::vector<ScanEdge> edgesOf(std::span<const glm::ivec3> outline);

/// The samples `from` to `to` - 1 of a row. There may be none: then from == to.
struct ScanSpan {
  int row = 0, from = 0, to = 0;
  int left = 0, right = 0;  ///< the active edges, indices into edgesOf()
};

/// All rows from the first to the last, from top to bottom. The outline is not clipped to a picture.
[[nodiscard]] std::vector<ScanSpan> spansOf(std::span<const ScanEdge> edges);

}  // namespace xnewell
