#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "shading/figure/shown_polygons.h"

namespace xnewell {

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

}  // namespace xnewell
