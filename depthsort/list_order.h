#pragma once

#include <span>
#include <vector>

#include "depthsort/box_grid.h"
#include "depthsort/newell_run.h"

namespace xnewell {

/// True for a face and itself, and for parts of one model face in one plane. They show the same picture in
/// any order.
[[nodiscard]] inline bool oneSurface(const SnappedScene& scene, int f, int g) {
  const SnappedFace &F = scene.faces[f], &G = scene.faces[g];
  return F.number == G.number && F.plane == G.plane;
}

/// Where the polygons of a run stand in its list: cell by cell of a grid, and by farthest z within a cell.
struct ListOrder {
  BoxGrid grid;
  std::vector<int> cellBegin;  ///< #cells + 1, places in the list
  /// #cells: a face, if all faces of the cell are of one surface with it; otherwise -1
  std::vector<int> cellSurface;
  std::vector<int> byDepth;  ///< the polygons by farthest z, at equal z in scene order
  std::vector<int> place;    ///< #polygons, in the list
  std::vector<int> turns;    ///< #polygons: the places by farthest z
};

/// If `fine` is false, the grid has one cell.
[[nodiscard]] ListOrder listOrder(const SnappedScene& scene, std::span<const Polygon> polygons, bool fine);

}  // namespace xnewell
