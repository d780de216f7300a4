#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "tests/x11/support/ready_workbench.h"
#include "tests/x11/support/watched_viewer.h"
#include "x11/sides/sides_page.h"
#include "x11/trade/trade_view.h"

#include <X11/keysym.h>

namespace xnewell {

/// What the window of a workbench would show on a screen, made without a server.
[[nodiscard]] inline RgbImage onScreen(const Workbench& bench, const Rect& rect) {
  RgbImage image{rect.width, rect.height};
  for (int j = 0; j < rect.height; ++j)
    for (int i = 0; i < rect.width; ++i) {
      const Rgb16& c = bench.palette()[bench.image().row(rect.y + j)[rect.x + i]];
      std::uint8_t* const pixel = image.pixel(i, j);
      pixel[0] = static_cast<std::uint8_t>(c.r >> 8);
      pixel[1] = static_cast<std::uint8_t>(c.g >> 8);
      pixel[2] = static_cast<std::uint8_t>(c.b >> 8);
    }
  return image;
}

/// The program's window on a server, and a workbench without a server. Both get the same keys and mouse, and
/// must show the same pixels. The window is in the upper left corner of the screen. It has 1024 x 768 pixels
/// at scale 1, 800 x 600 units at others.
class TwinWindow {
 public:
  explicit TwinWindow(int depth, const std::string& line = "teapot --divisions 3",
                      const std::string& scene = "teapot", const xnewell::Setup& setup = {}, int scale = 1)
      : unit{scale},
        server{XServer::xvfb(depth, std::max(1280, 800 * unit), std::max(1024, 600 * unit))},
        viewer{server,
               line + (unit == 1 ? ""
                                 : " --scale " + std::to_string(unit) + " --size " +
                                       std::to_string(800 * unit) + 'x' + std::to_string(600 * unit))},
        window{viewer.window},
        same{setup, 1024, 768, scene, {.shownBits = 8}} {
    if (unit > 1) {
      same.scale(unit);
      same.resize(800 * unit, 600 * unit);
      same.update();
    }
    moveTo(700, 15);  // over nothing that responds
  }

  void type(std::string_view letters) {
    window.type(letters);
    same.type(letters);
  }
  void press(KeySym symbol, NamedKey name, bool shift = false) {
    window.press(symbol, shift);
    same.press({name, 0, shift});
  }
  /// The pointer, in units.
  void moveTo(int x, int y) {
    window.moveTo(x * unit, y * unit);
    same.hover(x * unit, y * unit);
  }
  /// The button pressed, moved along and let go; then the pointer is over nothing that responds.
  void drag(int fromX, int fromY, int toX, int toY) {
    finish();
    moveTo(fromX, fromY);
    window.button(1, true);
    const bool dragging = same.grab(fromX * unit, fromY * unit);
    if (fromX != toX || fromY != toY) {
      window.moveTo(toX * unit, toY * unit);
      if (dragging)
        same.dragTo(toX * unit, toY * unit);
      else
        same.hover(toX * unit, toY * unit);
    }
    window.button(1, false);
    if (dragging) same.settle();
    moveTo(700, 15);
  }
  void click(const Rect& r) {
    const int x = r.x + r.width / 2, y = r.y + r.height / 2;
    drag(x, y, x, y);
  }
  void resize(int width, int height) {
    window.resize(width, height);
    same.resize(width, height);
  }
  /// The workbench uses the places that it drew last.
  void finish() { same.finish(); }

  [[nodiscard]] Rect body() const { return same.layout().body * unit; }
  /// The parts of the body that show no measured times, in pixels.
  [[nodiscard]] std::vector<Rect> timeless() const {
    const Layout& layout = same.layout();
    std::vector<Rect> parts{layout.body};
    if (same.view() == View::SideBySide) {
      const SidesLayout at = layoutOfSides(layout.body);
      parts = {at.captionA, at.A, at.captionB, at.B, at.difference};
    }
    if (same.view() == View::Trade) parts = {layoutOfTrade(layout.body).controls};
    for (Rect& part : parts) part = part * unit;
    return parts;
  }
  /// Compares these parts. The bands around the body tell times and facts of the server.
  [[nodiscard]] RgbImage expected() {
    finish();
    return onScreen(same, body());
  }
  [[nodiscard]] bool agrees() {
    finish();
    return std::ranges::all_of(
        timeless(), [&](const Rect& part) { return window.comesToShow(onScreen(same, part), part); });
  }

  const int unit;  ///< pixels
  XServer server;
  const WatchedViewer viewer;
  const WatchedWindow& window;
  ReadyWorkbench same;
};

}  // namespace xnewell
