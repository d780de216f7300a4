#include "x11/views/table_curves.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "shading/color/color_difference.h"
#include "shading/light/illumination.h"
#include "shading/picture/palette_effects.h"

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

}  // namespace xnewell
