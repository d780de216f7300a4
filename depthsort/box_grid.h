#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace xnewell {

/// Which boxes may overlap a box, without asking all of them: a grid of cells over the screen, in levels of
/// coarser cells for larger boxes. A box is entered once, in the cell of its upper left corner on the finest
/// level whose cells are as wide and as high as it is; so a level's boxes that reach into an area start in
/// its cells or in those one to the left or above. Width and height choose their levels apart: strips along
/// an axis stay where the fine cells are.

/// On the screen grid, x0 <= x1, y0 <= y1.
struct ScreenBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  /// Share more than their borders.
  [[nodiscard]] bool overlaps(const ScreenBox& o) const { return overlapsInX(o) && y0 < o.y1 && o.y0 < y1; }
  [[nodiscard]] bool overlapsInX(const ScreenBox& o) const { return x0 < o.x1 && o.x0 < x1; }
};

class BoxGrid {
 public:
  /// The finest cells are so large that three quarters of the boxes fit, and at most as many as there are
  /// boxes. `fine` false: one cell for all.
  explicit BoxGrid(std::span<const ScreenBox> boxes, bool fine = true);

  [[nodiscard]] int cells() const { return cells_; }
  /// The cell in which a box of the given ones is entered: 0..cells() - 1.
  [[nodiscard]] int cellOf(const ScreenBox& box) const;

  /// A walk over the cells whose boxes may overlap a box, level by level, row by row.
  struct Place {
    std::int16_t level = 0;
    std::uint16_t column = 0, row = 0;
  };
  [[nodiscard]] int cell(const Place& place) const {
    const Level& l = levels_[place.level];
    return l.firstCell + place.row * l.columns + place.column;
  }
  /// The first cell for the box at or after the place; false if there is none left. A walk
  /// may go on with a smaller box within the one it began with.
  [[nodiscard]] bool settle(const ScreenBox& box, Place& place) const;

 private:
  static constexpr int kSteps = 2;  ///< each level's cells are 2^kSteps times as large
  static constexpr int kMostLevels = 16;
  struct Level {
    int xShift, yShift, columns, rows, firstCell;
  };
  [[nodiscard]] static int levelFor(int length, int shift);

  int left_ = 0, top_ = 0, xShift_ = 0, yShift_ = 0, cells_ = 1;
  std::vector<Level> levels_;
  std::array<std::array<std::int8_t, kMostLevels>, kMostLevels> levelAt_;  ///< [y][x], -1: no box there
};

}  // namespace xnewell
