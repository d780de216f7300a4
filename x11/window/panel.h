#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shading/color/index_image.h"
#include "shading/color/palette.h"
#include "x11/drawing/painter.h"
#include "x11/views/color_strip.h"
#include "x11/window/bench.h"
#include "x11/window/layout.h"

namespace xnewell {

/// What is around a view: tabs above, the colour strip and the status below. Pure: no server is asked, so a
/// picture of the window is the same on all of them.

/// What is typed, and what was wrong with it.
struct Typed {
  std::string asks, text, complaint;
  bool offers = false;  ///< up and down put something there
};

struct PanelState {
  std::string title;   ///< "teapot, 8 x 8 divisions"
  std::string visual;  ///< "PseudoColor 8, private map, 256 of 256 cells"
  WindowView view = WindowView::Picture;
  SceneCellWords words;
  CellUse use;
  std::optional<int> inspected = {};  ///< cell that the strip marks
  std::string status, aside;          ///< the first line
  std::string notice, told;           ///< a warning, or a good word, in its place; "" for none
  std::optional<Typed> typed = {};    ///< in place of both lines
  std::vector<Legend> legend;         ///< the last line
  std::vector<HelpLine> help;         ///< all keys over the window; empty: not shown
};

/// The tab under the pointer.
[[nodiscard]] std::optional<WindowView> tabAt(const Layout& layout, int x, int y);

/// The bands of a window with room for them, and what lies over it: all keys, or the word to a small window.
/// `image` has the layout's size. Nothing drawn depends on the table's hue or bits, so a new hue needs no
/// redraw.
void drawPanel(IndexImage& image, const Layout& layout, const PanelState& state, const CellPlan& plan);

/// Over the middle of a window of any size, while what is to be seen is not there yet; mayEnd: q
/// ends the program meanwhile.
[[nodiscard]] Rect busyBox(int width, int height);
void drawBusyBox(IndexImage& image, const CellPlan& plan, int seconds, bool mayEnd);

/// What drawPanel() draws over the picture. Whoever fills the picture anew puts these parts of the image back
/// on top.
[[nodiscard]] std::vector<Rect> drawnOverPicture(const Layout& layout, const PanelState& state);

}  // namespace xnewell
