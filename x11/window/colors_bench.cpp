#include "x11/window/colors_bench.h"

#include <algorithm>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

/// A line of the table, and the key that changes its setting.
struct LineKey {
  std::string_view label;
  char key;
};
constexpr std::array kLineKeys{LineKey{"table", 'T'}, LineKey{"shades", 'c'}, LineKey{"nearest", 'j'},
                               LineKey{"hue", 'H'}, LineKey{"stored", 'B'}};

}  // namespace

bool ColorsBench::hasRamp(const char* what) {
  if (!ramps_) host_.notify(std::string{what} + " needs a ramp, and these cells hold single colours.");
  return ramps_;
}

void ColorsBench::inspect(int cell) {
  cell_ = std::clamp(cell, 0, 255);
  if (effects_.lit) effects_.lit = scene_.has(*cell_) ? cell_ : std::nullopt;
}

bool ColorsBench::press(const Key& key, const Setup& setup) {
  const int times = key.shift ? 10 : 1;
  if (focus_ != 0 && pressOnSlider(key, times)) return true;
  switch (key.name) {
    case NamedKey::Left:
      return inspect(cell() - times), true;
    case NamedKey::Right:
      return inspect(cell() + times), true;
    case NamedKey::Up:
      return cell() >= 16 ? inspect(cell() - 16) : void(), true;
    case NamedKey::Down:
      return cell() < 240 ? inspect(cell() + 16) : void(), true;
    case NamedKey::Home:
      return inspect(scene_.first), true;
    case NamedKey::End:
      return inspect(scene_.last()), true;
    case NamedKey::Escape:
      return undo(), true;
    case NamedKey::Tab:
      return true;
    default:
      break;
  }
  switch (key.letter) {
    case 'h':
      if (scene_.has(cell()))
        effects_.lit = cell();
      else
        host_.notify("Cell " + std::to_string(cell()) +
                     " does not belong to the scene: there is nothing to light up.");
      return true;
    case 'm':
      if (!hasRamp("Moving")) return true;
      moving_ = !moving_;
      effects_.rotate = 0;
      return true;
    case 'g': {
      const auto* const now = std::ranges::find(kGammas, effects_.gamma);
      effects_.gamma = now == kGammas.end() || now + 1 == kGammas.end() ? kGammas[0] : now[1];
      return true;
    }
    case 'i':
      if (!hasRamp("Holding indices")) return true;
      held_ = holds(setup) ? std::nullopt : std::optional{setup.picture.table};
      return true;
    case 'j':
      return host_.pressLetter('J'), true;
    case 'r':  // the host resets the settings; this view resets its own state
      undo();
      return false;
    case '0':
      if (const SliderRow& I0 = *sliderOf('0'); !I0.enabled(setup)) return host_.notify(I0.whenOff()), true;
      [[fallthrough]];
    case 'c':
      focus_ = std::ranges::find(lines_, key.letter, &TableLine::key) == lines_.end() ? '\0' : key.letter;
      return true;
    default:
      return false;
  }
}

/// Handles a key while a slider has the focus: the arrows change it. Esc, Tab or the pointer gives the arrows
/// back to the cells.
bool ColorsBench::pressOnSlider(const Key& key, int times) {
  const SliderRow& row = *sliderOf(focus_);
  const auto change = [&](const std::function<void(Setup&)>& edit) { host_.change(focus_, edit); };
  switch (key.name) {
    case NamedKey::Left:
    case NamedKey::Down:
      return change([&](Setup& s) { step(s, row, -times); }), true;
    case NamedKey::Right:
    case NamedKey::Up:
      return change([&](Setup& s) { step(s, row, times); }), true;
    case NamedKey::Home:
      return change([&](Setup& s) { row.set(s, row.low); }), true;
    case NamedKey::End:
      return change([&](Setup& s) { row.set(s, row.high); }), true;
    case NamedKey::Tab:
    case NamedKey::Escape:
      focus_ = 0;
      return true;
    default:
      return false;
  }
}

void ColorsBench::release(char letter) {
  if (letter == 'h') effects_.lit.reset();
}

void ColorsBench::undo() {
  effects_ = {};
  moving_ = grabbed_ = false;
  held_.reset();
  focus_ = 0;
}

