#pragma once

#include <cstdint>
#include <vector>

#include "shading/figure/figure.h"
#include "shading/laboratory/errors.h"

namespace xnewell {

/// What the areas of a figure show at the samples of the picture, row by row; `ground` where there is none.
/// Areas that end at a sample show there if they lie to its right, or below it. Strokes and texts are left
/// out.
[[nodiscard]] std::vector<FigureColor> colorsAtSamples(const VectorFigure& figure, FigureColor ground);

/// How far a figure is from the picture and from its reference, at the samples of the picture.
struct FigureErrors {
  std::int64_t samples = 0;  ///< at which the picture, the figure or the reference shows a face
  std::int64_t differ = 0;   ///< that are farther from the picture than FigureStatistics::off
  int largest = 0;           ///< from the picture, in steps of 1/255 of a channel
  Spread figure, picture;    ///< of each from the reference, in CIEDE2000
};
/// `comparison` is that of the same picture, in the colours of `palette`.
[[nodiscard]] FigureErrors errorsOf(const VectorFigure& figure, const Comparison& comparison,
                                    const Palette& palette);

}  // namespace xnewell
