#pragma once

#include <vector>

#include "tests/support/exact_region.h"

namespace xnewell {

/// The depth sort as the textbook tells it, with a list. It is the reference from which
/// depthsort/depth_sort.h departs, for the reasons given there.
/// The list is sorted by farthest z. P, the first in it, is tested against the other Q's whose z-extents
/// reach back to P's: 1, 2 extents in x and y, 3 P behind Q's plane, 4 Q in front of P's plane, 5 the
/// projections. If all fail, 3' and 4' follow with P and Q exchanged. If one of these holds, Q is moved to
/// the front of the list, is marked, and is the new P. If none does, or if Q is marked already, P is split by
/// Q's plane, its pieces go into the list by their farthest z, and everything starts again with the first in
/// the list.
/// It uses rational arithmetic, so that any error is the algorithm's.
/// @see Foley & van Dam 2e §15.5.1
struct ListPolygon {
  int face = 0;
  ExactRegion region;
  Rational zFar, zNear;
  bool marked = false;
};
struct ListSettings {
  /// Stops at the first Q of the list beyond P's z-extent. This is right only for a sorted list.
  bool stopAtFirstBeyond = false;
  bool piecesInheritMarks = false;
  int mostSplits = 60;  ///< after more splits the run counts as endless
};
struct ListSorted {
  std::vector<ListPolygon> painted;
  int moves = 0, splits = 0;
  int idle = 0;          ///< splits by a plane that does not cross P: one piece, the same as before
  bool endless = false;  ///< true if the limit ended the run with polygons left
};
[[nodiscard]] ListSorted listSort(const SnappedScene& scene, const ListSettings& settings = {});

}  // namespace xnewell
