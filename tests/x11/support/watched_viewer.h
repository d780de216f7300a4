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

/// All of a window but the status line, which tells times. The screen must hold the whole window.
inline Rect aboveStatus(int width, int height) {
  const Layout at = layoutOf(width, height);
  return {0, 0, width, at.roomy ? at.status.y : height};
}

/// The window as a fresh start shows it, without the status line.
inline RgbImage freshWindow(const XServer& server, const std::string& line, int width = 1024,
                            int height = 768) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  return cropped(pictureOf("snapshot --whole-window " + line + " --size " + size, server.name()),
                 aboveStatus(width, height));
}

}  // namespace xnewell
