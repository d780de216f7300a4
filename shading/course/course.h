#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace xnewell {

/// Interpolation over a triangle, as the textbook teaches it. It is written to be read. The fillers step the
/// same values along rows, or evaluate eight pixels at once (shading/fill); tests hold them against this
/// file.

/// How much each vertex counts at a place. The three add up to 1.
using Weights = std::array<double, 3>;

/// The weights of the vertices at the sample of pixel (i, j), on the screen: each is the area of the triangle
/// between the sample and the opposite side, over the whole area. Vertices are on the grid of 1/65536 pixel.
/// A triangle narrower than 2^-12 pixel has the mean everywhere, because the grid decides how its values
/// grow.
[[nodiscard]] Weights weightsOnScreen(const std::array<glm::ivec3, 3>& p, int i, int j);
/// The same at the origin, where the vertices are in pixels.
[[nodiscard]] Weights weightsOfOrigin(const std::array<glm::dvec2, 3>& p);

/// The weights at the place of the surface that is seen there. In perspective the far end of a side takes
/// less of the screen than the near end. 1/w is linear over the screen (w is the depth), and so is a value
/// over w. So each weight is divided by its vertex' depth, and all by their sum.
[[nodiscard]] Weights weightsInWorld(const Weights& onScreen, const std::array<double, 3>& overDepth);

/// The weighted sum of the values at the vertices. Gouraud's intensity takes the weights on the screen; a
/// texture coordinate, a place and a normal take those in the world. Phong's N is the sum of the normals made
/// a unit vector.
template <class Value>
[[nodiscard]] Value interpolated(const Weights& weights, const std::array<Value, 3>& v) {
  return weights[0] * v[0] + weights[1] * v[1] + weights[2] * v[2];
}

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

/// Values that are stepped over a triangle by additions, as the textbook teaches it: one increment from
/// pixel to pixel, another from row to row. They are whole numbers of steps of 2^-bits, so additions are
/// exact, and all error is in the rounding of the increments. It is written to be read. The filler has 24
/// bits (shading/fill/affine.h); tests hold it against this file, bit by bit.
/// @see Foley & van Dam 2e §3.6, §16.2.4 (Gouraud 1971)
struct SteppedPlane {
  int bits = 24;  ///< after the binary point
  /// At the centre of pixel (0, 0), and the two increments.
  std::int64_t c = 0, perColumn = 0, perRow = 0;

  /// The value at the centre of pixel (i, j), in steps.
  [[nodiscard]] std::int64_t at(int i, int j) const { return c + perColumn * i + perRow * j; }
  /// Steps as a number.
  [[nodiscard]] double number(std::int64_t steps) const {
    return static_cast<double>(steps) / static_cast<double>(std::int64_t{1} << bits);
  }
  bool operator==(const SteppedPlane&) const = default;
};

/// The plane through v[k] at vertex k. The filler steps places on a ramp of cells, 11.5 + 239 I (ramp.h).
/// Vertices are on the grid of 1/65536 pixel, |x|, |y| <= 2^29, and the triangle has an area; |v[k]| < 256; 0
/// <= bits <= 24. The values are rounded to steps, and the increments to steps a pixel, each to the nearest,
/// of two the even one. Where the values grow by more than 2^20 a pixel, the triangle is a sliver, and has
/// the mean everywhere.
[[nodiscard]] SteppedPlane steppedOver(const std::array<glm::ivec3, 3>& p, const std::array<double, 3>& v,
                                       int bits);

}  // namespace xnewell
