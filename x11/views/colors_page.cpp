#include "x11/views/colors_page.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
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

namespace {

constexpr int kGridLabels = 26, kTitle = 24, kGridGutter = 28, kTableWidth = 240;
constexpr int kLabels = 108;    // from the name of a fact to its value
constexpr int kLines = 10;      // of the table in a window, if the options of each fit beside each other
constexpr int kLeastPlot = 60;  // the height of the lower plot at least

int pitchOf(const ColorsLayout& at) { return at.compact ? 16 : 20; }

/// The line of the table's kind.
Control kindLine(TableKind chosen) {
  Control line{.kind = Control::Kind::Choice, .label = "table", .value = static_cast<double>(chosen)};
  for (const TableRow& row : kTables) line.options.emplace_back(row.name);
  return line;
}

/// Draws the parts of the page, one function each.
class ColorsDrawing {
 public:
  ColorsDrawing(Painter paint, const ColorsLayout& at, const ColorsPage& page)
      : pen_{paint, page.plan}, at_{at}, page_{page}, scene_{sceneCells(page.picture)} {}

  void drawGrid();
  void drawFacts();
  void drawStored();
  void drawSteps();
  void drawTable();

 private:
  [[nodiscard]] bool holdsColors() const {
    return channelsOf(page_.picture.colors().plan()) == Channels::Rgb;
  }
  [[nodiscard]] Rect cellRect(int cell) const {
    return {at_.grid.x + cell % 16 * at_.pitch, at_.grid.y + cell / 16 * at_.pitch, at_.pitch, at_.pitch};
  }
  void title(const Rect& plot, std::string_view name, std::string_view unit);
  /// The area that words at that place take, with a margin around them.
  [[nodiscard]] static Rect roomOf(int x, int baseline, std::string_view text) {
    return {x - 2, baseline - 11, textWidth(text) + 4, 14};
  }
  /// How many units of curves the area covers. Those of the chosen curve count more than all others.
  [[nodiscard]] int hidden(const Rect& room) const;
  /// Draws words beside a point of the plot's curve, or beside the line from there down: at the nearest place
  /// where they hide nothing. If there is no such place, where they hide least.
  void remark(int x, int y, std::string_view text);
  void outline(const CellRange& cells);

