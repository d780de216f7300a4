#include "x11/window/drawer.h"

namespace xnewell {

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
