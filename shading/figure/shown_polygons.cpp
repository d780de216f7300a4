#include "shading/figure/shown_polygons.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "depthsort/region.h"

namespace xnewell {

namespace {

constexpr double kRounding = 2.0;  ///< steps: rounding moves two corners towards each other by 1.42 at most

/// True if a line along a side of p has p on one side, and q on the other but for the rounding.
bool isApartAlong(const FigureLoop& p, const FigureLoop& q) {
  for (std::size_t k = 0; k < p.size(); ++k) {
    const glm::dvec2 a = p[k], side = glm::dvec2{p[k + 1 == p.size() ? 0 : k + 1]} - a;
    const double slack = kRounding * std::sqrt(side.x * side.x + side.y * side.y);
    if (std::ranges::all_of(q, [&](const glm::ivec2& v) { return cross(side, glm::dvec2{v} - a) <= slack; }))
      return true;
  }
  return false;
}

/// True if one of the sides of q has the whole part outside.
bool isBeyondASide(const ConvexPart& part, const FigureLoop& q) {
  for (std::size_t k = 0; k < q.size(); ++k) {
    const glm::dvec2 a = q[k], side = glm::dvec2{q[k + 1 == q.size() ? 0 : k + 1]} - a;
    if (std::ranges::all_of(part, [&](const glm::dvec2& v) { return cross(side, v - a) <= 0; })) return true;
  }
  return false;
}

/// The smallest box around corners.
struct Bounds {
  glm::dvec2 least{HUGE_VAL}, most{-HUGE_VAL};

  template <class Corners>
  explicit Bounds(const Corners& corners) {
    for (const auto& v : corners) {
      const double x = v.x, y = v.y;
      least = {std::min(least.x, x), std::min(least.y, y)};
      most = {std::max(most.x, x), std::max(most.y, y)};
    }
  }
  [[nodiscard]] bool isApartFrom(const Bounds& o) const {
    return most.x <= o.least.x || o.most.x <= least.x || most.y <= o.least.y || o.most.y <= least.y;
  }
};

}  // namespace

void clipPart(const ConvexPart& part, const glm::dvec2& a, const glm::dvec2& side, double sign,
              ConvexPart& to) {
  to.clear();
  for (std::size_t k = 0; k < part.size(); ++k) {
    const glm::dvec2 &u = part[k], &v = part[k + 1 == part.size() ? 0 : k + 1];
    const double hu = sign * cross(side, u - a), hv = sign * cross(side, v - a);
    if (hu >= 0) to.push_back(u);
    if ((hu > 0 && hv < 0) || (hu < 0 && hv > 0)) to.push_back(u + (v - u) * (hu / (hu - hv)));
  }
}

std::int64_t doubleArea(const FigureLoop& loop) {
  std::int64_t area = 0;
  for (std::size_t k = 2; k < loop.size(); ++k) {
    const glm::ivec2 a = loop[k - 1] - loop[0], b = loop[k] - loop[0];
    area += std::int64_t{a.y} * b.x - std::int64_t{a.x} * b.y;
  }
  return area;
}

bool isSliver(const ConvexPart& part) {
  double doubleArea = 0, longest = 0;
  for (std::size_t k = 1; k < part.size(); ++k) {
    const glm::dvec2 a = part[k] - part[0];
    if (k > 1) doubleArea += cross(part[k - 1] - part[0], a);
    longest = std::max(longest, a.x * a.x + a.y * a.y);
  }
  return doubleArea <= kRounding * std::sqrt(longest);
}

void takeAway(const FigureLoop& q, std::vector<ConvexPart>& parts) {
  const Bounds bounds{q};
  const std::size_t count = parts.size();
  std::size_t whole = 0;
  ConvexPart part, outside, inside;
  for (std::size_t at = 0; at < count; ++at) {
    // The lines of q's sides would cut a part beside q in vain.
    if (Bounds{parts[at]}.isApartFrom(bounds) || isBeyondASide(parts[at], q)) {
      if (whole != at) std::swap(parts[whole], parts[at]);
      ++whole;
      continue;
    }
    part = parts[at];
    for (std::size_t k = 0; k < q.size() && part.size() > 2; ++k) {
      const glm::dvec2 a = q[k], side = glm::dvec2{q[k + 1 == q.size() ? 0 : k + 1]} - a;
      if (std::ranges::all_of(part, [&](const glm::dvec2& v) { return cross(side, v - a) >= 0; })) continue;
      clipPart(part, a, side, -1, outside);
      if (outside.size() > 2 && !isSliver(outside)) parts.push_back(outside);
      clipPart(part, a, side, 1, inside);
      std::swap(part, inside);
    }
  }
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(whole),
              parts.begin() + static_cast<std::ptrdiff_t>(count));
}

bool overlap(const FigureLoop& p, const FigureLoop& q) { return !isApartAlong(p, q) && !isApartAlong(q, p); }

void common(const ConvexPart& part, const FigureLoop& q, ConvexPart& to) {
  ConvexPart inside;
  to = part;
  for (std::size_t k = 0; k < q.size() && !to.empty(); ++k) {
    const glm::dvec2 a = q[k];
    clipPart(to, a, glm::dvec2{q[k + 1 == q.size() ? 0 : k + 1]} - a, 1, inside);
    std::swap(to, inside);
  }
}

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
