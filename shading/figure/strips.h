#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "shading/figure/convex_part.h"
#include "shading/figure/shown_polygons.h"
#include "shading/figure/side_table.h"

namespace xnewell {

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

}  // namespace xnewell
