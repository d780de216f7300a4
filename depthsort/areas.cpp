#include "depthsort/areas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "depthsort/oracle.h"
#include "depthsort/region.h"
#include "geometry/view/scene_planes.h"

namespace xnewell {

namespace {

constexpr int kParts = 3;  // an area is divided into kParts by kParts
// A run may make kFewSplits splits, one more for kPerSplit polygons, and kPerPainted more for each polygon
// that it has painted: polygons that cross their neighbours alone need no areas.
constexpr int kFewSplits = 8, kPerSplit = 16, kPerPainted = 8;

/// What decides about the pixels of an area. This is right for polygons whose vertices are rounded to pixels,
/// too (`inPixels`). Rounding moves an edge by at most half a pixel along x and y, and no sample is nearer to
/// the border of the box than that. So a polygon paints no pixel of an area whose box it does not reach, and
/// one that covers the box paints all its pixels. (At exactly half a pixel, the rule for edges agrees: only
/// left and top edges are moved towards a sample within.)
ScreenBox boxOf(const PixelArea& area) {
  return {area.left * kGrid, area.top * kGrid, area.right * kGrid, area.bottom * kGrid};
}

/// The depths of a plane at the four corners of an area and at its centre. An error of a depth is far below
/// kRounding of it.
using Depths = std::array<double, 5>;
constexpr double kRounding = 0x1p-46;

Depths depthsAt(const ScreenBox& box, const ScreenPlane& plane) {
  return {depthAt(plane, box.x0, box.y0), depthAt(plane, box.x1, box.y0), depthAt(plane, box.x1, box.y1),
          depthAt(plane, box.x0, box.y1), depthAt(plane, (box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2)};
}

/// True if the first plane is surely nearer in the whole area.
bool isNearer(const Depths& a, const Depths& b) {
  for (std::size_t k = 0; k < 4; ++k)
    if (a[k] - b[k] <= kRounding * (std::abs(a[k]) + std::abs(b[k]))) return false;
  return true;
}

/// True if a region is a whole face: nothing was cut off.
bool isWhole(const Region& region, const SnappedFace& face) {
  return region.size() == static_cast<std::size_t>(face.count) &&
         std::ranges::all_of(region, [](const Side& side) {
           return side.line.kind == Line::Kind::Edge && side.corner.exact();
         });
}

class AreaSort {
 public:
  AreaSort(const SnappedScene& scene, const SortSettings& settings, PairTests& tests, SortedScene& sorted)
      : scene_{scene}, settings_{settings}, tests_{tests}, sorted_{sorted}, regions_{scene} {}

  void sort(const PolygonList& list, const PixelArea& area);

 private:
  /// What covers an area.
  struct Cover {
    int face;
    Depths depths;
  };

  /// The list of an area, from that of an area around it.
  [[nodiscard]] PolygonList within(const PixelArea& area, const PolygonList& list);
  /// The nearest of the covering polygons, at the corners and at the centre.
  [[nodiscard]] static std::vector<Cover> nearest(const std::vector<Cover>& covers);
  /// Clips a region to the box of an area. `of` is the region's bounding box within the picture.
  void clipTo(const ScreenBox& box, const ScreenBox& of, Region& region) const;
  /// Cuts off what the covering polygons hide of the region of face P. Returns true if all of it is hidden.
  [[nodiscard]] bool isHidden(Region& region, int P, const ScreenBox& box, const std::vector<Cover>& near);
  [[nodiscard]] bool hide(Region& region, int P, const Depths& depths, const Cover& cover);
  bool countHidden(bool hidden) {
    sorted_.statistics.hidden += hidden;
    return hidden;
  }
  /// Paints the nearest polygon at the sample of one pixel.
  void paintNearest(const PolygonList& list, const PixelArea& pixel);
  [[nodiscard]] const ScreenPlane& planeOf(int face) const { return scene_.planes[scene_.faces[face].plane]; }
  [[nodiscard]] Region regionOf(const PolygonList& list, std::size_t k) const {
    if (!list.regions.empty() && !list.regions[k].empty()) return list.regions[k];
    Region outline;
    regions_.outline(scene_.faces[list.polygons[k].face], outline);
    return outline;
  }

  const SnappedScene& scene_;
  const SortSettings& settings_;
  PairTests& tests_;
  SortedScene& sorted_;
  Regions regions_;
  bool divided_ = false;  ///< the picture is
};

void AreaSort::sort(const PolygonList& list, const PixelArea& area) {
  if (list.polygons.empty()) return;
  const int width = area.right - area.left, height = area.bottom - area.top;
  const auto makePlanes = [&] {
    if (!divided_ && settings_.planes)
      for (const Polygon& P : list.polygons) settings_.planes->make(scene_.faces[P.face]);
  };
  const bool isPixel = width == 1 && height == 1;
  if (isPixel && !settings_.inPixels) return makePlanes(), paintNearest(list, area);

  const std::size_t fragments = sorted_.fragments.size(), pieces = sorted_.pieces.size(),
                    cuts = sorted_.cuts.size();
  const SortStatistics before = sorted_.statistics;
  const std::int64_t few =
      isPixel ? std::numeric_limits<std::int64_t>::max() : kFewSplits + std::ssize(list.polygons) / kPerSplit;
  if (runNewell(list, scene_, settings_, {area, few, isPixel ? 0 : kPerPainted}, tests_, sorted_)) {
    sorted_.statistics.areas += divided_;
    return;
  }
  makePlanes();
  divided_ = true;
  sorted_.fragments.resize(fragments), sorted_.pieces.resize(pieces), sorted_.cuts.resize(cuts);
  sorted_.statistics = before;
  for (int j = 0; j < kParts; ++j)
    for (int i = 0; i < kParts; ++i) {
      const PixelArea part{area.left + width * i / kParts, area.top + height * j / kParts,
                           area.left + width * (i + 1) / kParts, area.top + height * (j + 1) / kParts};
      if (part.left < part.right && part.top < part.bottom) sort(within(part, list), part);
    }
}

PolygonList AreaSort::within(const PixelArea& area, const PolygonList& list) {
  const ScreenBox box = boxOf(area);
  PolygonList part;
  std::vector<Cover> covers;
  for (std::size_t k = 0; k < list.polygons.size(); ++k) {
    const Polygon& P = list.polygons[k];
    if (!P.extents.box.overlaps(box)) continue;
    Region region = regionOf(list, k);
    clipTo(box, P.extents.box, region);
    if (region.empty()) continue;
    if (std::ranges::all_of(region, [](const Side& side) { return side.line.isOfArea(); }))
      covers.push_back({P.face, depthsAt(box, planeOf(P.face))});
    part.polygons.push_back(P);
    part.regions.push_back(std::move(region));
  }

  const std::vector<Cover> near = nearest(covers);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < part.polygons.size(); ++k) {
    Polygon P = part.polygons[k];
    Region region = std::move(part.regions[k]);
    if (isHidden(region, P.face, box, near)) continue;
    if (isWhole(region, scene_.faces[P.face])) {
      region.clear();
    } else {
      P.extents = extentsOf(scene_, scene_.faces[P.face], region, P.extents);
      if (!settings_.inPixels &&
          !mayOwnSample(scene_, region, P.extents.box, settings_.width, settings_.height))
        continue;
    }
    part.polygons[kept] = P;
    part.regions[kept++] = std::move(region);
  }
  part.polygons.resize(kept), part.regions.resize(kept);
  return part;
}

void AreaSort::clipTo(const ScreenBox& box, const ScreenBox& of, Region& region) const {
  if (of.x0 <= box.x0) regions_.clip(region, Regions::upright(box.x0, 1));
  if (of.x1 >= box.x1 && !region.empty()) regions_.clip(region, Regions::upright(box.x1, -1));
  if (of.y0 <= box.y0 && !region.empty()) regions_.clip(region, Regions::level(box.y0, 1));
  if (of.y1 >= box.y1 && !region.empty()) regions_.clip(region, Regions::level(box.y1, -1));
}

bool AreaSort::isHidden(Region& region, int P, const ScreenBox& box, const std::vector<Cover>& near) {
  if (near.empty()) return false;
  const Depths depths = depthsAt(box, planeOf(P));
  const auto hidesAll = [&](const Cover& cover) {  // surely, so nothing is cut for the others
    return scene_.faces[P].plane != scene_.faces[cover.face].plane && isNearer(cover.depths, depths);
  };
  if (std::ranges::any_of(near, hidesAll)) return countHidden(true);
  return std::ranges::any_of(near, [&](const Cover& cover) { return hide(region, P, depths, cover); });
}

std::vector<AreaSort::Cover> AreaSort::nearest(const std::vector<Cover>& covers) {
  std::vector<Cover> near;
  for (std::size_t k = 0; k < std::tuple_size_v<Depths> && !covers.empty(); ++k) {
    const Cover& cover = *std::ranges::max_element(covers, {}, [k](const Cover& c) { return c.depths[k]; });
    if (std::ranges::find(near, cover.face, &Cover::face) == near.end()) near.push_back(cover);
  }
  return near;
}

bool AreaSort::hide(Region& region, int P, const Depths& depths, const Cover& cover) {
  if (P == cover.face) return false;
  const SnappedFace &p = scene_.faces[P], &q = scene_.faces[cover.face];
  if (p.plane == q.plane) return countHidden(P < cover.face);
  if (isNearer(depths, cover.depths)) return false;
  const Line line = regions_.cut(p.plane, q.plane);
  const Signs signs = regions_.signs(line, region);
  if (signs.none()) return countHidden(P < cover.face);
  if (!signs.negative) return false;
  if (!signs.positive) return countHidden(true);
  Region behind = region, front = region;
  regions_.clip(behind, Regions::flipped(line));
  regions_.clip(front, line);
  if (tests_.isDeep(behind, q, p) && tests_.isDeep(front, p, q)) {
    region = std::move(front);
    countHidden(true);
  }
  return false;
}

void AreaSort::paintNearest(const PolygonList& list, const PixelArea& pixel) {
  const int i = pixel.left, j = pixel.top;
  const Polygon* seen = nullptr;
  for (std::size_t k = 0; k < list.polygons.size(); ++k) {
    const Polygon& P = list.polygons[k];
    const Region region = regionOf(list, k);
    if (!std::ranges::all_of(region, [&](const Side& s) { return signAtSample(scene_, s.line, i, j) > 0; }))
      continue;
    if (seen) {
      const int sign = nearer(planeOf(P.face), planeOf(seen->face), i, j);
      if (sign < 0 || (sign == 0 && P.face < seen->face)) continue;
    }
    seen = &P;
  }
  ++sorted_.statistics.areas;
  if (!seen) return;
  sorted_.fragments.push_back({seen->face, static_cast<int>(sorted_.pieces.size())});
  sorted_.pieces.push_back({seen->face, static_cast<int>(sorted_.cuts.size()), 0, pixel, seen->face});
}

}  // namespace

void sortByAreas(const PolygonList& list, const SnappedScene& scene, const SortSettings& settings,
                 const PixelArea& area, PairTests& tests, SortedScene& sorted) {
  AreaSort{scene, settings, tests, sorted}.sort(list, area);
}

}  // namespace xnewell
