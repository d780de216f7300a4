#pragma once

#include <array>
#include <string>
#include <vector>

#include "shading/index_image.h"
#include "shading/painter.h"
#include "shading/palette.h"
#include "x11/controls.h"

/// The window as an index image: bands, picture, controls, colour strip, status. Pure: no server is asked,
/// so a picture of the window is the same on all of them.

/// The scene's cells, as the panel shows them.
struct PanelColors {
  int first = 11, count = 240;           ///< the scene's cells
  std::array<std::uint8_t, 256> ball{};  ///< cells for intensities k / 255 on the ball of the light
  std::string rule = {};                 ///< "linear: cell i holds (i - 10, 0, 0) of 255"
  std::string shortRule = {};            ///< "linear table"
  std::string_view what = "shades";      ///< or "colours"
};

/// What the panel shows beside the setup itself.
struct PanelState {
  Setup setup, defaults;
  std::string sceneTitle;     ///< "teapot, 8 x 8 divisions"
  std::string visual;         ///< "PseudoColor 8, private map, 256 of 256 cells"
  std::string counts, times;  ///< of the last picture
  std::string inexact;        ///< how wrong the picture is, as a sentence; "" if it is not, or not known
  PanelColors colors;
  std::string notice;               ///< a sentence in the status line instead of the counts; "" for none
  LightAngles light;                ///< about the scene's up axis
  glm::dvec3 lightInView{0, 0, 1};  ///< unit: to the right, up, towards the viewer
  char focus = 's';                 ///< key of the control that the arrows change
  bool help = false;                ///< all keys over the window
};

/// Where things are, in pixels. Below 800 x 600 there is no room for the controls and `roomy` is false.
struct Layout {
  int width = 0, height = 0;
  bool roomy = false, compact = false;
  Rect views, picture, controls, strip, status;
};
[[nodiscard]] Layout layoutOf(int width, int height);

/// Draws everything but the inside of the picture, which is already in `image` at layout.picture; the strip
/// counts its cells. `image` has the layout's size. Nothing drawn depends on the table's hue or bits, so a
/// new hue needs no redraw.
void drawPanel(IndexImage& image, const Layout& layout, const PanelState& state, const CellPlan& plan);

/// What drawPanel() draws over the picture: the word to a small window, the overlay of keys. Whoever fills
/// the picture anew puts these parts of the image back on top.
[[nodiscard]] std::vector<Rect> drawnOverPicture(const Layout& layout, bool help);

/// The picture's making in a line, for its caption: "flat; sorted by farthest z; own scanline; perspective".
[[nodiscard]] std::string captionOf(const Setup& setup);
/// "sorted by farthest z"
[[nodiscard]] std::string orderInWords(Order order);
