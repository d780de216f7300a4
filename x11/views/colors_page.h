#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/picture/cell_use.h"
#include "shading/picture/palette_effects.h"
#include "x11/drawing/painter.h"
#include "x11/kit/control.h"
#include "x11/views/cell_facts.h"
#include "x11/views/plot.h"
#include "x11/views/views.h"

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

/// What is in each cell, which cells are used, and why is the corrected table correct? The page shows all
/// cells as a grid, one of them in numbers, the stored values and the step to the next shade as curves, and
/// the picture itself.

/// The places of the page's parts, in units. The plots take the space that is free, the picture its share of
/// it.
struct ColorsLayout {
  bool compact = false;
  int pitch = 0;       ///< of the grid
  Rect grid, facts;    ///< 16 x 16 cells, the first at the upper left
  Rect stored, steps;  ///< the areas of the curves
  Rect table, picture;
};
/// `body` is at least 736 x 428.
[[nodiscard]] ColorsLayout layoutOfColors(const Rect& body);
[[nodiscard]] std::optional<int> cellInGrid(const ColorsLayout& at, int x, int y);

/// All that the page shows. The cells of the page itself show the palette's colours.
struct ColorsPage {
  const Picture& picture;           ///< painted, of the proportions of the layout's
  const Palette& palette;           ///< the colours that words and curves describe
  const std::vector<Curve>& steps;  ///< stepCurves() of it
  const CellPlan& plan;
  const CellUse& use;
  int cell = 0;                     ///< the inspected one
  std::string aside;                ///< words to the right of its number
  char asideKey = 0;                ///< a key before those words, in a window
  std::vector<Control> lines = {};  ///< of the table; none if a window draws them
  double gamma = 1;                 ///< of the screen on which the steps are seen
  std::string hint{};               ///< words in the upper plot, if it is high enough
};

/// How the lines of the table are placed, and the baseline of the first. In a window they have keys.
[[nodiscard]] RowStyle tableStyle(const ColorsLayout& at, bool keys);
[[nodiscard]] int firstTableLine(const ColorsLayout& at);

/// The steps of the stored colours as they are seen. If the colours are corrected for a screen's gamma, as
/// they are seen on that screen.
[[nodiscard]] std::vector<Curve> stepsSeen(const Picture& picture, const Palette& plain, const CellPlan& plan,
                                           PaletteEffects effects);

void drawColorsPage(Painter paint, const ColorsLayout& at, const ColorsPage& page);

/// The plot of the stored values, for the code that lets the user drag its curve.
[[nodiscard]] Plot storedPlot(const Picture& picture, const Palette& palette);

/// The settings of a picture's table, without keys, and the effects that are on.
[[nodiscard]] std::vector<Control> tableLines(const Picture& picture, const PaletteEffects& effects);

/// `r = 1.01650299   240 of 240 stored levels distinct, 144 at 8 bits   the eye sees 239 of 239 steps`.
/// `stored` is what the cells hold.
[[nodiscard]] std::string levelsText(const Picture& picture, const Palette& stored,
                                     const std::vector<Curve>& steps);

/// The colour table as a picture: the page of colors_page.h, below it the strip of all cells with how much
/// the picture uses each, and the number of levels that differ. A lit cell is lit in the grid, in the strip
/// and in the picture, because the light is stored in the cell itself. It is also the inspected cell, unless
/// another is asked for.
[[nodiscard]] ColoredImage drawColors(const Picture& picture, const ViewSettings& settings);
[[nodiscard]] PictureSettings pictureForColors(const ViewSettings& settings);

}  // namespace xnewell
