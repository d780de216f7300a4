#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>

#include "depthsort/depth_sort.h"
#include "depthsort/region.h"
#include "geometry/view/scanline.h"

namespace xnewell {

/// The samples of fragments. A piece owns those samples of its face that are on its side of every cut. So the
/// pieces of a face own each of its samples exactly once, and a cut needs no vertices.

/// Columns of a row: the first one, and the first one outside.
struct Columns {
  int from, to;
};

/// Where a cut crosses the rows of a picture.
///
/// The samples of row j lie on the line's other side from column ceil(t) on, t = p + q (j + 1/2), with p =
/// -c / (a g) - 1/2, q = -b / a, and g grid steps a pixel. The coefficients of a Line have relative errors of
/// at most 6 u, u = 2^-53. So the errors of p and q are at most 16 u (|p| + 1) and 15 u |q|, and that of t is
/// at most 18 u (|p| + |q| j + 1) < radius_. If an integer lies that near to t, the planes are asked.
class CutWalk {
 public:
  CutWalk(const SnappedScene& scene, const CutLine& cut)
      : over_{&scene.planes[cut.over]}, under_{&scene.planes[cut.under]} {
    const Line line = Regions{scene}.cut(cut.over, cut.under);
    rises_ = line.a > 0, falls_ = line.a < 0;
    if (line.a == 0) return;
    p_ = -line.c / (line.a * kGrid) - 0.5;
    q_ = -line.b / line.a;
    radius_ = 0x1p-48 * (std::abs(p_) + std::abs(q_) * kMostRows + 1);
  }

  /// Leaves those columns of row j whose samples are on the cut's side.
  void clip(int j, Columns& columns) const {
    if (rises_)
      columns.from = column(j, columns);
    else if (falls_)
      columns.to = column(j, columns);
    else if (!keeps(columns.from, j))  // the same for the whole row
      columns.to = columns.from;
  }

 private:
  static constexpr int kMostRows = 8192;

  [[nodiscard]] bool keeps(int i, int j) const { return nearer(*over_, *under_, i, j) > 0; }
  /// The first of these columns whose sample is to the right of the line.
  [[nodiscard]] int column(int j, const Columns& columns) const {
    const double t = p_ + q_ * (j + 0.5);
    if (t + radius_ <= columns.from) return columns.from;
    if (t - radius_ > columns.to - 1) return columns.to;
    int low = std::max(columns.from, static_cast<int>(std::ceil(t - radius_)));
    int high = static_cast<int>(std::ceil(std::min(t + radius_, static_cast<double>(columns.to))));
    while (low < high) {
      const int i = low + (high - low) / 2;
      if (keeps(i, j) == rises_)
        high = i;
      else
        low = i + 1;
    }
    return low;
  }

  const ScreenPlane *over_, *under_;
  bool rises_ = false, falls_ = false;  ///< to the right, the plane above gets nearer, or farther
  double p_ = 0, q_ = 0, radius_ = 0;
};

/// The samples on a piece's side of all its cuts.
class PieceWalk {
 public:
  PieceWalk(const SnappedScene& scene, const SortedScene& sorted, const Piece& piece) : area_{piece.area} {
    for (int k = piece.firstCut; k < piece.firstCut + piece.cuts; ++k)
      cuts_.emplace_back(scene, sorted.cuts[k]);
  }

  /// Those among `columns` of row j. If there are none, from >= to.
  [[nodiscard]] Columns within(int j, Columns columns) const {
    columns = {std::max(columns.from, area_.left), std::min(columns.to, area_.right)};
    for (const CutWalk& cut : cuts_) {
      if (columns.from >= columns.to) break;
      cut.clip(j, columns);
    }
    return columns;
  }

 private:
  PixelArea area_;
  boost::container::small_vector<CutWalk, 12> cuts_;
};

/// Calls span(row, from, to) for each run of samples in [0, width) x [0, height) that the fragment owns
/// inside an outline. The outline is its whole face, or a triangle of it.
template <class Span>
void forEachSpan(const SnappedScene& scene, const SortedScene& sorted, const Fragment& fragment,
                 const glm::ivec3* outline, int count, int width, int height, Span&& span) {
  if (fragment.piece < 0) return forEachSpan(outline, count, width, height, span);

  const Piece& piece = sorted.pieces[fragment.piece];
  const PieceWalk walk{scene, sorted, piece};
  forEachSpan(outline, count, piece.area.top, width, std::min(height, piece.area.bottom),
              [&](int row, int from, int to) {
                const Columns columns = walk.within(row, {from, to});
                if (columns.from < columns.to) span(row, columns.from, columns.to);
              });
}

/// The same for the whole face.
template <class Span>
void forEachSpan(const SnappedScene& scene, const SortedScene& sorted, const Fragment& fragment, int width,
                 int height, Span&& span) {
  const SnappedFace& face = scene.faces[fragment.face];
  forEachSpan(scene, sorted, fragment, &scene.vertices[face.first], face.count, width, height, span);
}

}  // namespace xnewell
