#include "x11/lessons/viewing_facts.h"

#include <cmath>
#include <limits>

#include "x11/viewing/lit_parts.h"
#include "x11/viewing/viewing_page.h"

namespace xnewell {

namespace {

double facesOff(const Picture& picture, const ViewingStory& story, ViewStage shadedIn) {
  const Palette none{};  // a plan of colours has no shades to compare
  const LitParts world{picture, none}, there{picture, none, &story.stages, shadedIn};
  const Mesh& mesh = picture.scene().mesh;
  int off = 0;
  for (int face = 0; face < mesh.faceCount(); ++face)
    if (const CellOnRamp* const ramp = world.ramp(face)) {
      const int corner = mesh.firstCorner[face];
      off += (*ramp)(world.at(corner, false)) != (*ramp)(there.at(corner, false));
    }
  return off;
}

}  // namespace

ViewingFacts viewingFactsOf(const Picture& picture, const Exhibit& exhibit) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  ViewingFacts facts{kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
  if (exhibit.stage != Stage::Viewing) return facts;
  const ViewingStory story{picture, exhibit.vertex};
  const VertexAtStage &world = story.world(), &here = story.of(exhibit.viewStage);
  facts.worldNdotL = world.NdotL.value_or(kNone), facts.worldI = world.I;
  facts.stageNdotL = here.NdotL.value_or(kNone), facts.stageI = here.I;
  if (world.cell && here.cell) facts.cells = std::abs(*world.cell - *here.cell);
  facts.facesOff = facesOff(picture, story, exhibit.shadedIn);
  const glm::dvec4 at = shownAt(story, exhibit.viewStage, lengthUnit(picture.scene()));
  facts.w = at.w, facts.z = at.z;
  const Mesh& mesh = picture.scene().mesh;
  facts.outside = 0;
  for (const int corner : mesh.corners) facts.outside += story.stages.outside(mesh.points[corner]) != 0;
  return facts;
}

}  // namespace xnewell
