#include "shading/figure/joined_paths.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "shading/figure/side_table.h"
#include "shading/figure/strips.h"

namespace xnewell {

namespace {

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
