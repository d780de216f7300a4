#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "x11/server/display.h"

namespace xnewell {

/// What a window may ask of the screen that it is on: how large letters should be, and all of its space.

/// The text of the server's resources (RESOURCE_MANAGER), as they are now; "" if it has none.
[[nodiscard]] std::string readResources(Display* display);

/// How many pixels a unit of a window should be wide, from 1 to `most`: the nearest to Xft.dpi / 96 if the
/// resources have that, half a unit more is a unit more. Else as many as a screen of `pixels` has times
/// 1920 x 1080.
[[nodiscard]] int scaleFor(const std::string& resources, glm::ivec2 pixels, int most);

[[nodiscard]] glm::ivec2 screenSize(Display* display);

/// True if the event says that the resources have changed. selectResources() must have been called.
void selectResources(Display* display);
[[nodiscard]] bool isResourceChange(const XEvent& event);

/// Makes a window fill the screen, and gives it its old place again. It asks the window manager, as EWMH has
/// it (_NET_WM_STATE_FULLSCREEN). If that offers no such thing, or there is none, it moves and resizes the
/// window itself.
class FullScreen {
 public:
  FullScreen(Display* display, Window window) : display_{display}, window_{window} {}
  /// Fills the screen or not; without `wish`, the other than now. Returns true if the window will fill it.
  bool fill(std::optional<bool> wish);

 private:
  struct Geometry {
    int x, y, width, height;
  };
  [[nodiscard]] bool isFull() const;
  Display* display_;
  Window window_;
  std::optional<Geometry> before_;  ///< if we have moved and resized the window
};

}  // namespace xnewell
