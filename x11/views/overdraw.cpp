#include "x11/views/overdraw.h"

#include <algorithm>
#include <string>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

constexpr int kCountSwatch = 48;

void drawCountLegend(Sheet& sheet, int x, int y) {
  Painter painter = sheet.painter();
  const int steps = static_cast<int>(kOverdrawSteps.size());
  for (int k = 0; k < steps; ++k) {
    const OverdrawStep& step = kOverdrawSteps[k];
    painter.fillRect({x + k * kCountSwatch, y, kCountSwatch, 12}, sheet.cell(step.cell));
    painter.text(x + k * kCountSwatch + (kCountSwatch - textWidth(step.label)) / 2, y + 14 + Sheet::kAscent,
                 step.label, sheet.cell(Cell::Soft));
  }
  painter.frame({x, y, steps * kCountSwatch, 12}, sheet.cell(Cell::Ink));
}

}  // namespace

Finding findingOf(const Overdraw& o, const Picture& picture) {
  if (o.samples == 0) return {"Nothing shows.", ""};
  const Order order = picture.settings().order;
  if (order == Order::Oracle)
    return {"Every sample is painted once.",
            "The oracle finds the face that each sample shows and paints no other, so nothing is painted "
            "over. The orders by a sort paint whole faces."};
  if (rowOf(order).bits > 0)
    return {"Every sample is painted once.", "The z-buffer found the face that each sample shows by " +
                                                 grouped(picture.sorted().statistics.depthTests) +
                                                 " tests of a depth, one for each sample of each face."};
  const double over = 100.0 * static_cast<double>(o.painted - o.samples) / static_cast<double>(o.painted);
  Finding finding{"A sample is painted " + fixed(o.mean(), 2) + " times on average, " +
                      std::to_string(o.most) + " at most.",
                  fixed(over, 1) +
                      " % of all painted samples are painted over. This is the price of an order that needs "
                      "no depth at any sample."};
  const auto faces = static_cast<std::int64_t>(picture.snapped().faces.size());
  if (order == Order::Newell && picture.sorted().statistics.splits == 0 &&
      static_cast<std::int64_t>(picture.sorted().fragments.size()) < faces)
    finding.why += " " + grouped(faces - static_cast<std::int64_t>(picture.sorted().fragments.size())) +
                   " of " + grouped(faces) + " polygons show nowhere and were left out.";
  return finding;
}

Overdraw overdrawOf(const Picture& picture) {
  Overdraw o{.width = picture.settings().width, .times = picture.timesPainted()};
  for (std::size_t k = 0; k < o.times.size(); ++k) {
    const int times = o.times[k];
    o.painted += times;
    o.samples += times > 0;
    o.once += times == 1;
    if (times > o.most) o.most = times, o.mostAt = k;
  }
  return o;
}

IndexImage overdrawImage(const Overdraw& overdraw, const CellPlan& plan) {
  IndexImage image{overdraw.width, static_cast<int>(overdraw.times.size()) / overdraw.width,
                   plan[Cell::Well]};
  for (std::size_t k = 0; k < overdraw.times.size(); ++k)
    if (overdraw.times[k] > 0)
      image.pixels[k] =
          plan[std::ranges::lower_bound(kOverdrawSteps, overdraw.times[k], {}, &OverdrawStep::most)->cell];
  return image;
}

Lens overdrawLens(const Picture& picture, const CellPlan& plan, const Palette& palette) {
  const Overdraw o = overdrawOf(picture);
  const double once =
      o.samples == 0 ? 0.0 : 100.0 * static_cast<double>(o.once) / static_cast<double>(o.samples);
  Lens lens{.shown = {overdrawImage(o, plan), palette},
            .finding = findingOf(o, picture),
            .section = "times painted",
            .rows = {{"order", std::string{rowOf(picture.settings().order).label}},
                     {"samples that show a face", grouped(o.samples)},
                     {"samples painted in total", grouped(o.painted)},
                     {"times each, mean and largest", fixed(o.mean(), 2) + "   " + std::to_string(o.most)},
                     {"painted once", fixed(once, 1) + " %"}},
            .onSheet = [most = o.most, at = static_cast<int>(o.mostAt), width = o.width](PictureSheet& page,
                                                                                         int y) {
              drawCountLegend(page.sheet, page.left, y);
              if (most <= 1) return;
              Painter painter = page.sheet.painter().within(page.at);
              const int x = page.at.x + at % width, row = page.at.y + at / width;
              painter.ring(x, row, 8, page.sheet.cell(Cell::White));
              painter.ring(x, row, 9, page.sheet.cell(Cell::Black));
            }};
  for (const OverdrawStep& step : kOverdrawSteps) lens.steps.push_back({step.cell, step.label});
  return lens;
}

}  // namespace xnewell