void ColorsBench::leave() {
  effects_.lit.reset();
  if (effects_ != PaletteEffects{} || moving_ || held_)
    host_.tell("Gamma, curve, ramp and indices are restored: only view 3 changes them.");
  undo();
}

void ColorsBench::hover(int x, int y) {
  if (const std::optional<int> cell = cellInGrid(at_, x, y)) return inspect(*cell);
  if (const std::optional<int> cell = cellInStrip(strip_, x, y)) return inspect(*cell);
  for (const Rect& plot : {at_.stored, at_.steps})
    if (plot.has(x, y) && scene_.count > 0) return inspect(cellAtX(scene_, plot, x));
}

bool ColorsBench::grab(int x, int y) {
  hover(x, y);
  if (const std::optional<TableLineHit> hit = lineAt(at_, lines_, x, y)) return grabLine(*hit);
  focus_ = 0;
  if (!at_.stored.has(x, y) || scene_.count == 0) return false;
  if (!hasRamp("Dragging the curve")) return false;
  inspect(cellAtX(scene_, at_.stored, x));
  grabbedY_ = y;
  return grabbed_ = true;
}

/// Handles a click on a line of the table. On a choice's name it takes the next option; on an option it takes
/// that one. It presses the choice's key as often as needed.
bool ColorsBench::grabLine(const TableLineHit& hit) {
  const TableLine line = lines_[hit.line];
  if (line.share) {
    focus_ = dragged_ = line.key;
    if (hit.share) setSlider(*hit.share);
    return hit.share.has_value();
  }
  if (line.key == 'H') host_.pressLetter('H');  // a value without options: its key changes it
  if (line.options.empty()) return false;
  const int options = static_cast<int>(line.options.size());
  const int times = hit.option < 0 ? 1 : (hit.option - line.chosen + options) % options;
  for (int k = 0; k < times; ++k)
    if (!press({NamedKey::Letter, line.key}, host_.setup())) host_.pressLetter(line.key);
  return false;
}

void ColorsBench::setSlider(double share) {
  const SliderRow& row = *sliderOf(dragged_);
  host_.change(dragged_, [&](Setup& s) { row.set(s, trackValue(row, share)); });
}

void ColorsBench::dragTo(int x, int y) {
  if (dragged_ != 0) return setSlider(trackShare(at_, x));
  if (!grabbed_ || y == grabbedY_) return;
  grabbedY_ = y;
  const double share = 1.0 - static_cast<double>(y - at_.stored.y) / (at_.stored.height - 1);
  effects_.bend = CurvePoint{cell(), std::min(255.0 * std::clamp(share, 0.0, 1.0), brightest_)};
}

void ColorsBench::tick() {
  if (moving_) effects_.rotate = (effects_.rotate + 1) % std::max(1, scene_.count);
}

bool ColorsBench::holds(const Setup& setup) const {
  const TableSettings& now = setup.picture.table;
  return held_ && held_->shades == now.shades && held_->I0 == now.I0;
}

Setup ColorsBench::painted(const Setup& setup) const {
  if (!holds(setup)) return setup;
  Setup painted = setup;
  TableSettings& table = painted.picture.table;
  table.kind = held_->kind;
  table.pick = held_->pick;
  return painted;
}

PaletteEffects ColorsBench::stored(const Setup& setup) const {
  PaletteEffects effects = effects_;
  const TableKind kind = setup.picture.table.kind;
  if (holds(setup) && held_->kind != kind) effects.stored = kind;
  return effects;
}

ColorsBench::Told ColorsBench::told(const Setup& setup) const {
  Told told{cell_, stored(setup), setup, focus_, moving_, holds(setup)};
  told.effects.lit.reset();
  told.effects.rotate = 0;
  return told;
}

