#pragma once

#include "x11/drawing/pen.h"
#include "x11/viewing/stage_image.h"

namespace xnewell {

/// The drawings of a stage: the scene from outside with the viewing volume around it, large or small.

struct OutsideView {
  const Picture& picture;
  const LitParts& lit;
  const ViewingStory& story;
  ViewStage stage = ViewStage::World;
  OutsideTurn turn = {};
  bool programs = true;  ///< the small viewport is the program's picture, not drawn with `lit`
};

/// The turn of the viewport and of the grid begins straight before the picture.
[[nodiscard]] OutsideTurn turnAt(ViewStage stage, const OutsideTurn& turn);

/// Draws the stage large: with names, axes, the vertex with its N and L, and what the volume was before.
/// Returns the image of the scene, so that a click finds a face; the grid has none.
std::optional<StageImage> drawStage(Pen& pen, const Rect& area, const OutsideView& view);
/// Draws it small, without words: the volume, and the vertex as a dot. The viewport is the program's picture.
void drawSmallStage(Pen& pen, const Rect& area, const OutsideView& view);

}  // namespace xnewell
