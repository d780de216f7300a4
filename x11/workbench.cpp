#include "x11/workbench.h"

#include <algorithm>
#include <cmath>

#include "geometry/box.h"

namespace {

constexpr std::string_view kFocusOrder = "lipadsnc0tz";

/// 4032 as 4,032.
std::string withCommas(int n) {
  std::string s = std::to_string(n);
  for (int at = static_cast<int>(s.size()) - 3; at > 0; at -= 3) s.insert(at, ",");
  return s;
}

std::string titleOf(const Scene& scene) {
  const std::size_t slash = scene.name.find_last_of('/');
  std::string title = slash == std::string::npos ? scene.name : scene.name.substr(slash + 1);
  if (scene.divisions > 0)
    title +=
        " \u00B7 " + std::to_string(scene.divisions) + " x " + std::to_string(scene.divisions) + " divisions";
  return title;
}

/// The cells that stand for intensities on the ball: where a plan holds no ramp the nearest grays.
std::array<std::uint8_t, 256> ballCells(const Picture& picture, const Palette& palette) {
  std::array<std::uint8_t, 256> ball{};
  const CellRange cells = sceneCells(picture);
  for (int k = 0; k < 256; ++k) {
    if (channelsOf(picture.colors().plan()) != Channels::Rgb) {
      ball[k] = static_cast<std::uint8_t>(picture.table().cell(k / 255.0));
      continue;
    }
    const auto distance = [&](int cell) {
      const Rgb16& c = palette[cell];
      const auto square = [&](int v) { return ((v >> 8) - k) * ((v >> 8) - k); };
      return square(c.r) + square(c.g) + square(c.b);
    };
    int nearest = cells.first;
    for (int cell = cells.first; cell <= cells.last(); ++cell)
      if (distance(cell) < distance(nearest)) nearest = cell;
    ball[k] = static_cast<std::uint8_t>(nearest);
  }
  return ball;
}

/// The setup with the colours of its cells left out: what the indices depend on.
Setup withoutColors(Setup s) {
  s.picture.table.hue = {};
  s.picture.table.bits = 0;
  return s;
}

}  // namespace

Workbench::Workbench(Scene scene, const Setup& setup, Server server)
    : picture_{std::move(scene)}, server_{std::move(server)} {
  state_.setup = state_.defaults = setup;
  state_.sceneTitle = titleOf(picture_.scene());
  state_.visual = server_.visual;
  centre_ = boxOf(picture_.scene().mesh.points).centre();
}

void Workbench::resize(int width, int height) {
  if (width == layout_.width && height == layout_.height) return;
  layout_ = layoutOf(width, height);
  repaint_ = true;
}

void Workbench::change(char control, const std::function<void(Setup&)>& edit) {
  Setup next = state_.setup;
  edit(next);
  if (next == state_.setup) return;
  if (control != lastChanged_ || undo_.empty()) undo_.push_back(state_.setup);
  lastChanged_ = control;
  redo_.clear();
  state_.setup = next;
  const SceneLight& own = picture_.scene().light;
  if (!own.lights.empty() && (control == 'l' || control == 'p' || control == ']'))
    notify("The scene brings its own lights: Ip and where the light is are theirs, not the control's.");
  else if (own.Ia && (control == 'i' || control == '['))
    notify("The scene brings its own ambient light: Ia is the scene's, not the control's.");
}

void Workbench::press(const Key& key) {
  repaint_ = repaint_ || !state_.notice.empty();
  state_.notice.clear();
  if (showsColors() && !(state_.help && key.name == NamedKey::Escape)) return pressInColors(key);
  const int times = key.shift ? 10 : 1;
  switch (key.name) {
    case NamedKey::Left:
      return pressArrow(-times, 0);
    case NamedKey::Right:
      return pressArrow(times, 0);
    case NamedKey::Up:
      return pressArrow(0, times);
    case NamedKey::Down:
      return pressArrow(0, -times);
    case NamedKey::Home:
      return pressEnd(false);
    case NamedKey::End:
      return pressEnd(true);
    case NamedKey::Tab:
      return nextFocus(key.shift ? -1 : 1);
    case NamedKey::Escape:
      repaint_ = repaint_ || state_.help;
      state_.help = false;
      return;
    case NamedKey::Letter:
      return pressLetter(key.letter);
  }
}

void Workbench::pressInColors(const Key& key) {
  constexpr std::string_view kShared = "q?13HBJTuUr";  // what this view shows too
  if (colors_.press(key, state_.setup))
    state_.notice = colors_.notice();
  else if (key.letter == 'j')
    pressLetter('J');
  else if (kShared.find(key.letter) != std::string_view::npos)
    pressLetter(key.letter);
  repaint_ = repaint_ || !state_.notice.empty();
}

void Workbench::show(WindowView view) {
  if (state_.view == view) return;
  colors_.undo();
  state_.view = view;
  repaint_ = true;
}

