#include "x11/views/views.h"

#include <cassert>

#include "x11/views/colors_page.h"
#include "x11/views/difference.h"
#include "x11/views/exactness_view.h"
#include "x11/views/mach_bands.h"
#include "x11/views/normals_view.h"
#include "x11/views/overdraw.h"
#include "x11/views/terms_view.h"
#include "x11/views/wireframe.h"

namespace xnewell {

namespace {

/// What the view asks its picture for.
PictureSettings pictureFor(const Scene& scene, const ViewSettings& settings) {
  switch (settings.view) {
    case View::Colors:
      return pictureForColors(settings);
    case View::MachBands:
      return pictureForMachBands(scene, settings);
    case View::Normals:
      return pictureForNormals(settings);
    case View::Difference:
      return pictureForDifference(settings);
    case View::Exactness:
      return pictureForExactness(settings);
    case View::Overdraw:
      return pictureForOverdraw(settings);
    case View::Wireframe:
      return pictureForWireframe(settings);
    case View::Ambient:
    case View::Diffuse:
    case View::Specular:
    case View::NdotL:
    case View::Cosine:
      return pictureForTerm(settings);
    case View::Picture:
      break;
  }
  return settings.picture;
}

}  // namespace

ColoredImage drawView(PictureCache& pictures, const ViewSettings& settings) {
  assert(settings.picture.width >= rowOf(settings.view).leastWidth &&
         settings.picture.height >= rowOf(settings.view).leastHeight);
  std::optional<std::uint8_t> ground = settings.cells[Cell::Well];
  if (hasOwnColors(settings.view)) ground.reset();  // it shows no cell of the picture's
  const Picture picture = pictures.make(pictureFor(pictures.scene(), settings), ground);
  switch (settings.view) {
    case View::Colors:
      return drawColors(picture, settings);
    case View::MachBands:
      return drawMachBands(picture, settings);
    case View::Normals:
      return drawNormals(picture, settings);
    case View::Difference:
      return drawDifference(picture, settings);
    case View::Exactness:
      return drawExactness(picture, settings);
    case View::Overdraw:
      return drawOverdraw(picture, settings);
    case View::Wireframe:
      return drawWireframe(picture, settings);
    case View::Ambient:
    case View::Diffuse:
    case View::Specular:
    case View::NdotL:
    case View::Cosine:
      return drawTerm(picture, settings, *termOf(settings.view));
    case View::Picture:
      break;
  }
  assert(false);
  return {};
}

}  // namespace xnewell
