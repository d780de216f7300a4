#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "x11/app/workbench.h"

namespace xnewell {

/// A part of an image.
[[nodiscard]] inline IndexImage partOf(const IndexImage& image, const Rect& r) {
  IndexImage copy{r.width, r.height, 0};
  for (int j = 0; j < r.height; ++j) std::copy_n(image.row(r.y + j) + r.x, r.width, copy.row(j));
  return copy;
}

/// A workbench at a size, up to date, with functions for keys and mouse.
struct ReadyWorkbench : Workbench {
  explicit ReadyWorkbench(const xnewell::Setup& setup = {}, int width = 1024, int height = 768,
                          const std::string& scene = "teapot", const Server& server = {})
      : Workbench{readScene(scene, 3), setup, server} {
    resize(width, height);
    update();
  }

  void type(std::string_view letters) {
    for (const char c : letters) press({NamedKey::Letter, c});
  }
  /// Presses a key and brings everything up to date.
  void does(const Key& key) {
    press(key);
    finish();
  }
  void does(std::string_view letters) {
    type(letters);
    finish();
  }
  void pointAt(int x, int y) {
    hover(x, y);
    finish();
  }
  void click(int x, int y) {
    (void)grab(x, y);
    settle();
    finish();
  }
  /// Drags the picture by so many pixels.
  void drag(int dx, int dy) {
    const Rect& at = layout().picture;
    const int x = at.x + at.width / 2, y = at.y + at.height / 2;
    ASSERT_TRUE(grab(x, y));
    dragTo(x + dx, y + dy);
  }
  /// A part of the window.
  [[nodiscard]] IndexImage part(const Rect& r) const { return partOf(image(), r); }
  /// All of the window but the status line, which tells times.
  [[nodiscard]] IndexImage aboveStatus() const {
    return part({0, 0, image().width, layout().roomy ? layout().status.y : image().height});
  }
  /// True if the status line warns.
  [[nodiscard]] bool complains() const {
    const Rect& at = layout().status;
    for (int j = at.y; j < at.y + 20; ++j)
      for (int i = 0; i < at.width; ++i)
        if (image().row(j)[i] == plan()[Cell::Alarm]) return true;
    return false;
  }
  /// Brings everything up to date. In the view of the colours, colours come first, and the words about them
  /// second.
  void finish() {
    for (int k = 0; k < 3 && stale() != Stale::Nothing; ++k) update();
    ASSERT_EQ(stale(), Stale::Nothing);
  }
};

}  // namespace xnewell
