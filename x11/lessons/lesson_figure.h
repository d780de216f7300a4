#pragma once

#include <memory>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/color/images.h"
#include "shading/explain/scanline_run.h"
#include "shading/picture/picture.h"
#include "x11/drawing/painter.h"
#include "x11/lessons/lesson_page.h"
#include "x11/window/layout.h"

namespace xnewell {

/// The left side of a lesson's page: the picture of the figure with letters on its faces, and below it what
/// the stage asks for.

struct FigureLayout {
  Rect picture;
  Rect lower;  ///< the second picture of View::SideBySide, otherwise empty
  Rect below;  ///< extents, tests or curves; empty if there is nothing to show
  bool compact = false;
};
/// The area for it in a window.
[[nodiscard]] Rect figureAreaOf(const Layout& window);
/// `area` is at least 400 x 400.
[[nodiscard]] FigureLayout layoutOfFigure(const Rect& area, const StepFigure& figure, bool compact);

struct DrawnFigure {
  const StepFigure& figure;
  const Picture& picture;   ///< of layout's size; of View::DepthSort with planes
  const IndexImage& image;  ///< the picture, painted
  const IndexImage* lower;  ///< the second picture of View::SideBySide
  const SortedScene* run;   ///< textbookRun(), for View::DepthSort
  int step = 1;             ///< the step of the run, from 1
  const CellPlan& plan;
  const Palette& palette;  ///< the colours that are stored
};

/// Draws the picture and what is below it, on a paper background.
void drawFigure(Painter paint, const FigureLayout& at, const DrawnFigure& drawn);

/// The run of the first part of a face of the model; null if it is not in the picture.
[[nodiscard]] std::unique_ptr<ScanlineRun> scanlineOfFace(const Picture& picture, int number, int bits);

/// The place of a letter: a sample of the face with space around it, as far from the middle of the picture as
/// possible; nothing if the face is not visible. `faces` comes from Picture::faceImage();
/// a letter's size is in units of so many pixels.
struct LetterPlace {
  int x, y;
};
[[nodiscard]] std::optional<LetterPlace> placeOfLetter(const std::vector<std::uint32_t>& faces, int width,
                                                       int height, int face, int unit);

}  // namespace xnewell
