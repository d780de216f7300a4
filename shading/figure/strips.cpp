#include "shading/figure/strips.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>
#include <utility>

namespace xnewell {

namespace {

constexpr int kMostTurns = 1000;  ///< polygons around a corner
constexpr double kDisk = 1.25;    ///< radius of a disk, in widths of the strip

double length(const glm::dvec2& v) { return std::sqrt(v.x * v.x + v.y * v.y); }
double dot(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.x + a.y * b.y; }

glm::ivec2 rounded(const glm::dvec2& v) {
  return {static_cast<int>(std::floor(v.x + 0.5)), static_cast<int>(std::floor(v.y + 0.5))};
}

/// An octagon around a disk.
FigureLoop octagon(const glm::ivec2& V, double radius) {
  const int r = static_cast<int>(std::ceil(radius)), c = static_cast<int>(std::ceil(radius * 0.41422));
  FigureLoop loop{{r, c}, {c, r}, {-c, r}, {-r, c}, {-r, -c}, {-c, -r}, {c, -r}, {r, -c}};
  std::ranges::reverse(loop);  // counter-clockwise as seen
  for (glm::ivec2& v : loop) v += V;
  return loop;
}

}  // namespace

Strips::Strips(const std::vector<FigurePolygon>& polygons, const std::vector<int>& path,
               const SideTable& table, int width, const glm::ivec2& page)
    : polygons_{polygons},
      path_{path},
      table_{table},
      width_{static_cast<double>(width)},
      grid_{polygons, page.x, page.y} {}

/// Where the strip along `side` ends at the corner V of the side: on the next side of the polygon beyond,
/// `along`, which begins (direction 1) or ends (-1) at V. If that turns away by more than a right angle,
/// the strip ends at a right angle.
glm::ivec2 Strips::end(const PolygonSide& side, const PolygonSide& along, const glm::ivec2& V,
                       int direction) const {
  constexpr double kMostSlanted = 3.0;  // widths of the strip
  const double sign = direction;
  const glm::dvec2 on = sign * (glm::dvec2{table_.to(side)} - glm::dvec2{table_.from(side)});
  const glm::dvec2 spoke = glm::dvec2{direction == 1 ? table_.to(along) : table_.from(along)} - glm::dvec2{V};
  const double l = length(on), s = length(spoke);
  // outwards: to the right of the side's direction on a screen with y down, as its polygon is to the left
  const glm::dvec2 out = glm::dvec2{-on.y, on.x} * (sign / l);
  const double sine = dot(out, spoke) / s;
  if (dot(on, spoke) >= 0 && sine > 0)
    return rounded(glm::dvec2{V} + spoke * std::min(1.0, std::min(width_ / sine, kMostSlanted * width_) / s));
  return rounded(glm::dvec2{V} + out * within(along.polygon, glm::dvec2{V}, out));
}

/// How far the ray from V stays in a polygon, at most the width of a strip.
double Strips::within(int polygon, const glm::dvec2& V, const glm::dvec2& ray) const {
  double far = width_;
  const FigureLoop& corners = polygons_[polygon].corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec2 a = corners[k], side = glm::dvec2{corners[k + 1 == corners.size() ? 0 : k + 1]} - a;
    const double slope = cross(side, ray), height = cross(side, V - a);
    if (slope < 0) far = std::min(far, std::max(0.0, height) / -slope);
  }
  return far;
}

FigureLoop Strips::aroundCorner(const PolygonSide& side, const PolygonSide& next) const {
  if (!along(side) || !along(next)) return {};
  const glm::ivec2 V = table_.to(side);
  const FigureLoop disk = octagon(V, kDisk * width_);
  FigureLoop around;
  ConvexPart wedge;
  const PolygonSide begin = table_.beyond(side), end = table_.beyond(next);
  const glm::dvec2 first{corners(side)[1] - V}, last{corners(next)[0] - V};
  PolygonSide other = begin;  // it begins at V
  for (int turns = 0; other != end; ++turns) {
    if (turns == kMostTurns || pathOf(other) < pathOf(side)) return {};
    const PolygonSide spoke = table_.previous(other);  // it ends at V
    const FigureLoop& outline = polygons_[other.polygon].corners;
    common(ConvexPart(outline.begin(), outline.end()), disk, wedge);
    const auto at = std::ranges::find(wedge, glm::dvec2{V});
    if (at != wedge.end()) {
      std::rotate(wedge.begin(), at, wedge.end());
      const auto isBetweenStrips = [&](const glm::dvec2& v) {
        return (other != begin || cross(first, v - glm::dvec2{V}) >= 0) &&
               (spoke != end || cross(v - glm::dvec2{V}, last) >= 0);
      };
      for (std::size_t k = 2; k + (spoke == end ? 1 : 0) < wedge.size(); ++k)
        if (isBetweenStrips(wedge[k])) around.push_back(rounded(wedge[k]));
    }
    if (spoke == end) break;
    other = table_.beyond(spoke);
    if (other.polygon < 0) return {};
  }
  return around;
}

