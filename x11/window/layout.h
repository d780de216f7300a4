#pragma once

#include "x11/drawing/rect.h"

namespace xnewell {

inline constexpr int kMargin = 16, kControls = 320;  ///< pixels

/// The places of the window's parts, in pixels. Below 800 x 600 there is no room for the controls: `roomy` is
/// false.
struct Layout {
  int width = 0, height = 0;
  bool roomy = false, compact = false;
  Rect views, picture, controls, strip, status;
  Rect body;  ///< between the tabs and the strip, for a view without controls
};
[[nodiscard]] Layout layoutOf(int width, int height);

}  // namespace xnewell
