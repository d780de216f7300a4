#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/color/images.h"
#include "x11/drawing/painter.h"
#include "x11/kit/key_table.h"
#include "x11/kit/typed_line.h"
#include "x11/views/colors_page.h"
#include "x11/window/layout.h"
#include "x11/window/window_view.h"

namespace xnewell {

/// What the pointer finds in what is written in the window, whatever view has written it: key caps are
/// buttons, counts are links, and words say what they mean.

/// Where a count leads: to the first cut of the depth sort, to a pixel that is clamped or shows a wrong face,
/// to a cell. The words of a mistake lead to the right picture.
enum class Lead { None, Cut, Clamped, Wrong, Cell, Right };

struct Pointed {
  Rect place;                   ///< of the cap, the count or the word
  std::string says = {};        ///< a sentence; "": none
  std::optional<Key> key = {};  ///< of a cap
  bool gesture = false;         ///< a cap without a key: the pointer does it
  Lead lead = Lead::None;
  int number = 0;  ///< of the cell
  bool operator==(const Pointed&) const = default;
};
/// What was written last at this place, in units.
[[nodiscard]] std::optional<Pointed> pointedAt(const Writing& writing, int x, int y);
/// The counts that lead somewhere.
[[nodiscard]] std::vector<Pointed> linksIn(const Written& written);

/// What surrounds a view: the tabs above it, the colour strip and the status lines below it. No code here
/// asks the server, so a picture of the window is the same on all servers.

struct PanelState {
  std::string title;   ///< "teapot, 8 x 8 divisions"
  std::string visual;  ///< "PseudoColor 8, private map, 256 of 256 cells"
  View view = View::Picture;
  SceneCellWords words;
  CellUse use;
  std::optional<int> inspected = {};  ///< the cell that the strip marks
  std::string selected;               ///< a control that is out of sight, before the first line; "" for none
  std::string status, aside;          ///< the first line and the softer text after it
  Rect picture = {};                  ///< of the scene, where the ribbon of a mistake is
  std::string mistake;                ///< in the equation of this picture; "": none
  std::string notice, told, hint;     ///< a warning, news, or what a word means, in place of a line
  std::optional<Typed> typed = {};    ///< shown in place of both lines
  std::vector<Legend> legend;         ///< the last line
  std::vector<HelpLine> help;         ///< the list of all keys, over the window; empty: not shown
};

/// True if the whole title has room beside the tabs.
[[nodiscard]] bool hasRoomForTitle(const Layout& layout, std::string_view title);
/// The tab under the pointer.
[[nodiscard]] std::optional<View> tabAt(const Layout& layout, int x, int y);

/// Draws the bands, and the list of keys over the view. A window without room for the controls has only the
/// last line. What it draws does not depend on the table's hue or bits, so a new hue needs no redraw.
void drawPanel(Painter paint, const Layout& layout, const PanelState& state, const CellPlan& plan);
/// Underlines the counts that are links, and frames what the pointer would press.
void drawLinks(Painter paint, const Writing& writing, const std::optional<Pointed>& pointed,
               const CellPlan& plan);

/// A note over the middle of a window of any size while the program is busy drawing. busyBox() is its place
/// in pixels, and drawBusyBox() draws it.
struct BusyNote {
  bool mayEnd = false;     ///< q ends the program meanwhile
  bool mayGiveUp = false;  ///< Esc keeps the last picture instead
  bool givesUp = false;    ///< Esc was pressed
};
[[nodiscard]] Rect busyBox(int width, int height, int unit);
void drawBusyBox(IndexImage& image, int unit, const CellPlan& plan, int seconds, const BusyNote& note);

/// The areas that drawPanel() draws over the picture, in units. After painting the picture again, draw these
/// parts of the image over it again.
[[nodiscard]] std::vector<Rect> drawnOverPicture(const Layout& layout, const PanelState& state);

}  // namespace xnewell
