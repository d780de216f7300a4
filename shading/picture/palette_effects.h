#pragma once

#include <optional>

#include "shading/color/color_table.h"
#include "shading/color/palette.h"
#include "shading/picture/cell_use.h"

namespace xnewell {

/// What may be done to a picture by storing other colours in its cells. No index changes, so on a writable
/// colormap nothing is drawn: colormap animation. @see Shoup, "Color Table Animation", 1979

/// A point of the curve of stored values, dragged.
struct CurvePoint {
  int cell = 0;
  double value = 0;  ///< of 255
  bool operator==(const CurvePoint&) const = default;
};

/// In the order in which they are applied; what a table of 8 bits keeps is then rounded to them. The first
/// value of each leaves the colours alone.
struct PaletteEffects {
  std::optional<TableKind> stored = {};  ///< this table's colours for indices that another one picked
  double hueTurn = 0;                    ///< degrees, towards green from red
  double gamma = 1;                      ///< kLeastGamma..kMostGamma; v becomes v^(1/gamma)
  std::optional<CurvePoint> bend = {};
  int rotate = 0;               ///< shade j gets the colour of shade j - rotate, round the ramp
  std::optional<int> lit = {};  ///< this cell alone in kLit
  bool operator==(const PaletteEffects&) const = default;
};
inline constexpr double kLeastGamma = 0.1, kMostGamma = 10;
/// Yellow, which no shade of red, gray or blue is, and brighter than most on gray screens.
inline constexpr Rgb16 kLit{0xFFFF, 0xE0E0, 0x0000};

/// All of them. The sixteen cells of the tool stay. `picture` is the one that `palette` belongs to.
/// @throws ViewError where the picture's plan has no ramp to turn round, to bend or to store, or a cell is
/// not one of the scene's
[[nodiscard]] Palette withEffects(Palette palette, const Picture& picture, const CellPlan& plan,
                                  const PaletteEffects& effects);

// One by one, on any palette.

/// The largest and the least channel stay, and so does gray; by 120 degrees red is green, green blue and
/// blue red.
[[nodiscard]] Rgb16 hueTurned(Rgb16 color, double degrees);
/// Each channel of 65535: what a screen needs that shows v^gamma.
[[nodiscard]] Rgb16 gammaCorrected(Rgb16 color, double gamma);
/// By one cell up for each step; steps < 0 go down.
void rotate(Palette& palette, const CellRange& ramp, int steps);
/// The ramp's value (its colours' largest channel) at the point becomes the point's, at most the brightest
/// shade's, which stays; below, values keep their ratio, above, their share of what is left. A curve that
/// never falls still never falls. The hue is that of the brightest shade.
void bend(Palette& palette, const CellRange& ramp, const CurvePoint& point);
/// What is stored where the screen is gray. Of one hue the intensities, which the hue would only darken: red
/// to 30 %. Several hues, and colours, become grayOf() them. Cells that are not the scene's stay.
[[nodiscard]] Palette forGrayScreen(Palette palette, const Picture& picture);
/// The same shades of another table, in its usual cells.
[[nodiscard]] ColorTable inTable(const ColorTable& table, TableKind kind);

}  // namespace xnewell
