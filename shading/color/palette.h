#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "shading/color/color_table.h"

namespace xnewell {

/// The 256 colours that go with an index image: sixteen cells for the tool, the rest for the ramp.

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
/// What each is for, in a word or two.
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

/// Where each interface colour lives. The usual places are those of the drawing of the window; black
/// and white are the server's own pixels, and whoever stood there moves aside.
class CellPlan {
 public:
  /// `black` and `white` as the server tells them. A pixel inside the ramp cannot be kept: the tool
  /// then keeps a black or white of its own.
  explicit CellPlan(TableKind table = TableKind::Linear, int black = 0, int white = 1);
  [[nodiscard]] std::uint8_t operator[](Cell cell) const { return at_[static_cast<int>(cell)]; }
  bool operator==(const CellPlan&) const = default;

 private:
  std::array<std::uint8_t, kCells> at_{};
};

using Palette = std::array<Rgb16, 256>;

/// The colours of the scene's cells, and in the plan's sixteen those of the tool.
[[nodiscard]] Palette withInterface(Palette scene, const CellPlan& plan);

/// Every cell's colour: the plan's sixteen, the ramp, and `unneeded` (the server's default colours, or
/// black) in the cells that fewer than 240 shades leave free.
[[nodiscard]] Palette makePalette(const CellPlan& plan, const ColorTable& table,
                                  const Palette& unneeded = {});

}  // namespace xnewell