  Pen pen_;
  const ColorsLayout& at_;
  const ColorsPage& page_;
  CellRange scene_;
};

/// Draws an outline around the cells, which may begin and end within a row.
void ColorsDrawing::outline(const CellRange& cells) {
  for (int cell = cells.first; cell <= cells.last(); ++cell) {
    const Rect r = cellRect(cell);
    const std::uint8_t line = pen_(Cell::Faint);
    if (!cells.has(cell - 16)) pen_.paint.hline(r.x, r.y, r.width + 1, line);
    if (!cells.has(cell + 16)) pen_.paint.hline(r.x, r.y + r.height, r.width + 1, line);
    if (cell % 16 == 0 || !cells.has(cell - 1)) pen_.paint.vline(r.x, r.y, r.height + 1, line);
    if (cell % 16 == 15 || !cells.has(cell + 1)) pen_.paint.vline(r.x + r.width, r.y, r.height + 1, line);
  }
}

void ColorsDrawing::drawGrid() {
  const int top = at_.grid.y - kTitle + 11;
  pen_.caps(at_.grid.x - kGridLabels, top, "CELLS");
  pen_.softRight(at_.grid.x + 16 * at_.pitch, top, "large: used by the picture");
  for (int row = 0; row < 16; ++row)
    pen_.softRight(at_.grid.x - 8, at_.grid.y + row * at_.pitch + at_.pitch / 2 + 5,
                   std::to_string(16 * row));

  const int large = at_.pitch - 2, middle = at_.pitch / 2, small = at_.pitch * 2 / 5;
  for (int cell = 0; cell < 256; ++cell) {
    const Rect r = cellRect(cell);
    const bool used = page_.use.samples[cell] > 0, tools = page_.plan.has(cell);
    const int side = tools ? middle : used ? large : small;
    const Rect mark{r.x + (r.width - side + 1) / 2, r.y + (r.height - side + 1) / 2, side, side};
    if (!tools && !scene_.has(cell)) {  // a free cell
      pen_.paint.hline(mark.x, mark.y + side / 2, side, pen_(Cell::Faint));
      continue;
    }
    pen_.paint.fillRect(mark, static_cast<std::uint8_t>(cell));
    if (tools) pen_.paint.frame(mark, pen_(Cell::Rule));
  }
  if (scene_.count > 0) outline(scene_);
  const std::vector<CellRange> ramps = rampsOf(page_.picture);
  if (ramps.size() > 1) std::ranges::for_each(ramps, [&](const CellRange& ramp) { outline(ramp); });
  const Rect r = cellRect(page_.cell);
  pen_.paint.frame({r.x - 1, r.y - 1, r.width + 2, r.height + 2}, pen_(Cell::Ink));
  pen_.paint.frame(r, pen_(Cell::White));
  if (page_.use.samples[page_.cell] > 0)
    pen_.paint.fillRect({r.x + 1, r.y + 1, r.width - 2, r.height - 2}, static_cast<std::uint8_t>(page_.cell));
}

void ColorsDrawing::drawFacts() {
  const Rect& at = at_.facts;
  pen_.rule(at.x, at.y, at.width);
  pen_.paint.text(at.x, at.y + 32, "cell " + std::to_string(page_.cell), pen_(Cell::Ink), Voice::Title);
  const int aside = pen_.softRight(at.x + at.width, at.y + 32, page_.aside);
  if (page_.asideKey) pen_.key(aside - 22, at.y + 21, std::string_view{&page_.asideKey, 1});
  int y = at.y + (at_.compact ? 52 : 57);
  for (const CellFact& fact : factsOf(page_.cell, page_.picture, page_.palette, page_.plan, page_.use)) {
    pen_.soft(at.x, y, fact.label);
    pen_.ink(at.x + kLabels, y, fact.value);
    y += at_.compact ? 16 : 18;
  }
}

void ColorsDrawing::title(const Rect& plot, std::string_view name, std::string_view unit) {
  const int y = plot.y - 13;
  pen_.caps(plot.x - kPlotLeft, y, name);
  pen_.softRight(plot.x + plot.width + kPlotRight, y, unit);
}

int ColorsDrawing::hidden(const Rect& room) const {
  constexpr int kChosen = 100;
  int sum = 0;
  for (int y = room.y; y < room.y + room.height; ++y)
    for (int x = room.x; x < room.x + room.width; ++x) {
      const std::uint8_t cell = pen_.paint.cellAt(x, y);
      if (cell != pen_(Cell::Paper) && cell != pen_(Cell::Panel))
        sum += cell == pen_(Cell::Ink) ? kChosen : 1;
    }
  return sum;
}

void ColorsDrawing::remark(int x, int y, std::string_view text) {
  const Rect& area = at_.stored;
  Rect best;
  int least = std::numeric_limits<int>::max();
  for (int away = 8; away < area.height; away += 2)
    for (const int baseline : {y - away, y + away + 8})
      for (const int at : {x - textWidth(text) - 6, x + 8}) {
        const Rect room = roomOf(at, baseline, text);
        if (intersection(room, area) != room) continue;
        if (const int hides = hidden(room); hides < least) least = hides, best = room;
      }
  pen_.paint.fillRect(best, pen_(Cell::Paper));
  pen_.ink(best.x + 2, best.y + 11, text);
}

void ColorsDrawing::drawStored() {
  const Rect& area = at_.stored;
  title(area, holdsColors() ? "luminance" : "stored value", "of 255, for each cell");
  const Plot plot = storedPlot(page_.picture, page_.palette);
  drawPlot(pen_.paint, page_.plan, area, plot);
  if (!at_.compact && hidden(roomOf(area.x + 12, area.y + 14, page_.hint)) == 0)
    pen_.soft(area.x + 12, area.y + 14, page_.hint);
  for (const Curve& curve : plot.curves) {
    const int k = page_.cell - curve.first;
    if (!curve.chosen || k < 0 || k >= static_cast<int>(curve.y.size())) continue;
    const int x = plotX(plot, area, page_.cell), y = plotY(plot, area, curve.y[k]);
    remark(x, y, std::to_string(page_.cell) + ": " + fixed(curve.y[k], 1));
    pen_.paint.vline(x, y, area.y + area.height - y, pen_(Cell::Ink));
    pen_.paint.disc(x, y, 4, pen_(Cell::Ink));
    pen_.paint.disc(x, y, 3, static_cast<std::uint8_t>(page_.cell));
    break;
  }
}

void ColorsDrawing::drawSteps() {
  const Rect& area = at_.steps;
  Plot plot{.cells = scene_,
            .ticks = {},
            .logarithmic = true,
            .curves = page_.steps,
            .level = kSeenStep,
            .levelName = "the eye"};
  double most = 30.0, least = 0.3;
  for (const Curve& curve : plot.curves)
    for (const double y : curve.y)
      if (y > 0.0) most = std::max(most, y), least = std::min(least, y);
  plot.ticks = logarithmicTicks(std::max(least, 0.03), std::min(most, 3e4));
  if (holdsColors())
    title(area, "to the nearest colour", "CIEDE2000, log scale");
  else
    title(area, "step to the next shade",
          page_.gamma == 1.0 ? "per cent brighter, log scale"
                             : "per cent, on a screen of gamma " + fixed(page_.gamma, 1));
  drawPlot(pen_.paint, page_.plan, area, plot);
}

void ColorsDrawing::drawTable() {
  const Rect& at = at_.table;
  pen_.rule(at.x, at.y, at_.picture.x + at_.picture.width - at.x);
  pen_.caps(at.x, at.y + 16, "TABLE");
  const RowStyle style = tableStyle(at_, false);
  int y = firstTableLine(at_);
  for (const Control& line : page_.lines) {
    const ControlPlace place = placeInRow(line, at.x, y, style);
    drawControl(pen_, line, place, {});
    y += place.area.height;
  }
}

}  // namespace

