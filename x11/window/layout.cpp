#include "x11/window/layout.h"

#include <algorithm>

#include "shading/scene/settings.h"
#include "x11/options/options.h"
#include "x11/window/setting_controls.h"

namespace xnewell {

std::string orderText(Order order) { return std::string{rowOf(order).text}; }

std::string shadingText(Shading shading) { return std::string{rowOf(shading).words}; }

std::string mistakeIn(const Setup& setup) {
  const MistakeRow& row = rowOf(setup.picture.light.mistake);
  const bool has = row.id != Mistake::None && hasEffect(*settingOf("--mistake"), factsOf(setup.picture));
  return has ? std::string{row.words} : "";
}

std::string captionOf(const Setup& setup) {
  const Control projection = settingControl('P', setup, setup, {});
  const std::string mistake = mistakeIn(setup);
  return shadingText(setup.picture.shading) + (mistake.empty() ? "" : " with " + mistake) + "; " +
         orderText(setup.picture.order) + "; " +
         (setup.fill == Fill::Scanline ? "own scanline" : "XFillPolygon") + "; " +
         projection.options[static_cast<std::size_t>(projection.value)];
}

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

namespace {

constexpr int kDrawerInset = 10, kDrawerRow = 24;

void drawHandle(Pen& pen, const Layout& at, const Look& look) {
  const Rect& handle = at.handle;
  pen.paint.fillRect(at.controls, pen(Cell::Panel));
  if (look.hovered) pen.paint.fillRect(handle, pen(Cell::White));
  pen.paint.fillRect({at.controls.x, at.controls.y, 2, at.controls.height}, pen(Cell::Ink));
  if (at.drawer == Drawer::Few) {
    const int y = handle.y + 17, x = handle.x + kDrawerInset;
    pen.soft(x + pen.key(x, y - kKeyCapBaseline, std::string_view{&kDrawerKey, 1}) + 6, y, "put away");
    pen.paint.triangle(handle.x + handle.width - 14, y - 9, 5, Direction::Right, pen(Cell::Ink));
    return;
  }
  const int middle = handle.x + handle.width / 2 + 1;
  pen.paint.triangle(middle - 3, handle.y + 8, 5, Direction::Left, pen(Cell::Ink));
  pen.key(middle - kKeyCap / 2, handle.y + 24, std::string_view{&kDrawerKey, 1});
  int y = handle.y + 62;
  for (const char letter : std::string_view{"CONTROLS"}) {
    pen.soft(middle - 3, y, std::string_view{&letter, 1});
    y += 15;
  }
}

}  // namespace

Control handleControl(const std::function<void(char)>& press) {
  return {.kind = Control::Kind::Button,
          .key = kDrawerKey,
          .label = "hide",
          .is = "put the controls away, or bring them back",
          .set = [press](double) { press(kDrawerKey); }};
}

void drawDrawer(Pen& pen, const Layout& at, const Controls& controls, std::string_view few,
                ControlList& list) {
  drawHandle(pen, at, list.look({kDrawerKey}));
  list.place({kDrawerKey}, {.area = at.handle, .bare = true});
  if (at.drawer != Drawer::Few) return;
  const int x = at.controls.x + kDrawerInset;
  const RowStyle row{.width = at.controls.width - kDrawerInset - 6,
                     .pitch = kDrawerRow,
                     .label = 20,
                     .value = 66,
                     .track = 56,
                     .beyond = 4,
                     .boxAfterKey = true};
  int baseline = at.handle.y + at.handle.height + 20;
  for (const char key : few)
    for (const Control& control : controls) {
      if (control.key != key || control.kind == Control::Kind::Button) continue;
      ControlPlace place = placeInRow(control, x, baseline, row);
      if (place.area.y + place.area.height > at.controls.y + at.controls.height) continue;
      baseline += place.area.height + 4;
      list.place(control.id(), std::move(place));
    }
}

}  // namespace xnewell
