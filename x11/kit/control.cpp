#include "x11/kit/control.h"

#include <algorithm>
#include <cmath>

#include "x11/drawing/wording.h"

namespace xnewell {

double shareOf(const TrackRange& range, double value) {
  if (range.high <= range.low) return 0;
  const double v = std::clamp(value, range.low, range.high);
  return range.logarithmic ? std::log(v / range.low) / std::log(range.high / range.low)
                           : (v - range.low) / (range.high - range.low);
}

double valueAt(const TrackRange& range, double share) {
  const double p = std::clamp(share, 0.0, 1.0);
  const double v = range.logarithmic ? range.low * std::pow(range.high / range.low, p)
                                     : range.low + p * (range.high - range.low);
  const double unit = std::pow(10.0, range.decimals);
  return std::clamp(std::round(v * unit) / unit, range.low, range.high);
}

double stepped(const TrackRange& range, double value, int steps) {
  const double share = range.logarithmic ? range.step : range.step / (range.high - range.low);
  const double unit = std::pow(10.0, -range.decimals);
  const double after = valueAt(range, shareOf(range, value) + steps * share);
  // On a logarithmic track a step may be smaller than the last decimal. Then the value moves by one unit of
  // that decimal.
  if (std::abs(after - value) >= unit / 2) return after;
  return std::clamp(value + (steps > 0 ? unit : -unit), range.low, range.high);
}

std::string textOf(const TrackRange& range, double value) {
  return range.decimals == 0 ? grouped(std::llround(value)) : fixed(value, range.decimals);
}

ControlPlace placeInRow(const Control& control, int x, int baseline, const RowStyle& style, int parts) {
  constexpr int kBox = 11, kReach = 5;  // a box's side; how far a thumb reaches beyond its track's ends
  ControlPlace place{
      .x = x, .y = baseline, .area = {x, baseline - 14, style.width, style.pitch}, .style = style};
  const int value = x + style.value;
  switch (control.kind) {
    case Control::Kind::Slider:
      place.track = {value, baseline - 5, style.track + 1, 2};
      place.grip = {value - kReach, place.area.y, style.track + 2 * kReach + 1, style.pitch};
      break;
    case Control::Kind::Choice:
      place.options = optionFrames(control.options, value, baseline, style.width - style.value,
                                   std::min(19, style.pitch));
      if (!place.options.empty()) place.area.height += place.options.back().y - place.options.front().y;
      break;
    case Control::Kind::Toggle:
      place.box = {style.boxAfterKey ? x + style.label : value, baseline - 10, kBox, kBox};
      break;
    case Control::Kind::Number: {
      const int right = x + style.width - style.numbers * (parts - 1 - control.part);
      place.box = place.grip = {right - style.numbers + 8, baseline - 12, style.numbers - 4, 15};
      if (parts > 1) place.area = place.box;
      break;
    }
    case Control::Kind::Button:
      place.box = place.area;
      break;
    case Control::Kind::Own:
      break;
  }
  return place;
}

std::vector<Rect> optionFrames(const std::vector<std::string>& options, int x, int baseline, int width,
                               int height) {
  constexpr int kLeastGap = 8;  // the frame of one option reaches 7 units beyond its text
  constexpr int kMostGap = 14, kGapInLines = 12;
  const auto widthOf = [&](std::size_t first, std::size_t count) {
    int sum = 0;
    for (std::size_t k = first; k < first + count; ++k) sum += textWidth(options[k]);
    return sum;
  };
  const auto gaps = [](std::size_t count) { return std::max(1, static_cast<int>(count) - 1); };
  const std::size_t all = options.size();
  const int wordGap = widthOf(0, all) + gaps(all) * kLeastGap <= width ? kLeastGap : kGapInLines;
  std::vector<Rect> frames;
  for (std::size_t first = 0; first < all;) {
    std::size_t fit = 1;
    while (first + fit < all && widthOf(first, fit + 1) + gaps(fit + 1) * wordGap <= width) ++fit;
    const int gap = std::clamp((width - widthOf(first, fit)) / gaps(fit), kLeastGap, kMostGap);
    int left = x - 6;
    for (std::size_t k = first; k < first + fit; ++k) {
      frames.push_back({left, baseline - (height + 9) / 2, textWidth(options[k]) + 13, height});
      left += textWidth(options[k]) + gap;
    }
    baseline += height;
    first += fit;
  }
  return frames;
}

void drawOptions(Pen& pen, const std::vector<std::string>& options, const std::vector<Rect>& frames,
                 int chosen, int hovered, const std::vector<bool>& lacking) {
  for (int i = 0; i < static_cast<int>(options.size()); ++i) {
    const Rect& box = frames[i];
    const int baseline = box.y + (box.height + 9) / 2;
    if (i == chosen) {
      pen.paint.fillRect(box, pen(Cell::White));
      pen.paint.frame(box, pen(Cell::Ink));
      pen.bold(box.x + 6, baseline, options[i]);
      continue;
    }
    if (i == hovered)
      pen.paint.fillRect({box.x + 2, box.y + 1, box.width - 4, box.height - 2}, pen(Cell::Panel));
    const bool lacks = !lacking.empty() && lacking[i];
    const Cell ink = lacks ? Cell::Faint : i == hovered ? Cell::Ink : Cell::Soft;
    pen.paint.text(box.x + 6, baseline, options[i], pen(ink));
  }
}

void drawTrack(Pen& pen, const ControlPlace& place, double share, std::optional<double> initially,
               bool enabled, const Look& look) {
  const int x = place.track.x, width = place.track.width - 1, middle = place.track.y + 1;
  const int height = std::min(15, (place.area.height - 2) | 1);  // thumbs of two rows stay apart
  const auto at = [&](double s) {
    return x + static_cast<int>(std::lround(std::clamp(s, 0.0, 1.0) * width));
  };
  const int thumb = at(share);
  pen.paint.fillRect({x, middle - 1, width, 2}, pen(Cell::Rule));
  pen.paint.fillRect({x, middle - 1, thumb - x, 2}, pen(enabled ? Cell::Soft : Cell::Rule));
  for (int quarter = 0; quarter <= 4; ++quarter)
    pen.paint.vline(x + quarter * width / 4, middle + 7, 2, pen(Cell::Faint));
  if (enabled && initially)
    pen.paint.triangle(at(*initially) - 2, middle - 8, 3, Direction::Down, pen(Cell::Faint));
  const Rect box{thumb - 4, middle - height / 2, 9, height};
  const Cell face = !enabled       ? Cell::Panel
                    : look.dragged ? Cell::Ink
                    : look.hovered ? Cell::White
                                   : Cell::Paper;
  pen.paint.fillRect(box, pen(face));
  pen.paint.frame(box, pen(enabled ? Cell::Ink : Cell::Faint));
  if (!enabled) return;
  if (!look.dragged) pen.paint.vline(box.x + 7, box.y + 1, box.height - 2, pen(Cell::Rule));
  pen.paint.vline(thumb, middle - 3, 7, pen(look.dragged ? Cell::White : Cell::Ink));
}

namespace {

void drawToggle(Pen& pen, const Control& control, const ControlPlace& place, const Look& look) {
  const Rect& box = place.box;
  pen.paint.fillRect(box, pen(look.hovered ? Cell::Panel : Cell::White));
  pen.paint.frame(box, pen(control.enabled() ? Cell::Ink : Cell::Faint));
  if (control.value != 0) pen.paint.tick(box.x + 2, box.y + 2, pen(Cell::Ink));
  const std::string& words = place.style.boxAfterKey ? control.label : control.words;
  pen.paint.text(box.x + (place.style.boxAfterKey ? 17 : 18), place.y, words,
                 pen(control.enabled() ? Cell::Ink : Cell::Faint));
}

void drawButton(Pen& pen, const Control& control, const ControlPlace& place, const Look& look) {
  const Rect& box = place.box;
  pen.paint.fillRect(box, pen(look.dragged ? Cell::Rule : look.hovered ? Cell::White : Cell::Panel));
  pen.paint.frame(box, pen(Cell::Faint));
  pen.paint.hline(box.x + 1, box.y + box.height, box.width, pen(Cell::Rule));
  const int width = textWidth(control.label) + 12, x = box.x + (box.width - width) / 2;
  pen.ink(x, place.y, control.label);
  pen.soft(x + width - 6, place.y, std::string{control.key});
}

void drawNumber(Pen& pen, const Control& control, const ControlPlace& place, const Look& look) {
  const int right = place.box.x + place.box.width - 4;
  if (look.focused) {
    pen.paint.fillRect(place.box, pen(Cell::White));
    pen.paint.frame(place.box, pen(Cell::Ink));
  } else if (look.hovered) {
    pen.paint.fillRect(place.box, pen(Cell::Panel));
  }
  pen.paint.textRight(right, place.y, textOf(control.range, control.value),
                      pen(control.enabled() ? Cell::Ink : Cell::Faint), Voice::Bold);
}

}  // namespace

void drawControl(Pen& pen, const Control& control, const ControlPlace& place, const Look& look) {
  if (control.kind == Control::Kind::Button) return drawButton(pen, control, place, look);
  const Cell ink = control.enabled() ? Cell::Ink : Cell::Faint;
  const bool labelled = control.kind != Control::Kind::Toggle || !place.style.boxAfterKey;
  if (control.part == 0) {
    if (control.key != 0) pen.key(place.x, place.y - 11, std::string{control.key});
    if (labelled) pen.paint.text(place.x + place.style.label, place.y, control.name(), pen(ink));
  }
  const auto valueAtTheRight = [&](const std::string& value) {
    pen.paint.textRight(place.x + place.style.width, place.y, value, pen(ink),
                        control.enabled() ? Voice::Bold : Voice::Plain);
  };
  switch (control.kind) {
    case Control::Kind::Slider: {
      const auto share = [&](double value) { return shareOf(control.range, value); };
      drawTrack(pen, place, share(control.value),
                control.initially ? std::optional{share(*control.initially)} : std::nullopt,
                control.enabled(), look);
      return valueAtTheRight(textOf(control.range, control.value));
    }
    case Control::Kind::Choice:
      return drawOptions(pen, control.options, place.options, static_cast<int>(control.value), look.option,
                         control.lacking);
    case Control::Kind::Toggle:
      return drawToggle(pen, control, place, look);
    case Control::Kind::Number:
      return drawNumber(pen, control, place, look);
    case Control::Kind::Own:
      if (!place.style.wordsAtValue) return valueAtTheRight(control.words);
      pen.bold(place.x + place.style.value, place.y, control.words);
      return;
    case Control::Kind::Button:
      return;
  }
}

}  // namespace xnewell