void Workbench::pressLetter(char letter) {
  for (const WindowViewRow& row : kWindowViews)
    if (row.key == letter) return show(row.id);
  if (kFocusOrder.find(letter) != std::string_view::npos) {
    state_.focus = letter;
    repaint_ = true;
    return;
  }
  for (const ChoiceRow& row : choices())
    if (row.key == letter) return choose(row);
  for (const ToggleRow& row : kToggles)
    if (row.key == letter)
      return change(letter, [&](Setup& s) { s.picture.light.*row.value = !(s.picture.light.*row.value); });
  const auto restore = [this](std::vector<Setup>& from, std::vector<Setup>& to) {
    if (from.empty()) return;
    to.push_back(state_.setup);
    state_.setup = from.back();
    from.pop_back();
    lastChanged_ = 0;
  };
  switch (letter) {
    case 'q':
      quit_ = true;
      return;
    case '?':
      state_.help = !state_.help;
      repaint_ = true;
      return;
    case '[':
      return change('[', [](Setup& s) { setIa(s, 1.0); });
    case ']':
      return change(']', [](Setup& s) { setIp(s, 1.0); });
    case 'H':
      return change('H', nextHue);
    case 'B':
      return change('B', [](Setup& s) { s.picture.table.bits = s.picture.table.bits == 16 ? 8 : 16; });
    case 'J':
      return change('J', [](Setup& s) {
        s.picture.table.pick = s.picture.table.pick == Pick::Log ? Pick::Search : Pick::Log;
      });
    case '+':
      return zoom(1.1);
    case '-':
      return zoom(1.0 / 1.1);
    case 'u':
      return restore(undo_, redo_);
    case 'U':
      return restore(redo_, undo_);
    case 'r':
      return change('r', [this](Setup& s) { s = state_.defaults; });
    default:
      return;
  }
}

void Workbench::choose(const ChoiceRow& row) {
  change(row.key, [&](Setup& s) {
    row.set(s, (row.get(s) + 1) % static_cast<int>(row.options.size()));
    if (s.fill != Fill::XFillPolygon) return;
    const bool oracle = s.picture.order == Order::Oracle;
    if (!oracle && !rowOf(s.picture.shading).interpolates) return;
    s.fill = Fill::Scanline;
    notify(oracle ? "The oracle decides each sample by itself: there is no polygon for the server to fill."
                  : "XFillPolygon gives a polygon one cell: the server cannot interpolate.");
    repaint_ = true;
  });
}

void Workbench::pressArrow(int along, int up) {
  const char focus = state_.focus;
  if (focus == 't') {
    change('t', [&](Setup& s) {
      s.picture.camera = moved(s.picture.camera, camera(), -2.0 * along, -2.0 * up, 1.0);
    });
  } else if (focus == 'z') {
    zoom(along + up > 0 ? std::pow(1.02, along + up) : 1.0 / std::pow(1.02, -along - up));
  } else if (focus == 'l') {
    change('l', [&](Setup& s) { turnLight(s.picture.light, picture_.scene().up, along, up, centre_); });
  } else {
    const auto* const row = std::ranges::find(kSliders, focus, &SliderRow::key);
    change(focus, [&](Setup& s) { step(s, *row, along + up); });
  }
}

void Workbench::pressEnd(bool high) {
  const auto* const row = std::ranges::find(kSliders, state_.focus, &SliderRow::key);
  if (row != kSliders.end()) change(row->key, [&](Setup& s) { row->set(s, high ? row->high : row->low); });
}

void Workbench::nextFocus(int direction) {
  const std::size_t n = kFocusOrder.size();
  state_.focus = kFocusOrder[(kFocusOrder.find(state_.focus) + n + direction) % n];
  repaint_ = true;
}

Camera Workbench::camera() const {
  const PictureSettings& p = state_.setup.picture;
  const double aspect = static_cast<double>(layout_.picture.width) / layout_.picture.height;
  return placeCamera(p.camera, picture_.scene().mesh.points, picture_.scene().up, aspect);
}

void Workbench::release(char letter) {
  if (showsColors()) colors_.release(letter);
}

bool Workbench::grab(int x, int y) {
  if (!showsColors()) return !intersection(layout_.picture, {x, y, 1, 1}).empty();
  hover(x, y);
  const bool grabbed = colors_.grab(x, y);
  repaint_ = repaint_ || state_.notice != colors_.notice();
  state_.notice = colors_.notice();
  return grabbed;
}

void Workbench::hover(int x, int y) {
  if (!showsColors()) return;
  colors_.hover(x, y);
  if (const std::optional<int> cell = cellInStrip(layout_.strip, x, y)) colors_.inspect(*cell);
}

void Workbench::settle() {
  colors_.drop();
  repaint_ = repaint_ || !counted_;
}

void Workbench::drag(int dx, int dy) {
  if (dx == 0 && dy == 0) return;
  if (showsColors()) return colors_.dragBy(dx, dy);
  change('t',
         [&](Setup& s) { s.picture.camera = moved(s.picture.camera, camera(), -0.5 * dx, 0.5 * dy, 1.0); });
}

