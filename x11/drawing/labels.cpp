#include "x11/drawing/labels.h"

#include <algorithm>
#include <array>

namespace xnewell {

namespace {

bool overlap(const Rect& a, const Rect& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

}  // namespace

std::optional<Rect> Labels::take(std::span<const Rect> places) {
  for (const Rect& at : places) {
    const bool inside = at.x >= area_.x && at.y >= area_.y && at.x + at.width <= area_.x + area_.width &&
                        at.y + at.height <= area_.y + area_.height;
    if (!inside || std::ranges::any_of(taken_, [&](const Rect& r) { return overlap(at, r); })) continue;
    taken_.push_back({at.x - kGap, at.y, at.width + 2 * kGap, at.height});
    return at;
  }
  return std::nullopt;
}

std::optional<Rect> Labels::place(int x, int y, const std::string& text, bool boxed) {
  const int width = textWidth(text, boxed ? Voice::Bold : Voice::Plain) + (boxed ? 10 : 2),
            height = boxed ? 18 : 13;
  const std::array<Rect, 8> places{Rect{x + 7, y - height - 2, width, height},
                                   Rect{x + 9, y - height / 2, width, height},
                                   Rect{x + 7, y + 5, width, height},
                                   Rect{x - width - 9, y + 3, width, height},
                                   Rect{x - width - 9, y - height / 2, width, height},
                                   Rect{x - width - 7, y - height - 2, width, height},
                                   Rect{x - 4, y - height - 9, width, height},
                                   Rect{x - width + 4, y + 9, width, height}};
  const std::optional<Rect> at = take(places);
  if (!at) return std::nullopt;
  if (boxed) {
    paint_.fillRect(*at, plan_[Cell::White]);
    paint_.frame(*at, plan_[Cell::Ink]);
  }
  paint_.text(at->x + (boxed ? 5 : 1), at->y + (boxed ? 13 : 11), text, plan_[Cell::Ink],
              boxed ? Voice::Bold : Voice::Plain);
  return at;
}

}  // namespace xnewell
