#include "x11/drawing/pen.h"

#include <algorithm>
#include <cmath>

namespace xnewell {

void drawTrack(Pen& pen, int x, int baseline, int width, const TrackLook& look) {
  const auto at = [&](double share) { return x + static_cast<int>(std::lround(share * width)); };
  const int thumb = at(look.share), middle = baseline - 4;
  pen.paint.fillRect({x, middle - 1, width, 2}, pen(Cell::Rule));
  pen.paint.fillRect({x, middle - 1, thumb - x, 2}, pen(look.enabled ? Cell::Soft : Cell::Rule));
  for (int quarter = 0; quarter <= 4; ++quarter)
    pen.paint.vline(x + quarter * width / 4, middle + 7, 2, pen(Cell::Faint));
  if (look.enabled && look.initially)
    pen.paint.triangle(at(*look.initially) - 2, middle - 8, 3, Direction::Down, pen(Cell::Faint));
  const Rect box{thumb - 4, middle - look.height / 2, 9, look.height};
  const Cell face = !look.enabled  ? Cell::Panel
                    : look.dragged ? Cell::Ink
                    : look.hovered ? Cell::White
                                   : Cell::Paper;
  pen.paint.fillRect(box, pen(face));
  pen.paint.frame(box, pen(look.enabled ? Cell::Ink : Cell::Faint));
  if (!look.enabled) return;
  if (!look.dragged) pen.paint.vline(box.x + 7, box.y + 1, box.height - 2, pen(Cell::Rule));
  pen.paint.vline(thumb, middle - 3, 7, pen(look.dragged ? Cell::White : Cell::Ink));
}

std::vector<Rect> optionFrames(std::span<const std::string_view> options, int x, int baseline, int width,
                               int height) {
  constexpr int kLeastGap = 8;  // the frame of one option reaches 7 pixels beyond its text
  constexpr int kGapInLines = 12;
  const auto widthOf = [](std::span<const std::string_view> words) {
    int sum = 0;
    for (const std::string_view word : words) sum += textWidth(word);
    return sum;
  };
  const auto gaps = [](std::span<const std::string_view> words) {
    return std::max(1, static_cast<int>(words.size()) - 1);
  };
  const int wordGap = widthOf(options) + gaps(options) * kLeastGap <= width ? kLeastGap : kGapInLines;
  std::vector<Rect> frames;
  for (auto rest = options; !rest.empty();) {
    std::size_t fit = 1;
    while (fit < rest.size() && widthOf(rest.first(fit + 1)) + gaps(rest.first(fit + 1)) * wordGap <= width)
      ++fit;
    const std::span<const std::string_view> line = rest.first(fit);
    const int gap = std::clamp((width - widthOf(line)) / gaps(line), kLeastGap, 14);
    int left = x - 6;
    for (const std::string_view option : line) {
      frames.push_back({left, baseline - (height + 9) / 2, textWidth(option) + 13, height});
      left += textWidth(option) + gap;
    }
    baseline += height;
    rest = rest.subspan(fit);
  }
  return frames;
}

void drawOptions(Pen& pen, std::span<const std::string_view> options, std::span<const Rect> frames,
                 int chosen, int hovered) {
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
    pen.paint.text(box.x + 6, baseline, options[i], pen(i == hovered ? Cell::Ink : Cell::Soft));
  }
}

void drawFocus(Pen& pen, const Rect& row, int beyond) {
  pen.paint.fillRect({row.x - 2, row.y, row.width + 2 + beyond, row.height}, pen(Cell::Focus));
  pen.paint.fillRect({row.x - 6, row.y, 2, row.height}, pen(Cell::Ink));
}

}  // namespace xnewell
