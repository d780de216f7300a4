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
  if (std::ranges::all_of(parts, [&](const ConvexPart& part) { return isBeyondASide(part, q); })) return;
  std::vector<ConvexPart> left;
  ConvexPart outside, inside;
  for (ConvexPart& part : parts) {
    if (isBeyondASide(part, q)) {  // else the lines of its sides would cut it in vain
      left.push_back(std::move(part));
      continue;
    }
    for (std::size_t k = 0; k < q.size() && !part.empty(); ++k) {
      const glm::dvec2 a = q[k], side = glm::dvec2{q[k + 1 == q.size() ? 0 : k + 1]} - a;
      if (std::ranges::all_of(part, [&](const glm::dvec2& v) { return cross(side, v - a) >= 0; })) continue;
      clipPart(part, a, side, -1, outside);
      if (outside.size() > 2 && !isSliver(outside)) left.push_back(outside);
      clipPart(part, a, side, 1, inside);
      std::swap(part, inside);
      if (part.size() < 3) break;
    }
  }
  parts = std::move(left);
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