/// True if polygons lie all around the corner where a side begins, each beside the one before.
bool Strips::isSurrounded(const PolygonSide& start) const {
  PolygonSide at = start;
  for (int turns = 0; turns < kMostTurns; ++turns) {
    const PolygonSide spoke = table_.previous(at);
    at = table_.beyond(spoke);
    if (at.polygon < 0 || table_.beyond(at) != spoke) return false;
    if (at == start) return true;
  }
  return false;
}

void Strips::findLater(int polygon) {
  if (near_ == polygon) return;
  near_ = polygon;
  later_.clear();
  grid_.forEachNear(polygon, static_cast<int>(width_) + 1, [&](int other) {
    if (path_[other] > path_[polygon]) later_.push_back(other);
  });
  std::ranges::sort(later_);
}

/// True if the polygon of a side shows nearer to it than the width of a strip. If not, no pixel needs more of
/// it there.
bool Strips::showsAlong(const PolygonSide& side) {
  const glm::dvec2 a{table_.from(side)}, b{table_.to(side)}, on = (b - a) / length(b - a);
  const glm::dvec2 along = on * width_, in = glm::dvec2{on.y, -on.x} * width_;
  common({a - along, b + along, b + along + in, a - along + in}, polygons_[side.polygon].corners, part_);
  left_.assign(1, part_);
  // The surface in front is the latest. It may hide the side before those between have left many parts.
  for (const int other : std::views::reverse(later_)) {
    if (left_.empty()) break;
    takeAway(polygons_[other].corners, left_);
  }
  return !left_.empty();
}

void Strips::addOthers(const PolygonSide& side, std::vector<FigureLoop>& loops) {
  if (width_ == 0 || polygons_[side.polygon].lines[side.corner].kind == SideLine::Kind::Page) return;
  findLater(side.polygon);
  if (later_.empty()) return;
  const glm::ivec2 A = table_.from(side), B = table_.to(side);
  const glm::dvec2 a{A}, b{B}, on = (b - a) / length(b - a), out{-on.y, on.x};
  const std::array surrounded{isSurrounded(side), isSurrounded(table_.next(side))};
  const double before = surrounded[0] ? 0 : width_, after = length(b - a) + (surrounded[1] ? 0 : width_);
  const ConvexPart zone{a - on * before, a - on * before + out * width_, a + on * after + out * width_,
                        a + on * after};
  const PolygonSide beyond = table_.beyond(side);
  std::optional<bool> shows;
  for (const int other : later_) {
    const FigureLoop& corners = polygons_[other].corners;
    double least = HUGE_VAL, most = -HUGE_VAL, first = HUGE_VAL, last = -HUGE_VAL;
    for (const glm::ivec2& v : corners) {
      const glm::dvec2 to = glm::dvec2{v} - a;
      const double far = dot(out, to), at = dot(on, to);
      least = std::min(least, far), most = std::max(most, far);
      first = std::min(first, at), last = std::max(last, at);
    }
    if (most <= 1 || least >= width_ || last <= -before || first >= after) continue;
    common(zone, corners, part_);
    if (part_.size() < 3 || isSliver(part_)) continue;
    left_.assign(1, part_);
    if (other == beyond.polygon && along(side)) {
      const std::array strip = this->corners(side);
      takeAway({A, strip[0], strip[1], B}, left_);
    }
    const auto isInDisk = [&](const ConvexPart& part) {
      for (const auto& [V, whole] : {std::pair{A, surrounded[0]}, std::pair{B, surrounded[1]}})
        if (whole && std::ranges::find(corners, V) != corners.end() &&
            std::ranges::all_of(part, [&, V = V](const glm::dvec2& v) {
              return length(v - glm::dvec2{V}) <= kDisk * width_;
            }))
          return true;
      return false;
    };
    if (std::ranges::all_of(left_, isInDisk)) continue;
    if (!shows) shows = showsAlong(side);
    if (!*shows) return;
    common(zone, corners, part_);
    FigureLoop loop;
    for (const glm::dvec2& v : part_)
      if (loop.empty() || loop.back() != rounded(v)) loop.push_back(rounded(v));
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    if (loop.size() > 2) loops.push_back(std::move(loop));
  }
}

}  // namespace xnewell
