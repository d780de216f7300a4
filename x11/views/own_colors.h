#pragma once

#include <algorithm>

#include "shading/color/colored_image.h"
#include "shading/color/palette.h"
#include "shading/color/quantize.h"
#include "shading/scene/picture_settings.h"

namespace xnewell {

/// A picture in full colour with colours of its own in the scene's cells, on the dark background. The rest of
/// its palette is `palette`. The cube of a plan of colours stays as it is.
[[nodiscard]] inline ColoredImage inOwnColors(const RgbImage& colors, Shows shows, bool dither,
                                              const PictureSettings& settings, const CellPlan& plan,
                                              const Palette& palette) {
  const bool cube = settings.colors == ColorPlan::Cube;
  const int first = kTables[static_cast<int>(settings.table.kind)].first;
  ColoredImage own{{colors.width, colors.height, plan[Cell::Well]}, palette};
  const std::vector<Rgb16> chosen = quantize(
      colors, shows,
      {.quantizer = cube ? Quantizer::Cube : Quantizer::Chosen, .dither = dither || cube, .first = first},
      own.image);
  std::ranges::copy(chosen, own.palette.begin() + first);
  return own;
}

}  // namespace xnewell
