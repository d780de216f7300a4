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

/// What is around a view: tabs above, the colour strip and the status lines below. Nothing here asks the
/// server, so a picture of the window is the same on all servers.

/// What the user types, and what is wrong with it.
struct Typed {
  std::string asks, text, complaint;
  bool offers = false;  ///< up and down offer a text
};

struct PanelState {
  std::string title;   ///< "teapot, 8 x 8 divisions"
  std::string visual;  ///< "PseudoColor 8, private map, 256 of 256 cells"
  WindowView view = WindowView::Picture;
  SceneCellWords words;
  CellUse use;
  std::optional<int> inspected = {};  ///< the cell that the strip marks
  std::string status, aside;          ///< the first line
  std::string notice, told;           ///< a warning, or plain news, in place of the first line; "" for none
  std::optional<Typed> typed = {};    ///< in place of both lines of text
  std::vector<Legend> legend;         ///< the last line
  std::vector<HelpLine> help;         ///< the list of all keys, over the window; empty: not shown
};

/// The tab under the pointer.
[[nodiscard]] std::optional<WindowView> tabAt(const Layout& layout, int x, int y);

/// Draws the bands of a window that has room for them, and what lies over the window: the list of keys, or
/// the note that the window is too small. `image` has the layout's size. The image does not depend on the
/// table's hue or bits, so a new hue needs no redraw.
void drawPanel(IndexImage& image, const Layout& layout, const PanelState& state, const CellPlan& plan);

/// Draws a note over the middle of a window of any size while the program is busy drawing. mayEnd: q ends the
/// program meanwhile.
[[nodiscard]] Rect busyBox(int width, int height);
void drawBusyBox(IndexImage& image, const CellPlan& plan, int seconds, bool mayEnd);

/// The areas that drawPanel() draws over the picture. Code that paints the picture again must put these parts
/// of the image back on top.
[[nodiscard]] std::vector<Rect> drawnOverPicture(const Layout& layout, const PanelState& state);

}  // namespace xnewell
