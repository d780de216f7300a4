#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shading/picture/cell_use.h"
#include "shading/picture/palette_effects.h"
#include "x11/views/cell_facts.h"
#include "x11/views/plot.h"

namespace xnewell {

/// What is in each cell, which are used, and why is the corrected table correct? All cells as a grid, one of
/// them in numbers, what is stored and the step to the next shade as curves, and the picture itself.

/// Where things are, in pixels. The plots take what is free, the picture its share of it.
struct ColorsLayout {
  bool compact = false;
  int pitch = 0;       ///< of the grid
  Rect grid, facts;    ///< 16 x 16 cells, the first at the upper left
  Rect stored, steps;  ///< what the curves have
  Rect table, picture;
};
/// `body` is at least 736 x 428.
[[nodiscard]] ColorsLayout layoutOfColors(const Rect& body);
[[nodiscard]] std::optional<int> cellInGrid(const ColorsLayout& at, int x, int y);

/// A line of the table's settings: a choice with its options, or a value, also on a track.
struct TableLine {
  char key = 0;  ///< that changes it in a window; 0 for none
  std::string label;
  std::vector<std::string> options = {};
  int chosen = 0;
  std::string value = {};
  std::optional<double> share = {};  ///< of the track up to its thumb
};

/// What of the lines is under the pointer.
struct TableLineHit {
  int line, option = -1;
  std::optional<double> share = {};  ///< on its track
};
[[nodiscard]] std::optional<TableLineHit> lineAt(const ColorsLayout& at, const std::vector<TableLine>& lines,
                                                 int x, int y);

/// All that the page shows. The palette's colours are shown by the cells themselves.
struct ColorsPage {
  const Picture& picture;           ///< painted, as large as the layout's
  const Palette& palette;           ///< that the words and curves are about
  const std::vector<Curve>& steps;  ///< stepCurves() of it
  const CellPlan& plan;
  const CellUse& use;
  int cell = 0;       ///< the inspected one
  std::string aside;  ///< beside its number, at the right
  char asideKey = 0;  ///< before that, for a window
  std::vector<TableLine> lines;
  char focus = 0;      ///< key of the line that the arrows change
  double gamma = 1;    ///< of the screen that the steps are seen on
  std::string hint{};  ///< in the upper plot, where it is high
};

/// Of any line's track, wherever the pointer is beside it.
[[nodiscard]] double trackShare(const ColorsLayout& at, int x);

/// The steps of what is stored, as they are seen: where it is corrected for a screen's gamma, on that screen.
[[nodiscard]] std::vector<Curve> stepsSeen(const Picture& picture, const Palette& plain, const CellPlan& plan,
                                           PaletteEffects effects);

void drawColorsPage(IndexImage& image, const ColorsLayout& at, const ColorsPage& page);

/// The plot of the stored values, for whoever drags its curve.
[[nodiscard]] Plot storedPlot(const Picture& picture, const Palette& palette);

/// The settings of a picture's table, without keys; the effects are those that are in force.
[[nodiscard]] std::vector<TableLine> tableLines(const Picture& picture, const PaletteEffects& effects);

/// `r = 1.01650299   240 of 240 levels distinct at 16 bits, 144 at 8   the eye tells 239 of 239 steps`
[[nodiscard]] std::string levelsText(const Picture& picture, const std::vector<Curve>& steps);

}  // namespace xnewell
