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

namespace {

/// The sides of polygons by their ends.
class SidesByEnds {
 public:
  explicit SidesByEnds(std::size_t sides) : entries_(sides) {
    while (shift_ > 36 && (std::size_t{1} << (64 - shift_)) < sides) --shift_;
    begin_.assign((std::size_t{1} << (64 - shift_)) + 1, -1);
  }
  void add(const glm::ivec2& from, const glm::ivec2& to, const PolygonSide& side) {
    int& first = begin_[bucket(key(from), key(to))];
    entries_[count_] = {key(from), key(to), side, first};
    first = count_++;
  }
  /// The one that was added last; polygon = -1 if there is none.
  [[nodiscard]] PolygonSide last(const glm::ivec2& a, const glm::ivec2& b) const {
    const std::uint64_t from = key(a), to = key(b);
    for (int k = begin_[bucket(from, to)]; k >= 0; k = entries_[k].next)
      if (entries_[k].from == from && entries_[k].to == to) return entries_[k].side;
    return {};
  }

 private:
  struct Entry {
    std::uint64_t from, to;
    PolygonSide side;
    int next;  ///< in the same bucket
  };
  [[nodiscard]] static std::uint64_t key(const glm::ivec2& v) {
    return std::uint64_t{static_cast<std::uint32_t>(v.x)} << 32 | static_cast<std::uint32_t>(v.y);
  }
  [[nodiscard]] std::size_t bucket(std::uint64_t from, std::uint64_t to) const {
    return (from * 0x9E3779B97F4A7C15U ^ (to + (from >> 29)) * 0xC2B2AE3D27D4EB4FU) >> shift_;
  }
  int shift_ = 60, count_ = 0;
  std::vector<int> begin_;
  std::vector<Entry> entries_;
};

}  // namespace

SideTable::SideTable(const std::vector<FigurePolygon>& polygons) : polygons_{polygons} {
  std::size_t sides = 0;
  for (const FigurePolygon& p : polygons) {
    first_.push_back(sides);
    sides += p.corners.size();
  }
  SidesByEnds table{sides};
  const auto forEachSide = [&](auto use) {
    for (int p = 0; p < static_cast<int>(polygons.size()); ++p)
      for (int k = 0; k < static_cast<int>(polygons[p].corners.size()); ++k) use(PolygonSide{p, k});
  };
  forEachSide([&](const PolygonSide& s) { table.add(from(s), to(s), s); });
  beyond_.reserve(sides);
  forEachSide([&](const PolygonSide& s) { beyond_.push_back(table.last(to(s), from(s))); });
}

}  // namespace xnewell
