#include "shading/figure/shown_polygons.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "depthsort/region.h"
#include "shading/figure/convex_part.h"

namespace xnewell {

namespace {

constexpr int kMargin = 2 * kFigureSteps;  ///< how far outside of the page polygons are clipped

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
  constexpr int kBeyond = kMargin * (kGrid / kFigureSteps);
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
    const auto within = [](int at, int most) { return std::clamp(at + kMargin, 0, most - 1); };
    boxes_.push_back({within(left.x, w), within(top.y, h), within(right.x, w), within(bottom.y, h)});
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

namespace {

/// A polygon with its sides moved outwards, as far as it lies in the page and in its box, which is made
/// larger in the same way.
ConvexPart enlarged(const FigureLoop& p, int by, const glm::ivec2& page) {
  const auto [left, right] = std::ranges::minmax(p, {}, &glm::ivec2::x);
  const auto [top, bottom] = std::ranges::minmax(p, {}, &glm::ivec2::y);
  const double x0 = std::max(0, left.x - by), x1 = std::min(page.x, right.x + by),
               y0 = std::max(0, top.y - by), y1 = std::min(page.y, bottom.y + by);
  if (x0 >= x1 || y0 >= y1) return {};
  ConvexPart part{{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}}, inside;
  for (std::size_t k = 0; k < p.size() && part.size() > 2; ++k) {
    const glm::dvec2 a = p[k], side = glm::dvec2{p[k + 1 == p.size() ? 0 : k + 1]} - a;
    const glm::dvec2 out = glm::dvec2{-side.y, side.x} / std::sqrt(side.x * side.x + side.y * side.y);
    clipPart(part, a + out * static_cast<double>(by), side, 1, inside);
    std::swap(part, inside);
  }
  return part;
}

bool isWithin(const glm::dvec2& at, const FigureLoop& p) {
  for (std::size_t k = 0; k < p.size(); ++k) {
    const glm::dvec2 a = p[k], side = glm::dvec2{p[k + 1 == p.size() ? 0 : k + 1]} - a;
    if (cross(side, at - a) < 0) return false;
  }
  return true;
}

}  // namespace

bool HidingPolygons::hides(int polygon, int beyond) {
  constexpr std::size_t kMostParts = 200;  // of one polygon; with more it counts as seen
  const FigureLoop& p = polygons_[polygon].corners;
  over_.clear();
  grid_.forEachNear(polygon, beyond, [&](int other) {
    if (other > polygon) over_.push_back(other);
  });
  glm::dvec2 centre{0.0};
  for (const glm::ivec2& v : p) centre += glm::dvec2{v};
  centre = centre / static_cast<double>(p.size());
  if (std::ranges::none_of(over_, [&](int other) { return isWithin(centre, polygons_[other].corners); }))
    return false;
  // The surface in front is the latest. It may cover all before the layers between have left many parts.
  std::ranges::sort(over_, std::greater{});
  const ConvexPart whole = enlarged(p, beyond, page_);
  const FigureLoop about{whole.begin(), whole.end()};
  std::vector<ConvexPart> parts;
  if (whole.size() > 2) parts.push_back(whole);
  for (const int other : over_) {
    if (overlap(about, polygons_[other].corners)) takeAway(polygons_[other].corners, parts);
    if (parts.empty() || parts.size() > kMostParts) break;
  }
  return parts.empty();
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
