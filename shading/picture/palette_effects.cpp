#include "shading/picture/palette_effects.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/exact/scale.h"

namespace xnewell {

namespace {

constexpr double kFull = 65535.0;

std::uint16_t stored(double v) {
  return static_cast<std::uint16_t>(std::floor(kFull * std::clamp(v, 0.0, 1.0) + 0.5));
}
Rgb16 inEightBits(const Rgb16& c) {
  const auto rounded = [](std::uint16_t v) { return static_cast<std::uint16_t>((v + 128) / 257 * 257); };
  return {rounded(c.r), rounded(c.g), rounded(c.b)};
}
int largest(const Rgb16& c) { return std::max({c.r, c.g, c.b}); }

/// v^e for v in [0, 1], e >= 0. The whole part of e is done by squaring, the binary digits after the point by
/// square roots. It uses only products and square roots, so the result is the same on every machine.
double realPower(double v, double e) {
  const double whole = std::floor(e);
  double result = power(v, static_cast<int>(whole)), root = v, rest = e - whole;
  while (rest > 0.0) {
    root = std::sqrt(root);
    rest *= 2.0;
    if (rest < 1.0) continue;
    result *= root;
    rest -= 1.0;
  }
  return result;
}

std::string range(const CellRange& cells) {
  return std::to_string(cells.first) + " to " + std::to_string(cells.last());
}

void requireRamps(const std::vector<CellRange>& ramps, const char* what) {
  if (ramps.empty())
    throw ViewError{std::string{what} + " needs a ramp: the cells of this picture hold single colours"};
}

}  // namespace

Rgb16 hueTurned(Rgb16 color, double degrees) {
  const int high = largest(color), low = std::min({color.r, color.g, color.b});
  if (high == low) return color;
  // The hexagon of hues: the largest channel gives a pair of sides, the middle channel the position on them.
  const double spread = high - low;
  double side = high == color.r   ? (color.g - color.b) / spread
                : high == color.g ? 2.0 + (color.b - color.r) / spread
                                  : 4.0 + (color.r - color.g) / spread;
  side += degrees / 60.0;
  const auto channel = [&](double from) {
    double at = side + from;
    at -= 6.0 * std::floor(at / 6.0);
    const double share = std::clamp(std::min(at, 4.0 - at), 0.0, 1.0);
    return static_cast<std::uint16_t>(std::floor(high - spread * share + 0.5));
  };
  return {channel(5.0), channel(3.0), channel(1.0)};
}

Rgb16 gammaCorrected(Rgb16 color, double gamma) {
  const auto corrected = [&](std::uint16_t v) { return stored(realPower(v / kFull, 1.0 / gamma)); };
  return {corrected(color.r), corrected(color.g), corrected(color.b)};
}

void rotate(Palette& palette, const CellRange& ramp, int steps) {
  const int n = ramp.count, up = ((steps % n) + n) % n;
  const auto begin = palette.begin() + ramp.first;
  std::rotate(begin, begin + (n - up), begin + n);
}

void bend(Palette& palette, const CellRange& ramp, const CurvePoint& point) {
  const auto valueAt = [&](int cell) { return largest(palette[cell]) / kFull; };
  const Rgb16 brightest = palette[ramp.last()];
  const double end = valueAt(ramp.last()), old = valueAt(point.cell);
  const double now = std::min(stored(point.value / 255.0) / kFull, end);
  if (now == old || end == 0.0) return;
  for (int cell = ramp.first; cell <= ramp.last(); ++cell) {
    const double v = valueAt(cell);
    double bent = v;
    if (cell == point.cell)
      bent = now;
    else if (cell < point.cell)
      bent = old > 0.0 ? v * now / old : now;
    else if (end > old)
      bent = now + (v - old) / (end - old) * (end - now);
    const double scale = bent / largest(brightest);
    palette[cell] = {stored(scale * brightest.r), stored(scale * brightest.g), stored(scale * brightest.b)};
  }
}

Palette forGrayScreen(Palette palette, const Picture& picture) {
  const bool oneHue = picture.colors().plan() == ColorPlan::OneHue;
  const CellRange scene = sceneCells(picture);
  for (int cell = scene.first; cell <= scene.last(); ++cell) {
    const Rgb16 c = palette[cell];
    const auto intensity = static_cast<std::uint16_t>(largest(c));
    palette[cell] = oneHue ? Rgb16{intensity, intensity, intensity} : grayOf(c);
  }
  return palette;
}

ColorTable inTable(const ColorTable& table, TableKind kind) {
  TableSettings settings = table.settings();
  const auto first = [](TableKind k) { return kTables[static_cast<int>(k)].first; };
  settings.first = table.first() + first(kind) - first(settings.kind);
  settings.kind = kind;
  return ColorTable{settings};
}

Palette withEffects(Palette palette, const Picture& picture, const CellPlan& plan,
                    const PaletteEffects& effects) {
  const CellRange scene = sceneCells(picture);
  const std::vector<CellRange> ramps = rampsOf(picture);

  // This acts like XStoreColors: cells that the other table does not fill keep their colours.
  if (effects.stored) {
    requireRamps(ramps, "storing another table");
    for (const ColorTable& table : picture.colors().tables()) {
      const ColorTable other = inTable(table, *effects.stored);
      for (int j = 0; j < other.shades(); ++j) palette[other.first() + j] = other.color(j);
    }
    palette = withInterface(palette, plan);
  }
  for (int cell = scene.first; cell <= scene.last(); ++cell) {
    if (effects.hueTurn != 0.0) palette[cell] = hueTurned(palette[cell], effects.hueTurn);
    if (effects.gamma != 1.0) palette[cell] = gammaCorrected(palette[cell], effects.gamma);
  }
  if (effects.bend) {
    requireRamps(ramps, "bending the curve");
    const auto ramp =
        std::ranges::find_if(ramps, [&](const CellRange& r) { return r.has(effects.bend->cell); });
    if (ramp == ramps.end())
      throw ViewError{"cell " + std::to_string(effects.bend->cell) + " is in no ramp: choose one of " +
                      range(scene)};
    bend(palette, *ramp, *effects.bend);
  }
  if (picture.settings().table.bits == 8 && effects != PaletteEffects{})
    for (int cell = scene.first; cell <= scene.last(); ++cell) palette[cell] = inEightBits(palette[cell]);
  if (effects.rotate != 0) {
    requireRamps(ramps, "rotating");
    for (const CellRange& ramp : ramps) rotate(palette, ramp, effects.rotate);
  }
  if (effects.lit) {
    if (!scene.has(*effects.lit))
      throw ViewError{"cell " + std::to_string(*effects.lit) + " is not one of the scene's: choose one of " +
                      range(scene)};
    palette[*effects.lit] = kLit;
  }
  return palette;
}

}  // namespace xnewell
