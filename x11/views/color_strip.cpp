#include "x11/views/color_strip.h"

#include <algorithm>
#include <cmath>

#include "x11/views/cell_facts.h"

namespace xnewell {

namespace {

constexpr int kBars = 23, kHeight = 17;  // of the bars and the space above them; of a cell

/// Cell i stands at x0 + i * width.
struct StripPlaces {
  int x0, width;
  explicit StripPlaces(const Rect& at) : x0{0}, width{at.width / 256} {
    x0 = at.x + (at.width - 256 * width) / 2;
  }
};

}  // namespace

SceneCellWords wordsOf(const Picture& picture, const PaletteEffects& effects) {
  const SceneColors& scene = picture.colors();
  const TableRow& row = kTables[static_cast<int>(picture.settings().table.kind)];
  const std::string table{row.name};
  SceneCellWords words{.cells = sceneCells(picture), .rule = "", .shortRule = table + " table"};
  words.rule = picture.settings().table.shades == kMaxShades ? table + ": " + holdsText(scene.table())
                                                             : words.shortRule;
  if (scene.plan() == ColorPlan::Hues) {
    const std::string hues = std::to_string(scene.tables().size()) + " hues";
    words.shortRule = hues + ", " + words.shortRule;
    words.rule = hues + ", each with a ramp of the " + table + " table";
  }
  if (effects.stored)
    words.rule = "indices of " + table + ", colours of " +
                 std::string{kTables[static_cast<int>(*effects.stored)].name};
  PaletteEffects others = effects;
  others.stored.reset(), others.lit.reset();
  if (others != PaletteEffects{}) words.rule = (effects.stored ? words.rule : table) + ", changed";
  if (channelsOf(scene.plan()) != Channels::Rgb) return words;
  const bool cube = scene.plan() == ColorPlan::Cube;
  words.what = "colours";
  words.shortRule = cube ? "colour cube" : "chosen colours";
  words.rule = cube ? "6 reds x 8 greens x 5 blues" : "colours chosen from the picture";
  return words;
}

std::optional<int> cellInStrip(const Rect& at, int x, int y) {
  const StripPlaces places{at};
  if (places.width == 0) return std::nullopt;  // a small window has no strip
  const int cell = x < places.x0 ? -1 : (x - places.x0) / places.width;
  if (cell < 0 || cell > 255 || y < at.y || y >= at.y + kBars + 1 + kHeight) return std::nullopt;
  return cell;
}

void drawColorStrip(Painter paint, const Rect& at, const CellPlan& plan, const CellUse& use,
                    const SceneCellWords& words, bool compact, std::optional<int> inspected) {
  const auto [x0, cell] = StripPlaces{at};
  const std::uint8_t ink = plan[Cell::Ink], soft = plan[Cell::Soft];
  const int barsBottom = at.y + kBars, stripTop = barsBottom + 1, stripBottom = stripTop + kHeight;
  const int most = std::max(2, *std::ranges::max_element(use.samples));
  for (int i = 0; i < 256; ++i) {
    if (words.cells.has(i) || plan.has(i))
      paint.fillRect({x0 + i * cell, stripTop, cell, kHeight}, static_cast<std::uint8_t>(i));
    else
      paint.hline(x0 + i * cell, stripTop + kHeight / 2, cell, plan[Cell::Faint]);
    if (use.samples[i] == 0) continue;
    const int height = 1 + static_cast<int>(17 * std::log(use.samples[i]) / std::log(most));
    paint.fillRect({x0 + i * cell, barsBottom - height, std::max(1, cell - 1), height}, ink);
  }
  const int first = words.cells.first, last = words.cells.last();
  for (const int edge : {x0 + first * cell, x0 + (last + 1) * cell - 1})
    paint.vline(edge, stripTop - 3, 22, ink);
  if (inspected) {
    const Rect mark{x0 + *inspected * cell - 2, stripTop - 2, cell + 4, kHeight + 4};
    paint.fillRect(mark, plan[Cell::White]);
    paint.frame(mark, ink);
    paint.fillRect({mark.x + 2, mark.y + 2, cell, kHeight}, static_cast<std::uint8_t>(*inspected));
  }

  const int y = stripBottom + 13;
  if (!compact) paint.text(x0 + 4, y, "0.." + std::to_string(first - 1), plan[Cell::Faint]);
  // The numbers of the scene's first and last cell at the ends of the ramp, or as one range if it is too
  // short for both.
  const int rampLeft = x0 + first * cell + 4, rampRight = x0 + (last + 1) * cell - 4;
  int left = rampLeft + 56;
  if (rampRight - rampLeft >= 60) {
    paint.text(rampLeft, y, std::to_string(first), soft);
    paint.textRight(rampRight, y, std::to_string(last), soft);
  } else {
    left = std::max(left,
                    paint.text(rampLeft, y, std::to_string(first) + ".." + std::to_string(last), soft) + 18);
  }
  const std::string& rule = compact ? words.shortRule : words.rule;
  std::string uses = std::to_string(usedCells(use, words.cells)) + " of " +
                     std::to_string(words.cells.count) + " " + words.what + " used";
  if (!compact) uses += " by the picture";
  const int centre = x0 + 146 * cell - textWidth(uses) / 2;
  if (rampRight > left - 18 && rampRight < left + textWidth(rule) + 42) left = rampRight + 18;
  paint.text(left, y, rule, soft);
  int begin = std::max(centre, left + textWidth(rule) + 18);
  if (begin < rampRight + 18 && begin + textWidth(uses) > rampRight - 36) begin = rampRight + 18;
  paint.text(begin, y, uses, soft);
}

}  // namespace xnewell
