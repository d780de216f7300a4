#include "x11/window/layout.h"

#include <algorithm>

#include "x11/options/options.h"

namespace xnewell {

namespace {

/// The heights of the bands, and the spaces above the body and below the picture.
struct Bands {
  int views, bodyTop, below, strip, status;
};
constexpr Bands kRoomy{32, 48, 56, 60, 44}, kCompact{32, 43, 44, 60, 44}, kLow{22, 27, 40, 56, 22};

constexpr glm::ivec2 kLeastForStatus{240, 66};  ///< a window that has room for a line below its picture

/// The places beside a drawer that has few controls, or none.
void placeDrawer(Layout& at, Drawer drawer) {
  constexpr int kEdge = 8, kTitle = 30, kFindings = 38, kHandleRow = 24;
  const Rect room{kEdge, at.views.height + 4, at.width - 2 * kEdge, at.strip.y - 4 - (at.views.height + 4)};
  const int aside = drawer == Drawer::Shut ? kHandle : kFewControls, right = room.x + room.width;
  at.drawer = drawer;
  at.controls = {right - aside, room.y, aside, room.height};
  at.handle = drawer == Drawer::Shut ? at.controls
                                     : Rect{at.controls.x, at.controls.y, at.controls.width, kHandleRow};
  const int width = at.controls.x - 2 * kEdge - room.x;
  at.body = {room.x, room.y, width, room.height};
  at.headline = {room.x, room.y, width, kTitle};
  at.well = {room.x, room.y + kTitle, width, room.height - kTitle - kFindings};
  at.picture = framed(at.well);
  at.finding = {room.x, at.well.y + at.well.height + 4, width, kFindings - 4};
}

}  // namespace

Rect framed(const Rect& room, int most) {
  const int k = std::max(1, std::min({room.width / 3, room.height / 2, most / 3}));
  return {room.x + (room.width - 3 * k) / 2, room.y + (room.height - 2 * k) / 2, 3 * k, 2 * k};
}

Layout layoutOf(int wide, int high, int unit, Drawer drawer) {
  const int width = (wide + unit - 1) / unit, height = (high + unit - 1) / unit;
  Layout at;
  at.width = width;
  at.height = height;
  at.unit = unit;
  at.roomy = width >= kLeastWindow.x && height >= kLeastWindow.y;
  at.compact = width < 1024 || height < 768;
  at.low = height < 600;
  if (!at.roomy) {
    const int status = width >= kLeastForStatus.x && height >= kLeastForStatus.y ? kLow.status : 0;
    at.low = true;
    at.picture = at.well = at.frame = {0, 0, width, height - status};
    at.status = {0, height - status, width, status};
    return at;
  }
  const Bands& bands = at.low ? kLow : at.compact ? kCompact : kRoomy;
  at.views = {0, 0, width, bands.views};
  at.status = {0, height - bands.status, width, bands.status};
  at.strip = {0, at.status.y - bands.strip, width, bands.strip};
  const int bodyTop = bands.bodyTop, bottom = at.strip.y;
  at.controls = {width - kMargin - kControls, bodyTop, kControls, bottom - bodyTop};
  at.body = {kMargin, bodyTop, width - 2 * kMargin, bottom - 4 - bodyTop};
  at.well = {kMargin, bodyTop, at.controls.x - 2 * kMargin, bottom - bands.below - bodyTop};
  at.picture = at.frame = framed(at.well);
  if (drawer != Drawer::Whole) placeDrawer(at, drawer);
  return at;
}

int largestScale(int width, int height) {
  int unit = kMostScale;
  while (unit > 1 && !layoutOf(width, height, unit).roomy) --unit;
  return unit;
}

}  // namespace xnewell
