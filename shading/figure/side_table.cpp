#include "shading/figure/side_table.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace xnewell {

namespace {

/// A side of a line that others share.
struct OnLine {
  SideLine line;
  int polygon, corner;
};

/// Puts into `within` the points of `all` that lie between a and b, in the order from a to b. All lie on one
/// line, but for their rounding; `all` is in ascending order of the coordinate that changes more.
void between(const glm::ivec2& a, const glm::ivec2& b, const std::vector<glm::ivec2>& all,
             FigureLoop& within) {
  const bool byX = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
  const auto along = [byX](const glm::ivec2& v) { return byX ? v.x : v.y; };
  const int low = std::min(along(a), along(b)), high = std::max(along(a), along(b));
  within.clear();
  for (const glm::ivec2& v : all)
    if (along(v) > low && along(v) < high && (within.empty() || within.back() != v)) within.push_back(v);
  std::ranges::sort(within, [&](const glm::ivec2& u, const glm::ivec2& v) {
    return along(a) < along(b) ? along(u) < along(v) : along(u) > along(v);
  });
}

}  // namespace

void meetAtCorners(std::vector<FigurePolygon>& polygons) {
  std::vector<OnLine> sides;
  for (int p = 0; p < static_cast<int>(polygons.size()); ++p)
    for (int k = 0; k < static_cast<int>(polygons[p].corners.size()); ++k)
      if (polygons[p].lines[k].kind != SideLine::Kind::Page) sides.push_back({polygons[p].lines[k], p, k});
  std::ranges::stable_sort(sides, {}, &OnLine::line);
  const auto ends = [&](const OnLine& side) {
    const FigureLoop& corners = polygons[side.polygon].corners;
    return std::pair{corners[side.corner],
                     corners[side.corner + 1 == std::ssize(corners) ? 0 : side.corner + 1]};
  };
  struct Added {
    int polygon, corner;
    FigureLoop points;
  };
  std::vector<Added> added;
  std::vector<glm::ivec2> all;
  FigureLoop within;
  const auto less = [](const glm::ivec2& u, const glm::ivec2& v) {
    return std::pair{u.x, u.y} < std::pair{v.x, v.y};
  };
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end = std::find_if(begin, sides.end(), [&](const OnLine& s) { return s.line != begin->line; });
    all.clear();
    for (auto side = begin; side != end; ++side) {
      const auto [a, b] = ends(*side);
      all.push_back(a), all.push_back(b);
    }
    std::ranges::sort(all, less);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (auto side = begin; all.size() > 2 && side != end; ++side) {
      const auto [a, b] = ends(*side);
      between(a, b, all, within);
      if (!within.empty()) added.push_back({side->polygon, side->corner, within});
    }
    begin = end;
  }
  // From the last corner to the first, so that the indices of those before stay right.
  std::ranges::sort(added, [](const Added& u, const Added& v) {
    return std::pair{u.polygon, -u.corner} < std::pair{v.polygon, -v.corner};
  });
  for (const Added& more : added) {
    FigurePolygon& polygon = polygons[more.polygon];
    const SideLine line = polygon.lines[more.corner];
    polygon.corners.insert(polygon.corners.begin() + more.corner + 1, more.points.begin(), more.points.end());
    polygon.lines.insert(polygon.lines.begin() + more.corner + 1, more.points.size(), line);
  }
}

SideTable::SideTable(const std::vector<FigurePolygon>& polygons) : polygons_{polygons} {
  std::size_t sides = 0;
  for (const FigurePolygon& p : polygons) sides += p.corners.size();
  while (shift_ > 36 && (std::size_t{1} << (64 - shift_)) < sides) --shift_;
  begin_.assign((std::size_t{1} << (64 - shift_)) + 1, 0);
  const auto forEachSide = [&](auto use) {
    for (int p = 0; p < static_cast<int>(polygons.size()); ++p)
      for (int k = 0; k < static_cast<int>(polygons[p].corners.size()); ++k) {
        const PolygonSide side{p, k};
        use(Entry{key(from(side)), key(to(side)), side});
      }
  };
  forEachSide([&](const Entry& e) { ++begin_[bucket(e.from, e.to) + 1]; });
  for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
  entries_.resize(sides);
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  forEachSide([&](const Entry& e) { entries_[next[bucket(e.from, e.to)]++] = e; });
}

PolygonSide SideTable::last(const glm::ivec2& a, const glm::ivec2& b) const {
  const std::uint64_t from = key(a), to = key(b);
  const std::size_t at = bucket(from, to);
  PolygonSide found;
  for (std::size_t k = begin_[at]; k < begin_[at + 1]; ++k)  // in ascending order of the polygons
    if (entries_[k].from == from && entries_[k].to == to) found = entries_[k].side;
  return found;
}

}  // namespace xnewell