void Workbench::zoom(double factor) {
  if (showsColors()) return;
  change('z', [&](Setup& s) { s.picture.camera = moved(s.picture.camera, camera(), 0.0, 0.0, factor); });
}

Workbench::Stale Workbench::stale() const {
  if (!any_ || repaint_ || withoutColors(painted()) != drawnIndices_) return Stale::Everything;
  if (state_.setup != drawn_) return Stale::Colors;
  if (!showsColors()) return Stale::Nothing;
  if (colors_.stored(state_.setup) != stored_) return Stale::Colors;
  return colors_.wordsAreLate(state_.setup) ? Stale::Everything : Stale::Nothing;
}

PictureSettings Workbench::sized() const {
  const Rect at = showsColors() ? layoutOfColors(layout_.body).picture : layout_.picture;
  PictureSettings settings = painted().picture;
  settings.width = at.width;
  settings.height = at.height;
  settings.inPixels = serverFills();
  return settings;
}

std::string Workbench::exactnessText() {
  constexpr std::size_t kMost = 100'000;  // polygons: more take longer to count than to look at
  const Order order = setup().picture.order;
  if (order == Order::Newell || order == Order::Oracle || picture_.snapped().faces.size() > kMost) return {};
  const Picture::Exactness e = picture_.exactness();
  if (e.wrong == 0) return {};
  return "Not exact: " + orderInWords(order) + ", it shows the wrong face at " + withCommas(e.wrong) +
         " of " + withCommas(e.samples) + " samples.";
}

/// Without effects.
Palette Workbench::plainPalette() const {
  const Palette palette = picture_.palette(plan(), server_.unneeded);
  return server_.gray ? forGrayScreen(palette, picture_) : palette;
}

void Workbench::makePalette() {
  stored_ = showsColors() ? colors_.stored(state_.setup) : PaletteEffects{};
  palette_ = withEffects(plainPalette(), picture_, plan(), stored_);
}

void Workbench::drawPicture(bool dragging) {
  const Rect& at = layout_.picture;
  for (int j = 0; j < at.height; ++j)
    std::copy_n(pictureImage_.row(j), at.width, image_.row(at.y + j) + at.x);
  const SnappedScene& snapped = picture_.snapped();
  const auto backs = std::ranges::count(snapped.faces, true, &SnappedFace::back);
  const auto splits = static_cast<int>(picture_.sorted().statistics.splits);
  state_.counts = withCommas(snapped.polygons - snapped.degenerate) + " polygons, " +
                  (splits > 0 ? withCommas(splits) + " cuts, " : "") +
                  withCommas(static_cast<int>(snapped.faces.size()) + splits) + " painted, " +
                  withCommas(static_cast<int>(backs) + snapped.culled) + " back faces   " +
                  withCommas(static_cast<int>(picture_.saturated())) + " clamped";
  state_.times = formatted(picture_.times().total(), 1) + " ms";
  counted_ = !dragging;
  state_.inexact = dragging ? "" : exactnessText();
  state_.light = lightAngles(state_.setup.picture.light, picture_.scene().up, centre_);
  state_.lightInView =
      vrcRotation(picture_.camera().view) * towardsLight(state_.setup.picture.light, centre_);
  state_.use = cellUse(pictureImage_);
  state_.ball = ballCells(picture_, palette_);
  state_.inspected.reset();
}

void Workbench::drawFrame(bool dragging) {
  picture_.make(sized());
  const CellPlan cells = plan();
  picture_.paint(pictureImage_, cells[Cell::Well]);
  makePalette();
  if (image_.width != layout_.width || image_.height != layout_.height)
    image_ = IndexImage{layout_.width, layout_.height, cells[Cell::Paper]};
  state_.words = wordsOf(picture_, showsColors() ? colors_.stored(state_.setup) : PaletteEffects{});
  if (showsColors()) {
    state_.use = cellUse(pictureImage_, picture_.faceImage());
    const Palette plain = plainPalette();
    state_.counts =
        colors_.draw(image_, layout_.body, {picture_, pictureImage_, state_.use, cells, plain}, state_.setup);
    state_.inspected = colors_.cell();
    state_.times.clear();
    counted_ = true;
  } else {
    drawPicture(dragging);
  }
  drawPanel(image_, layout_, state_, cells);
  drawnIndices_ = withoutColors(painted());
}

void Workbench::update(bool dragging) {
  if (stale() == Stale::Colors) {
    picture_.make(sized());
    makePalette();
  } else if (stale() == Stale::Everything) {
    try {
      drawFrame(dragging);
    } catch (const ViewError& e) {
      if (!any_) throw;
      state_.setup = drawn_;
      colors_.undo();
      state_.notice = e.what();
      drawFrame(dragging);
    }
  }
  drawn_ = state_.setup;
  any_ = true;
  repaint_ = false;
}
