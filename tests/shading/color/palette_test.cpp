#include "shading/color/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <glm/glm.hpp>

#include "shading/color/color_difference.h"

namespace xnewell::THIS_FILE {

namespace {

std::set<int> cellsOf(const CellPlan& plan) {
  std::set<int> cells;
  for (int c = 0; c < kCells; ++c) cells.insert(plan[static_cast<Cell>(c)]);
  return cells;
}

/// What an eye sees that lacks one kind of cone: red, green or blue. Rows of a matrix of linear RGB. Machado,
/// Oliveira, Fernandes 2009, severity 1.
using Eye = std::array<glm::dvec3, 3>;
constexpr std::array<Eye, 4> kEyes{
    Eye{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    Eye{{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    Eye{{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    Eye{{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}};

Rgb16 seenBy(const Eye& eye, Rgb16 color) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  const auto stored = [](double v) {
    v = std::clamp(v, 0.0, 1.0);
    return static_cast<std::uint16_t>(
        std::lround(65535 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055)));
  };
  const glm::dvec3 light{linear(color.r / 65535.0), linear(color.g / 65535.0), linear(color.b / 65535.0)};
  return {stored(glm::dot(eye[0], light)), stored(glm::dot(eye[1], light)), stored(glm::dot(eye[2], light))};
}

}  // namespace

// The colours that carry a meaning differ for every eye by a CIEDE2000 of 15, from each other and from what
// they stand on. Two pairs look alike to an eye without blue cones, and have a second sign: a verdict that
// holds stands beside its words, P carries its letter; what has the focus has a bar at its left.
TEST(Palette, MeaningsDifferForEveryEye) {
  const CellPlan plan;
  const Palette palette = makePalette(plan, ColorTable{{}});
  const std::set<std::pair<Cell, Cell>> secondSigns{{Cell::P, Cell::Good}, {Cell::Paper, Cell::Focus}};
  constexpr std::array kShown{Cell::Paper, Cell::Ink,  Cell::Well,  Cell::P,
                              Cell::Q,     Cell::Good, Cell::Alarm, Cell::Focus};
  std::set<std::pair<Cell, Cell>> alike;
  for (const Eye& eye : kEyes)
    for (std::size_t a = 0; a < kShown.size(); ++a)
      for (std::size_t b = std::max<std::size_t>(a + 1, 3); b < kShown.size(); ++b)
        if (ciede2000(labFromSrgb(seenBy(eye, palette[plan[kShown[a]]])),
                      labFromSrgb(seenBy(eye, palette[plan[kShown[b]]]))) < 15)
          alike.emplace(kShown[a], kShown[b]);
  EXPECT_EQ(alike, secondSigns);
}

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
