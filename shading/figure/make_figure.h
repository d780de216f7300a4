#pragma once

#include <stdexcept>

#include "shading/figure/figure.h"
#include "shading/figure/joined_paths.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// What a figure of a picture shows.
enum class FigureColors {
  Shades,  ///< the picture
  Ids      ///< each face in the colour of its number + 1, red the highest byte
};

/// The order of painting of a picture, for a figure: that of sortEveryFace() for Order::Newell, or
/// a list by one key. @throws TooManyPieces
[[nodiscard]] SortedScene figureOrder(const Picture& picture, Order order);

/// Makes the figure of a picture. The cells' colours are those of `palette`.
/// Preconditions: the picture is painted and has planes (Picture::withPlanes()), and its method of shading
/// gives each face a single cell.
[[nodiscard]] VectorFigure makeFigure(const Picture& picture, const SortedScene& order,
                                      const Palette& palette, FigureColors colors = FigureColors::Shades,
                                      int strip = kStrip);

}  // namespace xnewell
