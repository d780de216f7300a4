#include "x11/window/mach_bench.h"

#include <algorithm>
#include <cmath>

#include "x11/drawing/pen.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/window/typed_number.h"

namespace xnewell {

namespace {

constexpr int kMostDivisions = 32;  // more divisions would be slow, and nobody could see the difference
constexpr int kRow = 22, kRows = 3;

/// The sheet's margin lies in the window's margin: the sheet begins one margin above the body and ends one
/// margin below it.
int sheetHeight(const Layout& at) { return at.body.height + 2 * Sheet::kMargin; }
int sheetTop(const Layout& at) { return at.body.y - Sheet::kMargin; }

const ChoiceRow& shadings() { return *choiceOf('S'); }

}  // namespace

Rect MachBench::picture(const Layout& at) const {
  const MachBandsLayout view = layoutOfMachBands(at.width, sheetHeight(at));
  return {view.picture.x, view.picture.y + sheetTop(at), view.picture.width, view.pictureHeight};
}

/// A profile shows one channel, so a picture in colour is painted with one hue.
Setup MachBench::painted(const Setup& setup) const {
  Setup painted = setup;
  if (channelsOf(planOf(subject_().scene, setup.picture)) == Channels::Rgb)
    painted.picture.colors = ColorPlan::OneHue;
  return painted;
}

bool MachBench::press(const Key& key, const Setup& setup) {
  const int times = key.shift ? 10 : 1;
  const bool turns = focus() == 't' || focus() == 'z';
  switch (key.name) {
    case NamedKey::Up:
    case NamedKey::Down:
      if (turns) return false;
      return moveScanline(key.name == NamedKey::Up ? -times : times), true;
    case NamedKey::Left:
    case NamedKey::Right: {
      if (turns) return false;
      const int by = key.name == NamedKey::Left ? -times : times;
      return focus() == 'k' ? divide(divisions_ + by) : moveScanline(by), true;
    }
    case NamedKey::Home:
    case NamedKey::End: {
      const bool end = key.name == NamedKey::End;
      if (focus() == 'k') return divide(end ? kMostDivisions : 1), true;
      row_ = end ? height_ - 1 : 0;
      return true;
    }
    case NamedKey::Tab:
      focus_ = focus() == 'y' ? 'k' : 'y';
      return true;
    case NamedKey::Escape:
      focus_ = 'y';
      return true;
    case NamedKey::Letter:
      break;
    default:
      return false;
  }
  switch (key.letter) {
    case 'y':
    case 'k':
      focus_ = key.letter;
      return true;
    case 't':
    case 'z':
      focus_ = 0;
      return false;
    case '=': {
      if (focus() == 'k') return askForDivisions(), true;
      host_.ask({.asks = "scanline, 0 to " + std::to_string(height_ - 1),
                 .text = std::to_string(row_.value_or(0)),
                 .take = [this](const std::string& text) -> std::string {
                   const std::optional<int> value = wholeNumber(text);
                   if (!value || *value < 0 || *value >= height_)
                     return "The picture's rows are 0 to " + std::to_string(height_ - 1) + ".";
                   row_ = *value;
                   return {};
                 }});
      return true;
    }
    default:
      (void)setup;
      return false;
  }
}

void MachBench::askForDivisions() {
  if (divisions_ == 0) return divide(0);
  host_.ask({.asks = "divisions, 1 to " + std::to_string(kMostDivisions),
             .text = std::to_string(divisions_),
             .take = [this](const std::string& text) -> std::string {
               const std::optional<int> value = wholeNumber(text);
               if (!value || *value < 1 || *value > kMostDivisions)
                 return "A patch has 1 to " + std::to_string(kMostDivisions) + " divisions each way.";
               divide(*value);
               return {};
             }});
}

void MachBench::moveScanline(int rows) { row_ = std::clamp(row_.value_or(0) + rows, 0, height_ - 1); }

void MachBench::divide(int divisions) {
  if (divisions_ == 0)
    return host_.notify(patches_ ? "The scene's file sets the divisions of all its patches."
                                 : "The scene has no patches to divide.");
  host_.change('k', [&](Setup& s) { s.divisions = std::clamp(divisions, 1, kMostDivisions); });
}

char MachBench::rowAt(int x, int y, int& option) const {
  option = -1;
  if (!controls_.has(x, y)) return 0;
  const char row = "Syk"[std::min(kRows - 1, (y - controls_.y) / kRow)];
  if (row == 'S')
    for (std::size_t k = 0; k < options_.size(); ++k)
      if (options_[k].has(x, y)) option = static_cast<int>(k);
  return row;
}

void MachBench::hover(int x, int y) { hovered_ = rowAt(x, y, option_); }

bool MachBench::grab(int x, int y) {
  hover(x, y);
  if (picture_.has(x, y)) {
    dragged_ = 'p';
  } else if (hovered_ == 'S') {
    if (option_ >= 0) choose(host_, shadings(), option_);
    return false;
  } else if (hovered_ != 0) {
    focus_ = hovered_;
    const int track = controls_.x + kColumnTrackAt;
    if (x < track - 5 || x > track + kColumnTrack + 5) return false;
    dragged_ = hovered_;
  }
  if (dragged_ == 0) return false;
  focus_ = dragged_ == 'k' ? 'k' : 'y';
  dragTo(x, y);
  return true;
}

void MachBench::dragTo(int x, int y) {
  const double share = std::clamp(double(x - controls_.x - kColumnTrackAt) / kColumnTrack, 0.0, 1.0);
  if (dragged_ == 'p')
    row_ = std::clamp(std::clamp(y - picture_.y, 0, picture_.height - 1) + firstRow_.value_or(0), 0,
                      height_ - 1);
  if (dragged_ == 'y') row_ = static_cast<int>(std::lround(share * (height_ - 1)));
  if (dragged_ == 'k') divide(1 + static_cast<int>(std::lround(share * (kMostDivisions - 1))));
}

bool MachBench::late(const Setup&) const { return drawn_ != shown(); }

void MachBench::draw(IndexImage& image, const Desk& desk) {
  const Layout& at = desk.layout;
  const int top = sheetTop(at);
  // If the window's size changes, the scanline stays at the same place in the scene.
  if (row_ && height_ != desk.picture.settings().height) {
    row_ = (2 * *row_ + 1) * desk.picture.settings().height / (2 * height_);
    firstRow_.reset();
  }
  height_ = desk.picture.settings().height;
  divisions_ = desk.picture.scene().divisions;
  patches_ = !desk.picture.scene().patches.empty();
  if (!row_) row_ = defaultScanline(desk.picture);
  ViewSettings settings{.view = View::MachBands, .picture = desk.setup.picture, .cells = desk.plan};
  settings.picture.width = at.width;
  settings.picture.height = sheetHeight(at);
  const bool grayed = painted(desk.setup) != desk.setup;
  picture_ = layoutOfMachBands(at.width, sheetHeight(at)).picture;
  picture_.y += top;
  // The part of the picture that is shown moves only if the scanline leaves it.
  if (firstRow_ && (*row_ < *firstRow_ || *row_ >= *firstRow_ + picture_.height)) firstRow_.reset();
  const MachBandsPage page = drawMachBandsPage(
      desk.picture, {.row = *row_, .firstRow = firstRow_, .grayed = grayed, .controls = kRows * kRow + 4},
      settings);
  Painter{image}.within({0, top, at.width, at.strip.y - top}).place(page.image, 0, top);
  firstRow_ = page.firstRow;
  controls_ = page.controls;
  controls_.y += top;
  drawControls(image, desk);
  drawn_ = shown();
  const Shading method = desk.setup.picture.shading;
  status_ = "scanline " + grouped(*row_) + " of " + grouped(height_) + "   " +
            std::string{rowOf(method).label} + " shown";
}

void MachBench::drawControls(IndexImage& image, const Desk& desk) {
  Pen pen{Painter{image}, desk.plan};
  const int x = controls_.x;
  int y = controls_.y + 15;
  const auto row = [&](std::string_view key, std::string_view label, bool enabled = true) {
    if (key[0] == focus()) drawFocus(pen, {x, y - 14, kControls, kRow}, 6);
    pen.key(x, y - 11, key);
    pen.paint.text(x + 24, y, label, pen(enabled ? Cell::Ink : Cell::Faint));
  };
  const auto slider = [&](char key, double value, double initially, double low, double high, bool enabled) {
    drawTrack(pen, x + kColumnTrackAt, y, kColumnTrack,
              {.share = std::clamp((value - low) / std::max(1.0, high - low), 0.0, 1.0),
               .initially = std::clamp((initially - low) / std::max(1.0, high - low), 0.0, 1.0),
               .enabled = enabled,
               .hovered = hovered_ == key,
               .dragged = dragged_ == key});
    if (enabled) pen.boldRight(x + kControls, y, grouped(static_cast<int>(value)));
    y += kRow;
  };
  row("S", "shading");
  options_ = optionFrames(shadings().options, x + kColumnTrackAt, y, kControls - kColumnTrackAt);
  drawOptions(pen, shadings().options, options_, shadings().get(desk.setup), hovered_ == 'S' ? option_ : -1);
  y += kRow;
  row("y", "scanline");
  slider('y', *row_, height_ / 2.0, 0, height_ - 1, true);
  const bool patches = divisions_ > 0;
  row("k", "divisions", patches);
  slider('k', patches ? divisions_ : 1, kDefaultDivisions, 1, kMostDivisions, patches);
}

std::vector<Legend> MachBench::legend() const {
  return {{{"^", "v"}, "scanline"}, {{"Shift"}, "by 10"}, {{"S"}, "shading"}, {{"k", "<", ">"}, "divisions"},
          {{"="}, "type"},          {{"t"}, "turn"},      {{"z"}, "zoom"},    {{"u"}, "undo"}};
}

std::vector<HelpLine> MachBench::help() const {
  return {{"up, down", "move the scanline; Shift: ten rows; Home, End: first, last row"},
          {"drag", "the scanline, in the picture or on its slider"},
          {"y =", "select the scanline; type its row"},
          {"k", "the divisions of the patches: left and right, or = types them"},
          {"S", "next shading of the picture"},
          {"t z", "turn or zoom with the arrows"}};
}

}  // namespace xnewell
