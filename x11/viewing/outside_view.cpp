#include "x11/viewing/outside_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "geometry/exact/scale.h"
#include "x11/viewing/viewing_page.h"

namespace xnewell {

namespace {

struct Dashes {
  int on = 1, off = 0;
};
constexpr Dashes kDashed{4, 4};

/// Draws lines and words over a stage's image. Places are those of the stage's space.
class StagePen {
 public:
  StagePen(Pen& pen, const Rect& area, const StageImage& image)
      : pen_{pen}, paint_{pen.paint.within(area)}, area_{area}, image_{image}, unit_{pen.paint.unit()} {}

  /// The place on the paper, in units.
  [[nodiscard]] glm::dvec2 onPaper(const glm::dvec3& p) const {
    const glm::dvec3 q = image_.camera()(p);
    return {area_.x + q.x / unit_, area_.y + q.y / unit_};
  }

  /// A straight line; what a face hides of it is left out.
  void line(const glm::dvec3& from, const glm::dvec3& to, Cell cell, Dashes dashes = {}, int thick = 1,
            bool always = false) {
    const glm::dvec3 a = image_.camera()(from), b = image_.camera()(to);
    if (!std::isfinite(a.x + a.y + b.x + b.y)) return;
    double start = 0.0, end = 1.0;
    for (int k = 0; k < 2; ++k) {  // the part over the image
      const double size = k == 0 ? image_.image().width : image_.image().height, step = b[k] - a[k];
      if (step == 0.0) continue;
      const double u = -a[k] / step, v = (size - a[k]) / step;
      start = std::max(start, std::min(u, v)), end = std::min(end, std::max(u, v));
    }
    if (start >= end) return;
    const double steps = std::ceil(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)) / unit_);
    const int count = static_cast<int>(std::clamp(steps * (end - start), 1.0, 20'000.0));
    for (int k = 0; k <= count; ++k) {
      if (k % (dashes.on + dashes.off) >= dashes.on) continue;
      const glm::dvec3 p = a + (b - a) * (start + (end - start) * k / count);
      if (!always && !image_.shows(p)) continue;
      const int x = area_.x + static_cast<int>(std::floor(p.x / unit_));
      const int y = area_.y + static_cast<int>(std::floor(p.y / unit_));
      paint_.fillRect({x, y, thick, thick}, pen_(cell));
    }
  }
  void loop(const std::array<glm::dvec3, 4>& corners, Cell cell, Dashes dashes = {}, int thick = 1) {
    for (std::size_t k = 0; k < 4; ++k) line(corners[k], corners[(k + 1) % 4], cell, dashes, thick);
  }
  void volume(const StageVolume& v, bool dashed) {
    const Dashes dashes = dashed ? kDashed : Dashes{};
    const Cell cell = dashed ? Cell::Faint : Cell::WellText;
    for (std::size_t k = 0; k < 4; ++k) {
      if (v.eye && !v.parallel) line(*v.eye, v.front[k], Cell::Soft, dashes);
      line(v.front[k], v.back[k], cell, dashes);
    }
    if (v.eye && v.parallel) line(*v.eye, (v.window[0] + v.window[2]) / 2.0, Cell::Soft, dashes);
    loop(v.back, cell, dashes);
    loop(v.front, cell, dashes);
    if (!dashed) loop(v.window, Cell::White, {}, 2);
  }
  /// An arrow of so many units, as far as it is not seen end on.
  void arrow(const glm::dvec3& from, const glm::dvec3& direction, double length, Cell cell,
             std::string_view name, int thick = 1) {
    const glm::dvec3 step = unit(direction) * (length * unit_ / image_.camera().scale);
    line(from, from + step, cell, {}, thick, true);
    const glm::dvec2 a = onPaper(from), b = onPaper(from + step);
    if (!std::isfinite(b.x + b.y)) return;
    const double along = std::hypot(b.x - a.x, b.y - a.y);
    const glm::dvec2 d = along > 1.0 ? (b - a) / along : glm::dvec2{0.0};
    if (along > 6.0)
      for (const double side : {-1.0, 1.0})
        paint_.line(at(b.x), at(b.y), at(b.x - 6 * d.x + side * 3 * d.y), at(b.y - 6 * d.y - side * 3 * d.x),
                    pen_(cell), {.thickness = thick});
    (void)name_(b + 9.0 * d - glm::dvec2{3.0, -4.0}, name, cell);
  }
  /// A name beside a place, kept inside the area. Returns false if another name stands there already.
  bool name(const glm::dvec3& place, int dx, int dy, std::string_view text, Cell cell) {
    return name_(onPaper(place) + glm::dvec2{dx, dy}, text, cell);
  }
  /// A name at the first corner where there is room: the upper ones, then the lower ones.
  void nameOf(const std::array<glm::dvec3, 4>& corners, std::string_view text, Cell cell) {
    const int half = textWidth(text) / 2;
    for (const auto& [corner, below] : {std::pair{3, false}, {2, false}, {0, true}, {1, true}})
      if (name(corners[static_cast<std::size_t>(corner)], -half, below ? 16 : -8, text, cell)) return;
  }
  /// Words at a baseline below all the rest, which no name covers. Returns where they begin.
  void words(int x, int baseline, std::string_view text) {
    names_.push_back({x, baseline - 10, textWidth(text), 13});
    paint_.text(x, baseline, text, pen_(Cell::WellText));
  }
  /// A handle, at pixels of the image.
  void handle(const glm::dvec2& pixels, bool marked, std::string_view name) {
    const glm::dvec2 p{area_.x + pixels.x / unit_, area_.y + pixels.y / unit_};
    const int half = marked ? 4 : 2;
    const auto square = [&](int reach, Cell cell) {
      paint_.fillRect({at(p.x) - reach, at(p.y) - reach, 2 * reach + 1, 2 * reach + 1}, pen_(cell));
    };
    square(half + 1, Cell::Well);
    square(half, marked ? Cell::Q : Cell::White);
    if (!marked) square(half - 1, Cell::Well);
    (void)name_(p + glm::dvec2{9.0, -7.0}, name, Cell::White);
  }
  /// Writes the names that have been placed: no line that is drawn before this crosses their letters.
  void writeNames() {
    for (const auto& [x, y, text, cell] : placed_) {
      for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})  // a halo of the ground
        paint_.text(x + dx, y + dy, text, pen_(Cell::Well));
      paint_.text(x, y, text, pen_(cell));
    }
    placed_.clear();
  }
  void dot(const glm::dvec3& place, int radius, Cell cell) {
    const glm::dvec2 p = onPaper(place);
    if (!std::isfinite(p.x + p.y)) return;
    paint_.disc(at(p.x), at(p.y), radius + 1, pen_(Cell::Well));
    paint_.disc(at(p.x), at(p.y), radius, pen_(cell));
  }

