#include "shading/figure/hiding_polygons.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace xnewell {

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

/// True if the side from a to b lies inside of a convex part somewhere, farther than a step from its border.
bool runsThrough(const glm::dvec2& a, const glm::dvec2& b, const ConvexPart& part) {
  double from = 0, to = 1;
  for (std::size_t k = 0; k < part.size(); ++k) {
    const glm::dvec2 &u = part[k], side = part[k + 1 == part.size() ? 0 : k + 1] - u;
    const double step = std::sqrt(side.x * side.x + side.y * side.y);
    const double ha = cross(side, a - u) - step, hb = cross(side, b - u) - step;
    if (ha <= 0 && hb <= 0) return false;
    if (ha < 0) from = std::max(from, ha / (ha - hb));
    if (hb < 0) to = std::min(to, ha / (ha - hb));
    if (from >= to) return false;
  }
  return true;
}

}  // namespace

HidingPolygons::HidingPolygons(const std::vector<FigurePolygon>& polygons, const SideTable& sides, int width,
                               int height)
    : polygons_{polygons},
      sides_{sides},
      page_{width * kFigureSteps, height * kFigureSteps},
      grid_{polygons, width, height},
      met_(polygons.size(), 0) {}

/// True if later polygons that lie side by side cover a part of a polygon. The first of them, `start`, holds
/// a point of it. From there we go across each side that runs through the part. If a later polygon lies
/// beyond each of these sides, no border of what we have met runs through the part, so it has no uncovered
/// place.
bool HidingPolygons::surfaceCovers(int start, int polygon, const ConvexPart& part) {
  ++round_;
  open_.assign(1, start);
  met_[start] = round_;
  while (!open_.empty()) {
    const int k = open_.back();
    open_.pop_back();
    for (int c = 0; c < static_cast<int>(polygons_[k].corners.size()); ++c) {
      const PolygonSide side{k, c};
      if (!runsThrough(sides_.from(side), sides_.to(side), part)) continue;
      const int beyond = sides_.beyond(side).polygon;
      if (beyond < polygon) {
        metEarlier_ |= beyond >= 0;
        return false;
      }
      if (std::exchange(met_[beyond], round_) != round_) open_.push_back(beyond);
    }
  }
  return true;
}

/// True if nothing is left of a part of a polygon when all later polygons are taken away from it.
bool HidingPolygons::nothingIsLeft(int polygon, int beyond, const ConvexPart& part) {
  constexpr std::size_t kMostParts = 200;  // with more, the polygon counts as seen
  over_.clear();
  grid_.forEachNear(polygon, beyond, [&](int other) {
    if (other > polygon) over_.push_back(other);
  });
  // The surface in front is the latest. It may cover all before the layers between have left many parts.
  std::ranges::sort(over_, std::greater{});
  const FigureLoop about{part.begin(), part.end()};
  std::vector<ConvexPart> left{part};
  for (const int other : over_) {
    if (overlap(about, polygons_[other].corners)) takeAway(polygons_[other].corners, left);
    if (left.empty() || left.size() > kMostParts) break;
  }
  return left.empty();
}

/// True if use(other) is true for a later polygon that holds a point.
template <class Use>
bool HidingPolygons::isUnder(const glm::dvec2& point, int polygon, Use&& use) const {
  bool found = false;
  grid_.untilAt(point, [&](int other) {
    found = other > polygon && isWithin(point, polygons_[other].corners) && use(other);
    return found || other <= polygon;
  });
  return found;
}

bool HidingPolygons::hides(int polygon, int beyond) {
  const ConvexPart part = enlarged(polygons_[polygon].corners, beyond, page_);
  if (part.size() < 3) return true;  // outside of the page
  glm::dvec2 centre{0.0};
  for (const glm::dvec2& v : part) centre += v;
  centre = centre / static_cast<double>(part.size());
  metEarlier_ = false;
  if (isUnder(centre, polygon, [&](int other) { return surfaceCovers(other, polygon, part); })) return true;
  // Near the border of what hides a polygon, the search for another proof nearly always fails.
  if (beyond > 0 && metEarlier_) return false;
  const auto isCovered = [&](const glm::dvec2& corner) {
    return isUnder(centre + 0.9 * (corner - centre), polygon, [](int) { return true; });
  };
  return isCovered(centre) && std::ranges::all_of(part, isCovered) && nothingIsLeft(polygon, beyond, part);
}

}  // namespace xnewell
