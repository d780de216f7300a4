#pragma once

#include <signal.h>

#include "tests/x11/support/program_picture.h"
#include "x11/window/panel.h"

#include "tests/x11/support/watched_window.h"

namespace xnewell {

/// `xnewell view LINE` on a server, with its window. The order of the members is the order of their lives.
struct WatchedViewer {
  RunningProgram program;
  WatchedWindow window;

  WatchedViewer(const XServer& server, const std::string& line, Window other = 0)
      : program{words("view " + line), server.name()}, window{server, other} {}
  /// Waits until the window is gone, so that the next viewer finds its own.
  ~WatchedViewer() {
    program.signal(SIGKILL);
    EXPECT_TRUE(window.goes());
  }
};

/// What a part of an image shows on a screen of 8 bits.
[[nodiscard]] inline RgbImage onScreen(const IndexImage& image, const Palette& palette, const Rect& part) {
  RgbImage shown{part.width, part.height};
  for (int j = 0; j < part.height; ++j)
    for (int i = 0; i < part.width; ++i) {
      const Rgb16& c = palette[image.row(part.y + j)[part.x + i]];
      std::uint8_t* pixel = shown.pixel(i, j);
      for (const int value : {c.r, c.g, c.b}) *pixel++ = static_cast<std::uint8_t>(value >> 8);
    }
  return shown;
}

/// All of a window but the status line, which tells times. The screen must hold the whole window.
inline Rect aboveStatus(int width, int height, int scale = 1) {
  const Layout at = layoutOf(width, height, scale);
  return {0, 0, width, at.roomy ? at.status.y * scale : height};
}

/// The window as a fresh start shows it, without the status line.
inline RgbImage freshWindow(const XServer& server, const std::string& line, int width = 1024,
                            int height = 768, int scale = 1) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  const std::string all =
      "snapshot --whole-window " + line + " --size " + size + " --scale " + std::to_string(scale);
  return cropped(pictureOf(all, server.name()), aboveStatus(width, height, scale));
}

}  // namespace xnewell