 private:
  static int at(double v) { return static_cast<int>(std::lround(std::clamp(v, -1e5, 1e5))); }
  bool name_(const glm::dvec2& place, std::string_view text, Cell cell) {
    if (text.empty() || !std::isfinite(place.x + place.y)) return false;
    const int width = textWidth(text);
    const int x =
        std::clamp(at(place.x), area_.x + 4, std::max(area_.x + 4, area_.x + area_.width - width - 4));
    const int y = std::clamp(at(place.y), area_.y + 32, std::max(area_.y + 32, area_.y + area_.height - 5));
    constexpr int kApart = 4;  // so that two names do not read as one
    const Rect box{x - kApart / 2, y - 10, width + kApart, 13};
    for (const Rect& other : names_)
      if (const Rect both = intersection(box, other); both.width > 0 && both.height > 0) return false;
    names_.push_back(box);
    placed_.push_back({x, y, std::string{text}, cell});
    return true;
  }

  Pen& pen_;
  Painter paint_;
  Rect area_;
  const StageImage& image_;
  int unit_;
  std::vector<Rect> names_;
  struct Placed {
    int x, y;
    std::string text;
    Cell cell;
  };
  std::vector<Placed> placed_;
};

/// The vertex at a stage, divided by w.
glm::dvec3 vertexAt(const OutsideView& view) {
  const glm::dvec4 p = view.story.of(view.stage).at;
  return glm::dvec3{p} / p.w;
}

