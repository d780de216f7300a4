#include "x11/window/layout.h"

#include "x11/options/options.h"

namespace xnewell {

namespace {
constexpr int kStatusHeight = 44, kStripHeight = 60, kViewsHeight = 32;
}

Layout layoutOf(int wide, int high, int unit) {
  const int width = (wide + unit - 1) / unit, height = (high + unit - 1) / unit;
  Layout at;
  at.width = width;
  at.height = height;
  at.unit = unit;
  at.roomy = width >= kLeastWindow.x && height >= kLeastWindow.y;
  at.compact = width < 1024 || height < 768;
  if (!at.roomy) {
    at.picture = {0, 0, width, height};
    return at;
  }
  const int bodyTop = at.compact ? 43 : 48, below = at.compact ? 44 : 56;
  at.views = {0, 0, width, kViewsHeight};
  at.status = {0, height - kStatusHeight, width, kStatusHeight};
  at.strip = {0, at.status.y - kStripHeight, width, kStripHeight};
  at.controls = {width - kMargin - kControls, bodyTop, kControls, at.strip.y - bodyTop};
  at.body = {kMargin, bodyTop, width - 2 * kMargin, at.strip.y - 4 - bodyTop};
  at.picture = {kMargin, bodyTop, at.controls.x - 2 * kMargin, at.strip.y - below - bodyTop};
  return at;
}

}  // namespace xnewell
