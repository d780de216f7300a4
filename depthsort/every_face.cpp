#include "depthsort/every_face.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "depthsort/newell_run.h"

namespace xnewell {

SortedScene sortEveryFace(const SnappedScene& scene, int width, int height, int mostPieces) {
  SortSettings settings{.width = width, .height = height};
  settings.mostPieces = mostPieces;
  settings.samples = false;
  PairTests tests{scene, settings};
  const ScreenBox page{0, 0, width * kGrid, height * kGrid};
  PolygonList list;
  list.polygons.reserve(scene.faces.size());
  for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f) {
    const SnappedFace& face = scene.faces[f];
    Polygon P{.extents = extentsOf(scene, face, tests.vertexDepthsAreExact(face)), .face = f};
    ScreenBox& box = P.extents.box;
    if (!box.overlaps(page)) continue;
    // What is farther outside is not compared.
    box = {std::max(box.x0, page.x0), std::max(box.y0, page.y0), std::min(box.x1, page.x1),
           std::min(box.y1, page.y1)};
    list.polygons.push_back(P);
  }
  SortedScene sorted;
  const RunLimits limits{{0, 0, width, height}, std::numeric_limits<std::int64_t>::max(), 0};
  if (!runNewell(list, scene, settings, limits, tests, sorted))
    throw std::logic_error{"a run without a limit gave up"};
  sorted.statistics.bytes = bytesOf(sorted);
  return sorted;
}

}  // namespace xnewell
