#pragma once

#include "x11/drawing/pen.h"
#include "x11/lessons/lesson_sight.h"

namespace xnewell {

inline constexpr int kDisc = 10;       ///< radius of the plate of a letter
inline constexpr int kNameWidth = 92;  ///< pixels for names at the left of bars and profiles

/// What the parts of the left side of a lesson are drawn with; only for the source files of lesson_sight.h.
struct SightPen : Pen {
  const SightLayout& at;
  const Sight& sight;

  [[nodiscard]] int right() const { return at.below.x + at.below.width; }
  /// Draws a rule and a name at the top of the area below the picture. Returns the baseline of its first
  /// line.
  int section(std::string_view name);
  void plate(int x, int y, std::string_view letter, Cell ground, Cell ink, int radius = kDisc);
  /// Words over a picture.
  void line(const Rect& on, std::string_view words);
};

/// The z-extents of the named faces as bars.
void drawExtents(SightPen& pen);
/// A stage of the viewing transformation from outside; below it the picture, and N and L.
void drawViewing(SightPen& pen);
/// A step of the depth sort: the picture so far, and what decided.
void drawRun(SightPen& pen);
/// The first named face, partly filled, and the drift.
void drawFilling(SightPen& pen);
/// What the colour cells hold.
void drawCurves(SightPen& pen);
/// A row of the picture in each shading method: as a strip, and its intensity as a curve.
void drawProfiles(SightPen& pen);

}  // namespace xnewell
