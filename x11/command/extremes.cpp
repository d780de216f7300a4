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

/// What is said about a way: what was found, and why, or what was done if nothing was.
struct SaidOfWay {
  std::string finding, why;
  bool wrong;
  [[nodiscard]] int height() const {
    return Sheet::paragraphHeight(kChartWords, finding) + Sheet::paragraphHeight(kChartWords, why);
  }
};

SaidOfWay saidOf(const Extreme& way, const ExtremeStep& setUp) {
  const ExtremeStep* const wrong = firstWrong(way, setUp);
  const ExtremeStep* const explained = firstToExplain(way, setUp);
  return {findingOf(way, setUp), explained ? explained->why : std::string{way.drives}, wrong != nullptr};
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
  const int width = kChartWidth - 2 * Sheet::kMargin;
  std::vector<std::pair<std::string, Cell>> above{
      {"A bar is one picture. Its height is the share of wrong samples, or in amber of doubtful ones, from 1 "
       "in "
       "100,000 to all of them.",
       Cell::Soft}};
  for (const std::string& said : {stoppedText(extremes), findingOf(extremes.setUp)})
    if (!said.empty()) above.emplace_back(said, Cell::Alarm);
  std::vector<SaidOfWay> words;
  for (const Extreme& way : extremes.ways) words.push_back(saidOf(way, extremes.setUp));

  int height = 2 * Sheet::kMargin + Sheet::kTitle;
  for (const auto& [text, cell] : above) height += Sheet::paragraphHeight(width, text);
  for (const SaidOfWay& said : words) height += kWayGap + std::max(kBarHeight + 20, said.height());
  const CellPlan plan{TableKind::Linear};
  Sheet sheet{kChartWidth, height, plan};
  int y = sheet.title(Sheet::kMargin, Sheet::kMargin, title);
  for (const auto& [text, cell] : above) y = sheet.paragraph(Sheet::kMargin, y, width, text, cell);
  for (std::size_t k = 0; k < words.size(); ++k) {
    y += kWayGap;
    drawBars(sheet, y, extremes.ways[k]);
    const int left = Sheet::kMargin + kChartNames + kChartBars + Sheet::kMargin;
    const int below =
        sheet.paragraph(left, y, kChartWords, words[k].finding, words[k].wrong ? Cell::Alarm : Cell::Ink);
    sheet.paragraph(left, below, kChartWords, words[k].why, Cell::Soft);
    y += std::max(kBarHeight + 20, words[k].height());
  }
  return {sheet.image(), makePalette(plan, ColorTable{{}})};
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
