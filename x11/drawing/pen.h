#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

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

/// A slider's line and thumb; shares of the track in [0, 1].
struct TrackLook {
  double share;
  std::optional<double> initially = {};  ///< marked on the track
  bool enabled = true, hovered = false, dragged = false;
  int height = 15;  ///< of the thumb, in pixels: odd
};
/// Where the track of a slider begins in a row of controls, and how wide it is, in pixels.
inline constexpr int kColumnTrackAt = 84, kColumnTrack = 168;
/// Draws a track of `width` pixels from x on, beside text on `baseline`.
void drawTrack(Pen& pen, int x, int baseline, int width, const TrackLook& look);
/// The frames of all options of a choice, in a line from x on within `width`. If there is too little room for
/// the words, more lines follow, each one `height` below the one before. `height` is at least
/// that of the text, 13.
[[nodiscard]] std::vector<Rect> optionFrames(std::span<const std::string_view> options, int x, int baseline,
                                             int width, int height = 19);
/// The chosen option is framed and bold; the one under the pointer is marked.
void drawOptions(Pen& pen, std::span<const std::string_view> options, std::span<const Rect> frames,
                 int chosen, int hovered = -1);
/// Marks the row that has the keyboard: a background that reaches `beyond` pixels past its end, and an ink
/// bar before it.
void drawFocus(Pen& pen, const Rect& row, int beyond = 2);

}  // namespace xnewell
