#include "shading/figure/shown_polygons.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "depthsort/region.h"
#include "shading/figure/convex_part.h"

namespace xnewell {

namespace {

std::uint64_t packed(const glm::ivec3& v) {
  return std::uint64_t{static_cast<std::uint32_t>(v.x)} << 32 | static_cast<std::uint32_t>(v.y);
}

SideLine lineOf(const SnappedScene& scene, const Line& line) {
  if (line.isOfArea()) return {};
  if (line.kind == Line::Kind::Edge) return edgeOf(scene.vertices[line.p], scene.vertices[line.q]);
  const auto [a, b] = std::minmax({line.p, line.q});
  return {SideLine::Kind::Cut, static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b)};
}

/// The region of a fragment.
void regionOf(const SnappedScene& scene, const SortedScene& sorted, const Fragment& fragment,
              const Regions& regions, Region& region) {
  regions.outline(scene.faces[fragment.face], region);
  if (fragment.piece < 0) return;
  const Piece& piece = sorted.pieces[fragment.piece];
  for (int k = 0; k < piece.cuts && !region.empty(); ++k) {
    const CutLine& cut = sorted.cuts[piece.firstCut + k];
    regions.clip(region, regions.cut(cut.over, cut.under));
  }
}

/// Rounds the corners, drops sides that become points, and says whether an area is left.
bool round(const SnappedScene& scene, const Region& region, FigurePolygon& polygon) {
  constexpr double kStep = double{kGrid} / kFigureSteps;
  const auto corner = [](const Corner& c) {
    return glm::ivec2{static_cast<int>(std::floor(c.x / kStep + 0.5)),
                      static_cast<int>(std::floor(c.y / kStep + 0.5))};
  };
  for (std::size_t k = 0; k < region.size(); ++k) {
    const glm::ivec2 from = corner(region[k == 0 ? region.size() - 1 : k - 1].corner);
    if (from == corner(region[k].corner)) continue;
    polygon.corners.push_back(from);
    polygon.lines.push_back(lineOf(scene, region[k].line));
  }
  return doubleArea(polygon.corners) > 0;
}

}  // namespace

SideLine edgeOf(const glm::ivec3& from, const glm::ivec3& to) {
  const auto [a, b] = std::minmax({packed(from), packed(to)});
  return {SideLine::Kind::Edge, a, b};
}

std::vector<FigurePolygon> polygonsOf(const SnappedScene& scene, const SortedScene& sorted, int width,
                                      int height) {
  constexpr int kBeyond = PolygonGrid::kMargin * (kGrid / kFigureSteps);
  const Regions regions{scene};
  const int right = width * kGrid + kBeyond, bottom = height * kGrid + kBeyond;
  const std::array borders{Regions::upright(-kBeyond, 1), Regions::upright(right, -1),
                           Regions::level(-kBeyond, 1), Regions::level(bottom, -1)};
  std::vector<FigurePolygon> polygons;
  polygons.reserve(sorted.fragments.size());
  Region region;
  for (const Fragment& fragment : sorted.fragments) {
    regionOf(scene, sorted, fragment, regions, region);
    const auto outside = [&](const Side& side) {
      const Corner& c = side.corner;
      return c.x < -kBeyond || c.y < -kBeyond || c.x > right || c.y > bottom;
    };
    if (std::ranges::any_of(region, outside))
      for (const Line& border : borders)
        if (!region.empty()) regions.clip(region, border);
    FigurePolygon polygon;
    polygon.face = fragment.face;
    if (!region.empty() && round(scene, region, polygon)) polygons.push_back(std::move(polygon));
  }
  return polygons;
}

PolygonGrid::PolygonGrid(const std::vector<FigurePolygon>& polygons, int width, int height) {
  const double cells = 1.0 + static_cast<double>(polygons.size());
  const int w = width * kFigureSteps + 2 * kMargin + 2, h = height * kFigureSteps + 2 * kMargin + 2;
  side_ = std::max(kFigureSteps, static_cast<int>(std::sqrt(static_cast<double>(w) * h / cells)));
  columns_ = w / side_ + 1, rows_ = h / side_ + 1;
  right_ = w - 1, bottom_ = h - 1;
  met_.assign(polygons.size(), 0);
  for (const FigurePolygon& p : polygons) {
    const auto [left, right] = std::ranges::minmax(p.corners, {}, &glm::ivec2::x);
    const auto [top, bottom] = std::ranges::minmax(p.corners, {}, &glm::ivec2::y);
    boxes_.push_back(
        {moved(left.x, right_), moved(top.y, bottom_), moved(right.x, right_), moved(bottom.y, bottom_)});
  }
  const auto forEachCell = [&](const Box& box, auto use) {
    for (int j = box.y0 / side_; j <= box.y1 / side_; ++j)
      for (int i = box.x0 / side_; i <= box.x1 / side_; ++i) use(std::size_t(j) * columns_ + i);
  };
  begin_.assign(std::size_t(columns_) * rows_ + 1, 0);
  for (const Box& box : boxes_) forEachCell(box, [&](std::size_t cell) { ++begin_[cell + 1]; });
  for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
  members_.resize(begin_.back());
  std::vector<int> next = begin_;
  for (std::size_t k = 0; k < boxes_.size(); ++k)
    forEachCell(boxes_[k], [&](std::size_t cell) { members_[next[cell]++] = static_cast<int>(k); });
}

std::vector<int> levelsOf(const std::vector<FigurePolygon>& polygons, int width, int height) {
  PolygonGrid grid{polygons, width, height};
  std::vector<int> levels(polygons.size(), 0);
  for (int k = 0; k < static_cast<int>(polygons.size()); ++k)
    grid.forEachNear(k, 0, [&](int other) {
      if (other < k && levels[other] >= levels[k] && overlap(polygons[k].corners, polygons[other].corners))
        levels[k] = levels[other] + 1;
    });
  return levels;
}

}  // namespace xnewell
