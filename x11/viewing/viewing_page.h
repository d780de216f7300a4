#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "x11/drawing/pen.h"
#include "x11/viewing/outside_view.h"
#include "x11/viewing/viewing_words.h"
#include "x11/window/layout.h"

namespace xnewell {

/// The page of view 9: the stage from outside, the seven stages small, a table of the vertex and its plane,
/// the matrix, and the light.

struct ViewingLayout {
  Rect outside;
  std::array<Rect, kViewStages.size()> small;
  Rect table;
  Rect column;        ///< of the controls and what is below them
  int pitch = 16;     ///< from line to line
  int rowPitch = 22;  ///< from control to control
  int box = 84;       ///< the height of the two boxes of SHADING
  bool narrow = false;
};
[[nodiscard]] ViewingLayout layoutOfViewing(const Layout& at);

struct ViewingPage {
  const OutsideView& view;
  ShownMatrix matrix = ShownMatrix::ThisStage;
};

/// Draws the table. Returns the rows' places.
std::array<Rect, kViewStages.size()> drawStageTable(Pen& pen, const ViewingLayout& at,
                                                    const ViewingPage& page);
/// The baseline of the choice of the matrix, when the controls above end at `y`.
[[nodiscard]] int matrixRow(const ViewingLayout& at, int y);
/// Draws the matrix below that line, and the light and the finding below the matrix.
void drawMatrixAndLight(Pen& pen, const ViewingLayout& at, const ViewingPage& page, int baseline);

/// N straight up and L at its true angle at a stage; if it is `lit`, with I and its cell.
void drawAngle(Pen& pen, const Rect& box, const ViewingStory& story, ViewStage stage, bool lit = true);

/// What the page says, a line each.
[[nodiscard]] std::vector<std::string> inWords(const ViewingPage& page);

}  // namespace xnewell
