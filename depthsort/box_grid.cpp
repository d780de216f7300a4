#include "depthsort/box_grid.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace xnewell {

namespace {

/// The smallest s with length <= 2^s.
int bitsFor(int length) { return length <= 1 ? 0 : std::bit_width(static_cast<unsigned>(length) - 1u); }

}  // namespace

int BoxGrid::levelFor(int length, int shift) {
  return std::max(0, (bitsFor(length) - shift + kSteps - 1) / kSteps);
}

BoxGrid::BoxGrid(std::span<const ScreenBox> boxes, bool fine) {
  for (auto& row : levelAt_) row.fill(-1);
  if (boxes.empty() || !fine) {
    levels_.push_back({31, 31, 1, 1, 0});
    xShift_ = yShift_ = 31;
    levelAt_[0][0] = 0;
    left_ = top_ = std::numeric_limits<int>::min() / 2;
    return;
  }

  // Find the area, and count the boxes by width and by height.
  int right = boxes[0].x1, bottom = boxes[0].y1;
  left_ = boxes[0].x0, top_ = boxes[0].y0;
  std::array<std::size_t, 33> widths{}, heights{};
  for (const ScreenBox& b : boxes) {
    left_ = std::min(left_, b.x0), right = std::max(right, b.x1);
    top_ = std::min(top_, b.y0), bottom = std::max(bottom, b.y1);
    ++widths[bitsFor(b.x1 - b.x0)], ++heights[bitsFor(b.y1 - b.y0)];
  }
  const auto mostFit = [&](const auto& lengths) {
    std::size_t fit = 0;
    int shift = -1;
    do fit += lengths[++shift];
    while (4 * fit < 3 * boxes.size());
    return shift;
  };
  const auto count = [](int length, int shift) { return (std::int64_t{length} >> shift) + 1; };
  const int width = right - left_, height = bottom - top_;
  xShift_ = mostFit(widths), yShift_ = mostFit(heights);
  for (;;) {
    const std::int64_t columns = count(width, xShift_), rows = count(height, yShift_);
    if (columns * rows <= static_cast<std::int64_t>(boxes.size()) + 64 && columns < 65536 && rows < 65536)
      break;
    columns >= rows ? ++xShift_ : ++yShift_;
  }

  for (const ScreenBox& b : boxes)
    levelAt_[levelFor(b.y1 - b.y0, yShift_)][levelFor(b.x1 - b.x0, xShift_)] = 0;
  cells_ = 0;
  for (int y = 0; y < kMostLevels; ++y)
    for (int x = 0; x < kMostLevels; ++x) {
      if (levelAt_[y][x] < 0) continue;
      const int xShift = std::min(31, xShift_ + x * kSteps), yShift = std::min(31, yShift_ + y * kSteps);
      const int columns = static_cast<int>(count(width, xShift));
      const int rows = static_cast<int>(count(height, yShift));
      levelAt_[y][x] = static_cast<std::int8_t>(levels_.size());
      levels_.push_back({xShift, yShift, columns, rows, cells_});
      cells_ += columns * rows;
    }
}

int BoxGrid::cellOf(const ScreenBox& b) const {
  if (cells_ == 1) return 0;
  const Level& l = levels_[levelAt_[levelFor(b.y1 - b.y0, yShift_)][levelFor(b.x1 - b.x0, xShift_)]];
  return l.firstCell + ((b.y0 - top_) >> l.yShift) * l.columns + ((b.x0 - left_) >> l.xShift);
}

bool BoxGrid::settle(const ScreenBox& box, Place& place) const {
  for (; place.level < static_cast<int>(levels_.size()); place = {std::int16_t(place.level + 1), 0, 0}) {
    const Level& l = levels_[place.level];
    // A box starts at most one cell before the cells that it reaches into.
    const auto from = [](std::int64_t edge, int shift) {
      return static_cast<int>(std::max<std::int64_t>(0, (edge - (std::int64_t{1} << shift) + 1) >> shift));
    };
    const auto to = [](std::int64_t edge, int shift, int cells) {
      return static_cast<int>(std::min<std::int64_t>(cells - 1, edge >> shift));
    };
    const int x0 = from(std::int64_t{box.x0} - left_, l.xShift),
              y0 = from(std::int64_t{box.y0} - top_, l.yShift);
    const int x1 = to(std::int64_t{box.x1} - left_, l.xShift, l.columns),
              y1 = to(std::int64_t{box.y1} - top_, l.yShift, l.rows);
    int column = std::max<int>(place.column, x0), row = place.row;
    if (row < y0) row = y0, column = x0;
    if (column > x1) ++row, column = x0;
    if (row > y1 || column > x1) continue;
    place.column = static_cast<std::uint16_t>(column);
    place.row = static_cast<std::uint16_t>(row);
    return true;
  }
  return false;
}

}  // namespace xnewell
