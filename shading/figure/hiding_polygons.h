#pragma once

#include <vector>

#include "shading/figure/convex_part.h"
#include "shading/figure/shown_polygons.h"
#include "shading/figure/side_table.h"

namespace xnewell {

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
