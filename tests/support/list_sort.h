#pragma once

#include <vector>

#include "tests/support/exact_region.h"

namespace xnewell {

/// The depth sort as the textbook tells it, with a list: the reference that depthsort/depth_sort.h departs
/// from, and says why. The list is sorted by farthest z. P, the first of it, is tested against the other Q's
/// whose z-extents reach back to P's: 1, 2 extents in x and y, 3 P behind Q's plane, 4 Q in front of P's, 5
/// the projections. If all fail: 3' and 4' with P and Q exchanged. If one holds, Q is moved to the front of
/// the list and marked, and is the new P. If none does, or Q is marked already, P is split by Q's plane, its
/// pieces go into the list by their farthest z, and all starts again with the first of the list.
/// In rational arithmetic, so that what goes wrong is the algorithm.
/// @see Foley & van Dam 2e §15.5.1
struct ListPolygon {
  int face = 0;
  ExactRegion region;
  Rational zFar, zNear;
  bool marked = false;
};
struct ListSettings {
  /// Looks no further than the first Q of the list beyond P's z-extent: true of a sorted list only.
  bool stopAtFirstBeyond = false;
  bool piecesInheritMarks = false;
  int mostSplits = 60;  ///< then it is taken to be endless
};
struct ListSorted {
  std::vector<ListPolygon> painted;
  int moves = 0, splits = 0;
  int idle = 0;          ///< splits by a plane that does not cut: one piece, the same as before
  bool endless = false;  ///< ended by the limit, with polygons left
};
[[nodiscard]] ListSorted listSort(const SnappedScene& scene, const ListSettings& settings = {});

}  // namespace xnewell
