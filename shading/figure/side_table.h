#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "shading/figure/shades.h"
#include "shading/figure/shown_polygons.h"

namespace xnewell {

/// What shades.h makes polygons with: convex parts whose sides know their lines.

/// A corner of a part, and the line of the side from it to the next one.
struct SidedCorner {
  glm::dvec2 at;
  SideLine line;
};
using SidedPart = std::vector<SidedCorner>;

/// A value over the page: x (at.x) + y (at.y) + c.
struct LinearOver {
  double x = 0, y = 0, c = 0;
  [[nodiscard]] double operator()(const glm::dvec2& at) const { return x * at.x + y * at.y + c; }
  [[nodiscard]] LinearOver negative() const { return {-x, -y, -c}; }
  /// Positive to the left of the way from a to b, as seen.
  [[nodiscard]] static LinearOver besides(const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 on = b - a;
    return {on.y, -on.x, on.x * a.y - on.y * a.x};
  }
  /// With the values v at three places that are on no common line.
  [[nodiscard]] static LinearOver through(const std::array<glm::dvec2, 3>& at,
                                          const std::array<double, 3>& v);
};

[[nodiscard]] SidedPart sided(const FigurePolygon& polygon);
/// The part where a value is not negative. The side that this makes lies on `line`.
[[nodiscard]] SidedPart clipped(const SidedPart& part, const LinearOver& value, const SideLine& line);
/// Adds a part as a polygon with rounded corners, if it keeps an area.
void addRounded(const SidedPart& part, int face, const FigureColor& color, std::vector<FigurePolygon>& to);

/// The least box around some colours.
struct ColorBox {
  FigureColor low{255, 255, 255}, high{0, 0, 0};
  void add(const FigureColor& color) {
    for (int c = 0; c < 3; ++c) low[c] = std::min(low[c], color[c]), high[c] = std::max(high[c], color[c]);
  }
  [[nodiscard]] FigureColor middle() const {
    FigureColor middle;
    for (int c = 0; c < 3; ++c) middle[c] = static_cast<std::uint8_t>((low[c] + high[c]) / 2);
    return middle;
  }
  /// How far the middle is from the others.
  [[nodiscard]] int radius() const {
    int most = 0;
    for (int c = 0; c < 3; ++c) most = std::max(most, (high[c] - low[c] + 1) / 2);
    return most;
  }
};

/// Cuts a polygon, the index-th, into runs of pixels of one colour; see shadePartsOf().
/// @return  how far a run's colour is at most from that of a sample
int splitIntoRuns(const FigurePolygon& polygon, int index, const ShownSamples& samples, int tolerance,
                  std::vector<FigurePolygon>& to);

/// Polygons that lie side by side, found by the ends of their sides.

/// Adds corners where another polygon of the same line has one within a side. After that, two polygons that
/// meet along a line have sides with the same ends there.
void meetAtCorners(std::vector<FigurePolygon>& polygons);

/// A side of a polygon: from this corner to the next one.
struct PolygonSide {
  int polygon = -1, corner = 0;
  bool operator==(const PolygonSide&) const = default;
};

/// Tells what lies beside each side. The polygons must outlive it and stay as they are.
class SideTable {
 public:
  explicit SideTable(const std::vector<FigurePolygon>& polygons);

  /// The side of the last polygon on the other side of a side, with the same ends; polygon = -1 if there is
  /// none.
  [[nodiscard]] const PolygonSide& beyond(const PolygonSide& s) const {
    return beyond_[first_[s.polygon] + s.corner];
  }

  [[nodiscard]] const glm::ivec2& from(const PolygonSide& s) const {
    return polygons_[s.polygon].corners[s.corner];
  }
  [[nodiscard]] const glm::ivec2& to(const PolygonSide& s) const { return from(next(s)); }
  [[nodiscard]] PolygonSide next(const PolygonSide& s) const {
    return {s.polygon, s.corner + 1 == count(s) ? 0 : s.corner + 1};
  }
  [[nodiscard]] PolygonSide previous(const PolygonSide& s) const {
    return {s.polygon, (s.corner == 0 ? count(s) : s.corner) - 1};
  }

 private:
  [[nodiscard]] int count(const PolygonSide& s) const {
    return static_cast<int>(polygons_[s.polygon].corners.size());
  }
  const std::vector<FigurePolygon>& polygons_;
  std::vector<std::size_t> first_;  ///< of each polygon, in beyond_
  std::vector<PolygonSide> beyond_;
};

/// Finds the polygons that later ones hide.
class HidingPolygons {
 public:
  /// The polygons and the table must outlive this.
  HidingPolygons(const std::vector<FigurePolygon>& polygons, const SideTable& sides, int width, int height);

  /// True if later polygons cover all of a polygon, and all of the page that is nearer to it than `beyond`,
  /// in the steps of a figure; slivers thinner than the rounding do not count. The pixels at the border of
  /// what hides a polygon show some of it, so one that is hidden by less than a pixel is still needed.
  /// True too if a polygon has no area on the page.
  [[nodiscard]] bool hides(int polygon, int beyond);

 private:
  template <class Use>
  [[nodiscard]] bool isUnder(const glm::dvec2& point, int polygon, Use&& use) const;
  [[nodiscard]] bool surfaceCovers(int start, int polygon, const ConvexPart& part);
  [[nodiscard]] bool nothingIsLeft(int polygon, int beyond, const ConvexPart& part);

  const std::vector<FigurePolygon>& polygons_;
  const SideTable& sides_;
  glm::ivec2 page_;
  PolygonGrid grid_;
  std::vector<int> met_, open_, over_;
  int round_ = 0;
  bool metEarlier_ = false;  ///< the surface goes on in a polygon that is painted before the hidden one
};

}  // namespace xnewell
