#pragma once

#include <map>
#include <vector>

#include "shading/figure/shown_polygons.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// Polygons whose shade changes from place to place become polygons of one colour each.

/// How the shades of a picture's faces lie over them.
enum class ShadesOver {
  Face,    ///< one shade each
  Bands,   ///< Gouraud shading: within a triangle, each cell is a band between two parallel lines
  Samples  ///< all others: only the samples of the picture tell
};
[[nodiscard]] ShadesOver shadesOver(const Picture& picture, const SnappedFace& face);
/// True if a face of the picture has its shades from samples.
[[nodiscard]] bool needsSamples(const Picture& picture);

/// What the samples of a painted picture show.
struct ShownSamples {
  int width = 0, height = 0;
  std::vector<int> faces;  ///< indices into SnappedScene::faces; kNothing where no face shows
  std::vector<FigureColor> colors;
};
[[nodiscard]] ShownSamples shownSamples(const Picture& painted, const Palette& palette);

inline constexpr int kRanks = 256;

/// Polygons that are painted right after those of their level: shades that differ from the polygon's colour.
struct ShadeParts {
  std::vector<FigurePolygon> polygons;
  std::vector<int> levels;  ///< kRanks times that of their polygon, and a rank: painted in ascending order
  std::map<int, std::vector<FigureTriangle>> smooth;  ///< by the level of their polygon
  int off = 0;  ///< how far a colour is at most from the picture's, in steps of 1/255 of a channel
};

/// Splits the polygons whose shade is not the same everywhere. Each gets one of its colours and is painted as
/// a whole first, so no paper shows between its parts. In Gouraud shading the colour is its least, and what
/// is brighter than the start of a cell, beyond an exact line, is painted over it. From samples, each row of
/// pixels is cut into runs; where a face shows in a pixel but not at its sample, it takes the colour of its
/// nearest sample.
/// @param tolerance  how far a colour may be from the picture's, in steps of 1/255 of each channel
/// @param smooth     true: in Gouraud shading, triangles with the colours of their corners
[[nodiscard]] ShadeParts shadePartsOf(std::vector<FigurePolygon>& polygons, const std::vector<int>& levels,
                                      const Picture& picture, const Palette& palette,
                                      const ShownSamples& samples, int tolerance, bool smooth = false);

}  // namespace xnewell
