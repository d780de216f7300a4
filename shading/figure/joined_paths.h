#pragma once

#include <vector>

#include "shading/figure/figure.h"
#include "shading/figure/shown_polygons.h"

namespace xnewell {

/// Makes the paths of a figure from polygons that are not hidden. `levels` are those of levelsOf(). Polygons
/// of one level and one colour become one path, and the borders between them vanish.
/// What is beside them and painted later gets their colour first, for the width of a strip.
/// @param strip  its width in the steps of a figure; 0: no strips
/// @param width, height  of the page, in pixels
[[nodiscard]] std::vector<FigurePath> joinedPaths(std::vector<FigurePolygon> polygons,
                                                  const std::vector<int>& levels, int strip, int width,
                                                  int height);

/// How wide the strips are: the diagonal of a pixel, and a little more.
inline constexpr int kStrip = kFigureSteps * 3 / 2;

}  // namespace xnewell
