#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "shading/color/palette.h"
#include "x11/drawing/painter.h"

namespace xnewell {

/// The window's voices and marks, drawn with the plan's cells.
struct Pen {
  Painter paint;
  const CellPlan& plan;

  [[nodiscard]] std::uint8_t cell(Cell c) const { return plan[c]; }
  [[nodiscard]] KeyCapCells keyCells() const {
    return {plan[Cell::Panel], plan[Cell::Rule], plan[Cell::Faint], plan[Cell::Soft]};
  }
  int key(int x, int y, std::string_view name) { return paint.keyCap(x, y, name, keyCells()); }
  int arrow(int x, int y, Direction d) { return paint.keyCap(x, y, d, keyCells()); }
  int soft(int x, int y, std::string_view s) { return paint.text(x, y, s, plan[Cell::Soft]); }
  int ink(int x, int y, std::string_view s) { return paint.text(x, y, s, plan[Cell::Ink]); }
  int bold(int x, int y, std::string_view s) { return paint.text(x, y, s, plan[Cell::Ink], Voice::Bold); }
  void boldRight(int x, int y, std::string_view s) { paint.textRight(x, y, s, plan[Cell::Ink], Voice::Bold); }
  void rule(int x, int y, int width) { paint.hline(x, y, width, plan[Cell::Rule]); }
};

/// A slider's line and thumb; shares of the track in [0, 1].
struct TrackLook {
  double share;
  std::optional<double> initially = {};  ///< marked
  bool enabled = true, hovered = false, dragged = false;
};
/// Where a slider's track stands in a row of a column of controls, and its width: pixels.
inline constexpr int kColumnTrackAt = 84, kColumnTrack = 168;
/// The track is `width` pixels from x on, for a row of text on `baseline`.
void drawTrack(Pen& pen, int x, int baseline, int width, const TrackLook& look);
/// All options of a choice in a line: their frames, from x on within `width`; at least 17 high.
[[nodiscard]] std::vector<Rect> optionFrames(std::span<const std::string_view> options, int x, int baseline,
                                             int width, int height = 19);
/// The chosen one framed in bold, the one under the pointer marked.
void drawOptions(Pen& pen, std::span<const std::string_view> options, std::span<const Rect> frames,
                 int chosen, int hovered = -1);
/// The row that has the keyboard: its own colour, so far beyond its end, with an ink bar before it.
void drawFocus(Pen& pen, const Rect& row, int beyond = 2);

}  // namespace xnewell
