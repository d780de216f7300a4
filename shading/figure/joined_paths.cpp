#include "shading/figure/joined_paths.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "shading/figure/side_table.h"

namespace xnewell {

namespace {

double length(const glm::dvec2& v) { return std::sqrt(v.x * v.x + v.y * v.y); }
double dot(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.x + a.y * b.y; }

glm::ivec2 rounded(const glm::dvec2& v) {
  return {static_cast<int>(std::floor(v.x + 0.5)), static_cast<int>(std::floor(v.y + 0.5))};
}

/// Traces the borders of paths, with their strips.
class Tracer {
 public:
  /// `path` is the index of each polygon's path; it ascends.
  Tracer(const std::vector<FigurePolygon>& polygons, const std::vector<int>& path, int strip,
         const glm::ivec2& page)
      : polygons_{polygons},
        path_{path},
        strip_{static_cast<double>(strip)},
        table_{polygons},
        grid_{polygons, page.x, page.y} {
    for (const FigurePolygon& p : polygons) traced_.emplace_back(p.corners.size(), false);
  }

  /// The borders of polygons [first, end), which are one path.
  std::vector<FigureLoop> trace(int first, int end) {
    for (int p = first; p < end; ++p)
      for (int k = 0; k < static_cast<int>(traced_[p].size()); ++k) dropInner({p, k});
    std::vector<FigureLoop> loops;
    for (int p = first; p < end; ++p)
      for (int k = 0; k < static_cast<int>(traced_[p].size()); ++k)
        if (!traced_[p][k]) loops.push_back(loopFrom({p, k}));
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

  FigureLoop loopFrom(const PolygonSide& first) {
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
      if (hasStrip(side)) {
        const PolygonSide beyond = table_.beyond(side);
        add(edgeOfStrip(side, table_.next(beyond), table_.from(side), 1));
        add(edgeOfStrip(side, table_.previous(beyond), table_.to(side), -1));
      }
      if (strip_ > 0 && table_.beyond(side).polygon < 0) freeStrip(side, add);
      if (!coverCorner(side, next, add)) add(table_.to(side));
    }
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    return straightened(loop);
  }

  [[nodiscard]] bool hasStrip(const PolygonSide& side) const {
    return strip_ > 0 && pathOf(table_.beyond(side)) > pathOf(side);
  }

  /// A side along which no other polygon has one may still lie right beside others: where surfaces cross.
  /// Adds the corners of a strip if later polygons cover it.
  template <class Add>
  void freeStrip(const PolygonSide& side, const Add& add) {
    if (polygons_[side.polygon].lines[side.corner].kind == SideLine::Kind::Page) return;
    const glm::dvec2 a{table_.from(side)}, b{table_.to(side)}, on = (b - a) / length(b - a);
    const glm::dvec2 out{-on.y, on.x};
    for (const double taper : {0.0, 1.0, 3.0}) {
      const double narrower = std::min(taper * strip_, length(b - a) / 2);
      const FigureLoop area{table_.from(side), rounded(a + out * strip_ + on * narrower),
                            rounded(b + out * strip_ - on * narrower), table_.to(side)};
      if (!isCovered(area, polygons_, side.polygon, kStrip + 1, grid_)) continue;
      add(area[1]), add(area[2]);
      return;
    }
  }

  /// Where the strip along `side` ends at the corner V of the side: on the next side of the polygon beyond,
  /// `along`, which begins (direction 1) or ends (-1) at V. If that turns away by more than a right angle,
  /// the strip ends at a right angle.
  [[nodiscard]] glm::ivec2 edgeOfStrip(const PolygonSide& side, const PolygonSide& along, const glm::ivec2& V,
                                       int direction) const {
    constexpr double kMostSlanted = 3.0;  // widths of the strip
    const double sign = direction;
    const glm::dvec2 on = sign * (glm::dvec2{table_.to(side)} - glm::dvec2{table_.from(side)});
    const glm::dvec2 spoke =
        glm::dvec2{direction == 1 ? table_.to(along) : table_.from(along)} - glm::dvec2{V};
    const double l = length(on), s = length(spoke);
    // outwards: to the right of the side's direction on a screen with y down, as its polygon is to the left
    const glm::dvec2 out = glm::dvec2{-on.y, on.x} * (sign / l);
    const double sine = dot(out, spoke) / s;
    if (dot(on, spoke) >= 0 && sine > 0)
      return rounded(glm::dvec2{V} +
                     spoke * std::min(1.0, std::min(strip_ / sine, kMostSlanted * strip_) / s));
    return rounded(glm::dvec2{V} + out * within(along.polygon, glm::dvec2{V}, out));
  }

  /// How far the ray from V stays in a polygon, at most the width of a strip.
  [[nodiscard]] double within(int polygon, const glm::dvec2& V, const glm::dvec2& ray) const {
    double far = strip_;
    const FigureLoop& corners = polygons_[polygon].corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const glm::dvec2 a = corners[k], side = glm::dvec2{corners[k + 1 == corners.size() ? 0 : k + 1]} - a;
      const double slope = side.y * ray.x - side.x * ray.y;
      const double height = side.y * (V.x - a.x) - side.x * (V.y - a.y);
      if (slope < 0) far = std::min(far, std::max(0.0, height) / -slope);
    }
    return far;
  }

  /// If the path of `side` is painted first at the corner between it and `next`, adds points around the
  /// corner, on the sides that meet there, and returns true.
  template <class Add>
  bool coverCorner(const PolygonSide& side, const PolygonSide& next, const Add& add) const {
    if (!hasStrip(side) || !hasStrip(next)) return false;
    const glm::ivec2 V = table_.to(side);
    std::vector<glm::ivec2> around;
    PolygonSide other = table_.beyond(side);
    const PolygonSide end = table_.beyond(next);
    for (int turns = 0; other != end; ++turns) {
      if (turns == kMostTurns || pathOf(other) < pathOf(side)) return false;
      const PolygonSide spoke = table_.previous(other);  // it ends at the corner
      const PolygonSide beyond = table_.beyond(spoke);
      if (beyond.polygon < 0) return false;
      if (spoke == end) break;
      const glm::dvec2 out = glm::dvec2{table_.from(spoke)} - glm::dvec2{V};
      around.push_back(rounded(glm::dvec2{V} + out * std::min(1.0, kDisk * strip_ / length(out))));
      other = beyond;
    }
    for (const glm::ivec2& v : around) add(v);
    return !around.empty();
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
  static constexpr double kDisk = 1.25;    ///< radius of a disk, in widths of the strip

  const std::vector<FigurePolygon>& polygons_;
  const std::vector<int>& path_;
  double strip_;
  SideTable table_;
  PolygonGrid grid_;
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
    FigurePath made{sorted[first].color, tracer.trace(first, end)};
    if (!made.loops.empty()) paths.push_back(std::move(made));
  }
  return paths;
}

}  // namespace xnewell