void drawAxes(StagePen& pen, const OutsideView& view, const StageVolume& volume) {
  const bool vrc = view.stage == ViewStage::Vrc;
  const double length = view.stage == ViewStage::World ? 24 : 34;
  const std::array<std::string_view, 3> names{vrc ? "u" : "x", vrc ? "v" : "y", vrc ? "n" : "z"};
  for (int k = 0; k < 3; ++k) {
    glm::dvec3 axis{0.0};
    axis[k] = 1.0;
    pen.arrow(volume.origin, axis, length, Cell::WellText, names[static_cast<std::size_t>(k)]);
  }
}

void drawNames(StagePen& pen, const OutsideView& view, const StageVolume& volume) {
  pen.nameOf(volume.window, "window", Cell::White);
  pen.nameOf(volume.front, "front", Cell::WellText);
  pen.nameOf(volume.back, "back", Cell::WellText);
  const ViewSpec& spec = view.picture.camera().view;
  if (volume.eye) {
    pen.dot(*volume.eye, 3, Cell::White);
    (void)pen.name(*volume.eye, -9, 19, spec.projection == Projection::Parallel ? "PRP" : "eye",
                   Cell::WellText);
  }
  if (view.stage == ViewStage::World) {
    pen.dot(spec.vrp, 2, Cell::White);
    (void)pen.name(spec.vrp, 6, 12, "VRP", Cell::WellText);
    pen.arrow(spec.vrp, spec.vpn, 64, Cell::White, "VPN");
    pen.arrow(spec.vrp, spec.vup, 64, Cell::White, "VUP");
  }
}

/// The vertex on the grid of the screen: the place before the snap as a ring, and after it as a dot.
void drawGrid(Pen& pen, const Rect& area, const OutsideView& view, bool words) {
  pen.paint.fillRect(area, pen(Cell::Well));
  Painter paint = pen.paint.within(area);
  const ViewingStory& story = view.story;
  if (!story.snapped) {
    if (words)
      paint.text(area.x + 8, area.y + 40, "this vertex is cut off: it has no place on the grid",
                 pen(Cell::WellText));
    return;
  }
  const double step = words ? 40.0 : 10.0;  // units for a step of the grid
  const glm::dvec2 middle{area.x + area.width / 2.0, area.y + area.height / 2.0};
  const glm::ivec2 grid{*story.snapped};
  const auto at = [](double v) { return static_cast<int>(std::lround(std::clamp(v, -1e5, 1e5))); };
  const int columns = static_cast<int>(area.width / step / 2) + 1,
            rows = static_cast<int>(area.height / step / 2) + 1;
  for (int k = -columns; k <= columns; ++k)
    paint.vline(at(middle.x + k * step), area.y, area.height, pen(Cell::WellLine));
  for (int k = -rows; k <= rows; ++k)
    paint.hline(area.x, at(middle.y + k * step), area.width, pen(Cell::WellLine));
  // The edges of the faces that have this vertex, as the picture draws them.
  const SnappedScene& scene = view.picture.snapped();
  for (const SnappedFace& f : scene.faces)
    for (int k = 0; k < f.count; ++k) {
      const glm::ivec3 &a = scene.vertices[f.first + k], &b = scene.vertices[f.first + (k + 1) % f.count];
      if (glm::ivec2{a} != grid && glm::ivec2{b} != grid) continue;
      const glm::dvec2 away =
          glm::ivec2{a} == grid ? glm::dvec2{b} - glm::dvec2{a} : glm::dvec2{a} - glm::dvec2{b};
      if (away == glm::dvec2{0.0}) continue;
      const glm::dvec2 end = middle + away / glm::length(away) * double(area.width + area.height);
      paint.line(at(middle.x), at(middle.y), at(end.x), at(end.y), pen(Cell::WellText));
    }
  const glm::dvec4 before = story.of(ViewStage::Viewport).at;
  const glm::dvec2 off = (glm::dvec2{before} * double{kGrid} - glm::dvec2{grid}) * step;
  if (words) {
    paint.ring(at(middle.x + off.x), at(middle.y + off.y), 5, pen(Cell::Q));
    paint.text(at(middle.x + off.x) + 10, at(middle.y + off.y) - 6, "before", pen(Cell::WellText));
  }
  paint.disc(at(middle.x), at(middle.y), 3, pen(Cell::White));
  if (!words) return;
  const std::string square = "a square is 1/65,536 pixel wide; ";
  const std::string lines = "the lines are edges of the faces at this vertex";
  const int last = area.y + area.height - 8;
  const bool inOne = textWidth(square + lines) <= area.width - 16;
  const int end = paint.text(area.x + 8, inOne ? last : last - 15, square, pen(Cell::WellText));
  paint.text(inOne ? end : area.x + 8, last, lines, pen(Cell::WellText));
}

