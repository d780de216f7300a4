#include "x11/views/plot.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "shading/color/color_difference.h"
#include "shading/light/illumination.h"
#include "shading/picture/palette_effects.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

double of255(int v) { return v / 257.0; }
double brightest(const Rgb16& c) { return of255(std::max({c.r, c.g, c.b})); }
double brightness(const Rgb16& c) { return luminance({of255(c.r), of255(c.g), of255(c.b)}); }

template <class Value>
Curve curveOf(std::string name, const Palette& palette, const CellRange& cells, Value&& value) {
  Curve curve{std::move(name), cells.first, {}, true};
  for (int cell = cells.first; cell <= cells.last(); ++cell) curve.y.push_back(value(palette[cell]));
  return curve;
}

bool holdsColors(const Picture& picture) { return channelsOf(picture.colors().plan()) == Channels::Rgb; }

Curve stepsBetween(const Curve& values) {
  Curve steps = values;
  for (std::size_t k = 0; k < values.y.size(); ++k) {
    const bool any = k + 1 < values.y.size() && values.y[k] > 0.0;
    steps.y[k] = any ? 100.0 * (values.y[k + 1] / values.y[k] - 1.0) : kNoValue;
  }
  return steps;
}

Curve nearestOthers(const Palette& palette, const CellRange& cells) {
  std::vector<Lab> colors;
  for (int cell = cells.first; cell <= cells.last(); ++cell) colors.push_back(labFromSrgb(palette[cell]));
  Curve curve{"", cells.first, std::vector<double>(colors.size(), kNoValue), true};
  for (std::size_t p = 0; p < colors.size(); ++p)
    for (std::size_t q = 0; q < p; ++q) {
      const double difference = ciede2000(colors[p], colors[q]);
      curve.y[p] = std::fmin(curve.y[p], difference);
      curve.y[q] = std::fmin(curve.y[q], difference);
    }
  return curve;
}

}  // namespace

