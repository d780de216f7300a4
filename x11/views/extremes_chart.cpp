#include "x11/views/extremes_chart.h"

#include <algorithm>
#include <cmath>

#include "x11/drawing/sheet.h"

namespace xnewell {

namespace {

constexpr int kChartWidth = 960, kChartNames = 190, kChartBars = 336, kBarHeight = 36, kChartWords = 380;
constexpr int kWayGap = 14;  // between two ways

/// The share of samples that are wrong in any respect; 1 if there is no picture.
double shareOf(const ExtremeStep& step) {
  if (!step.refused.empty()) return 1.0;
  const double samples = std::max(1, step.seen.samples);
  const double share = std::max(step.seen.wrong, step.changed) / samples;
  return step.isWrong() ? std::clamp(share, 1.0 / samples, 1.0) : 0.0;
}

/// A share from 1e-5 to 1 as a height.
int heightOf(double share) {
  return share <= 0 ? 0
                    : 3 + static_cast<int>(std::lround((kBarHeight - 3) *
                                                       std::clamp(1 + std::log10(share) / 5, 0.0, 1.0)));
}

std::string whyOf(const Extreme& extreme) {
  const auto wrong = std::ranges::find_if(extreme.steps, &ExtremeStep::isWrong);
  return wrong == extreme.steps.end() ? std::string{extreme.drives} : wrong->why;
}

int wordsHeight(const Extreme& extreme) {
  return Sheet::paragraphHeight(kChartWords, findingOf(extreme)) +
         Sheet::paragraphHeight(kChartWords, whyOf(extreme));
}

}  // namespace

ColoredImage drawExtremes(const std::vector<Extreme>& extremes, const std::string& title) {
  int height = 2 * Sheet::kMargin + Sheet::kTitle + Sheet::kLine;
  for (const Extreme& extreme : extremes) height += kWayGap + std::max(kBarHeight + 20, wordsHeight(extreme));
  const CellPlan plan{TableKind::Linear};
  Sheet sheet{kChartWidth, height, plan};
  Painter paint = sheet.painter();
  int y = sheet.title(Sheet::kMargin, Sheet::kMargin, title);
  y = sheet.paragraph(
      Sheet::kMargin, y, kChartWidth - 2 * Sheet::kMargin,
      "A bar is one picture. Its height is the share of wrong samples, from 1 in 100,000 to all of them.",
      Cell::Soft);
  for (const Extreme& extreme : extremes) {
    y += kWayGap;
    paint.text(Sheet::kMargin, y + Sheet::kAscent, extreme.name, sheet.cell(Cell::Ink));
    paint.text(Sheet::kMargin, y + Sheet::kAscent + Sheet::kLine, extreme.unit, sheet.cell(Cell::Soft));
    const int left = Sheet::kMargin + kChartNames, base = y + kBarHeight,
              count = static_cast<int>(extreme.steps.size());
    const int pitch = kChartBars / std::max(1, count);
    paint.fillRect({left, base, pitch * count, 1}, sheet.cell(Cell::Ink));
    const auto firstWrong =
        std::ranges::find_if(extreme.steps, &ExtremeStep::isWrong) - extreme.steps.begin();
    for (int k = 0; k < count; ++k) {
      const ExtremeStep& step = extreme.steps[k];
      const int x = left + k * pitch, tall = heightOf(shareOf(step));
      if (tall > 0)
        paint.fillRect({x + 1, base - tall, pitch - 2, tall}, sheet.cell(Cell::Alarm));
      else
        paint.fillRect({x + 1, base - 3, pitch - 2, 3}, sheet.cell(Cell::Good));
      // The first, the last and the first wrong value are named, if their names do not touch.
      const std::string name = shortly(step.value);
      const int centre = x + pitch / 2 - textWidth(name) / 2;
      const bool named = k == 0 || k == count - 1 || k == firstWrong;
      const bool crowded =
          k == firstWrong && (k * pitch < 60 || (count - 1 - k) * pitch < 60) && k != 0 && k != count - 1;
      if (named && !crowded) paint.text(centre, base + 4 + Sheet::kAscent, name, sheet.cell(Cell::Soft));
    }
    const int words = left + kChartBars + Sheet::kMargin;
    const bool right = firstWrong == count;
    const int below =
        sheet.paragraph(words, y, kChartWords, findingOf(extreme), right ? Cell::Ink : Cell::Alarm);
    sheet.paragraph(words, below, kChartWords, whyOf(extreme), Cell::Soft);
    y += std::max(kBarHeight + 20, wordsHeight(extreme));
  }
  return {sheet.image(), makePalette(plan, ColorTable{{}})};
}

}  // namespace xnewell
