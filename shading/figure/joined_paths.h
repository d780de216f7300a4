#pragma once

#include <vector>

#include "shading/figure/figure.h"
#include "shading/figure/shown_polygons.h"

namespace xnewell {

/// Makes the paths of a figure from polygons that are not hidden. `levels` are those of levelsOf(). Polygons
/// of one level and one colour become one path, and the borders between them vanish.
///
/// A renderer mixes the colours of a pixel by the share that each path covers, so it shows the paper between
/// two areas that only touch. So each polygon also covers a strip of the polygons beside it that are painted
/// later. They hide the strip, so every point keeps its colour; but the paper has no share in a pixel at the
/// border. Where surfaces cross, the polygons have no common side, and a strip is added only where later ones
/// cover it. The polygon that is painted first at a corner covers a disk around the corner.
/// @param strip  its width in the steps of a figure; 0: no strips
/// @param width, height  of the page, in pixels
[[nodiscard]] std::vector<FigurePath> joinedPaths(std::vector<FigurePolygon> polygons,
                                                  const std::vector<int>& levels, int strip, int width,
                                                  int height);

/// How wide the strips are: the diagonal of a pixel, and a little more.
inline constexpr int kStrip = kFigureSteps * 3 / 2;

}  // namespace xnewell
