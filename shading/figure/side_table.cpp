#include "shading/figure/side_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <utility>

#include "shading/figure/shown_polygons.h"

namespace xnewell {

LinearOver LinearOver::through(const std::array<glm::dvec2, 3>& at, const std::array<double, 3>& v) {
  const glm::dvec2 a = at[1] - at[0], b = at[2] - at[0];
  const double area = a.x * b.y - a.y * b.x, u = v[1] - v[0], w = v[2] - v[0];
  LinearOver over{(u * b.y - w * a.y) / area, (w * a.x - u * b.x) / area, 0};
  over.c = v[0] - over(at[0]);
  return over;
}

SidedPart sided(const FigurePolygon& polygon) {
  SidedPart part;
  for (std::size_t k = 0; k < polygon.corners.size(); ++k)
    part.push_back({glm::dvec2{polygon.corners[k]}, polygon.lines[k]});
  return part;
}

SidedPart clipped(const SidedPart& part, const LinearOver& value, const SideLine& line) {
  SidedPart left;
  for (std::size_t k = 0; k < part.size(); ++k) {
    const SidedCorner &u = part[k], &v = part[k + 1 == part.size() ? 0 : k + 1];
    const double hu = value(u.at), hv = value(v.at);
    if (hu >= 0) left.push_back({u.at, hu == 0 && hv < 0 ? line : u.line});
    if ((hu > 0 && hv < 0) || (hu < 0 && hv > 0))
      left.push_back({u.at + (v.at - u.at) * (hu / (hu - hv)), hu > 0 ? line : u.line});
  }
  return left;
}

void addRounded(const SidedPart& part, int face, const FigureColor& color, std::vector<FigurePolygon>& to) {
  FigurePolygon polygon;
  polygon.face = face, polygon.color = color;
  const auto rounded = [](const glm::dvec2& v) {
    return glm::ivec2{static_cast<int>(std::floor(v.x + 0.5)), static_cast<int>(std::floor(v.y + 0.5))};
  };
  for (std::size_t k = 0; k < part.size(); ++k) {
    const glm::ivec2 from = rounded(part[k].at);
    if (from == rounded(part[k + 1 == part.size() ? 0 : k + 1].at)) continue;
    polygon.corners.push_back(from);
    polygon.lines.push_back(part[k].line);
  }
  if (doubleArea(polygon.corners) > 0) to.push_back(std::move(polygon));
}

namespace {

using Color = FigureColor;

/// The colour of a face in a pixel: that of its nearest sample; if there is none near, that of the sample.
Color colorIn(const ShownSamples& samples, int face, int i, int j) {
  constexpr int kFar = 3;
  i = std::clamp(i, 0, samples.width - 1), j = std::clamp(j, 0, samples.height - 1);
  const auto at = [&](int x, int y) { return std::size_t(y) * samples.width + x; };
  if (samples.faces[at(i, j)] == face) return samples.colors[at(i, j)];
  int nearest = 2 * kFar * kFar + 1;
  Color color = samples.colors[at(i, j)];
  for (int y = std::max(0, j - kFar); y <= std::min(samples.height - 1, j + kFar); ++y)
    for (int x = std::max(0, i - kFar); x <= std::min(samples.width - 1, i + kFar); ++x) {
      const int distance = (x - i) * (x - i) + (y - j) * (y - j);
      if (samples.faces[at(x, y)] == face && distance < nearest)
        nearest = distance, color = samples.colors[at(x, y)];
    }
  return color;
}

}  // namespace

int splitIntoRuns(const FigurePolygon& polygon, int index, const ShownSamples& samples, int tolerance,
                  std::vector<FigurePolygon>& to) {
  const auto pixel = [](double steps) { return static_cast<int>(std::floor(steps / kFigureSteps)); };
  const auto [top, bottom] = std::ranges::minmax(polygon.corners, {}, &glm::ivec2::y);
  const auto lineAt = [index](bool upright, int at) {
    return SideLine{SideLine::Kind::Shade, static_cast<std::uint64_t>(index) * 2 + (upright ? 1 : 0),
                    static_cast<std::uint64_t>(at + kFigureSteps)};
  };
  int off = 0;
  SidedPart below = sided(polygon);
  for (int j = pixel(top.y); j <= pixel(bottom.y) && !below.empty(); ++j) {
    const double end = (j + 1.0) * kFigureSteps;
    SidedPart row = clipped(below, {0, -1, end}, lineAt(false, j + 1));
    below = clipped(below, {0, 1, -end}, lineAt(false, j + 1));
    if (row.size() < 3) continue;
    double left = HUGE_VAL, right = -HUGE_VAL;
    for (const SidedCorner& c : row) left = std::min(left, c.at.x), right = std::max(right, c.at.x);
    ColorBox run;
    run.add(colorIn(samples, polygon.face, pixel(left), j));
    for (int i = pixel(left) + 1; i <= pixel(right); ++i) {
      const Color color = colorIn(samples, polygon.face, i, j);
      ColorBox longer = run;
      longer.add(color);
      if (longer.radius() > tolerance) {
        const double at = static_cast<double>(i) * kFigureSteps;
        addRounded(clipped(row, {-1, 0, at}, lineAt(true, i)), polygon.face, run.middle(), to);
        row = clipped(row, {1, 0, -at}, lineAt(true, i));
        off = std::max(off, run.radius());
        longer = {};
        longer.add(color);
      }
      run = longer;
    }
    off = std::max(off, run.radius());
    addRounded(row, polygon.face, run.middle(), to);
  }
  return off;
}

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
