#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/color/images.h"
#include "shading/laboratory/ground_truth.h"
#include "shading/picture/palette_effects.h"
#include "shading/picture/picture_cache.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"
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

/// A legend in one line: what the steps of a map mean, on the background of the map.

struct LegendStep {
  Cell cell;
  std::string_view label;
};
/// Steps of differences. Each is twice as large as the one before; the first is a unit.
inline constexpr std::array kDoublingSteps{
    LegendStep{Cell::WellLine, "below 1"}, LegendStep{Cell::Soft, "1"},  LegendStep{Cell::Faint, "2"},
    LegendStep{Cell::WellText, "4"},       LegendStep{Cell::White, "8"}, LegendStep{Cell::Q, "16"},
};
/// The step that a difference belongs to: below the unit, below twice the unit, below four times the unit,
/// and so on; the last step has no limit, and any difference has it where the unit is 0. Both have the same
/// measure.
[[nodiscard]] const LegendStep& doublingStep(double difference, double unit);
/// Draws the legend from its upper left corner on, with `unit` after the steps.
void drawStepLegend(Painter painter, const CellPlan& plan, int x, int y, std::span<const LegendStep> steps,
                    std::string_view unit);

/// A view with a picture over the whole width of the sheet and a strip of numbers below it. The strip has two
/// columns: legend and table at the left, the finding at the right.
class PictureSheet {
 public:
  /// The strip has so many pixels, its section's line and name included.
  PictureSheet(const ViewSettings& settings, int strip);

  /// What such a sheet asks its picture for: the size that the strip leaves.
  [[nodiscard]] static PictureSettings picture(const ViewSettings& settings, int strip);

  Rect at;                           ///< the picture
  int left = Sheet::kMargin, right;  ///< where the columns begin
  int column;                        ///< how wide they are
  int top, width;                    ///< of the strip
  Sheet sheet;
};

/// What a view of numbers shows of a picture: in its place, or on a sheet with a strip of numbers.
struct Lens {
  ColoredImage shown = {};  ///< of the picture's size
  Finding finding = {};
  std::vector<LegendStep> steps = {};  ///< the legend in one line
  std::string section = {};            ///< the name of the strip
  std::vector<std::pair<std::string, std::string>> rows = {};
  /// Draws what a sheet has besides; in place of `steps` it draws a legend from y on.
  std::function<void(PictureSheet&, int y)> onSheet = {};
  std::function<void(Painter, int x, int y)> marks = {};  ///< on the picture, whose corner is at (x, y)
};
[[nodiscard]] Lens lensOf(View view, const Picture& picture, const CellPlan& plan, const Palette& palette,
                          int unit = 1);

}  // namespace xnewell
