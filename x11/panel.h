#pragma once

#include <array>
#include <string>
#include <vector>

#include "shading/color_strip.h"
#include "shading/index_image.h"
#include "shading/painter.h"
#include "shading/palette.h"
#include "x11/controls.h"

/// The window as an index image: bands, picture, controls, colour strip, status. Pure: no server is asked,
/// so a picture of the window is the same on all of them.

/// What the window may show, a tab and a key each.
enum class WindowView { Picture, Colors };
struct WindowViewRow {
  WindowView id;
  char key;
  std::string_view name;
};
inline constexpr std::array kWindowViews{
    WindowViewRow{WindowView::Picture, '1', "Picture"},
    WindowViewRow{WindowView::Colors, '3', "Colours"},
};

/// What the panel shows beside the setup itself.
struct PanelState {
  Setup setup, defaults;
  std::string sceneTitle;     ///< "teapot, 8 x 8 divisions"
  std::string visual;         ///< "PseudoColor 8, private map, 256 of 256 cells"
  std::string counts, times;  ///< of the last picture
  std::string inexact;        ///< how wrong the picture is, as a sentence; "" if it is not, or not known
  WindowView view = WindowView::Picture;
  SceneCellWords words;
  CellUse use;                           ///< of the picture that is shown
  std::array<std::uint8_t, 256> ball{};  ///< cells for intensities k / 255 on the ball of the light
  std::optional<int> inspected = {};     ///< cell that the strip marks
  std::string notice;                    ///< a sentence in the status line instead of the counts; "" for none
  LightAngles light;                     ///< about the scene's up axis
  glm::dvec3 lightInView{0, 0, 1};       ///< unit: to the right, up, towards the viewer
  char focus = 's';                      ///< key of the control that the arrows change
  bool help = false;                     ///< all keys over the window
};

/// Where things are, in pixels. Below 800 x 600 there is no room for the controls and `roomy` is false.
struct Layout {
  int width = 0, height = 0;
  bool roomy = false, compact = false;
  Rect views, picture, controls, strip, status;
  Rect body;  ///< between the views and the strip, for a view without controls
};
[[nodiscard]] Layout layoutOf(int width, int height);

/// Draws everything but the inside of the picture, which is already in `image` at layout.picture, and in
/// another view than the picture's all but its body. `image` has the layout's size. Nothing drawn depends on
/// the table's hue or bits, so a new hue needs no redraw.
void drawPanel(IndexImage& image, const Layout& layout, const PanelState& state, const CellPlan& plan);

/// What drawPanel() draws over the picture: the word to a small window, the overlay of keys. Whoever fills
/// the picture anew puts these parts of the image back on top.
[[nodiscard]] std::vector<Rect> drawnOverPicture(const Layout& layout, bool help);

/// The picture's making in a line, for its caption: "flat; sorted by farthest z; own scanline; perspective".
[[nodiscard]] std::string captionOf(const Setup& setup);
/// "sorted by farthest z"
[[nodiscard]] std::string orderInWords(Order order);
