#include "x11/window/colors_view.h"

#include <algorithm>
#include <utility>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {
constexpr ControlId kCurve{0, 1};  // of the stored values: it has no key
}

void ColorsView::inspect(int cell) {
  cell_ = std::clamp(cell, 0, 255);
  if (effects_.lit) effects_.lit = scene_.has(*cell_) ? cell_ : std::nullopt;
}

/// The lines of the table, with the keys and the values of the settings. The number of shades and I0 are
/// sliders here.
Controls ColorsView::controls() {
  const Setup& now = host_.setup();
  Controls all;
  const auto add = [&](char key, const char* legend) -> Control& {
    all.push_back(settingControl(key, now, host_.defaults(), change()));
    all.back().legend = legend;
    return all.back();
  };
  for (const Control& fact : facts_) {
    if (fact.label == "table") {
      add('T', "table").options = fact.options;
    } else if (fact.label == "shades") {
      add('c', "shades");
      add('o', "I0");
      Control& nearest = add('J', "nearest");
      nearest.label = "nearest";
      if (now.picture.table.kind != TableKind::Corrected)
        nearest.off = noEffect(nearest.label, *settingOf('J')) + ".";
    } else if (fact.label == "hue") {
      const Control choice = add('H', "hue");
      all.back() = fact;  // the line shows the hue's numbers
      all.back().key = 'H', all.back().legend = choice.legend, all.back().is = choice.is;
      all.back().set = [choice](double) { activate(choice); };
    } else if (fact.label == "stored") {
      add('B', "bits").label = fact.label;
    } else if (fact.label != "nearest" && fact.label != "gamma") {
      all.push_back(fact);
    }
  }
  const auto choice = [&](char key, std::string label, std::string is, std::string legend, double chosen,
                          std::vector<std::string> options, std::function<void(double)> set) {
    all.push_back({.kind = Control::Kind::Choice,
                   .key = key,
                   .label = std::move(label),
                   .is = std::move(is),
                   .legend = std::move(legend),
                   .value = chosen,
                   .options = std::move(options),
                   .set = std::move(set)});
  };
  all.push_back(gammaControl(effects_.gamma, [this](double gamma) { effects_.gamma = gamma; }));
  all.back().legend = "gamma";
  choice('i', "indices", "held, they show what storing colours alone does", "hold indices", holds(now),
         {"follow", "held"},
         [this](double on) { held_ = on != 0 ? std::optional{host_.setup().picture.table} : std::nullopt; });
  choice('m', "move", "moves the ramp through the cells", "move the ramp", moving_, {"off", "rotate"},
         [this](double on) { moving_ = on != 0, effects_.rotate = 0; });
  // The curve of stored values.
  all.push_back({.kind = Control::Kind::Own, .part = kCurve.part, .drag = [this](int, int y, int, int dy) {
                   if (dy != 0) bendTo(y);
                 }});
  if (ramps_) return all;
  for (Control& control : all)
    if (control.key == 'i' || control.key == 'm' || control.id() == kCurve)
      control.off = "This needs a ramp, and these cells hold single colours.";
  return all;
}

KeyTable ColorsView::ownKeys() {
  KeyTable table;
  if (!list_.focused(controls())) {
    const auto by = [this](int cells, int ofShift) {
      return [=, this](const Key& key) {
        const int to = cell() + (key.shift ? ofShift : cells);
        if (std::abs(cells) == 1 || (to >= 0 && to < 256)) inspect(to), chosen_ = true;
      };
    };
    const std::string does = "choose a cell; Shift: ten";
    table = {{{NamedKey::Left}, "cell", does, by(-1, -10)},
             {{NamedKey::Right}, "cell", does, by(1, 10)},
             {{NamedKey::Up}, "cell", does, by(-16, -16)},
             {{NamedKey::Down}, "cell", does, by(16, 16)}};
    const std::string ends = "the scene's first cell, its last";
    table.push_back({{NamedKey::Home}, "", ends, [this](const Key&) { inspect(scene_.first); }});
    table.push_back({{NamedKey::End}, "", ends, [this](const Key&) { inspect(scene_.last()); }});
  }
  table.push_back({{'h'},
                   "light it up",
                   "light up the cell, or no longer; or while the key is held",
                   [this](const Key&) {
                     again_ = effects_.lit.has_value();  // a held key is pressed again and again
                     effects_.lit = cell();
                   },
                   scene_.has(cell()) ? ""
                                      : "Cell " + std::to_string(cell()) +
                                            " does not belong to the scene: there is nothing to light up."});
  table.push_back(
      {{NamedKey::Escape}, "restore", "restore light, gamma, curve, indices and ramp", [this](const Key&) {
         undo();
       }});
  table.back().idle = effects_ == PaletteEffects{} && !moving_ && !held_ && !list_.focus() && !chosen_;
  table.push_back({.does = "bend the curve of stored values", .gesture = "drag"});
  return table;
}

void ColorsView::release(char letter) {
  if (letter == 'h' && std::exchange(again_, false)) effects_.lit.reset();
}

