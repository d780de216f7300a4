#include "shading/figure/joined_paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <numeric>
#include <optional>
#include <ranges>
#include <utility>
#include <vector>

#include "shading/figure/shown_polygons.h"
#include "shading/figure/side_table.h"

namespace xnewell {

namespace {

/// ---- Strips

/// What the paths of a figure cover beyond their polygons.
///
/// A renderer mixes the colours of a pixel by the share that each path covers, so it shows the paper between
/// two areas that only touch. So each path also covers what is painted later and lies nearer to it than a
/// strip's width. The later paths hide that again, so every point keeps its colour. But of the paths in a
/// pixel, the one painted first now covers all of the pixel that any path covers, so the paper has no share
/// there. This holds for strips as wide as the diagonal of a pixel, and for all surfaces that touch, cross or
/// hide each other.
class Strips {
 public:
  /// `path` is the index of each polygon's path; it ascends. All arguments must outlive this.
  /// @param width  of a strip, in the steps of a figure; 0: none
  Strips(const std::vector<FigurePolygon>& polygons, const std::vector<int>& path, const SideTable& table,
         int width, const glm::ivec2& page);

  /// True if the polygon beyond a side is painted later: then the strip becomes a part of the outline.
  [[nodiscard]] bool along(const PolygonSide& side) const {
    return width_ > 0 && pathOf(table_.beyond(side)) > pathOf(side);
  }
  /// For such a side, the other two corners of its strip; it lies in the polygon beyond.
  [[nodiscard]] std::array<glm::ivec2, 2> corners(const PolygonSide& side) const {
    const PolygonSide beyond = table_.beyond(side);
    return {end(side, table_.next(beyond), table_.from(side), 1),
            end(side, table_.previous(beyond), table_.to(side), -1)};
  }
  /// The outline of a disk around the corner between two sides of a border, or {}. The path that is painted
  /// first at a corner with polygons all around it covers that disk.
  [[nodiscard]] FigureLoop aroundCorner(const PolygonSide& side, const PolygonSide& next) const;

  /// Adds what lies near a side of a path's border, is painted later, and is in none of the above: beside
  /// narrow polygons, at corners of borders, and where surfaces cross.
  void addOthers(const PolygonSide& side, std::vector<FigureLoop>& loops);

 private:
  [[nodiscard]] int pathOf(const PolygonSide& s) const { return s.polygon < 0 ? -1 : path_[s.polygon]; }
  [[nodiscard]] glm::ivec2 end(const PolygonSide& side, const PolygonSide& along, const glm::ivec2& V,
                               int direction) const;
  [[nodiscard]] double within(int polygon, const glm::dvec2& V, const glm::dvec2& ray) const;
  [[nodiscard]] bool isSurrounded(const PolygonSide& start) const;
  [[nodiscard]] bool showsAlong(const PolygonSide& side);
  /// Finds the later polygons near one, into later_.
  void findLater(int polygon);

  const std::vector<FigurePolygon>& polygons_;
  const std::vector<int>& path_;
  const SideTable& table_;
  double width_;
  PolygonGrid grid_;
  int near_ = -1;  ///< the polygon of later_
  std::vector<int> later_;
  ConvexPart part_;
  std::vector<ConvexPart> left_;
};

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

/// Traces the borders of paths, with their strips.
class Tracer {
 public:
  /// `path` is the index of each polygon's path; it ascends.
  Tracer(const std::vector<FigurePolygon>& polygons, const std::vector<int>& path, int strip,
         const glm::ivec2& page)
      : polygons_{polygons}, path_{path}, table_{polygons}, strips_{polygons, path, table_, strip, page} {
    for (const FigurePolygon& p : polygons) traced_.emplace_back(p.corners.size(), false);
  }

  /// The borders of polygons [first, end), which are one path.
  std::vector<FigureLoop> trace(int first, int end) {
    for (int p = first; p < end; ++p)
      for (int k = 0; k < static_cast<int>(traced_[p].size()); ++k) dropInner({p, k});
    std::vector<FigureLoop> loops;
    for (int p = first; p < end; ++p)
      for (int k = 0; k < static_cast<int>(traced_[p].size()); ++k)
        if (!traced_[p][k]) loopFrom({p, k}, loops);
    std::erase_if(loops, [](const FigureLoop& loop) { return loop.size() < 3; });
    return loops;
  }