std::vector<Curve> storedCurves(const Picture& picture, const Palette& palette) {
  if (holdsColors(picture)) {
    Curve bright = curveOf("largest", palette, sceneCells(picture), brightest);
    bright.chosen = false;
    return {curveOf("luminance", palette, sceneCells(picture), brightness), bright};
  }
  std::vector<Curve> curves;
  const std::vector<CellRange> ramps = rampsOf(picture);
  for (const CellRange& ramp : ramps) curves.push_back(curveOf("", palette, ramp, brightest));
  if (ramps.size() > 1) return curves;
  const ColorTable& table = picture.table();
  bool changed = false;
  for (int j = 0; j < table.shades(); ++j) changed |= palette[table.first() + j] != table.color(j);
  const auto name = [](TableKind kind) { return std::string{kTables[static_cast<int>(kind)].name}; };
  curves.front().name = changed ? "as stored" : name(table.settings().kind);
  for (const TableRow& row : kTables) {
    if (row.id == table.settings().kind && !changed) continue;
    const ColorTable other = inTable(table, row.id);
    Curve curve{name(row.id), other.first(), {}, false};
    for (int j = 0; j < other.shades(); ++j) curve.y.push_back(brightest(other.color(j)));
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<Curve> stepCurves(const Picture& picture, const Palette& palette) {
  if (holdsColors(picture)) return {nearestOthers(palette, sceneCells(picture))};
  std::vector<Curve> curves = storedCurves(picture, palette);
  std::ranges::transform(curves, curves.begin(), stepsBetween);
  return curves;
}

double nearestOther(const Palette& palette, const CellRange& cells, int cell) {
  double nearest = kNoValue;
  for (int other = cells.first; other <= cells.last(); ++other)
    if (other != cell)
      nearest = std::fmin(nearest, ciede2000(labFromSrgb(palette[cell]), labFromSrgb(palette[other])));
  return nearest;
}

int distinctLevels(TableSettings settings, int bits) {
  settings.bits = bits;
  const ColorTable table{settings};
  Palette palette;
  for (int j = 0; j < table.shades(); ++j) palette[table.first() + j] = table.color(j);
  return distinctColors(palette, {table.first(), table.shades()}, 16);
}

int distinctColors(const Palette& palette, const CellRange& cells, int bits) {
  const auto kept = [bits](int v) { return bits == 8 ? std::lround(of255(v)) : v; };
  std::set<std::tuple<long, long, long>> colors;
  for (int cell = cells.first; cell <= cells.last(); ++cell)
    colors.insert({kept(palette[cell].r), kept(palette[cell].g), kept(palette[cell].b)});
  return static_cast<int>(colors.size());
}

double ratioOf(const ColorTable& table) {
  assert(table.settings().kind == TableKind::Corrected);
  return ratioOfShades(table.level(0) / table.level(table.shades() - 1), table.shades() - 1);
}

namespace {

constexpr int kAscent = 4;       // from the baseline of a label up to its middle
constexpr int kLabelPitch = 14;  // from label to label at the right, at least
constexpr int kTickPitch = 13;

std::string number(double v) { return fixed(v, v >= 1 || v == 0 ? 0 : v < 0.1 ? 2 : 1); }

/// Both ends, and the cells at multiples of a step that leaves room for their numbers.
std::vector<int> cellTicks(const Plot& plot, const Rect& area) {
  const auto [first, count] = plot.cells;
  int step = 1;
  while (step * (area.width - 1) < 80 * std::max(1, count - 1)) step *= 2;
  std::vector<int> ticks{first};
  const int room = 30 * std::max(1, count - 1) / std::max(1, area.width - 1);
  for (int cell = (first / step + 1) * step; cell < plot.cells.last(); cell += step)
    if (cell - first > room && plot.cells.last() - cell > room) ticks.push_back(cell);
  if (count > 1) ticks.push_back(plot.cells.last());
  return ticks;
}

struct EndLabel {
  int y;
  std::string name;
  Cell color;
  Voice voice;
};

void drawCurve(Painter paint, const Rect& area, const Plot& plot, const Curve& curve, std::uint8_t cell) {
  Painter inside = paint.within(area);
  for (std::size_t k = 0; k < curve.y.size(); ++k) {
    if (std::isnan(curve.y[k])) continue;
    const int at = curve.first + static_cast<int>(k);
    const bool joins = k + 1 < curve.y.size() && !std::isnan(curve.y[k + 1]);
    inside.line(plotX(plot, area, at), plotY(plot, area, curve.y[k]), plotX(plot, area, at + joins),
                plotY(plot, area, curve.y[k + joins]), cell, {curve.chosen ? 2 : 1});
  }
}

/// The last value of the curve within the plot.
double endOf(const Curve& curve, const Plot& plot) {
  double y = plot.ticks.front();
  for (std::size_t k = 0; k < curve.y.size(); ++k)
    if (!std::isnan(curve.y[k]) && curve.first + static_cast<int>(k) <= plot.cells.last()) y = curve.y[k];
  return y;
}

/// Keeps names apart: each moves down below the one above it, then all move up again from the bottom.
void drawEndLabels(Painter paint, const CellPlan& plan, const Rect& area, std::vector<EndLabel> labels) {
  std::ranges::stable_sort(labels, {}, &EndLabel::y);
  for (std::size_t k = 1; k < labels.size(); ++k)
    labels[k].y = std::max(labels[k].y, labels[k - 1].y + kLabelPitch);
  int most = area.y + area.height - kAscent;
  for (std::size_t k = labels.size(); k-- > 0; most = labels[k].y - kLabelPitch)
    labels[k].y = std::min(labels[k].y, most);
  for (const EndLabel& label : labels)
    paint.text(area.x + area.width + 8, label.y + kAscent, label.name, plan[label.color], label.voice);
}

}  // namespace

std::vector<double> logarithmicTicks(double least, double most) {
  const auto tick = [](int k) {  // 1 at 0, 3 at 1, 10 at 2
    double power = 1.0;
    const int decades = (k - (k & 1)) / 2;
    for (int d = 0; d < std::abs(decades); ++d) power *= 10.0;
    return (k & 1 ? 3.0 : 1.0) * (decades < 0 ? 1.0 / power : power);
  };
  constexpr int kMost = 40;  // twenty decades either way
  int from = 0, to = 1;
  while (from > -kMost && tick(from) > least * (1 + 1e-9)) --from;
  while (to < kMost && tick(to) < most) ++to;
  std::vector<double> ticks;
  for (int k = from; k <= to; ++k) ticks.push_back(tick(k));
  return ticks;
}

int plotX(const Plot& plot, const Rect& area, int cell) {
  const double share = static_cast<double>(cell - plot.cells.first) / std::max(1, plot.cells.count - 1);
  return area.x + static_cast<int>(std::lround(share * (area.width - 1)));
}

int cellAtX(const CellRange& cells, const Rect& area, int x) {
  const double share = static_cast<double>(x - area.x) / std::max(1, area.width - 1);
  return cells.first +
         std::clamp(static_cast<int>(std::lround(share * (cells.count - 1))), 0, cells.count - 1);
}

int plotY(const Plot& plot, const Rect& area, double value) {
  const double low = plot.ticks.front(), high = plot.ticks.back(), v = std::clamp(value, low, high);
  const double share = plot.logarithmic ? std::log(v / low) / std::log(high / low) : (v - low) / (high - low);
  return area.y + static_cast<int>(std::lround((1.0 - share) * (area.height - 1)));
}

void drawPlot(Painter paint, const CellPlan& plan, const Rect& area, const Plot& plot) {
  const auto cell = [&](Cell c) { return plan[c]; };
  int labelled = area.y + area.height + kTickPitch;
  for (const double tick : plot.ticks) {
    const int y = plotY(plot, area, tick);
    if (y > labelled - kTickPitch) continue;
    labelled = y;
    paint.hline(area.x, y, area.width, cell(Cell::Panel));
    paint.hline(area.x - 5, y, 4, cell(Cell::Faint));
    paint.textRight(area.x - 8, y + kAscent, number(tick), cell(Cell::Soft));
  }
  paint.vline(area.x - 1, area.y, area.height, cell(Cell::Faint));
  paint.hline(area.x - 1, area.y + area.height, area.width + 1, cell(Cell::Faint));
  for (const int tick : cellTicks(plot, area)) {
    const int x = plotX(plot, area, tick);
    const std::string text = std::to_string(tick);
    paint.vline(x, area.y + area.height, 4, cell(Cell::Faint));
    paint.text(x - textWidth(text) / 2, area.y + area.height + 16, text, cell(Cell::Soft));
  }

  std::vector<EndLabel> labels;
  if (plot.level) {
    const int y = plotY(plot, area, *plot.level);
    paint.line(area.x, y, area.x + area.width - 1, y, cell(Cell::Alarm), {1, 4, 3});
    labels.push_back({y, plot.levelName, Cell::Alarm, Voice::Plain});
  }
  for (const bool chosen : {false, true})
    for (const Curve& curve : plot.curves) {
      if (curve.chosen != chosen) continue;
      drawCurve(paint, area, plot, curve, cell(chosen ? Cell::Ink : Cell::Faint));
      if (!curve.name.empty())
        labels.push_back({plotY(plot, area, endOf(curve, plot)), curve.name, chosen ? Cell::Ink : Cell::Soft,
                          chosen ? Voice::Bold : Voice::Plain});
    }
  drawEndLabels(paint, plan, area, labels);
}

void drawStrip(Painter paint, const Rect& area, const std::vector<std::uint8_t>& cells) {
  const Rect all = area * paint.unit();
  Painter fine = paint.pixels();
  for (int i = 0; i < static_cast<int>(cells.size()); ++i)
    fine.fillRect({all.x + i, all.y, 1, all.height}, cells[i]);
}

}  // namespace xnewell
