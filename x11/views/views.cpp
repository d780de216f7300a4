#include "x11/views/views.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "shading/figure/make_figure.h"
#include "x11/drawing/painter.h"
#include "x11/views/colors_page.h"
#include "x11/views/difference.h"
#include "x11/views/exactness_view.h"
#include "x11/views/mach_bands.h"
#include "x11/views/wireframe.h"

namespace xnewell {

namespace {

constexpr int kLegend = 8;  // pixels from the upper left corner

/// The cell that looks most like a colour.
std::uint8_t nearestCell(const FigureColor& color, const Palette& palette) {
  const auto away = [&](const Rgb16& c) {
    const FigureColor held = figureColorOf(c);
    int sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += (held[k] - color[k]) * (held[k] - color[k]);
    return sum;
  };
  return static_cast<std::uint8_t>(std::ranges::min_element(palette, {}, away) - palette.begin());
}

/// The height of the legend above the table of a sheet; the terms have theirs in the picture.
int legendOf(View view) { return view == View::Overdraw ? 36 : rowOf(view).term ? 0 : 22; }
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
  const bool own = rowOf(settings.view).hasOwnColors();
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
      return termLens(picture, plan, palette, *rowOf(view).term, unit);
  }
}

ColoredImage drawView(PictureCache& pictures, const ViewSettings& settings) {
  assert(settings.view != View::Picture && rowOf(settings.view).hasSheet() &&
         settings.picture.width >= rowOf(settings.view).least.x &&
         settings.picture.height >= rowOf(settings.view).least.y);
  std::optional<std::uint8_t> ground = settings.cells[Cell::Well];
  if (rowOf(settings.view).hasOwnColors()) ground.reset();  // it shows no cell of the picture's
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

IndexImage withMarks(const Picture& picture, const Palette& palette) {
  IndexImage image = picture.image();
  const VectorFigure marks = marksOf(picture);
  const auto pixels = [](int steps) { return static_cast<int>(std::floor(steps / double{kFigureSteps})); };
  for (const FigureStroke& stroke : marks.strokes)
    for (const FigureLoop& line : stroke.lines)
      for (std::size_t k = 1; k < line.size(); ++k)
        Painter{image}.line(pixels(line[k - 1].x), pixels(line[k - 1].y), pixels(line[k].x),
                            pixels(line[k].y), nearestCell(stroke.color, palette),
                            {.thickness = std::max(1, pixels(stroke.width + kFigureSteps / 2)),
                             .on = kDash,
                             .off = stroke.dashed ? kDashPeriod - kDash : 0});
  for (const FigureText& text : marks.texts) {
    const int unit = std::max(1, pixels(text.size + 6 * kFigureSteps) / 12);  // letters have whole units
    Painter{image, unit}.text(pixels(text.at.x) / unit, pixels(text.at.y) / unit, text.text,
                              nearestCell(text.color, palette));
  }
  return image;
}

ShownPicture shownAs(View view, const Picture& picture, const Palette& palette, const CellPlan& plan,
                     CachedGroundTruth& truth, int unit) {
  if (view == View::Picture) return {withMarks(picture, palette), palette, ""};
  if (view == View::Normals) {
    const ColoredImage normals = normalsImage(picture, plan, palette, unit);
    return {normals.image, normals.palette, "Red: N to the right. Green: up. Blue: towards the viewer."};
  }
  if (view == View::Difference) {
    const Difference difference = comparedWithReference(picture, truth.of(picture)).difference;
    ShownPicture shown{stepsImage(difference, plan), palette, findingOf(difference).bold};
    drawStepLegend({shown.image, unit}, plan, kLegend, kLegend, kDoublingSteps, rowOf(difference.kind).times);
    return shown;
  }
  Lens lens = lensOf(view, picture, plan, palette, unit);
  const Painter painter{lens.shown.image, unit};
  if (lens.marks) lens.marks(painter, 0, 0);
  if (!lens.steps.empty()) drawStepLegend(painter, plan, kLegend, kLegend, lens.steps, "");
  return {std::move(lens.shown.image), lens.shown.palette, std::move(lens.finding.bold)};
}

namespace {

Rect pictureAbove(const ViewSettings& settings, int strip) {
  return {Sheet::kMargin, Sheet::kMargin, settings.picture.width - 2 * Sheet::kMargin,
          settings.picture.height - strip - 2 * Sheet::kMargin - Sheet::kGutter};
}

}  // namespace

PictureSheet::PictureSheet(const ViewSettings& settings, int strip)
    : at{pictureAbove(settings, strip)},
      column{(at.width - Sheet::kGutter) / 2},
      top{at.y + at.height + Sheet::kGutter},
      width{at.width},
      sheet{settings.picture.width, settings.picture.height, settings.cells} {
  right = left + width - column;
}

PictureSettings PictureSheet::picture(const ViewSettings& settings, int strip) {
  const Rect at = pictureAbove(settings, strip);
  PictureSettings smaller = settings.picture;
  smaller.width = at.width, smaller.height = at.height;
  return smaller;
}

const LegendStep& doublingStep(double difference, double unit) {
  std::size_t step = 0;
  for (double limit = unit; step + 1 < kDoublingSteps.size() && difference > limit; limit *= 2) ++step;
  return kDoublingSteps[step];
}

void drawStepLegend(Painter painter, const CellPlan& plan, int x, int y, std::span<const LegendStep> steps,
                    std::string_view unit) {
  constexpr int kSwatch = 12, kHigh = 16;
  const auto word = [&](std::string_view text) {
    painter.fillRect({x, y - 2, textWidth(text) + 12, kHigh}, plan[Cell::Well]);
    x = painter.text(x + 4, y + 10, text, plan[Cell::WellText]) + 8;
  };
  for (const LegendStep& step : steps) {
    painter.fillRect({x - 2, y - 2, kSwatch + 4, kHigh}, plan[Cell::Well]);
    painter.fillRect({x, y, kSwatch, kSwatch}, plan[step.cell]);
    x += kSwatch;
    word(step.label);
  }
  if (!unit.empty()) word(unit);
}

}  // namespace xnewell
