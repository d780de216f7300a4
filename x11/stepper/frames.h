#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "depthsort/explain.h"
#include "depthsort/replay.h"
#include "shading/color/palette.h"
#include "shading/picture/picture.h"
#include "x11/drawing/painter.h"
#include "x11/stepper/so_far.h"

namespace xnewell {

/// Pictures of a recorded run: what is painted so far, P and Q outlined, and below it what happened in a
/// sentence.

inline constexpr int kMostWaiting = 3000;  ///< more thin outlines than this are a blot

/// The frames of a run over picture.snapped(). The run outlives it.
class Frames {
 public:
  /// `steps` are those that will be asked for: the strip below the picture is as high as they need.
  Frames(const Picture& picture, const SortedScene& sorted, bool textbook, const std::vector<int>& steps)
      : Frames{picture, sorted, textbook, steps, CellPlan{picture.settings().table.kind}} {}
  Frames(const Picture& picture, const SortedScene& sorted, bool textbook, const std::vector<int>& steps,
         const CellPlan& plan);

  /// The picture in the upper left corner, at least 320 pixels wide with its surroundings, and the strip.
  /// Valid until the next call. Asking in ascending order paints each fragment once.
  [[nodiscard]] const IndexImage& at(int step);
  /// The finished picture, nothing drawn over it.
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
  /// Broken to the width.
  [[nodiscard]] std::vector<Line> wrapped(const std::vector<Line>& lines) const;

  void compose(const IndexImage& soFar, const std::vector<Line>& lines);
  /// Whether few enough are left; those that are to be split count as their pieces.
  [[nodiscard]] bool waitingAreOutlined() const;
  void outlineWaiting();
  void mark(int fragment, Cell cell, Stipple stipple, std::string_view letter);
  [[nodiscard]] Rect pictureArea() const;
  [[nodiscard]] std::uint8_t cell(Cell c) const { return plan_[c]; }

  const Picture picture_;
  const SortedScene& sorted_;
  Explainer explainer_;
  Replay replay_;
  CellPlan plan_;
  Palette palette_;
  Voice voice_;
  int width_, rows_ = 0;  ///< pixels; lines of the strip
  SoFar soFar_;
  IndexImage frame_;
};

}  // namespace xnewell
