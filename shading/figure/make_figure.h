#pragma once

#include <stdexcept>

#include "shading/figure/figure.h"
#include "shading/figure/joined_paths.h"
#include "shading/figure/shades.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// What a figure of a picture shows.
enum class FigureColors {
  Shades,  ///< the picture
  Ids      ///< each face in the colour of its number + 1, red the highest byte
};

/// The order of painting of a picture, for a figure, which has no samples: that of depthSort() for
/// Order::Newell, or a list by one key. @throws TooManyPieces
[[nodiscard]] SortedScene figureOrder(const Picture& picture, Order order);

/// How polygons are split whose shade is not the same everywhere (shades.h).
struct ShadeSplit {
  int tolerance = 0;     ///< in steps of 1/255 of each channel
  ShownSamples samples;  ///< if needsSamples()
  bool smooth = false;   ///< Gouraud shading as triangles with a colour at each corner
};

/// Makes the figure of a picture. The cells' colours are those of `palette`.
/// Precondition: the picture is painted and has planes (Picture::withPlanes()).
[[nodiscard]] VectorFigure makeFigure(const Picture& picture, const SortedScene& order,
                                      const Palette& palette, FigureColors colors = FigureColors::Shades,
                                      const ShadeSplit& split = {}, int strip = kStrip);

/// Only the edges, lines and labels that the scene's picture shows, without paths.
[[nodiscard]] VectorFigure marksOf(const Picture& picture);

/// All that a scene's figures are made of. @throws ViewError, TooManyPieces
struct FigureStages {
  Picture picture;
  bool samples;  ///< whether colours come from the picture's samples
  SortedScene order;
  Palette palette;
  ShadeSplit split;

  FigureStages(const Scene& scene, const PictureSettings& settings, int tolerance, bool smooth = false);
  [[nodiscard]] VectorFigure figure(FigureColors colors = FigureColors::Shades) const;
};

}  // namespace xnewell
