#include "x11/colors_bench.h"

#include <algorithm>

#include "shading/wording.h"

namespace {

constexpr std::array kGammas{1.0, 1.4, 1.8, 2.2};

/// Which key changes the setting that a line of the table tells.
struct LineKey {
  std::string_view label;
  char key;
};
constexpr std::array kLineKeys{LineKey{"table", 'T'}, LineKey{"nearest", 'j'}, LineKey{"hue", 'H'},
                               LineKey{"stored", 'B'}};

bool inside(const Rect& r, int x, int y) { return !intersection(r, {x, y, 1, 1}).empty(); }

}  // namespace

bool ColorsBench::hasRamp(const char* what) {
  if (!ramps_) notice_ = std::string{what} + " needs a ramp, and these cells hold single colours.";
  return ramps_;
}

void ColorsBench::inspect(int cell) {
  cell_ = std::clamp(cell, 0, 255);
  if (effects_.lit) effects_.lit = scene_.has(*cell_) ? cell_ : std::nullopt;
}

bool ColorsBench::press(const Key& key, const Setup& setup) {
  notice_.clear();
  const int times = key.shift ? 10 : 1;
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
    case NamedKey::Letter:
      break;
  }
  switch (key.letter) {
    case 'h':
      if (scene_.has(cell()))
        effects_.lit = cell();
      else
        notice_ = "Cell " + std::to_string(cell()) + " is not one of the scene's: there is nothing to light.";
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
  notice_.clear();
}

void ColorsBench::hover(int x, int y) {
  if (const std::optional<int> cell = cellInGrid(at_, x, y)) return inspect(*cell);
  for (const Rect& plot : {at_.stored, at_.steps})
    if (inside(plot, x, y) && scene_.count > 0) return inspect(cellAtX(scene_, plot, x));
}

bool ColorsBench::grab(int x, int y) {
  if (!inside(at_.stored, x, y) || scene_.count == 0) return false;
  notice_.clear();
  if (!hasRamp("Dragging the curve")) return false;
  inspect(cellAtX(scene_, at_.stored, x));
  x_ = x, y_ = y;
  grabbed_ = true;
  return true;
}

void ColorsBench::dragBy(int dx, int dy) {
  if (!grabbed_) return;
  x_ += dx, y_ += dy;
  const double share = 1.0 - static_cast<double>(y_ - at_.stored.y) / (at_.stored.height - 1);
  effects_.bend = CurvePoint{cell(), 255.0 * std::clamp(share, 0.0, 1.0)};
}

void ColorsBench::tick() {
  if (moving_) effects_.rotate = (effects_.rotate + 1) % std::max(1, scene_.count);
}

bool ColorsBench::holds(const Setup& setup) const {
  const TableSettings& now = setup.picture.table;
  return held_ && held_->shades == now.shades && held_->I0 == now.I0;
}

Setup ColorsBench::painted(Setup setup) const {
  if (!holds(setup)) return setup;
  TableSettings& table = setup.picture.table;
  table.kind = held_->kind;
  table.pick = held_->pick;
  return setup;
}

PaletteEffects ColorsBench::stored(const Setup& setup) const {
  PaletteEffects effects = effects_;
  const TableKind kind = setup.picture.table.kind;
  if (holds(setup) && held_->kind != kind) effects.stored = kind;
  return effects;
}

ColorsBench::Told ColorsBench::told(const Setup& setup) const {
  Told told{cell_, stored(setup), setup, moving_, holds(setup)};
  told.effects.lit.reset();
  told.effects.rotate = 0;
  return told;
}

bool ColorsBench::wordsAreLate(const Setup& setup) const { return told(setup) != drawn_; }

std::string ColorsBench::draw(IndexImage& image, const Rect& body, const Shown& shown, const Setup& setup) {
  at_ = layoutOfColors(body);
  scene_ = sceneCells(shown.picture);
  const std::size_t ramps = rampsOf(shown.picture).size();
  ramps_ = ramps > 0;
  if (!cell_) cell_ = medianCell(shown.use, scene_);
  drawn_ = told(setup);
  const Palette palette = withEffects(shown.palette, shown.picture, shown.plan, drawn_->effects);
  const std::vector<Curve> steps = stepsSeen(shown.picture, shown.palette, shown.plan, drawn_->effects);
  std::ranges::fill(image.pixels, shown.plan[Cell::Paper]);
  drawColorsPage(image, at_,
                 {.picture = shown.picture,
                  .image = shown.image,
                  .palette = palette,
                  .steps = steps,
                  .plan = shown.plan,
                  .use = shown.use,
                  .cell = cell(),
                  .aside = "lit up everywhere",
                  .asideKey = 'h',
                  .lines = lines(shown.picture, setup),
                  .gamma = effects_.gamma,
                  .hint = moving_      ? "Colours move on; what is told is of standing still."
                          : ramps == 1 ? "Drag the curve: colours change, the indices stay."
                                       : ""});
  return levelsText(shown.picture, steps);
}

std::vector<TableLine> ColorsBench::lines(const Picture& picture, const Setup& setup) const {
  std::vector<TableLine> lines = tableLines(picture, {.bend = effects_.bend});
  for (TableLine& line : lines) {
    const auto* const row = std::ranges::find(kLineKeys, line.label, &LineKey::label);
    if (row != kLineKeys.end()) line.key = row->key;
    if (line.key == 'T') line.chosen = static_cast<int>(setup.picture.table.kind);
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