void ColorsBench::draw(IndexImage& image, const Desk& desk) {
  at_ = layoutOfColors(desk.layout.body);
  strip_ = desk.layout.strip;
  scene_ = sceneCells(desk.picture);
  const std::size_t ramps = rampsOf(desk.picture).size();
  ramps_ = ramps > 0;
  if (!cell_) cell_ = medianCell(desk.use, scene_);
  drawn_ = told(desk.setup);
  const Rgb16& last = desk.palette[scene_.last()];
  brightest_ = std::max({last.r, last.g, last.b}) / 65535.0 * 255.0;
  const Palette palette = withEffects(desk.palette, desk.picture, desk.plan, drawn_->effects);
  const std::vector<Curve> steps = stepsSeen(desk.picture, desk.palette, desk.plan, drawn_->effects);
  drawColorsPage(image, at_,
                 {.picture = desk.picture,
                  .palette = palette,
                  .steps = steps,
                  .plan = desk.plan,
                  .use = desk.use,
                  .cell = cell(),
                  .aside = "light it up everywhere",
                  .asideKey = 'h',
                  .lines = lines_ = lines(desk.picture, desk.setup),
                  .focus = focus_,
                  .gamma = effects_.gamma,
                  .hint = moving_      ? "The colours are rotating; the numbers are for the table at rest."
                          : ramps == 1 ? "Drag the curve: colours change, the indices stay."
                                       : ""});
  levels_ = levelsText(desk.picture, steps);
}

std::vector<Legend> ColorsBench::legend() const {
  std::vector<Legend> legend{
      {{"<", ">", "^", "v"}, focus_ == 0 ? std::string_view{"cell"} : sliderOf(focus_)->label},
      {{"h"}, "light it up"},
      {{"Esc"}, "restore"}};
  if (ramps_)  // without a ramp there is no table to change
    legend.insert(legend.end(), {{{"T"}, "table"},
                                 {{"c"}, "shades"},
                                 {{"0"}, "I0"},
                                 {{"j"}, "nearest"},
                                 {{"H"}, "hue"},
                                 {{"B"}, "bits"}});
  legend.push_back({{"g"}, "gamma"});
  if (ramps_) legend.insert(legend.end(), {{{"i"}, "hold indices"}, {{"m"}, "move the ramp"}});
  return legend;
}

std::vector<HelpLine> ColorsBench::help() const {
  return {{"arrows", "choose a cell; Shift: ten; Home, End: the scene's first, last"},
          {"h", "light up the cell while the key is held"},
          {"T j H B", "table; nearest in ratio or difference; hue; 8 or 16 bits a cell"},
          {"c 0", "go to the shades, or to I0; then arrows; Esc goes back to the cells"},
          {"g", "the screen's gamma"},
          {"i", "hold the indices, to see what storing colours does"},
          {"m", "move the ramp through the cells"},
          {"drag", "bend the curve of stored values"},
          {"Esc", "restore light, gamma, curve, indices and ramp"}};
}

std::vector<TableLine> ColorsBench::lines(const Picture& picture, const Setup& setup) const {
  std::vector<TableLine> lines = tableLines(picture, {.bend = effects_.bend});
  for (TableLine& line : lines) {
    const auto* const row = std::ranges::find(kLineKeys, line.label, &LineKey::label);
    if (row != kLineKeys.end()) line.key = row->key;
    if (line.key == 'T') line.chosen = static_cast<int>(setup.picture.table.kind);
  }
  // The number of shades and I0 are sliders here.
  const auto shades = std::ranges::find(lines, 'c', &TableLine::key);
  if (shades != lines.end()) {
    const auto slider = [&](char key) {
      const SliderRow& row = *sliderOf(key);
      return TableLine{.key = row.key,
                       .label = std::string{row.label},
                       .value = fixed(row.get(setup), row.decimals),
                       .share = trackPosition(row, row.get(setup))};
    };
    *shades = slider('c');
    if (setup.picture.table.kind == TableKind::Corrected) lines.insert(shades + 1, slider('0'));
  }
  const auto* const gamma = std::ranges::find(kGammas, effects_.gamma);
  TableLine gammas{.key = 'g', .label = "gamma", .chosen = static_cast<int>(gamma - kGammas.begin())};
  for (const double g : kGammas) gammas.options.push_back(fixed(g, 1));
  lines.push_back(gammas);
  if (!ramps_) return lines;
  lines.push_back({.key = 'i', .label = "indices", .options = {"follow", "held"}, .chosen = holds(setup)});
  lines.push_back({.key = 'm', .label = "move", .options = {"off", "rotate"}, .chosen = moving_});
  return lines;
}

}  // namespace xnewell
