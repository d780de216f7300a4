#pragma once

#include <vector>

#include "shading/color/index_image.h"
#include "shading/color/palette.h"
#include "shading/picture/picture.h"
#include "x11/drawing/rect.h"
#include "x11/lessons/exhibit.h"

namespace xnewell {

/// The left of a lesson's page: the exhibit's picture with letters on its faces, and below it what the stage
/// asks for.

struct SightLayout {
  Rect picture;
  Rect lower;  ///< the second picture of Stage::SideBySide, else empty
  Rect below;  ///< extents, tests, curves; empty where there is nothing to tell
  bool compact = false;
};
/// `area` is at least 400 x 400.
[[nodiscard]] SightLayout layoutOfSight(const Rect& area, const Exhibit& exhibit, bool compact);

struct Sight {
  const Exhibit& exhibit;
  const Picture& picture;   ///< of layout's size; of Stage::DepthSort with planes
  const IndexImage& image;  ///< it, painted
  const IndexImage* lower;  ///< of Stage::SideBySide
  const SortedScene* run;   ///< of Stage::DepthSort, textbookRun()
  int step = 1;             ///< of the run, from 1
  const CellPlan& plan;
  const Palette& palette;  ///< what is stored
};

/// What stands on the area before is painted over.
void drawSight(IndexImage& image, const SightLayout& at, const Sight& sight);

/// Where a letter stands: at a sample of the face with room around it, as far from the picture's middle as
/// may be; nothing where the face is not seen. `faces` as Picture::faceImage() has them.
struct LetterPlace {
  int x, y;
};
[[nodiscard]] std::optional<LetterPlace> placeOfLetter(const std::vector<std::uint32_t>& faces, int width,
                                                       int height, int face);

}  // namespace xnewell