const StageImage& imageOf(const OutsideView& view, const Rect& area, Pen& pen, bool large) {
  const int unit = pen.paint.unit();
  const OutsideCamera* const held = large ? view.held : nullptr;
  const StageImages::Shows shows{.made = view.made,
                                 .turn = turnAt(view.stage, view.turn),
                                 .size = {area.width * unit, area.height * unit},
                                 .ground = pen(Cell::Well),
                                 .held = held ? std::optional{*held} : std::nullopt};
  return view.images.get(view.stage, large, shows, [&](StageMemory memory) {
    return StageImage{view.picture, view.lit,         view.story,
                      view.points,  view.stage,       shows.turn,
                      shows.size,   shows.ground,     large ? kWordBand * unit : 0,
                      held,         std::move(memory)};
  });
}

}  // namespace

OutsideTurn turnAt(ViewStage stage, const OutsideTurn& turn) {
  if (stage < ViewStage::Viewport) return turn;
  const OutsideTurn first;
  return {turn.around - first.around, turn.down - first.down, turn.zoom};
}

const StageImage* drawStage(Pen& pen, const Rect& area, const OutsideView& view) {
  if (view.stage == ViewStage::Snapped) {
    drawGrid(pen, area, view, true);
    return nullptr;
  }
  const StageImage& image = imageOf(view, area, pen, true);
  pen.paint.place(image.image(), area.x, area.y);
  StagePen lines{pen, area, image};
  const ViewSpec& spec = view.picture.camera().view;
  const int last = area.y + area.height - 8;
  if (const auto before = volumeBefore(view.story, spec, view.stage)) {
    lines.volume(*before, true);
    const std::string_view words =
        view.stage == ViewStage::Sheared ? "dashed: before the shear" : "dashed: before the warp, scaled";
    lines.words(area.x + area.width - 8 - textWidth(words), last, words);
  }
  const std::vector<HandleAt> handles =
      handlesAt(view.story, spec, view.stage, image, lengthUnit(view.picture.scene()), pen.paint.unit());
  if (!handles.empty()) lines.words(area.x + 8, last, "drag a square to change its number");
  lines.volume(image.volume(), false);
  const VertexAtStage& here = view.story.of(view.stage);
  if (here.at.w > 0.0) {
    const glm::dvec3 vertex = vertexAt(view);
    if (!here.equation.lights.empty())
      lines.arrow(vertex, here.equation.lights.front().L, 60, Cell::WellText, "L");
    lines.arrow(vertex, here.N, 60, Cell::White, "N", 2);
    lines.dot(vertex, 3, Cell::White);
  }
  for (const HandleAt& handle : handles)
    if (handle.id == view.handle) lines.handle(handle.at, true, view.handleName);
  drawNames(lines, view, image.volume());
  drawAxes(lines, view, image.volume());
  lines.writeNames();
  for (const HandleAt& handle : handles) lines.handle(handle.at, handle.id == view.handle, {});
  return &image;
}

