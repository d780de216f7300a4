#include "x11/views/picture_sheet.h"

namespace xnewell {

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
