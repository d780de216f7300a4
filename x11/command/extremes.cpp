#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/files/output_file.h"
#include "shading/color/png.h"
#include "shading/extremes/extremes.h"
#include "x11/command/commands.h"
#include "x11/command/report.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/options/exit_status.h"
#include "x11/options/options.h"
#include "x11/terminal/terminal.h"

namespace xnewell {

namespace {

/// ---- The report: the ways, how far each one went, what was found, and what explains it

page::Object dataOf(const ExtremeStep& step) {
  return {{"refused", step.refused},
          {"samples", step.seen.samples},
          {"wrong_face", step.seen.wrong},
          {"missing_face", step.seen.missing},
          {"doubtful_face", step.seen.doubtful},
          {"behind", step.seen.behind},
          {"shades_off", step.shadesOff},
          {"changed", step.changed},
          {"merged_shades", step.merged},
          {"wrong", step.isWrong()},
          {"doubtful", step.isDoubtful()}};
}

page::Page pageOf(const std::string& scene, const Extremes& extremes) {
  constexpr int kFinding = 66;
  page::Page page{.sections = {{}}, .indent = 2};
  page::Section& s = page.sections.front();
  page::List ways;
  page::Table table{.columns = {{.head = "way"}, {.head = "tried"}, {.head = "what was found"}}};
  for (const Extreme& way : extremes.ways) {
    const std::string finding = findingOf(way, extremes.setUp);
    std::vector<std::string> lines = broken(finding, kFinding);
    if (const ExtremeStep* const explained = firstToExplain(way, extremes.setUp))
      for (const std::string& line : broken(explained->why, kFinding)) lines.push_back("  " + line);
    const bool ofPowers = way.unit.starts_with('(');
    for (const std::string& line : lines) table.rows.push_back({{}, {}, {.words = line}});
    auto& first = table.rows[table.rows.size() - lines.size()];
    first[0].words = std::string{way.name} + (ofPowers ? " " + std::string{way.unit} : "");
    first[1].words = shortly(way.steps.front().value) + " to " + shortly(way.steps.back().value);
    page::List steps;
    for (const ExtremeStep& step : way.steps) {
      page::Object one = dataOf(step);
      one.insert(one.begin(), {"value", step.value});
      one.emplace_back("why", step.why);
      steps.emplace_back(std::move(one));
    }
    ways.emplace_back(page::Object{{"way", way.name},
                                   {"unit", way.unit},
                                   {"drives", way.drives},
                                   {"finding", finding},
                                   {"steps", std::move(steps)}});
  }
  s.fact("scene", scene);
  s.fact("stopped", extremes.isStopped(), stoppedText(extremes));
  s.fact("set_up", dataOf(extremes.setUp), findingOf(extremes.setUp));
  s.add(std::move(table));
  s.fact("extremes", std::move(ways));
  return page;
}

/// ---- The chart

constexpr int kChartWidth = 960, kChartNames = 190, kChartBars = 336, kBarHeight = 36, kChartWords = 380;
constexpr int kWayGap = 14;  // between two ways

/// The share of samples that are wrong or doubtful in any respect; 1 if there is no picture.
double shareOf(const ExtremeStep& step) {
  if (!step.refused.empty()) return 1.0;
  const double samples = std::max(1, step.seen.samples);
  const double share = std::max({step.seen.wrong + step.seen.doubtful, step.changed}) / samples;
  return step.isWrong() || step.isDoubtful() ? std::clamp(share, 1.0 / samples, 1.0) : 0.0;
}

/// A share from 1e-5 to 1 as a height.
int heightOf(double share) {
  return share <= 0 ? 0
                    : 3 + static_cast<int>(std::lround((kBarHeight - 3) *
                                                       std::clamp(1 + std::log10(share) / 5, 0.0, 1.0)));
}

/// The name of a way and its bars, from y down.
void drawBars(Sheet& sheet, int y, const Extreme& way) {
  Painter paint = sheet.painter();
  paint.text(Sheet::kMargin, y + Sheet::kAscent, way.name, sheet.cell(Cell::Ink));
  paint.text(Sheet::kMargin, y + Sheet::kAscent + Sheet::kLine, way.unit, sheet.cell(Cell::Soft));
  const int left = Sheet::kMargin + kChartNames, base = y + kBarHeight,
            count = static_cast<int>(way.steps.size());
  const int pitch = kChartBars / std::max(1, count);
  paint.fillRect({left, base, pitch * count, 1}, sheet.cell(Cell::Ink));
  const auto firstWrong = std::ranges::find_if(way.steps, &ExtremeStep::isWrong) - way.steps.begin();
  for (int k = 0; k < count; ++k) {
    const ExtremeStep& step = way.steps[k];
    const int x = left + k * pitch, tall = std::max(3, heightOf(shareOf(step)));
    const Cell cell = step.isWrong()      ? Cell::Alarm
                      : step.isDoubtful() ? Cell::Q
                      : step.isEmpty()    ? Cell::Soft
                                          : Cell::Good;
    paint.fillRect({x + 1, base - tall, pitch - 2, tall}, sheet.cell(cell));
    // The first, the last and the first wrong value are named, if their names do not touch.
    const std::string name = shortly(step.value);
    const int centre = x + pitch / 2 - textWidth(name) / 2;
    const bool named = k == 0 || k == count - 1 || k == firstWrong;
    const bool crowded =
        k == firstWrong && (k * pitch < 60 || (count - 1 - k) * pitch < 60) && k != 0 && k != count - 1;
    if (named && !crowded) paint.text(centre, base + 4 + Sheet::kAscent, name, sheet.cell(Cell::Soft));
  }
}

/// What becomes wrong first, as a chart: a line for each way to an extreme, with a bar for each picture on
/// it. A bar is as high as the share of samples that are wrong, on a logarithmic scale. It is amber where
/// samples are only doubtful, and grey where no face shows.
ColoredImage drawExtremes(const Extremes& extremes, const std::string& title) {
  constexpr int kMostHeight = 4000;
  const CellPlan plan{TableKind::Linear};
  Sheet sheet{kChartWidth, kMostHeight, plan};
  int y = sheet.title(Sheet::kMargin, Sheet::kMargin, title);
  const auto say = [&](const std::string& text, Cell cell) {
    if (!text.empty()) y = sheet.paragraph(Sheet::kMargin, y, kChartWidth - 2 * Sheet::kMargin, text, cell);
  };
  say("A bar is one picture. Its height is the share of wrong samples, or in amber of doubtful ones, from 1 "
      "in 100,000 to all of them.",
      Cell::Soft);
  say(stoppedText(extremes), Cell::Alarm);
  say(findingOf(extremes.setUp), Cell::Alarm);
  for (const Extreme& way : extremes.ways) {
    y += kWayGap;
    drawBars(sheet, y, way);
    const int left = Sheet::kMargin + kChartNames + kChartBars + Sheet::kMargin;
    const bool wrong = firstWrong(way, extremes.setUp) != nullptr;
    const ExtremeStep* const explained = firstToExplain(way, extremes.setUp);
    int below = sheet.paragraph(left, y, kChartWords, findingOf(way, extremes.setUp),
                                wrong ? Cell::Alarm : Cell::Ink);
    below = sheet.paragraph(left, below, kChartWords, explained ? explained->why : std::string{way.drives},
                            Cell::Soft);
    y = std::max(y + kBarHeight + 20, below);
  }
  IndexImage image = sheet.image();
  image.height = y + Sheet::kMargin;
  image.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
  return {std::move(image), makePalette(plan, ColorTable{{}})};
}

}  // namespace

int tellExtremes(const Options& options, const Scene& scene) {
  awaitInterrupt();
  std::optional<Doing> driving;
  const Extremes extremes =
      extremesOf(scene, settingsOf(options, kExtremesSize), [&](const std::string& doing) {
        driving.emplace("trying: " + doing);
        return !wasInterrupted();
      });
  driving.reset();
  print(options, pageOf(options.scene, extremes));
  if (!options.output.empty()) {
    const ColoredImage chart = drawExtremes(extremes, "Extremes of " + titleOf(scene));
    writeFile(options.output, encodePng(chart.image, chart.palette));
  }
  return extremes.isStopped() ? kInterrupted : kDone;
}

}  // namespace xnewell
