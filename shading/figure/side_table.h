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

/// Finds the sides between two points. The polygons must outlive it and stay as they are.
class SideTable {
 public:
  explicit SideTable(const std::vector<FigurePolygon>& polygons);

  /// The last polygon with a side from a to b; polygon = -1 if there is none.
  [[nodiscard]] PolygonSide last(const glm::ivec2& a, const glm::ivec2& b) const;
  /// What lies on the other side of a side.
  [[nodiscard]] PolygonSide beyond(const PolygonSide& side) const { return last(to(side), from(side)); }

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
  struct Entry {
    std::uint64_t from, to;
    PolygonSide side;
  };
  [[nodiscard]] static std::uint64_t key(const glm::ivec2& v) {
    return std::uint64_t{static_cast<std::uint32_t>(v.x)} << 32 | static_cast<std::uint32_t>(v.y);
  }
  [[nodiscard]] std::size_t bucket(std::uint64_t from, std::uint64_t to) const {
    return (from * 0x9E3779B97F4A7C15U ^ (to + (from >> 29)) * 0xC2B2AE3D27D4EB4FU) >> shift_;
  }
  const std::vector<FigurePolygon>& polygons_;
  int shift_ = 60;
  std::vector<std::size_t> begin_;  ///< of each bucket, in entries_
  std::vector<Entry> entries_;
};

}  // namespace xnewell
