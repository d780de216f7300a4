#pragma once

#include <optional>
#include <string>

#include "shading/color/colored_image.h"
#include "shading/color/index_image.h"
#include "shading/color/palette.h"
#include "shading/laboratory/ground_truth.h"
#include "shading/picture/palette_effects.h"
#include "shading/picture/picture_cache.h"
#include "x11/views/view_table.h"

namespace xnewell {

/// Draws what may be asked for of a scene: the picture, or the numbers behind it.

struct ViewSettings {
  View view = View::Picture;
  std::optional<int> scanline = {};  ///< for MachBands: a row of its picture; without it defaultScanline()
  std::optional<int> cell =
      {};  ///< for Colors: the inspected cell; without it the lit one, or else medianCell()
  PaletteEffects effects = {};  ///< for Colors
  PictureSettings picture;  ///< width and height are those of the whole view, at least the least of its row
  CellPlan cells{};
  Palette unneeded{};  ///< the colours of cells that are not needed, as in makePalette()
  bool gray = false;   ///< for Colors: the screen shows only grays
};

/// Makes the picture that the view shows, which is smaller than the view, and draws the view. Any but
/// View::Picture.
/// @throws ViewError as PictureCache::make(), std::invalid_argument where the scanline is not in the picture
[[nodiscard]] ColoredImage drawView(PictureCache& pictures, const ViewSettings& settings);

/// What the window may show in the place of the picture: one of the other views without the sheet around it.

struct ShownPicture {
  IndexImage image;  ///< of the picture's size
  Palette palette;   ///< the picture's own, except for what hasOwnColors()
  std::string finding;
};

/// The image of a painted picture, and over it the edges, lines and labels of its scene, each in the
/// cell that looks most like its colour.
[[nodiscard]] IndexImage withMarks(const Picture& picture, const Palette& palette);

/// `picture` is painted; `palette` has its colours. View::Difference needs the truth, which takes long to
/// make; it is kept in `truth`. Marks and legends are drawn in units of so many pixels.
[[nodiscard]] ShownPicture shownAs(View show, const Picture& picture, const Palette& palette,
                                   const CellPlan& plan, CachedGroundTruth& truth, int unit = 1);

}  // namespace xnewell
