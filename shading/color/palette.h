#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "shading/color/color_table.h"

namespace xnewell {

/// The 256 colours of an index image: sixteen cells for the interface, the rest for the scene.

enum class Cell {
  Black,
  White,
  Paper,
  Panel,
  Rule,
  Faint,
  Soft,
  Ink,
  Well,
  WellLine,
  WellText,
  P,
  Q,
  Good,
  Alarm,
  Focus
};
inline constexpr int kCells = 16;
/// A short name of each cell's use.
inline constexpr std::array<std::string_view, kCells> kCellNames{"black",
                                                                 "white",
                                                                 "paper",
                                                                 "panel",
                                                                 "rule",
                                                                 "faint",
                                                                 "soft",
                                                                 "ink",
                                                                 "well",
                                                                 "lines on the well",
                                                                 "words on the well",
                                                                 "polygon P",
                                                                 "polygon Q",
                                                                 "holds",
                                                                 "fails",
                                                                 "focus"};

/// The cell of each interface colour. The usual cells are those of the window's design. Black and white keep
/// the pixel values that the server gives them; a colour whose usual cell is thereby taken moves to another.
class CellPlan {
 public:
  /// `black` and `white` are the server's pixel values. If one of them lies inside the ramp, it cannot be
  /// kept: the interface then has a black or white of its own.
  explicit CellPlan(TableKind table = TableKind::Linear, int black = 0, int white = 1);
  [[nodiscard]] std::uint8_t operator[](Cell cell) const { return at_[static_cast<int>(cell)]; }
  /// True if this cell, 0..255, is one of the interface's sixteen.
  [[nodiscard]] bool has(int cell) const { return std::ranges::find(at_, cell) != at_.end(); }
  bool operator==(const CellPlan&) const = default;

 private:
  std::array<std::uint8_t, kCells> at_{};
};

using Palette = std::array<Rgb16, 256>;

/// The scene's colours, with the interface's sixteen colours put into the cells of the plan.
[[nodiscard]] Palette withInterface(Palette scene, const CellPlan& plan);

/// The colour of every cell: the plan's sixteen, the ramp, and `unneeded` in the cells that a ramp of fewer
/// than 240 shades leaves free (the server's default colours, or black).
[[nodiscard]] Palette makePalette(const CellPlan& plan, const ColorTable& table,
                                  const Palette& unneeded = {});

}  // namespace xnewell
