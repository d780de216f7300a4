#include "depthsort/depth_sort.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "depthsort/areas.h"
#include "depthsort/oracle.h"
#include "geometry/view/scene_planes.h"

namespace xnewell {

namespace {

/// The faces of the scene. For the quick run, only those that may show.
PolygonList facesOf(const SnappedScene& scene, const SortSettings& settings) {
  PolygonList list;
  list.polygons.reserve(scene.faces.size());
  const int margin = settings.inPixels ? kGrid : 0;  // rounding may move a vertex into the picture
  const ScreenBox picture{-margin, -margin, settings.width * kGrid + margin,
                          settings.height * kGrid + margin};
  for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f) {
    const SnappedFace& face = scene.faces[f];
    if (settings.planes && !face.throughVertices) settings.planes->make(face);
    Polygon P{.extents = extentsOf(scene, face), .face = f};
    if (!settings.textbook) {
      ScreenBox& box = P.extents.box;
      if (settings.samples ? !mayShow(scene, face, box, settings.width, settings.height, settings.inPixels)
                           : !box.overlaps(picture))
        continue;
      // What is farther outside is not compared.
      box = {std::max(box.x0, picture.x0), std::max(box.y0, picture.y0), std::min(box.x1, picture.x1),
             std::min(box.y1, picture.y1)};
    }
    list.polygons.push_back(P);
  }
  return list;
}

}  // namespace

std::int64_t bytesOf(const SortedScene& sorted) {
  return static_cast<std::int64_t>(sorted.fragments.size() * sizeof(Fragment) +
                                   sorted.pieces.size() * sizeof(Piece) +
                                   sorted.cuts.size() * sizeof(CutLine));
}

TooManyPieces tooManyPieces(std::string_view who, int most) {
  return TooManyPieces{std::string{who} + " needs more than " + std::to_string(most) +
                       " pieces, for the polygons cross too often; --max-fragments allows more, and --order "
                       "oracle needs none"};
}

SortedScene depthSort(const SnappedScene& scene, const SortSettings& settings) {
  SortedScene sorted;
  PairTests tests{scene, settings};
  const PolygonList list = facesOf(scene, settings);
  const PixelArea picture{0, 0, settings.width, settings.height};
  if (settings.areas && !settings.textbook && !settings.record) {
    sortByAreas(list, scene, settings, picture, tests, sorted);
  } else {
    const RunLimits limits{picture, std::numeric_limits<std::int64_t>::max(), 0};
    if (!runNewell(list, scene, settings, limits, tests, sorted))
      throw std::logic_error{"a run without a limit gave up"};
  }
  sorted.statistics.bytes = bytesOf(sorted);
  return sorted;
}

}  // namespace xnewell
