#include "x11/views/colors_view.h"

#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/views/color_strip.h"
#include "x11/views/colors_page.h"

namespace xnewell {

namespace {

constexpr int kStrip = 60, kFoot = 28;

Rect stripOf(const ViewSettings& settings) {
  return {0, settings.picture.height - kFoot - kStrip, settings.picture.width, kStrip};
}

ColorsLayout layoutOf(const ViewSettings& settings) {
  return layoutOfColors({Sheet::kMargin, Sheet::kMargin, settings.picture.width - 2 * Sheet::kMargin,
                         stripOf(settings).y - 12 - Sheet::kMargin});
}

}  // namespace

PictureSettings pictureForColors(const ViewSettings& settings) {
  const Rect at = layoutOf(settings).picture;
  PictureSettings shown = settings.picture;
  shown.width = at.width, shown.height = at.height;
  return shown;
}

ColoredImage drawColors(const Picture& picture, const ViewSettings& settings) {
  const int W = settings.picture.width, H = settings.picture.height;
  const Rect strip = stripOf(settings);
  const ColorsLayout at = layoutOf(settings);
  const CellUse use = cellUse(picture.image(), picture.faceImage());
  const CellRange scene = sceneCells(picture);
  const int cell = settings.cell.value_or(settings.effects.lit.value_or(medianCell(use, scene)));

  // Words and curves describe what is stored, except for the light, which only shows where the cell is.
  PaletteEffects effects = settings.effects;
  effects.lit.reset();
  const CellPlan& plan = settings.cells;
  Palette plain = picture.palette(plan, settings.unneeded);
  if (settings.gray) plain = forGrayScreen(plain, picture);
  const Palette stored = withEffects(plain, picture, plan, effects);
  const Palette palette = withEffects(stored, picture, plan, {.lit = settings.effects.lit});
  const std::vector<Curve> steps = stepsSeen(picture, plain, plan, effects);
  IndexImage page{W, H, plan[Cell::Paper]};
  drawColorsPage(page, at,
                 {.picture = picture,
                  .palette = stored,
                  .steps = steps,
                  .plan = plan,
                  .use = use,
                  .cell = cell,
                  .aside = settings.effects.lit == cell ? "light it up everywhere" : "",
                  .lines = tableLines(picture, effects),
                  .gamma = effects.gamma,
                  .hint = ""});
  Painter paint{page};
  paint.hline(0, strip.y, W, plan[Cell::Rule]);
  drawColorStrip(paint, strip, plan, use, wordsOf(picture, effects), W < 1024, cell);
  const int foot = H - kFoot;
  paint.fillRect({0, foot, W, kFoot}, plan[Cell::Panel]);
  paint.hline(0, foot, W, plan[Cell::Rule]);
  const int end = paint.text(Sheet::kMargin, foot + 18, levelsText(picture, stored, steps), plan[Cell::Ink]);
  const std::string title = titleOf(picture.scene());
  if (end + 18 + textWidth(title) <= W - Sheet::kMargin)
    paint.textRight(W - Sheet::kMargin, foot + 18, title, plan[Cell::Soft]);
  return {page, palette};
}

}  // namespace xnewell
