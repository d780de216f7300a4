#include "shading/views.h"

#include <cassert>

#include "shading/colors_view.h"
#include "shading/difference.h"
#include "shading/mach_bands.h"
#include "shading/normals_view.h"
#include "shading/overdraw.h"
#include "shading/wireframe.h"

ColoredImage drawView(Picture& picture, const ViewSettings& settings) {
  assert(settings.picture.width >= rowOf(settings.view).leastWidth &&
         settings.picture.height >= rowOf(settings.view).leastHeight);
  switch (settings.view) {
    case View::Colors:
      return drawColors(picture, settings);
    case View::MachBands:
      return drawMachBands(picture, settings);
    case View::Normals:
      return drawNormals(picture, settings);
    case View::Difference:
      return drawDifference(picture, settings);
    case View::Overdraw:
      return drawOverdraw(picture, settings);
    case View::Wireframe:
      return drawWireframe(picture, settings);
    case View::Picture:
      break;
  }
  assert(false);
  return {};
}
