#include "shading/color/palette.h"

#include <algorithm>

namespace xnewell {

namespace {

struct CellRow {
  int preferred;
  Rgb16 color;
};
constexpr std::array<CellRow, kCells> kCellRows{{
    {0, {0x0000, 0x0000, 0x0000}},    // Black
    {1, {0xFFFF, 0xFFFF, 0xFFFF}},    // White
    {2, {0xF5F5, 0xF2F2, 0xEBEB}},    // Paper
    {3, {0xE8E8, 0xE3E3, 0xD9D9}},    // Panel
    {4, {0xCDCD, 0xC6C6, 0xB9B9}},    // Rule
    {5, {0x9C9C, 0x9595, 0x8A8A}},    // Faint
    {6, {0x6969, 0x6262, 0x5A5A}},    // Soft
    {7, {0x2323, 0x2020, 0x1C1C}},    // Ink
    {8, {0x2A2A, 0x2E2E, 0x3535}},    // Well
    {9, {0x4A4A, 0x5050, 0x5A5A}},    // WellLine
    {10, {0xC6C6, 0xCBCB, 0xD2D2}},   // WellText
    {251, {0x2A2A, 0x7F7F, 0xC9C9}},  // P
    {252, {0xF0F0, 0xA8A8, 0x1818}},  // Q
    {253, {0x1B1B, 0x8282, 0x5959}},  // Good
    {254, {0xB8B8, 0x4040, 0x0E0E}},  // Alarm
    {255, {0xFFFF, 0xF0F0, 0xB3B3}},  // Focus
}};

}  // namespace

CellPlan::CellPlan(TableKind table, int black, int white) {
  const int rampFirst = kTables[static_cast<int>(table)].first, rampEnd = rampFirst + kMaxShades;
  const auto inRamp = [&](int cell) { return cell >= rampFirst && cell < rampEnd; };
  std::array<bool, 256> taken{};
  for (int cell = rampFirst; cell < rampEnd; ++cell) taken[cell] = true;
  std::array<bool, kCells> placed{};
  const auto place = [&](int role, int cell) {
    at_[role] = static_cast<std::uint8_t>(cell);
    taken[cell] = placed[role] = true;
  };
  if (black >= 0 && black < 256 && !inRamp(black)) place(0, black);
  if (white >= 0 && white < 256 && white != black && !inRamp(white)) place(1, white);
  // A colour keeps its usual cell if that is free. The others take the cells that are left, in order.
  for (int role = 0; role < kCells; ++role)
    if (!placed[role] && !taken[kCellRows[role].preferred]) place(role, kCellRows[role].preferred);
  for (int role = 0; role < kCells; ++role)
    if (!placed[role])
      place(role, static_cast<int>(std::find(taken.begin(), taken.end(), false) - taken.begin()));
}

Palette withInterface(Palette palette, const CellPlan& plan) {
  for (int role = 0; role < kCells; ++role) palette[plan[static_cast<Cell>(role)]] = kCellRows[role].color;
  return palette;
}

Palette makePalette(const CellPlan& plan, const ColorTable& table, const Palette& unneeded) {
  Palette palette = unneeded;
  for (int j = 0; j < table.shades(); ++j) palette[table.first() + j] = table.color(j);
  return withInterface(palette, plan);
}

}  // namespace xnewell
