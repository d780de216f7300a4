#pragma once

#include <optional>
#include <string>

#include "shading/color/palette.h"
#include "shading/picture/cell_use.h"
#include "shading/picture/palette_effects.h"
#include "x11/drawing/painter.h"

namespace xnewell {

/// All 256 cells side by side. A free cell holds what other programs stored there: it is a line. Bars above
/// them show how much the picture uses each; words below say what they hold.

/// The cells of the scene in words.
struct SceneCellWords {
  CellRange cells{11, 240};
  std::string rule;             ///< "linear: cell i holds (i - 10)/255 of the hue"
  std::string shortRule;        ///< "linear table"
  std::string what = "shades";  ///< or "colours"
};
[[nodiscard]] SceneCellWords wordsOf(const Picture& picture, const PaletteEffects& effects = {});

/// `at` is 60 pixels high and at least 512 wide. Each cell has a whole number of pixels; the rest stays empty
/// at both ends. Bars grow with the logarithm of the number of samples. `compact` leaves out what a narrow
/// strip has no room for.
void drawColorStrip(Painter paint, const Rect& at, const CellPlan& plan, const CellUse& use,
                    const SceneCellWords& words, bool compact, std::optional<int> inspected = {});
/// The cell drawn at x.
[[nodiscard]] std::optional<int> cellInStrip(const Rect& at, int x, int y);

}  // namespace xnewell
