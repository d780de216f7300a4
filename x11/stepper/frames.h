#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "depthsort/record/explain.h"
#include "depthsort/record/replay.h"
#include "shading/color/color_table.h"
#include "shading/picture/picture.h"
#include "x11/drawing/painter.h"
#include "x11/stepper/sort_picture.h"
#include "x11/stepper/sort_state.h"

namespace xnewell {

/// Pictures of a recorded run: what is painted so far, with P and Q outlined, and a sentence below that says
/// what happened.

inline constexpr int kMostWaiting = 3000;  ///< more thin outlines would cover the picture

/// Outlines polygons that are not painted yet in thin lines, the marked ones brighter. `placed` is the
/// outline of a fragment in the image.
void outlineWaiting(Painter fine, const Replay& replay, const CellPlan& plan,
                    const std::function<Outline(int)>& placed);

/// The frames of a run over picture.snapped(). The run outlives it.
class Frames {
 public:
  /// `steps` are the steps that will be asked for: the strip below the picture is as high as they need. Lines
  /// and letters over the picture are drawn in units of so many pixels; the picture is whole units.
  Frames(const Picture& picture, const SortedScene& sorted, bool textbook, const std::vector<int>& steps)
      : Frames{picture, sorted, textbook, steps, CellPlan{picture.settings().table.kind}} {}
  Frames(const Picture& picture, const SortedScene& sorted, bool textbook, const std::vector<int>& steps,
         const CellPlan& plan, int unit = 1);

  /// The frame of a step: the picture in the upper left corner, and the strip below. A frame is at least 320
  /// pixels wide. It is valid until the next call. If steps are asked for in ascending order, each fragment
  /// is painted once.
  [[nodiscard]] const IndexImage& at(int step);
  /// The finished picture, with nothing drawn over it.
  [[nodiscard]] const IndexImage& finished();
  [[nodiscard]] const Palette& palette() const { return palette_; }

 private:
  /// A line of text, and the colour it explains.
  struct Line {
    std::string text;
    int swatch = -1;
  };
  [[nodiscard]] std::vector<Line> linesOf(int step);
  [[nodiscard]] std::vector<Line> lastLines() const;
  /// The lines, broken to the width of the frame.
  [[nodiscard]] std::vector<Line> wrapped(const std::vector<Line>& lines) const;

  void compose(const IndexImage& soFar, const std::vector<Line>& lines);
  /// True if few enough fragments are left to outline them. A polygon that will be split counts as its
  /// pieces.
  [[nodiscard]] bool waitingAreOutlined() const;
  void mark(int fragment, Cell cell, Stipple stipple, std::string_view letter);
  /// In units.
  [[nodiscard]] Rect pictureArea() const;
  [[nodiscard]] Painter overPicture() { return Painter{frame_, unit_}.within(pictureArea()); }
  [[nodiscard]] std::uint8_t cell(Cell c) const { return plan_[c]; }

  const Picture picture_;
  const SortedScene& sorted_;
  Explainer explainer_;
  Replay replay_;
  CellPlan plan_;
  Palette palette_;
  int unit_;
  Voice voice_;
  int width_, rows_ = 0;  ///< pixels; lines of the strip
  SoFar soFar_;
  IndexImage frame_;
};

}  // namespace xnewell
