#include "shading/color/color_plan.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace xnewell {

namespace {

std::uint32_t keyOf(const std::uint8_t* rgb) {
  return std::uint32_t{rgb[0]} << 16 | std::uint32_t{rgb[1]} << 8 | rgb[2];
}

}  // namespace

std::optional<ColoredImage> inFewColors(const RgbImage& picture) {
  constexpr std::size_t kMost = 256;
  std::vector<std::uint32_t> colors;  // ascending
  for (std::size_t k = 0; k < picture.rgb.size(); k += 3) {
    const std::uint32_t key = keyOf(&picture.rgb[k]);
    const auto place = std::ranges::lower_bound(colors, key);
    if (place != colors.end() && *place == key) continue;
    if (colors.size() == kMost) return std::nullopt;
    colors.insert(place, key);
  }
  ColoredImage cells{IndexImage{picture.width, picture.height, 0}, {}};
  for (std::size_t k = 0; k < cells.image.pixels.size(); ++k)
    cells.image.pixels[k] = static_cast<std::uint8_t>(
        std::ranges::lower_bound(colors, keyOf(&picture.rgb[3 * k])) - colors.begin());
  const auto sixteen = [](std::uint32_t key, int shift) {
    return static_cast<std::uint16_t>(257 * (key >> shift & 255));
  };
  for (std::size_t c = 0; c < colors.size(); ++c)
    cells.palette[c] = {sixteen(colors[c], 16), sixteen(colors[c], 8), sixteen(colors[c], 0)};
  return cells;
}

double stepOf(const HueNeed& need, const TableSettings& table, int N) {
  constexpr double kFinest = 1.0 / 255.0;
  if (isEven(table.kind)) return std::max(kFinest, (need.high - need.low) / (N - 1));
  const double lowest = std::max(table.I0, need.low), highest = std::max(lowest, need.high);
  return std::max(kFinest, ratioOfShades(lowest / highest, N - 1) - 1.0);
}

std::vector<TableSettings> planHues(std::span<const HueNeed> needs, const TableSettings& table) {
  const int hues = static_cast<int>(needs.size());
  assert(hues >= 1 && 2 * hues <= table.shades);
  std::vector<TableSettings> ramps;
  for (const HueNeed& need : needs) {
    TableSettings ramp = table;
    ramp.hue = need.hue, ramp.low = need.low, ramp.high = need.high;
    ramp.shades = 2;
    ramps.push_back(ramp);
  }

  // The amount by which one more shade for a hue would lower that hue's part of the sum.
  std::vector<double> gains(hues);
  const auto gainOf = [&](int k) {
    const int N = ramps[k].shades;
    return static_cast<double>(needs[k].samples) *
           (stepOf(needs[k], table, N) - stepOf(needs[k], table, N + 1));
  };
  for (int k = 0; k < hues; ++k) gains[k] = gainOf(k);
  for (int left = table.shades - 2 * hues; left > 0; --left) {
    const auto most = std::max_element(gains.begin(), gains.end());
    if (*most <= 0.0) break;
    const int k = static_cast<int>(most - gains.begin());
    ++ramps[k].shades;
    gains[k] = gainOf(k);
  }

  int first = table.first.value_or(kTables[static_cast<int>(table.kind)].first);
  for (TableSettings& ramp : ramps) {
    ramp.first = first;
    first += ramp.shades;
  }
  return ramps;
}

}  // namespace xnewell
