#include "x11/views/cell_facts.h"

#include <algorithm>
#include <cmath>

#include "x11/drawing/wording.h"
#include "x11/views/plot.h"

namespace xnewell {

namespace {

std::string triple(int r, int g, int b) {
  return "(" + std::to_string(r) + ", " + std::to_string(g) + ", " + std::to_string(b) + ")";
}

std::string hex(int v) {
  std::string digits;
  for (int shift = 12; shift >= 0; shift -= 4) digits += "0123456789ABCDEF"[v >> shift & 15];
  return "0x" + digits;
}

/// In hexadecimal too if only one channel is not 0.
std::string storedText(const Rgb16& c) {
  std::string text = triple(c.r, c.g, c.b) + " of 65535";
  const int others = (c.r > 0) + (c.g > 0) + (c.b > 0);
  if (others == 1) text += ", " + hex(std::max({c.r, c.g, c.b}));
  return text;
}

std::string intensityText(const ColorTable& table, int j) {
  const TableSettings& s = table.settings();
  const std::string k = std::to_string(j), I = fixed(table.intensity(j), 4);
  if (s.kind == TableKind::Corrected && table.level(0) == s.I0 && s.high == 1.0)
    return "I_" + k + " = r^" + k + " I0 = " + I;
  if (s.kind != TableKind::Corrected && s.low == 0.0 && s.high == 1.0)
    return "I_" + k + " = " + k + "/" + std::to_string(s.shades - 1) + " = " + I;
  return "I_" + k + " = " + I + ", shade " + k + " of 0.." + std::to_string(s.shades - 1);
}

std::string stepText(const Palette& palette, const CellRange& ramp, int cell) {
  if (cell == ramp.last()) return "none: the last shade";
  const auto value = [&](int at) {
    const Rgb16& c = palette[at];
    return std::max({c.r, c.g, c.b});
  };
  const double now = value(cell), next = value(cell + 1);
  if (next == now) return "none: the next is the same";
  if (now == 0.0) return "from black";
  return fixed(100.0 * std::abs(next / now - 1.0), 2) + " % " + (next > now ? "brighter" : "darker");
}

std::string usedText(const CellUse& use, int cell) {
  if (use.samples[cell] == 0) return "no sample";
  return counted(use.samples[cell], "sample") + ", " + counted(use.polygons[cell], "polygon");
}

/// Colour k of the cube, in the order of cubeColors().
std::string cubeText(int k) {
  return "red " + std::to_string(k / 40) + "/5, green " + std::to_string(k / 5 % 8) + "/7, blue " +
         std::to_string(k % 5) + "/4";
}

}  // namespace

std::string pickedText(const ColorTable& table, int j, int least) {
  const ColorTable::Picked picked = table.picked(j);
  const double from = picked.from, to = picked.to;
  if (from >= to) return "no I";
  constexpr int kMostDecimals = 12;
  int decimals = 4;
  double unit = 1e-4;
  for (; (to - from < 10.0 * unit || decimals < least) && decimals <= kMostDecimals; ++decimals) unit /= 10.0;
  const auto up = [&](double I) {
    return decimals <= kMostDecimals ? fixed(std::ceil(I / unit) * unit, decimals) : significant(I, 17);
  };
  return (j > 0 ? up(from) + " <= " : "") + "I" + (picked.last ? "" : " < " + up(to));
}

std::string shadesText(const Picture& picture) {
  const std::vector<ColorTable>& tables = picture.colors().tables();
  if (channelsOf(picture.colors().plan()) == Channels::Rgb || tables.size() < 2)
    return std::to_string(picture.settings().table.shades) + " shades";
  const auto [least, most] = std::ranges::minmax(tables, {}, &ColorTable::shades);
  return (least.shades() < most.shades() ? std::to_string(least.shades()) + " to " : "") +
         std::to_string(most.shades()) + " shades for each of " + std::to_string(tables.size()) + " hues";
}

std::string holdsText(const ColorTable& table) {
  const TableSettings& s = table.settings();
  const int first = table.first(), lowest = s.kind == TableKind::Linear ? 1 : 0;
  const std::string shade = "cell " + std::to_string(first) + " + j holds ";
  if (!isEven(s.kind)) return shade + "I0 r^j of the hue";
  if (s.low == 0.0 && s.high == 1.0 && s.shades == kMaxShades)
    return "cell i holds (i - " + std::to_string(first - lowest) + ")/255 of the hue";
  return shade + "(" + significant(lowest + 239 * s.low, 6) + " + " + significant(239 * (s.high - s.low), 6) +
         " j/" + std::to_string(s.shades - 1) + ")/255 of the hue";
}

std::vector<CellFact> factsOf(int cell, const Picture& picture, const Palette& palette, const CellPlan& plan,
                              const CellUse& use) {
  const Rgb16& c = palette[cell];
  std::vector<CellFact> facts{{"stored RGB", storedText(c)},
                              {"8 bits", triple(c.r >> 8, c.g >> 8, c.b >> 8) + " of 255"}};
  const SceneColors& colors = picture.colors();
  const CellRange scene = sceneCells(picture);
  for (int role = 0; role < kCells; ++role)
    if (plan[static_cast<Cell>(role)] == cell) {
      facts.insert(facts.begin(), {"holds", "the tool's own: " + std::string{kCellNames[role]}});
      if (use.samples[cell] > 0) facts.push_back({"background of", counted(use.samples[cell], "sample")});
      return facts;
    }
  if (channelsOf(colors.plan()) != Channels::Rgb) {
    for (const ColorTable& table : colors.tables()) {
      const CellRange ramp{table.first(), table.shades()};
      if (!ramp.has(cell)) continue;
      facts.push_back({"intensity", intensityText(table, cell - ramp.first)});
      facts.push_back({"shown when", pickedText(table, cell - ramp.first)});
      facts.push_back({"used by", usedText(use, cell)});
      facts.push_back({"step to next", stepText(palette, ramp, cell)});
      return facts;
    }
  } else if (scene.has(cell)) {
    const int k = cell - scene.first;
    const bool cube = colors.plan() == ColorPlan::Cube;
    facts.push_back({"colour", cube ? cubeText(k)
                                    : std::to_string(k + 1) + " of " + std::to_string(scene.count) +
                                          " chosen from the picture"});
    facts.push_back(
        {"shown when", picture.settings().dither ? "it is near, by dithering" : "it is the nearest"});
    facts.push_back({"used by", usedText(use, cell)});
    const double step = nearestOther(palette, scene, cell);
    facts.push_back({"nearest", std::isnan(step) ? "no other" : fixed(step, 2) + " CIEDE2000 away"});
    return facts;
  }
  facts.insert(facts.begin(), {"holds", "nothing of ours: a free cell"});
  return facts;
}

}  // namespace xnewell
