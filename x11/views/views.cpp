#include "x11/views/views.h"

#include <cassert>

#include "x11/views/colors_view.h"
#include "x11/views/difference.h"
#include "x11/views/mach_bands.h"
#include "x11/views/normals_view.h"
#include "x11/views/overdraw.h"
#include "x11/views/wireframe.h"

namespace xnewell {

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

}  // namespace xnewell
