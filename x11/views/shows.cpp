#include "x11/views/shows.h"

#include <algorithm>
#include <cmath>

#include "shading/figure/make_figure.h"
#include "x11/drawing/painter.h"
#include "x11/views/difference.h"
#include "x11/views/normals_view.h"
#include "x11/views/picture_sheet.h"
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

}  // namespace

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

ShownPicture shownAs(Show show, const Picture& picture, const Palette& palette, const CellPlan& plan,
                     LastTruth& truth, int unit) {
  if (show == Show::Shaded) return {withMarks(picture, palette), palette, ""};
  if (show == Show::Normals) {
    const ColoredImage normals = normalsImage(picture, plan, palette, unit);
    return {normals.image, normals.palette, "Red: N to the right. Green: up. Blue: towards the viewer."};
  }
  if (show == Show::Difference) {
    const Difference difference = comparedWithReference(picture, truth.of(picture)).difference;
    ShownPicture shown{stepsImage(difference, plan), palette, findingOf(difference).bold};
    drawStepLegend({shown.image, unit}, plan, kLegend, kLegend, kDoublingSteps, rowOf(difference.kind).times);
    return shown;
  }
  const View view = std::ranges::find(kViews, rowOf(show).name, &ViewRow::name)->id;
  Lens lens = lensOf(view, picture, plan, palette, unit);
  const Painter painter{lens.shown.image, unit};
  if (lens.marks) lens.marks(painter, 0, 0);
  if (!lens.steps.empty()) drawStepLegend(painter, plan, kLegend, kLegend, lens.steps, "");
  return {std::move(lens.shown.image), lens.shown.palette, std::move(lens.finding.bold)};
}

}  // namespace xnewell
