#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shading/picture/cell_use.h"
#include "shading/picture/palette_effects.h"
#include "x11/views/cell_facts.h"
#include "x11/views/plot.h"

namespace xnewell {

/// What is in each cell, which cells are used, and why is the corrected table correct? The page shows all
/// cells as a grid, one of them in numbers, the stored values and the step to the next shade as curves, and
/// the picture itself.

/// The places of the page's parts, in pixels. The plots take the space that is free, the picture its share of
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

/// A line of the table's settings: a choice with its options, or a value, perhaps on a track.
struct TableLine {
  char key = 0;  ///< the key that changes it in a window; 0 for none
  std::string label;
  std::vector<std::string> options = {};
  int chosen = 0;
  std::string value = {};
  std::optional<double> share = {};  ///< of the track up to its thumb
};

/// Which line is under the pointer, and which part of it.
struct TableLineHit {
  int line, option = -1;
  std::optional<double> share = {};  ///< on its track
};
[[nodiscard]] std::optional<TableLineHit> lineAt(const ColorsLayout& at, const std::vector<TableLine>& lines,
                                                 int x, int y);

/// All that the page shows. The cells of the page itself show the palette's colours.
struct ColorsPage {
  const Picture& picture;           ///< painted, as large as the layout's
  const Palette& palette;           ///< the colours that words and curves describe
  const std::vector<Curve>& steps;  ///< stepCurves() of it
  const CellPlan& plan;
  const CellUse& use;
  int cell = 0;       ///< the inspected one
  std::string aside;  ///< words to the right of its number
  char asideKey = 0;  ///< a key before those words, in a window
  std::vector<TableLine> lines;
  char focus = 0;      ///< key of the line that the arrows change
  double gamma = 1;    ///< of the screen on which the steps are seen
  std::string hint{};  ///< words in the upper plot, if it is high enough
};

/// The share of a line's track at column x, in [0, 1]; the pointer may be beside the track.
[[nodiscard]] double trackShare(const ColorsLayout& at, int x);

/// The steps of the stored colours as they are seen. If the colours are corrected for a screen's gamma, as
/// they are seen on that screen.
[[nodiscard]] std::vector<Curve> stepsSeen(const Picture& picture, const Palette& plain, const CellPlan& plan,
                                           PaletteEffects effects);

void drawColorsPage(IndexImage& image, const ColorsLayout& at, const ColorsPage& page);

/// The plot of the stored values, for the code that lets the user drag its curve.
[[nodiscard]] Plot storedPlot(const Picture& picture, const Palette& palette);

/// The settings of a picture's table, without keys, and the effects that are on.
[[nodiscard]] std::vector<TableLine> tableLines(const Picture& picture, const PaletteEffects& effects);

/// `r = 1.01650299   240 of 240 levels distinct at 16 bits, 144 at 8   the eye sees 239 of 239 steps`
[[nodiscard]] std::string levelsText(const Picture& picture, const std::vector<Curve>& steps);

}  // namespace xnewell
