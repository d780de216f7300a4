#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "depthsort/depth_sort.h"
#include "shading/figure/figure.h"

namespace xnewell {

/// Convex parts of the page, in the steps of a figure; counter-clockwise as seen (y down).
using ConvexPart = std::vector<glm::dvec2>;

/// Positive if b points to the left of a as seen.
[[nodiscard]] inline double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.y * b.x - a.x * b.y; }

/// Sets `to` to what lies to the left of the line through a along `side` (sign 1), or to its right (-1).
void clipPart(const ConvexPart& part, const glm::dvec2& a, const glm::dvec2& side, double sign,
              ConvexPart& to);

/// Sets `to` to what a part has in common with a convex polygon.
void common(const ConvexPart& part, const FigureLoop& q, ConvexPart& to);

/// Twice the area of a loop; positive if it runs counter-clockwise as seen.
[[nodiscard]] std::int64_t doubleArea(const FigureLoop& loop);

/// True if the part is thinner than the rounding of corners may make it.
[[nodiscard]] bool isSliver(const ConvexPart& part);

/// Takes the polygon q away from the parts. What is left of those that it cuts comes last.
void takeAway(const FigureLoop& q, std::vector<ConvexPart>& parts);

/// True if the polygons overlap by more than the rounding of their corners may make them.
[[nodiscard]] bool overlap(const FigureLoop& p, const FigureLoop& q);

/// The line of the scene on which a side of a polygon lies. Sides of one line meet there; between them are no
/// gaps.
struct SideLine {
  /// Page: the border of the page. Shade: a border between two shades of a face.
  enum class Kind : std::uint8_t { Page, Edge, Cut, Shade };
  Kind kind = Kind::Page;
  /// Edge: the places of its ends on the screen grid, packed. Cut: two planes. Smaller first. Shade: a
  /// polygon and one of its lines.
  std::uint64_t a = 0, b = 0;
  auto operator<=>(const SideLine&) const = default;
};

/// The line of an edge between two vertices on the screen grid.
[[nodiscard]] SideLine edgeOf(const glm::ivec3& from, const glm::ivec3& to);

/// A fragment of the painting order, or a part of one, in the steps of a figure.
/// Holds: counter-clockwise as seen (y down), with an area; convex but for the rounding of its corners.
struct FigurePolygon {
  FigureLoop corners;
  std::vector<SideLine> lines;  ///< lines[k]: of the side from corner k to the next one
  int face = 0;                 ///< index into SnappedScene::faces
  FigureColor color{};
};

/// The fragments as polygons, in the same order. Those outside of a page of that size, in pixels, are left
/// out. The others are clipped a little outside of it.
[[nodiscard]] std::vector<FigurePolygon> polygonsOf(const SnappedScene& scene, const SortedScene& sorted,
                                                    int width, int height);

/// Finds the polygons whose boxes may overlap a box.
class PolygonGrid {
 public:
  static constexpr int kMargin = 2 * kFigureSteps;  ///< how far outside of the page polygons are clipped

  PolygonGrid(const std::vector<FigurePolygon>& polygons, int width, int height);
  /// Calls use(k) once for each polygon k whose box overlaps that of `polygon`, made larger by `beyond`
  /// steps, in no order.
  template <class Use>
  void forEachNear(int polygon, int beyond, Use&& use) {
    const Box& of = boxes_[polygon];
    const Box box{std::max(0, of.x0 - beyond), std::max(0, of.y0 - beyond), std::min(right_, of.x1 + beyond),
                  std::min(bottom_, of.y1 + beyond)};
    ++round_;
    for (int j = box.y0 / side_; j <= box.y1 / side_; ++j)
      for (int i = box.x0 / side_; i <= box.x1 / side_; ++i) {
        const std::size_t cell = std::size_t(j) * columns_ + i;
        for (int at = begin_[cell]; at < begin_[cell + 1]; ++at) {
          const int k = members_[at];
          if (met_[k] == round_) continue;
          met_[k] = round_;
          const Box& o = boxes_[k];
          if (o.x0 < box.x1 && box.x0 < o.x1 && o.y0 < box.y1 && box.y0 < o.y1) use(k);
        }
      }
  }

  /// Calls use(k) for each polygon k whose box holds a point, from the last to the first, until it returns
  /// true.
  template <class Use>
  void untilAt(const glm::dvec2& point, Use&& use) const {
    const int x = moved(static_cast<int>(std::floor(point.x)), right_),
              y = moved(static_cast<int>(std::floor(point.y)), bottom_);
    const std::size_t cell = std::size_t(y / side_) * columns_ + x / side_;
    for (int at = begin_[cell + 1]; at-- > begin_[cell];) {
      const Box& o = boxes_[members_[at]];
      if (o.x0 <= x && x <= o.x1 && o.y0 <= y && y <= o.y1 && use(members_[at])) return;
    }
  }

 private:
  /// A coordinate so that none is negative.
  [[nodiscard]] static int moved(int at, int most) { return std::clamp(at + kMargin, 0, most); }
  struct Box {
    int x0, y0, x1, y1;  ///< moved
  };
  int side_, columns_, rows_, right_, bottom_, round_ = 0;
  std::vector<Box> boxes_;
  std::vector<int> begin_, members_, met_;
};

/// For each polygon a level: one more than the highest of the earlier polygons that it overlaps; 0 if there
/// are none. So the polygons may be painted level by level, and those of one level in any order.
[[nodiscard]] std::vector<int> levelsOf(const std::vector<FigurePolygon>& polygons, int width, int height);

}  // namespace xnewell