void drawSmallStage(Pen& pen, const Rect& area, const OutsideView& view) {
  if (view.stage == ViewStage::Snapped) return drawGrid(pen, area, view, false);
  if (view.stage == ViewStage::Viewport && view.picture.isPainted() && view.programs) {
    pen.paint.fillRect(area, pen(Cell::Well));
    const IndexImage& all = view.picture.image();
    const double share = std::min((area.width - 8.0) / all.width, (area.height - 8.0) / all.height);
    const int width = std::max(1, static_cast<int>(all.width * share));
    const int height = std::max(1, static_cast<int>(all.height * share));
    const int x = area.x + (area.width - width) / 2, y = area.y + (area.height - height) / 2;
    pen.paint.fit(all, {x, y, width, height});
    return pen.paint.frame({x - 1, y - 1, width + 2, height + 2}, pen(Cell::WellText));
  }
  const StageImage& image = imageOf(view, area, pen, false);
  pen.paint.place(image.image(), area.x, area.y);
  StagePen lines{pen, area, image};
  lines.volume(image.volume(), false);
  if (view.story.of(view.stage).at.w > 0.0) lines.dot(vertexAt(view), 1, Cell::White);
}

namespace {

constexpr double kEndOn = 0.1;   // of an axis' length: what is seen shorter cannot be aimed at
constexpr double kAside = 30.0;  // units from PRP to the handles that move it along u and v

/// The view when one number of a handle has grown.
ViewSpec grown(ViewSpec view, ViewHandle handle, double by) {
  switch (handle) {
    case ViewHandle::Vrp:
      break;
    case ViewHandle::PrpU:
      view.prp.x += by;
      break;
    case ViewHandle::PrpV:
      view.prp.y += by;
      break;
    case ViewHandle::PrpN:
      view.prp.z += by;
      break;
    case ViewHandle::Front:
      view.front += by;
      break;
    case ViewHandle::Back:
      view.back += by;
      break;
    case ViewHandle::Umin:
      view.windowMin.x += by;
      break;
    case ViewHandle::Umax:
      view.windowMax.x += by;
      break;
    case ViewHandle::Vmin:
      view.windowMin.y += by;
      break;
    case ViewHandle::Vmax:
      view.windowMax.y += by;
      break;
  }
  return view;
}

/// The place of a handle in a volume: planes have it at a corner, and the window's edges in their middle.
glm::dvec3 placeIn(const StageVolume& volume, ViewHandle handle, const glm::dvec3& vrp) {
  const auto edge = [&](std::size_t a, std::size_t b) { return (volume.window[a] + volume.window[b]) / 2.0; };
  switch (handle) {
    case ViewHandle::Vrp:
      return vrp;
    case ViewHandle::PrpU:
    case ViewHandle::PrpV:
    case ViewHandle::PrpN:
      return volume.eye.value_or(vrp);
    case ViewHandle::Front:
      return volume.front[3];
    case ViewHandle::Back:
      return volume.back[3];
    case ViewHandle::Umin:
      return edge(0, 3);
    case ViewHandle::Umax:
      return edge(1, 2);
    case ViewHandle::Vmin:
      return edge(0, 1);
    case ViewHandle::Vmax:
      return edge(2, 3);
  }
  return vrp;
}

/// The longest of 1, 2 and 5 times a power of ten that is not above `most`.
double tidyStep(double most) {
  const double ten = std::pow(10.0, std::floor(std::log10(most)));
  for (const double times : {5.0, 2.0})
    if (times * ten <= most) return times * ten;
  return ten;
}

const Control* numberOf(const Controls& controls, ViewHandle handle, int k) {
  const ViewHandleRow& row = rowOf(handle);
  const auto at = std::ranges::find(controls, ControlId{row.number.key, row.number.part + k}, &Control::id);
  return at == controls.end() ? nullptr : &*at;
}

}  // namespace