ColorsLayout layoutOfColors(const Rect& body) {
  ColorsLayout at;
  at.compact = body.height < kCompactBelow;
  const int factsHeight = at.compact ? 158 : 178, gap = at.compact ? 8 : 20;
  const int columns = (body.width + 16) * 5 / 12 - 16;
  at.pitch = std::min((columns - kGridLabels) / 16, (body.height - kTitle - factsHeight - gap) / 16);
  at.grid = {body.x + kGridLabels, body.y + kTitle, 16 * at.pitch, 16 * at.pitch};
  const int left = std::max(300, kGridLabels + 16 * at.pitch + 1);
  at.facts = {body.x, at.grid.y + at.grid.height + gap, left, factsHeight};

  const int x = body.x + left + kGridGutter, width = body.x + body.width - x;
  const int kinds = placeInRow(kindLine({}), 0, 0, tableStyle(at, true)).area.height;
  const int lines = pitchOf(at) * (kLines - 1) + kinds + (at.compact ? 24 : 28);
  const int bottom = std::max(lines, body.height * 36 / 100);
  const int between = kPlotBelow + (at.compact ? 28 : 30);
  const int plots = body.height - bottom - 12 - kTitle - between - kPlotBelow;
  const int upper = std::min(plots * 56 / 100, plots - kLeastPlot);
  at.stored = {x + kPlotLeft, body.y + kTitle, width - kPlotLeft - kPlotRight, upper};
  at.steps = {at.stored.x, at.stored.y + upper + between, at.stored.width, plots - upper};
  at.table = {x, body.y + body.height - bottom, kTableWidth, bottom};
  at.picture = {x + kTableWidth + 12, at.table.y + 8, width - kTableWidth - 12, bottom - 8};
  return at;
}

RowStyle tableStyle(const ColorsLayout& at, bool keys) {
  const int label = keys ? 24 : 0, value = label + 60;
  return {.width = kTableWidth - 24 + label,
          .pitch = pitchOf(at),
          .label = label,
          .value = value,
          .track = 96,
          .beyond = 2,
          .wordsAtValue = true};
}

