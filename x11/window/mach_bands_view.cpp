#include "x11/window/mach_bands_view.h"

#include <algorithm>
#include <utility>

#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

constexpr int kMostDivisions = 32;  // more divisions would be slow, and nobody could see the difference
constexpr int kRow = 22, kRows = 3;

/// The sheet's margin lies in the window's margin: the sheet begins one margin above the body and ends one
/// margin below it.
int sheetHeight(const Layout& at) { return at.body.height + 2 * Sheet::kMargin; }
int sheetTop(const Layout& at) { return at.body.y - Sheet::kMargin; }

}  // namespace

Rect MachBandsView::picture(const Layout& at) const {
  const MachBandsLayout view = layoutOfMachBands(at.width, sheetHeight(at));
  return {view.picture.x, view.picture.y + sheetTop(at), view.picture.width, view.pictureHeight};
}

/// A profile shows one channel, so a picture in colour is painted with one hue.
Setup MachBandsView::painted(const Setup& setup) const {
  Setup painted = setup;
  if (channelsOf(planOf(subject_().scene, setup.picture)) == Channels::Rgb)
    painted.picture.colors = ColorPlan::OneHue;
  return painted;
}

Controls MachBandsView::controls() {
  const Setup& now = host_.setup();
  Controls all{settingControl('S', now, host_.defaults(), change())};
  all.back().legend = "shading";
  all.push_back({.kind = Control::Kind::Slider,
                 .key = 'y',
                 .label = "scanline",
                 .is = "the row of the picture that is plotted",
                 .value = static_cast<double>(row_.value_or(0)),
                 .range = {0, static_cast<double>(height_ - 1), 1, false, 0},
                 .initially = height_ / 2.0,
                 .set = [this](double row) { moveTo(static_cast<int>(row)); }});
  all.push_back({.kind = Control::Kind::Slider,
                 .key = 'k',
                 .label = "divisions",
                 .is = "into how many polygons each patch is divided, each way",
                 .legend = "divisions",
                 .value = static_cast<double>(std::max(1, divisions_)),
                 .range = {1, kMostDivisions, 1, false, 0},
                 .initially = kDefaultDivisions,
                 .off = divisions_ > 0 ? ""
                        : patches_     ? "The scene's file sets the divisions of all its patches."
                                       : "The scene has no patches to divide.",
                 .set = [this](double divisions) {
                   host_.change('k', [&](Setup& s) { s.divisions = static_cast<int>(divisions); });
                 }});
  for (Control& control : cameraControls(now, subject_(), change())) {
    control.drag = {};
    control.legend = control.label;
    all.push_back(std::move(control));
  }
  // The picture: a drag takes the scanline along.
  all.push_back({.kind = Control::Kind::Own, .drag = [this](int, int y, int, int) {
                   list_.setFocus(ControlId{'y'});
                   const int row = std::clamp(y - picture_.y, 0, picture_.height - 1);
                   moveTo(row * unit_ + unit_ / 2 + firstRow_.value_or(0));
                 }});
  return all;
}

KeyTable MachBandsView::ownKeys() {
  KeyTable table;
  const Controls all = controls();
  const Control* const selected = list_.focused(all);
  if (!selected || selected->kind == Control::Kind::Slider) {
    const auto by = [this](int rows) {
      return [this, rows](const Key& key) { moveScanline(key.shift ? 10 * rows : rows); };
    };
    const std::string does = "move the scanline; Shift: ten rows; or drag it in the picture";
    table = {{{NamedKey::Up}, "scanline", does, by(-1)}, {{NamedKey::Down}, "scanline", does, by(1)}};
  }
  table.push_back({{NamedKey::Escape}, "", "select the scanline again", [this](const Key&) {
                     list_.setFocus(ControlId{'y'});
                   }});
  table.back().idle = list_.focus() == ControlId{'y'};
  append(table, zoomKeys(host_.setup(), subject_(), change()));
  return table;
}

void MachBandsView::draw(Painter paint, const DrawContext& context) {
  const Layout& at = context.layout;
  const int top = sheetTop(at);
  unit_ = at.unit;
  // If the window's size changes, the scanline stays at the same place in the scene.
  if (row_ && height_ != context.picture.settings().height) {
    row_ = (2 * *row_ + 1) * context.picture.settings().height / (2 * height_);
    firstRow_.reset();
  }
  height_ = context.picture.settings().height;
  divisions_ = context.picture.scene().divisions;
  patches_ = !context.picture.scene().patches.empty();
  if (asked_) moveTo(*std::exchange(asked_, std::nullopt));
  if (!row_) row_ = defaultScanline(context.picture);
  ViewSettings settings{.view = View::MachBands, .picture = context.setup.picture, .cells = context.plan};
  settings.picture.width = at.width;
  settings.picture.height = sheetHeight(at);
  const bool grayed = painted(context.setup) != context.setup;
  picture_ = layoutOfMachBands(at.width, sheetHeight(at)).picture;
  picture_.y += top;
  // The part of the picture that is shown moves only if the scanline leaves it.
  if (firstRow_ && (*row_ < *firstRow_ || *row_ >= *firstRow_ + picture_.height * unit_)) firstRow_.reset();
  const MachBandsPage page = drawMachBandsPage(context.picture,
                                               {.row = *row_,
                                                .firstRow = firstRow_,
                                                .framed = true,
                                                .grayed = grayed,
                                                .controls = kRows * kRow + 4,
                                                .unit = unit_},
                                               settings);
  paint.within({0, top, at.width, at.strip.y - top}).place(page.image, 0, top);
  paint.note(page.writing, 0, top);
  firstRow_ = page.firstRow;
  words_ = page.report;
  const Controls all = controls();
  int y = page.controls.y + top + 15;
  list_.forgetPlaces();
  for (const char key : {'S', 'y', 'k'}) y = list_.placeRow(all, key, page.controls.x, y);
  list_.place({}, {.area = picture_, .grip = picture_, .bare = true});
  Pen pen{paint, context.plan};
  list_.draw(pen, all);
  drawnRow_ = row_;
  const Shading method = context.setup.picture.shading;
  status_ = "scanline " + grouped(*row_) + " of " + grouped(height_) + "   " +
            std::string{rowOf(method).label} + " shown";
}

}  // namespace xnewell
