#pragma once

#include <optional>

#include "shading/color/color_table.h"
#include "shading/picture/cell_use.h"

namespace xnewell {

/// Effects that change a picture by storing other colours in its cells. No index changes, so on a writable
/// colormap nothing is drawn again. This is colormap animation. @see Shoup, "Color Table Animation", 1979

/// A point of the curve of stored values that the user drags to a new value.
struct CurvePoint {
  int cell = 0;
  double value = 0;  ///< 0..255
  bool operator==(const CurvePoint&) const = default;
};

/// The effects, in the order in which they are applied. If the table has 8 bits, the colours are rounded to 8
/// bits after `bend`. The initial value of each effect leaves the colours unchanged.
struct PaletteEffects {
  /// store this table's colours; the indices stay those of the picture's own table
  std::optional<TableKind> stored = {};
  double hueTurn = 0;  ///< degrees; a positive turn takes red towards green
  double gamma = 1;    ///< kLeastGamma..kMostGamma; v becomes v^(1/gamma)
  std::optional<CurvePoint> bend = {};
  int rotate = 0;               ///< shade j gets the colour of shade j - rotate, cyclically in its ramp
  std::optional<int> lit = {};  ///< this cell gets the colour kLit
  bool operator==(const PaletteEffects&) const = default;
};
inline constexpr double kLeastGamma = 0.1, kMostGamma = 10;
/// Yellow. No shade of red, gray or blue is yellow, and on a gray screen it is brighter than most shades.
inline constexpr Rgb16 kLit{0xFFFF, 0xE0E0, 0x0000};

/// Applies all effects. The interface's sixteen cells keep their colours. `picture` is the one that `palette`
/// belongs to. @throws ViewError if an effect needs a ramp (to rotate, bend or store) and the picture's plan
/// has none, or if a cell is not one of the scene's
[[nodiscard]] Palette withEffects(Palette palette, const Picture& picture, const CellPlan& plan,
                                  const PaletteEffects& effects);

// The single effects, for any palette.

/// Turns the hue. The largest and the smallest channel value stay the same, so gray does not change. A turn
/// of 120 degrees takes red to green, green to blue and blue to red.
[[nodiscard]] Rgb16 hueTurned(Rgb16 color, double degrees);
/// Corrects each channel, 0..65535, for a screen that shows v^gamma.
[[nodiscard]] Rgb16 gammaCorrected(Rgb16 color, double gamma);
/// Moves the colours up by `steps` cells, cyclically; steps < 0 moves them down.
void rotate(Palette& palette, const CellRange& ramp, int steps);
/// Bends the curve of a ramp's values. The value of a shade is the largest channel of its colour. The value
/// at the point's cell becomes the point's value, or that of the brightest shade if that is less. The
/// brightest shade stays the same. Values below the point keep their ratio to the point's value; if that was
/// 0, they become the new value. Values above keep their relative position between the point and the
/// brightest shade. A curve that never falls still never falls. All shades get the hue of the brightest one.
void bend(Palette& palette, const CellRange& ramp, const CurvePoint& point);
/// The colours to store for a gray screen. For one hue, these are the intensities: the gray value of a hue is
/// darker (30 % for red). In the other plans, each colour becomes its grayOf(). Cells that do not belong to
/// the scene stay the same.
[[nodiscard]] Palette forGrayScreen(Palette palette, const Picture& picture);
/// The same shades in another kind of table. The first cell moves by the distance between the usual first
/// cells of the two kinds.
[[nodiscard]] ColorTable inTable(const ColorTable& table, TableKind kind);

}  // namespace xnewell
