#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace xnewell {

/// Finds the boxes that may overlap a box, without testing them all. It is a grid of cells over the screen,
/// with levels of coarser cells for larger boxes. Each box is entered once: on the finest level whose cells
/// are at least as wide and as high as the box, in the cell of its upper left corner. So the boxes of a level
/// that reach into an area start in the cells of the area or in those one to the left or above. Width and
/// height choose their levels independently: a long, narrow box is entered among cells that are long and
/// narrow too.

/// A box on the screen grid, x0 <= x1, y0 <= y1.
struct ScreenBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  /// True if the boxes share more than their borders.
  [[nodiscard]] bool overlaps(const ScreenBox& o) const { return overlapsInX(o) && overlapsInY(o); }
  [[nodiscard]] bool overlapsInX(const ScreenBox& o) const { return x0 < o.x1 && o.x0 < x1; }
  [[nodiscard]] bool overlapsInY(const ScreenBox& o) const { return y0 < o.y1 && o.y0 < y1; }
};

class BoxGrid {
 public:
  /// The finest cells are so large that three quarters of the boxes fit into them. There are at most 64 more
  /// of them than boxes. If `fine` is false, there is one cell for all.
  explicit BoxGrid(std::span<const ScreenBox> boxes, bool fine = true);

  [[nodiscard]] int cells() const { return cells_; }
  /// The cell in which one of the given boxes is entered: 0..cells() - 1.
  [[nodiscard]] int cellOf(const ScreenBox& box) const;

  /// A position in the walk over the cells whose boxes may overlap a box, level by level and row by row.
  struct Place {
    std::int16_t level = 0;
    std::uint16_t column = 0, row = 0;
  };
  [[nodiscard]] int cell(const Place& place) const {
    const Level& l = levels_[place.level];
    return l.firstCell + place.row * l.columns + place.column;
  }
  /// Moves `place` to the first such cell at or after it. Returns false if there is none left. A walk may
  /// continue with a smaller box inside the box that it began with.
  [[nodiscard]] bool settle(const ScreenBox& box, Place& place) const;

 private:
  /// each level's cells are 2^kSteps times as large as those of the level before
  static constexpr int kSteps = 2;
  static constexpr int kMostLevels = 16;
  struct Level {
    int xShift, yShift, columns, rows, firstCell;
  };
  [[nodiscard]] static int levelFor(int length, int shift);

  int left_ = 0, top_ = 0, xShift_ = 0, yShift_ = 0, cells_ = 1;
  std::vector<Level> levels_;
  std::array<std::array<std::int8_t, kMostLevels>, kMostLevels> levelAt_;  ///< [y][x]; -1 if there is no box
};

}  // namespace xnewell