 private:
  [[nodiscard]] int pathOf(const PolygonSide& s) const { return s.polygon < 0 ? -1 : path_[s.polygon]; }
  [[nodiscard]] bool isTraced(const PolygonSide& s) const { return traced_[s.polygon][s.corner]; }
  void mark(const PolygonSide& s) { traced_[s.polygon][s.corner] = true; }

  /// Two polygons of one path have no border between them.
  void dropInner(const PolygonSide& side) {
    if (isTraced(side)) return;
    const PolygonSide beyond = table_.beyond(side);
    if (pathOf(beyond) != pathOf(side) || isTraced(beyond)) return;
    if (table_.beyond(beyond) != side) return;  // other polygons have the same side
    mark(side), mark(beyond);
  }

  /// The side of the border after `side`, which was not traced before: the one that turns around the corner
  /// through polygons of the same path.
  [[nodiscard]] std::optional<PolygonSide> after(const PolygonSide& side) const {
    PolygonSide next = table_.next(side);
    for (int turns = 0; turns < kMostTurns; ++turns) {
      if (!isTraced(next)) return next;
      const PolygonSide beyond = table_.beyond(next);
      if (pathOf(beyond) != pathOf(side)) break;
      next = table_.next(beyond);
    }
    return {};
  }

  /// Adds the loop with a side, and what its sides need elsewhere.
  void loopFrom(const PolygonSide& first, std::vector<FigureLoop>& loops) {
    std::vector<PolygonSide> sides{first};
    mark(first);
    const glm::ivec2 start = table_.from(first);
    while (table_.to(sides.back()) != start) {
      const std::optional<PolygonSide> next = after(sides.back());
      if (!next) break;
      sides.push_back(*next);
      mark(*next);
    }
    FigureLoop loop;
    const auto add = [&](const glm::ivec2& v) {
      if (loop.empty() || loop.back() != v) loop.push_back(v);
    };
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const PolygonSide &side = sides[k], &next = sides[k + 1 == sides.size() ? 0 : k + 1];
      if (strips_.along(side))
        for (const glm::ivec2& v : strips_.corners(side)) add(v);
      const FigureLoop disk = strips_.aroundCorner(side, next);
      for (const glm::ivec2& v : disk) add(v);
      if (disk.empty()) add(table_.to(side));
    }
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    loops.push_back(straightened(loop));
    for (const PolygonSide& side : sides) strips_.addOthers(side, loops);
  }

  static FigureLoop straightened(const FigureLoop& loop) {
    FigureLoop straight;
    const std::size_t n = loop.size();
    for (std::size_t k = 0; k < n; ++k) {
      const glm::ivec2 a = straight.empty() ? loop[n - 1] : straight.back();
      const glm::ivec2 u = loop[k] - a, v = loop[k + 1 == n ? 0 : k + 1] - loop[k];
      const bool goesOn = std::int64_t{u.x} * v.y == std::int64_t{u.y} * v.x &&
                          std::int64_t{u.x} * v.x + std::int64_t{u.y} * v.y > 0;
      if (!goesOn) straight.push_back(loop[k]);
    }
    return straight;
  }

  static constexpr int kMostTurns = 1000;  ///< polygons around a corner

  const std::vector<FigurePolygon>& polygons_;
  const std::vector<int>& path_;
  SideTable table_;
  Strips strips_;
  std::vector<std::vector<bool>> traced_;
};

}  // namespace

std::vector<FigurePath> joinedPaths(std::vector<FigurePolygon> polygons, const std::vector<int>& levels,
                                    int strip, int width, int height) {
  std::vector<int> order(polygons.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](int a, int b) {
    return std::pair{levels[a], polygons[a].color} < std::pair{levels[b], polygons[b].color};
  });
  std::vector<FigurePolygon> sorted;
  std::vector<int> path;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same =
        k > 0 && levels[order[k]] == levels[order[k - 1]] && polygons[order[k]].color == sorted.back().color;
    path.push_back(k == 0 ? 0 : path.back() + !same);
    sorted.push_back(std::move(polygons[order[k]]));
  }
  meetAtCorners(sorted);
  Tracer tracer{sorted, path, strip, {width, height}};
  std::vector<FigurePath> paths;
  for (int first = 0, end = 0; first < static_cast<int>(sorted.size()); first = end) {
    while (end < static_cast<int>(sorted.size()) && path[end] == path[first]) ++end;
    FigurePath made{sorted[first].color, tracer.trace(first, end), levels[order[first]]};
    if (!made.loops.empty()) paths.push_back(std::move(made));
  }
  return paths;
}

}  // namespace xnewell
