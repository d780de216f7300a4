#pragma once

#include <cstdint>
#include <vector>

#include "depthsort/depth_sort.h"
#include "depthsort/pair_tests.h"
#include "depthsort/region.h"

namespace xnewell {

/// A polygon of the list, whole or a piece. It holds what is read for every Q; two fit into a cache line.
struct Polygon {
  enum class State : std::uint8_t { Waiting, Marked, Split, Painted };
  Extents extents;
  int face = 0;  ///< index into the scene's faces
  State state = State::Waiting;
};
static_assert(sizeof(Polygon) == 32);

/// The polygons that a run sorts, in the order of their faces.
struct PolygonList {
  std::vector<Polygon> polygons;
  /// One for each polygon, or none at all. An empty region stands for the whole face.
  std::vector<Region> regions;
};

/// Where a run paints, and when it gives up.
struct RunLimits {
  PixelArea area;  ///< the run paints nothing outside of it
  /// The run gives up when it makes more splits than this, and `perPainted` more for each polygon of the list
  /// that it has painted.
  std::int64_t splits, perPainted;
};

/// Sorts a list by Newell's algorithm, as depth_sort.h describes it, and appends what it paints to `sorted`.
/// Returns false if it gave up. Then `sorted` has the pieces, fragments and statistics of an unfinished run.
[[nodiscard]] bool runNewell(const PolygonList& list, const SnappedScene& scene, const SortSettings& settings,
                             const RunLimits& limits, PairTests& tests, SortedScene& sorted);

}  // namespace xnewell