int firstTableLine(const ColorsLayout& at) { return at.table.y + (at.compact ? 35 : 37); }

std::optional<int> cellInGrid(const ColorsLayout& at, int x, int y) {
  const int column = x - at.grid.x, row = y - at.grid.y;
  if (column < 0 || row < 0 || column >= at.grid.width || row >= at.grid.height) return std::nullopt;
  return row / at.pitch * 16 + column / at.pitch;
}

std::vector<Curve> stepsSeen(const Picture& picture, const Palette& plain, const CellPlan& plan,
                             PaletteEffects effects) {
  effects.gamma = 1;
  return stepCurves(picture, withEffects(plain, picture, plan, effects));
}

Plot storedPlot(const Picture& picture, const Palette& palette) {
  return {.cells = sceneCells(picture),
          .ticks = {0, 64, 128, 192, 255},
          .curves = storedCurves(picture, palette)};
}

std::vector<Control> tableLines(const Picture& picture, const PaletteEffects& effects) {
  const TableSettings& table = picture.settings().table;
  const bool colors = channelsOf(picture.colors().plan()) == Channels::Rgb;
  const std::string turned = effects.hueTurn != 0.0 ? " + " + fixed(effects.hueTurn, 0) + "\u00B0" : "";
  std::vector<Control> lines;
  const auto choice = [&](std::string label, double chosen, std::vector<std::string> options) {
    lines.push_back({.kind = Control::Kind::Choice,
                     .label = std::move(label),
                     .value = chosen,
                     .options = std::move(options)});
  };
  const auto fact = [&](std::string label, std::string words) {
    lines.push_back({.kind = Control::Kind::Own, .label = std::move(label), .words = std::move(words)});
  };
  if (colors) {
    choice("colours", picture.colors().plan() == ColorPlan::Cube, {"chosen", "cube"});
    fact("cells", std::to_string(sceneCells(picture).count));
    if (!turned.empty()) fact("hue", turned);
    choice("dither", picture.settings().dither, {"off", "on"});
  } else {
    lines.push_back(kindLine(table.kind));
    const bool corrected = table.kind == TableKind::Corrected;
    const std::string I0 = corrected ? ", I0 " + fixed(table.I0, table.I0 < 0.001 ? 6 : 3) : "";
    const std::string shades = shadesText(picture);
    fact("shades", shades.substr(0, shades.find(" shades")) + I0);
    if (corrected) choice("nearest", table.pick == Pick::Search, {"in ratio", "difference"});
    const std::size_t ramps = picture.colors().tables().size();
    const glm::dvec3& h = table.hue;
    const std::string hue = ramps > 1 ? std::to_string(ramps) + ", a ramp each"
                                      : fixed(h.r, 2) + ", " + fixed(h.g, 2) + ", " + fixed(h.b, 2);
    fact(ramps > 1 ? "hues" : "hue", hue + turned);
    choice("stored", table.bits == 16, {"8 bits", "16 bits"});
  }
  if (effects.stored) fact("colours", "of " + std::string{kTables[int(*effects.stored)].name});
  if (effects.gamma != 1.0) fact("gamma", fixed(effects.gamma, 2));
  if (effects.bend) fact("bent", std::to_string(effects.bend->cell) + " to " + fixed(effects.bend->value, 1));
  if (effects.rotate != 0) fact("rotated", std::to_string(effects.rotate));
  return lines;
}

