#include "shading/color/palette.h"

#include <gtest/gtest.h>

#include <set>

namespace xnewell::THIS_FILE {

namespace {

std::set<int> cellsOf(const CellPlan& plan) {
  std::set<int> cells;
  for (int c = 0; c < kCells; ++c) cells.insert(plan[static_cast<Cell>(c)]);
  return cells;
}

}  // namespace

// The tool's cells are at their usual places, and the well's text is at 250 while `brief` uses 10..249.
TEST(CellPlan, UsualPlaces) {
  const CellPlan linear{TableKind::Linear};
  EXPECT_EQ(linear[Cell::Black], 0);
  EXPECT_EQ(linear[Cell::White], 1);
  EXPECT_EQ(linear[Cell::Well], 8);
  EXPECT_EQ(linear[Cell::WellText], 10);
  EXPECT_EQ(linear[Cell::Focus], 255);
  EXPECT_EQ(CellPlan{TableKind::Brief}[Cell::WellText], 250);
}

// If black is 1 and white is 0, all other cells stay.
TEST(CellPlan, SwappedBlackAndWhite) {
  const CellPlan usual{TableKind::Corrected}, swapped{TableKind::Corrected, 1, 0};
  EXPECT_EQ(swapped[Cell::Black], 1);
  EXPECT_EQ(swapped[Cell::White], 0);
  for (int c = 2; c < kCells; ++c) EXPECT_EQ(swapped[static_cast<Cell>(c)], usual[static_cast<Cell>(c)]);
}

// Sixteen different cells are found outside the ramp, wherever the server's black and white are. Black and
// white keep the server's pixels unless these lie within the ramp.
TEST(CellPlan, MovesAsideForTheServersPixels) {
  for (const TableRow& table : kTables)
    for (int black = 0; black < 256; ++black)
      for (const int white : {0, 1, 5, 10, 100, 250, 254, 255}) {
        const CellPlan plan{table.id, black, white};
        const std::set<int> cells = cellsOf(plan);
        ASSERT_EQ(cells.size(), 16u) << black << ' ' << white;
        const auto inRamp = [&](int cell) { return cell >= table.first && cell < table.first + 240; };
        for (const int cell : cells) ASSERT_FALSE(inRamp(cell));
        if (!inRamp(black)) {
          ASSERT_EQ(plan[Cell::Black], black);
        }
        if (!inRamp(white) && white != black) {
          ASSERT_EQ(plan[Cell::White], white);
        }
      }
}

// Cells that fewer shades leave free hold the colours that they are given, those of the default map.
TEST(Palette, UnneededCellsKeepTheirColours) {
  Palette defaults;
  for (int i = 0; i < 256; ++i) defaults[i] = {static_cast<std::uint16_t>(257 * i), 1, 2};
  TableSettings settings;
  settings.shades = 64;
  const ColorTable table{settings};
  const Palette palette = makePalette(CellPlan{TableKind::Linear}, table, defaults);
  EXPECT_EQ(palette[11 + 63], table.color(63));
  for (int i = 11 + 64; i <= 250; ++i) EXPECT_EQ(palette[i], defaults[i]);
  EXPECT_EQ(palette[8], (Rgb16{0x2A2A, 0x2E2E, 0x3535}));
}

}  // namespace xnewell::THIS_FILE
