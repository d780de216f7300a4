#include "shading/figure/convex_part.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

}  // namespace xnewell