std::string levelsText(const Picture& picture, const Palette& stored, const std::vector<Curve>& curves) {
  const SceneColors& colors = picture.colors();
  int steps = 0, seen = 0;
  for (const Curve& curve : curves)
    for (const double y : curve.y)
      if (curve.chosen && !std::isnan(y)) ++steps, seen += y >= kSeenStep;
  const std::string told = "   the eye sees " + std::to_string(seen) + " of " + std::to_string(steps);
  if (channelsOf(colors.plan()) == Channels::Rgb)
    return (colors.plan() == ColorPlan::Cube
                ? "6 x 8 x 5 = 240 colours, whatever the picture"
                : counted(sceneCells(picture).count, "colour") + " chosen from the picture") +
           told + " apart from all others";
  int shades = 0, distinct = 0, eight = 0;
  for (const ColorTable& table : colors.tables()) {
    const CellRange ramp{table.first(), table.shades()};
    shades += ramp.count;
    distinct += distinctColors(stored, ramp, 16);
    eight += distinctColors(stored, ramp, 8);
  }
  std::string text;
  if (colors.tables().size() == 1 && picture.settings().table.kind == TableKind::Corrected)
    text = "r = " + fixed(ratioOf(colors.table()), 8) + "   ";
  return text + std::to_string(distinct) + " of " + std::to_string(shades) + " stored levels distinct, " +
         std::to_string(eight) + " at 8 bits" + told + " steps";
}

void drawColorsPage(Painter paint, const ColorsLayout& at, const ColorsPage& page) {
  paint.fit(page.picture.image(), at.picture);
  ColorsDrawing draws{paint, at, page};
  draws.drawGrid();
  draws.drawFacts();
  draws.drawStored();
  draws.drawSteps();
  draws.drawTable();
}

namespace {

constexpr int kStripHeight = 60, kFoot = 28;

Rect stripOf(const ViewSettings& settings) {
  return {0, settings.picture.height - kFoot - kStripHeight, settings.picture.width, kStripHeight};
}

ColorsLayout layoutOf(const ViewSettings& settings) {
  return layoutOfColors({Sheet::kMargin, Sheet::kMargin, settings.picture.width - 2 * Sheet::kMargin,
                         stripOf(settings).y - 12 - Sheet::kMargin});
}

}  // namespace

PictureSettings pictureForColors(const ViewSettings& settings) {
  const Rect at = layoutOf(settings).picture;
  PictureSettings shown = settings.picture;
  shown.width = at.width, shown.height = at.height;
  return shown;
}

ColoredImage drawColors(const Picture& picture, const ViewSettings& settings) {
  const int W = settings.picture.width, H = settings.picture.height;
  const Rect strip = stripOf(settings);
  const ColorsLayout at = layoutOf(settings);
  const CellUse use = cellUse(picture.image(), picture.faceImage());
  const CellRange scene = sceneCells(picture);
  const int cell = settings.cell.value_or(settings.effects.lit.value_or(medianCell(use, scene)));

  // Words and curves describe what is stored, except for the light, which only shows where the cell is.
  PaletteEffects effects = settings.effects;
  effects.lit.reset();
  const CellPlan& plan = settings.cells;
  Palette plain = picture.palette(plan, settings.unneeded);
  if (settings.gray) plain = forGrayScreen(plain, picture);
  const Palette stored = withEffects(plain, picture, plan, effects);
  const Palette palette = withEffects(stored, picture, plan, {.lit = settings.effects.lit});
  const std::vector<Curve> steps = stepsSeen(picture, plain, plan, effects);
  IndexImage page{W, H, plan[Cell::Paper]};
  drawColorsPage(page, at,
                 {.picture = picture,
                  .palette = stored,
                  .steps = steps,
                  .plan = plan,
                  .use = use,
                  .cell = cell,
                  .aside = settings.effects.lit == cell ? "light it up everywhere" : "",
                  .lines = tableLines(picture, effects),
                  .gamma = effects.gamma,
                  .hint = ""});
  Painter paint{page};
  paint.hline(0, strip.y, W, plan[Cell::Rule]);
  drawColorStrip(paint, strip, plan, use, wordsOf(picture, effects), W < 1024, cell);
  const int foot = H - kFoot;
  paint.fillRect({0, foot, W, kFoot}, plan[Cell::Panel]);
  paint.hline(0, foot, W, plan[Cell::Rule]);
  const int end = paint.text(Sheet::kMargin, foot + 18, levelsText(picture, stored, steps), plan[Cell::Ink]);
  const std::string title = titleOf(picture.scene());
  if (end + 18 + textWidth(title) <= W - Sheet::kMargin)
    paint.textRight(W - Sheet::kMargin, foot + 18, title, plan[Cell::Soft]);
  return {page, palette};
}

}  // namespace xnewell
