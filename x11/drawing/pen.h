#pragma once

#include <string_view>

#include "shading/color/palette.h"
#include "x11/drawing/painter.h"

namespace xnewell {

/// Draws the window's texts, keys and rules with the cells of a plan. A view that needs more adds it to a
/// struct derived from this one.
struct Pen {
  Painter paint;
  const CellPlan& plan;

  [[nodiscard]] std::uint8_t operator()(Cell cell) const { return plan[cell]; }
  [[nodiscard]] KeyCapCells keyCells() const {
    return {plan[Cell::Panel], plan[Cell::Rule], plan[Cell::Faint], plan[Cell::Soft]};
  }
  int key(int x, int y, std::string_view name) { return paint.keyCap(x, y, name, keyCells()); }
  int arrow(int x, int y, Direction d) { return paint.keyCap(x, y, d, keyCells()); }
  int soft(int x, int y, std::string_view s) { return paint.text(x, y, s, plan[Cell::Soft]); }
  int ink(int x, int y, std::string_view s) { return paint.text(x, y, s, plan[Cell::Ink]); }
  int bold(int x, int y, std::string_view s, Cell cell = Cell::Ink) {
    return paint.text(x, y, s, plan[cell], Voice::Bold);
  }
  int softRight(int x, int y, std::string_view s) { return paint.textRight(x, y, s, plan[Cell::Soft]); }
  void boldRight(int x, int y, std::string_view s) { paint.textRight(x, y, s, plan[Cell::Ink], Voice::Bold); }
  int caps(int x, int y, std::string_view s) { return paint.text(x, y, s, plan[Cell::Soft], Voice::Caps); }
  void rule(int x, int y, int width) { paint.hline(x, y, width, plan[Cell::Rule]); }
};

/// A white box with a bar of a colour at its left: the finding in bold, then why, in as many lines of this
/// height as fit.
void drawFindingBox(Pen& pen, const Rect& at, int line, std::string_view bold, std::string_view why,
                    Cell bar);

/// Marks the row that has the keyboard: a background that reaches `beyond` pixels past its end, and an ink
/// bar before it.
void drawFocus(Pen& pen, const Rect& row, int beyond = 2);

}  // namespace xnewell