bool ColorsView::reset() {
  const bool changed = effects_ != PaletteEffects{} || moving_ || held_;
  undo();
  return changed;
}

void ColorsView::undo() {
  effects_ = {};
  moving_ = false;
  held_.reset();
  chosen_ = false;
  list_.drop();
  list_.setFocus(std::nullopt);
}

void ColorsView::leave() {
  effects_.lit.reset();
  if (effects_ != PaletteEffects{} || moving_ || held_)
    host_.tell("Gamma, curve, ramp and indices are restored: only view 3 changes them.");
  undo();
  WindowView::leave();
}

void ColorsView::hover(int x, int y) {
  WindowView::hover(x, y);
  if (const std::optional<int> cell = cellAt(x, y); cell && !chosen_) inspect(*cell);
}

std::optional<int> ColorsView::cellAt(int x, int y) const {
  if (const std::optional<int> cell = cellInGrid(at_, x, y)) return cell;
  if (const std::optional<int> cell = cellInStrip(strip_, x, y)) return cell;
  for (const Rect& plot : {at_.stored, at_.steps})
    if (plot.has(x, y) && scene_.count > 0) return cellAtX(scene_, plot, x);
  return std::nullopt;
}

bool ColorsView::grab(int x, int y) {
  WindowView::hover(x, y);
  if (const std::optional<int> cell = cellAt(x, y)) inspect(*cell), chosen_ = true;
  if (!at_.table.has(x, y)) list_.setFocus(std::nullopt);
  return WindowView::grab(x, y);
}

void ColorsView::bendTo(int y) {
  const double share = 1.0 - static_cast<double>(y - at_.stored.y) / (at_.stored.height - 1);
  effects_.bend = CurvePoint{cell(), std::min(255.0 * std::clamp(share, 0.0, 1.0), brightest_)};
}

void ColorsView::tick() {
  if (moving_) effects_.rotate = (effects_.rotate + 1) % std::max(1, scene_.count);
}

bool ColorsView::holds(const Setup& setup) const {
  const TableSettings& now = setup.picture.table;
  return held_ && held_->shades == now.shades && held_->I0 == now.I0;
}

Setup ColorsView::painted(const Setup& setup) const {
  if (!holds(setup)) return setup;
  Setup painted = setup;
  TableSettings& table = painted.picture.table;
  table.kind = held_->kind;
  table.pick = held_->pick;
  return painted;
}

PaletteEffects ColorsView::stored(const Setup& setup) const {
  PaletteEffects effects = effects_;
  const TableKind kind = setup.picture.table.kind;
  if (holds(setup) && held_->kind != kind) effects.stored = kind;
  return effects;
}

ColorsView::Shown ColorsView::told(const Setup& setup) const {
  Shown told{cell_, stored(setup), setup, moving_, holds(setup)};
  told.effects.lit.reset();
  told.effects.rotate = 0;
  return told;
}

void ColorsView::draw(Painter paint, const DrawContext& context) {
  at_ = layoutIn(context.layout);
  strip_ = context.layout.strip;
  scene_ = sceneCells(context.picture);
  const std::size_t ramps = rampsOf(context.picture).size();
  ramps_ = ramps > 0;
  if (!cell_) cell_ = medianCell(context.use, scene_);
  drawn_ = told(context.setup);
  const Rgb16& last = context.palette[scene_.last()];
  brightest_ = std::max({last.r, last.g, last.b}) / 65535.0 * 255.0;
  const Palette palette = withEffects(context.palette, context.picture, context.plan, drawn_->effects);
  const std::vector<Curve> steps = stepsSeen(context.picture, context.palette, context.plan, drawn_->effects);
  drawColorsPage(paint, at_,
                 {.picture = context.picture,
                  .palette = palette,
                  .steps = steps,
                  .plan = context.plan,
                  .use = context.use,
                  .cell = cell(),
                  .aside = "light it up everywhere",
                  .asideKey = 'h',
                  .gamma = effects_.gamma,
                  .hint = moving_      ? "The colours are rotating; the numbers are for the table at rest."
                          : ramps == 1 ? "Drag the curve: colours change, the indices stay."
                                       : ""});
  facts_ = tableLines(context.picture, {.bend = effects_.bend});
  const Controls all = controls();
  const RowStyle style = tableStyle(at_, true);
  int line = firstTableLine(at_);
  Pen pen{paint, context.plan};
  list_.forgetPlaces();
  for (const Control& control : all) {
    if (control.label.empty()) continue;
    const ControlPlace place = placeInRow(control, at_.table.x, line, style);
    if (control.key == 0)
      drawControl(pen, control, place, {});
    else
      list_.place(control.id(), place);
    line += place.area.height;
  }
  if (scene_.count > 0) list_.place(kCurve, {.area = at_.stored, .grip = at_.stored, .bare = true});
  list_.draw(pen, all);
  levels_ = levelsText(context.picture, palette, steps);
  words_ = {levels_, "cell " + std::to_string(cell())};
  for (const CellFact& fact : factsOf(cell(), context.picture, palette, context.plan, context.use))
    words_.push_back(fact.label + ": " + fact.value);
}

}  // namespace xnewell
