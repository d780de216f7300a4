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
  const Rect box{thumb - 4, middle - 7, 9, 15};
  const Cell face = !look.enabled  ? Cell::Panel
                    : look.dragged ? Cell::Ink
                    : look.hovered ? Cell::White
                                   : Cell::Paper;
  pen.paint.fillRect(box, pen(face));
  pen.paint.frame(box, pen(look.enabled ? Cell::Ink : Cell::Faint));
  if (!look.enabled) return;
  if (!look.dragged) pen.paint.vline(box.x + 7, box.y + 1, 13, pen(Cell::Rule));
  pen.paint.vline(thumb, middle - 3, 7, pen(look.dragged ? Cell::White : Cell::Ink));
}

std::vector<Rect> optionFrames(std::span<const std::string_view> options, int x, int baseline, int width,
                               int height) {
  constexpr int kLeastGap = 4;
  int words = 0;
  for (const std::string_view option : options) words += textWidth(option);
  const int gap =
      std::clamp((width - words) / std::max(1, static_cast<int>(options.size()) - 1), kLeastGap, 14);
  std::vector<Rect> frames;
  for (const std::string_view option : options) {
    frames.push_back({x - 6, baseline - (height + 9) / 2, textWidth(option) + 13, height});
    x += textWidth(option) + gap;
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
