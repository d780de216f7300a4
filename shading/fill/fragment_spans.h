#pragma once

#include <algorithm>

#include "depthsort/depth_sort.h"
#include "shading/fill/scanline.h"

namespace xnewell {

/// The samples of fragments. A piece owns those samples of its face that are on its side of every cut. Near a
/// cut, each sample is tested with the two planes of the cut. So the pieces of a face own each of its samples
/// exactly once, and a cut needs no vertices.

/// The first column of [from, to) whose sample and all later samples are on the same side of the cut, where
/// the depth difference of the two planes grows, or falls, along row j. The result is exact; the double is
/// only the first guess.
[[nodiscard]] inline int columnOfCut(const ScreenPlane& over, const ScreenPlane& under, int j, int from,
                                     int to, bool grows) {
  const auto after = [&](int i) { return (nearer(over, under, i, j) > 0) == grows; };
  const auto slope = [](const ScreenPlane& p) { return static_cast<double>(p.A) / static_cast<double>(p.C); };
  const auto x = [](int i) { return std::int64_t{i} * kGrid + kGrid / 2; };
  const double ahead = depthAt(over, x(from), x(j)) - depthAt(under, x(from), x(j));
  const double columns = -ahead / ((slope(over) - slope(under)) * kGrid);
  int low = from, high = to;  // the column lies in [low, high]
  for (int reach = 1,
           i = from + static_cast<int>(std::max(0.0, std::min(columns, static_cast<double>(to - from))));
       low < high; reach *= 2) {
    i = std::clamp(i, low, high - 1);
    if (after(i)) {
      high = i;
      i -= reach;
    } else {
      low = i + 1;
      i += reach;
    }
    if (reach > 4) i = low + (high - low) / 2;
  }
  return low;
}

struct Columns {
  int from, to;  ///< the first column, and the first one outside
};

/// The columns of row j whose samples are on a piece's side of all its cuts, among `columns`, from < to.
[[nodiscard]] inline Columns withinCuts(const SnappedScene& scene, const SortedScene& sorted,
                                        const Piece& piece, int j, Columns columns) {
  auto& [from, to] = columns;
  const CutLine *cut = sorted.cuts.data() + piece.firstCut, *const end = cut + piece.cuts;
  for (; cut != end && from < to; ++cut) {
    const ScreenPlane &over = scene.planes[cut->over], &under = scene.planes[cut->under];
    const Int128 grows = Int128{over.A} * under.C - Int128{under.A} * over.C;
    if (grows > 0)
      from = columnOfCut(over, under, j, from, to, true);
    else if (grows < 0)
      to = columnOfCut(over, under, j, from, to, false);
    else if (nearer(over, under, from, j) < 0)
      to = from;
  }
  return columns;
}

/// Calls span(row, from, to) for each run of samples in [0, width) x [0, height) that the fragment owns
/// inside an outline. The outline is its whole face, or a triangle of it.
template <class Span>
void forEachSpan(const SnappedScene& scene, const SortedScene& sorted, const Fragment& fragment,
                 const glm::ivec3* outline, int count, int width, int height, Span&& span) {
  if (fragment.piece < 0) return forEachSpan(outline, count, width, height, span);

  const Piece& piece = sorted.pieces[fragment.piece];
  const PixelArea& area = piece.area;
  forEachSpan(outline, count, area.top, std::min(width, area.right), std::min(height, area.bottom),
              [&](int row, int from, int to) {
                if (from = std::max(from, area.left); from >= to) return;
                const Columns columns = withinCuts(scene, sorted, piece, row, {from, to});
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