std::vector<HandleAt> handlesAt(const ViewingStory& story, const ViewSpec& view, ViewStage stage,
                                const StageImage& image, double shownUnit, int scale) {
  std::vector<HandleAt> handles;
  const OutsideCamera& camera = image.camera();
  const auto onImage = [&](const glm::dvec3& p) { return glm::dvec2{camera(p)}; };
  const auto inside = [size = glm::dvec2{image.image().width, image.image().height}](const glm::dvec2& p,
                                                                                     double band) {
    return p.x >= 0.0 && p.y >= band && p.x < size.x && p.y < size.y - band;
  };
  const StageVolume volume = volumeAt(story, view, stage);
  for (const ViewHandleRow& row : kViewHandles) {
    if (stage > row.last) continue;
    const glm::dvec3 place = placeIn(volume, row.id, view.vrp);
    HandleAt handle{.id = row.id, .at = onImage(place), .along = {}, .pace = camera.scale * shownUnit};
    if (row.numbers == 3) {
      for (int k = 0; k < 3; ++k) {
        glm::dvec3 step{0.0};
        step[k] = shownUnit;
        handle.along[static_cast<std::size_t>(k)] = onImage(place + step) - handle.at;
      }
    } else {
      // All maps up to the shear are affine, so the way is the same from everywhere.
      const glm::dvec3 next =
          placeIn(volumeAt(story, grown(view, row.id, shownUnit), stage), row.id, view.vrp);
      handle.along[0] = onImage(next) - handle.at;
      const double length = camera.scale * glm::length(next - place);
      handle.pace = glm::length(handle.along[0]);
      if (!(handle.pace > kEndOn * length)) continue;
      if (row.id == ViewHandle::PrpU || row.id == ViewHandle::PrpV) {
        const glm::dvec2 aside = handle.along[0] / handle.pace * (kAside * scale);
        handle.at += inside(handle.at + aside, kWordBand * scale) ? aside : -aside;
      }
    }
    if (inside(handle.at, 0.0)) handles.push_back(handle);
  }
  return handles;
}

HandleDrag::HandleDrag(const HandleAt& handle, const OutsideCamera& camera, const Controls& controls,
                       glm::ivec2 pointer, int scale)
    : handle_{handle}, camera_{camera}, from_{pointer}, scale_{scale} {
  for (int k = 0; k < rowOf(id()).numbers; ++k)
    if (const Control* const number = numberOf(controls, id(), k))
      begun_[static_cast<std::size_t>(k)] = number->value;
}

void HandleDrag::to(glm::ivec2 pointer, const Controls& controls, const Host& host) {
  moved_ = moved_ || pointer != from_;
  if (!moved_) return;
  const glm::dvec2 moved = glm::dvec2{pointer - from_} * double(scale_);
  for (int k = 0; k < rowOf(id()).numbers; ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (const Control* const number = numberOf(controls, id(), k))
      set(*number, begun_[at] + glm::dot(handle_.along[at], moved) / (handle_.pace * handle_.pace), host);
  }
}

void HandleDrag::set(const Control& number, double wanted, const Host& host) const {
  const double digits = std::pow(10.0, number.range.decimals);
  const double step = std::max(tidyStep(scale_ / handle_.pace), 1.0 / digits);
  const auto valueOf = [&](double steps) { return std::round(steps * step * digits) / digits; };
  const auto takes = [&](double steps) {
    const Setup before = host.setup();
    number.set(valueOf(steps));
    return host.setup() != before;
  };
  if (number.kind == Control::Kind::Number) wanted = std::clamp(wanted, number.range.low, number.range.high);
  double bad = std::round(wanted / step), good = std::round(number.value / step);
  if (valueOf(bad) == number.value || takes(bad)) return;
  // It was refused. What is a view lies between two ends, so halving finds the last step that is one.
  while (std::abs(bad - good) > 1.0) {
    const double middle = std::trunc((good + bad) / 2.0);
    (takes(middle) ? good : bad) = middle;
  }
}

}  // namespace xnewell
