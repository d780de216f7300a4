#include <algorithm>
#include <string>

#include "x11/lessons/sight_pen.h"
#include "x11/viewing/outside_view.h"
#include "x11/viewing/viewing_page.h"

namespace xnewell {

void drawViewing(SightPen& pen) {
  const Exhibit& exhibit = pen.sight.exhibit;
  const ViewingStory story{pen.sight.picture, exhibit.vertex};
  const LitParts lit{pen.sight.picture, pen.sight.palette, &story.stages, exhibit.shadedIn};
  const StagePoints points{pen.sight.picture.scene().mesh, story.stages};
  StageImages images;
  OutsideView view{.picture = pen.sight.picture,
                   .lit = lit,
                   .story = story,
                   .points = points,
                   .images = images,
                   .stage = exhibit.viewStage,
                   .programs = exhibit.shadedIn == ViewStage::World};
  (void)drawStage(pen, pen.at.picture, view);

  // The picture, and the angles in the world and at the stage. Where the picture's light is not computed, the
  // box has no I: that may be what the step asks.
  constexpr int kGap = 14, kName = 18, kLeastBox = 148;
  const Rect& below = pen.at.below;
  const int boxes = std::min(170, std::max(kLeastBox, (below.width - 2 * kGap) / 3 - 10));
  const Rect small{below.x, below.y, below.width - 2 * (boxes + kGap), below.height - kName};
  view.stage = ViewStage::Viewport;
  drawSmallStage(pen, small, view);
  const std::string light =
      exhibit.shadedIn == ViewStage::World ? "" : ", lit at " + std::string{rowOf(exhibit.shadedIn).name};
  pen.soft(small.x, below.y + below.height - 4, "the picture" + light);
  int x = small.x + small.width + kGap;
  for (const ViewStage stage :
       {ViewStage::World, exhibit.viewStage == ViewStage::World ? ViewStage::Vrc : exhibit.viewStage}) {
    drawAngle(pen, {x, below.y, boxes, std::min(84, below.height - kName)}, story, stage,
              stage == ViewStage::World || stage == exhibit.shadedIn);
    x += boxes + kGap;
  }
}

}  // namespace xnewell
