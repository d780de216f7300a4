#include "x11/views/views.h"

#include <algorithm>
#include <cassert>

#include "x11/views/colors_page.h"
#include "x11/views/difference.h"
#include "x11/views/exactness_view.h"
#include "x11/views/mach_bands.h"
#include "x11/views/normals_view.h"
#include "x11/views/overdraw.h"
#include "x11/views/picture_sheet.h"
#include "x11/views/terms_view.h"
#include "x11/views/wireframe.h"

namespace xnewell {

namespace {

/// The height of the legend above the table of a sheet; the terms have theirs in the picture.
int legendOf(View view) { return view == View::Overdraw ? 36 : termOf(view) ? 0 : 22; }
int stripOf(View view) { return Sheet::kSection + legendOf(view) + 5 * Sheet::kRow; }

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
    default:
      return PictureSheet::picture(settings, stripOf(settings.view));
  }
}

ColoredImage drawLens(const Picture& picture, const ViewSettings& settings) {
  const bool own = hasOwnColors(settings.view);
  const Lens lens = lensOf(settings.view, picture, settings.cells,
                           own ? settings.unneeded : picture.palette(settings.cells, settings.unneeded));
  PictureSheet page{settings, stripOf(settings.view)};
  Painter painter = page.sheet.painter();
  painter.place(lens.shown.image, {0, 0, page.at.width, page.at.height}, page.at.x, page.at.y);
  if (lens.marks) lens.marks(painter.within(page.at), page.at.x, page.at.y);
  int y = page.sheet.section(page.left, page.top, page.width, lens.section);
  if (lens.onSheet)
    lens.onSheet(page, y);
  else if (!lens.steps.empty())
    drawStepLegend(painter, settings.cells, page.left + 2, y + 2, lens.steps, "");
  const bool isWide = lens.onSheet && lens.steps.empty();  // the legend: the finding is below it
  page.sheet.finding(page.right, y + (isWide ? legendOf(settings.view) : 0), page.column, lens.finding.bold,
                     lens.finding.why);
  y += std::max(4, legendOf(settings.view));
  for (const auto& [label, value] : lens.rows)
    y = page.sheet.tableRow(page.left, y, label, {value}, {page.column});
  return {page.sheet.image(), own ? withInterface(lens.shown.palette, settings.cells) : lens.shown.palette};
}

}  // namespace

Lens lensOf(View view, const Picture& picture, const CellPlan& plan, const Palette& palette, int unit) {
  switch (view) {
    case View::Exactness:
      return exactnessLens(picture, plan, palette);
    case View::Overdraw:
      return overdrawLens(picture, plan, palette);
    case View::Wireframe:
      return wireframeLens(picture, plan, palette);
    default:
      return termLens(picture, plan, palette, *termOf(view), unit);
  }
}

ColoredImage drawView(PictureCache& pictures, const ViewSettings& settings) {
  assert(settings.view != View::Picture && settings.picture.width >= rowOf(settings.view).leastWidth &&
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
    default:
      return drawLens(picture, settings);
  }
}

}  // namespace xnewell
