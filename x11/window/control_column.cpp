#include "x11/window/control_column.h"

#include <algorithm>
#include <cmath>

#include "shading/color/quantize.h"
#include "shading/light/equation.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/pen.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

using Kind = ControlPlace::Kind;

constexpr int kName = 24;  // pixels from the left edge of a row to the name
constexpr int kButton = 20;

/// Places the controls, from the top of the column to the bottom.
class Walk {
 public:
  Walk(const Layout& at, int pitch) : x_{at.controls.x}, y_{at.controls.y + 11}, pitch_{pitch} {
    column_.compact = at.compact;
    column_.area = at.controls;
  }

  ControlColumn column() && {
    light();
    section(Section::Surface, "SURFACE", 20);
    section(Section::Method, "METHOD", 22);
    section(Section::ColourTable, "COLOUR TABLE", 22);
    buttons();
    return std::move(column_);
  }

 private:
  void add(Kind kind, char key, const Rect& row, const Rect& track = {}, std::vector<Rect> options = {}) {
    column_.places.push_back({kind, key, x_, y_, row, track, std::move(options)});
  }
  [[nodiscard]] Rect row(int width = kControls) const { return {x_, y_ - 14, width, pitch_}; }

  void light() {
    const bool compact = column_.compact;
    const int size = compact ? 112 : 152;
    column_.ball = {x_ + kControls - size, column_.area.y, size, compact ? 78 : 128};
    column_.radius = column_.ball.height * 54 / 128;
    column_.headings.push_back({y_, "LIGHT"});
    y_ += compact ? 19 : 24;
    const int width = column_.ball.x - kMargin - x_;
    add(Kind::Light, 'l', {x_, y_ - 14, width, compact ? 18 : 58});
    y_ += compact ? 19 : 61;
    for (const ToggleRow& toggle : toggles()) {
      add(Kind::Toggle, toggle.key, row(width));
      y_ += compact ? 20 : 22;
    }
    y_ += compact ? 7 : 11;
    const Rect bar{x_, y_ + 9, kControls, 10};
    add(Kind::Intensity, 'i', {x_, y_ - 14, kControls / 2, 23}, bar);
    add(Kind::Intensity, 'p', {x_ + kControls / 2, y_ - 14, kControls - kControls / 2, 23}, bar);
    y_ += compact ? 35 : 44;
  }

  void section(Section section, std::string_view name, int advance) {
    y_ += column_.compact ? 5 : 8;
    column_.headings.push_back({y_, name});
    y_ += column_.compact ? 18 : advance;
    const auto addSliders = [&] {
      for (const SliderRow& slider : sliders())
        if (slider.section == section) {
          add(Kind::Slider, slider.key, row(), {x_ + kColumnTrackAt, y_ - 5, kColumnTrack + 1, 2});
          y_ += pitch_;
        }
    };
    if (section != Section::ColourTable) addSliders();
    for (const ChoiceRow& choice : choices())
      if (choice.section == section) {
        std::vector<Rect> frames = optionFrames(choice.options, x_ + kColumnTrackAt, y_,
                                                kControls - kColumnTrackAt, std::min(19, pitch_));
        const int more = frames.back().y - frames.front().y;  // if they need a second line
        Rect area = row();
        area.height += more;
        add(Kind::Choice, choice.key, area, {}, std::move(frames));
        y_ += pitch_ + more;
      }
    if (section == Section::ColourTable) addSliders();
  }

  void buttons() {
    y_ += column_.compact ? 3 : 4;
    const int left = x_;
    int placed = 0;
    for (const ButtonRow& button : kButtons) {
      if (column_.compact && !button.always) continue;
      x_ = left + 84 * (placed % 4);
      add(Kind::Button, button.key, {x_, y_ - 14, 68, column_.compact ? kButton - 2 : kButton});
      if (++placed % 4 == 0) y_ += kButton + 4;
    }
    x_ = left;
  }

  ControlColumn column_;
  int x_, y_, pitch_;
};

/// Draws the controls, one function for each kind.
struct ColumnPen : Pen {
  const ControlColumn& at;
  const ControlsShown& shown;

  [[nodiscard]] bool hovered(char key) const { return shown.hover && shown.hover->key == key; }

  void slider(const ControlPlace& place);
  void choice(const ControlPlace& place);
  void toggle(const ControlPlace& place);
  void light(const ControlPlace& place);
  void ball();
  void intensities(const ControlPlace& place);
  void thumb(int x, const Rect& bar, char key);
  void button(const ControlPlace& place);
};

void ColumnPen::slider(const ControlPlace& place) {
  const SliderRow& row = *sliderOf(place.key);
  const bool enabled = row.enabled(shown.setup);
  key(place.x, place.y - 11, std::string_view{&row.key, 1});
  paint.text(place.x + kName, place.y, row.label, (*this)(enabled ? Cell::Ink : Cell::Faint));
  drawTrack(*this, place.track.x, place.y, kColumnTrack,
            {.share = trackPosition(row, row.get(shown.setup)),
             .initially = trackPosition(row, row.get(shown.defaults)),
             .enabled = enabled,
             .hovered = hovered(row.key),
             .dragged = shown.dragged == row.key,
             .height = std::min(15, (place.row.height - 2) | 1)});  // thumbs of two rows stay apart
  const std::string value = fixed(row.get(shown.setup), row.decimals);
  if (enabled)
    boldRight(place.x + kControls, place.y, value);
  else
    paint.textRight(place.x + kControls, place.y, value, (*this)(Cell::Faint));
}

void ColumnPen::choice(const ControlPlace& place) {
  const ChoiceRow& row = *choiceOf(place.key);
  key(place.x, place.y - 11, std::string_view{&row.key, 1});
  ink(place.x + kName, place.y, row.label);
  drawOptions(*this, row.options, place.options, row.get(shown.setup),
              hovered(row.key) ? shown.hover->option : -1);
}

void ColumnPen::toggle(const ControlPlace& place) {
  const ToggleRow* const row = toggleOf(place.key);
  key(place.x, place.y - 11, std::string_view{&row->key, 1});
  const Rect box{place.x + kName, place.y - 10, 11, 11};
  paint.fillRect(box, (*this)(hovered(row->key) ? Cell::Panel : Cell::White));
  paint.frame(box, (*this)(Cell::Ink));
  if (row->get(shown.setup)) paint.tick(box.x + 2, box.y + 2, (*this)(Cell::Ink));
  ink(place.x + 41, place.y, row->label);
}

std::string withDegree(double degrees) { return fixed(degrees, 0) + "\u00B0"; }

void ColumnPen::light(const ControlPlace& place) {
  if (shown.focus == 'l') drawFocus(*this, {place.row.x, place.row.y, place.row.width, at.compact ? 18 : 40});
  const int x = place.x, y = place.y, end = place.row.x + place.row.width;
  key(x, y - 11, "l");
  if (shown.ownLights) {
    paint.text(x + kName, y, "the scene's own", (*this)(Cell::Faint));
    return;
  }
  if (at.compact) {
    ink(x + kName, y,
        "azimuth " + withDegree(shown.light.azimuth) + " elev. " + withDegree(shown.light.elevation));
    return;
  }
  ink(x + kName, y, "azimuth");
  boldRight(end, y, withDegree(shown.light.azimuth));
  ink(x + kName, y + 18, "elevation");
  boldRight(end, y + 18, withDegree(shown.light.elevation));
  ink(x + kName, y + 36, "distance");
  boldRight(end, y + 36, shown.setup.picture.light.lightPosition ? "near" : "far");
}

/// Draws a sphere with the current material, form and table. A ring marks the light, so that the user can see
/// L.
void ColumnPen::ball() {
  paint.fillRect(at.ball, (*this)(Cell::Well));
  const int radius = at.radius, cx = at.ball.x + at.ball.width / 2, cy = at.ball.y + at.ball.height / 2;
  if (shown.ownLights) {
    paint.text(cx - textWidth("the scene's") / 2, cy - 3, "the scene's", (*this)(Cell::WellText));
    paint.text(cx - textWidth("own lights") / 2, cy + 13, "own lights", (*this)(Cell::WellText));
    return;
  }
  paint.hline(cx - radius - 5, cy, 2 * radius + 11, (*this)(Cell::WellLine));
  paint.vline(cx, cy - radius - 5, 2 * radius + 11, (*this)(Cell::WellLine));
  const Illumination& light = shown.setup.picture.light;
  const glm::dvec3& L = shown.lightInView;
  const glm::dvec3 V{0, 0, 1};
  const Light source{.direction = L};
  const Reflection surface{light.ka, light.kd, light.ks, light.n};
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x) {
      const double rest = static_cast<double>(radius) * radius - x * x - y * y;
      if (rest < 0) continue;
      const glm::dvec3 N = glm::dvec3{x, -y, std::sqrt(rest)} / static_cast<double>(radius);
      const double I = illuminate(light.Ia, light.Ip, source, surface, N, V, N, light.form).I;
      const auto k = static_cast<std::size_t>(255.0 * std::min(1.0, I) + 0.5);
      const bool high = bayerRank(x & 7, y & 7) < shown.ball.share[k];
      paint.point(cx + x, cy + y, (high ? shown.ball.high : shown.ball.low)[k]);
    }
  const int lx = cx + static_cast<int>(std::lround(radius * L.x)),
            ly = cy - static_cast<int>(std::lround(radius * L.y));
  const bool behind = L.z < 0;
  paint.ring(lx, ly, 5, (*this)(behind ? Cell::Faint : Cell::White));
  if (!behind)
    paint.disc(lx, ly, 1, (*this)(Cell::White));
  else
    paint.text(at.ball.x + 5, at.ball.y + at.ball.height - 6, "behind", (*this)(Cell::Faint));
}

int onBar(const Rect& bar, double value) {
  return bar.x + static_cast<int>(std::lround(value * (bar.width - 1)));
}

void ColumnPen::thumb(int x, const Rect& bar, char key) {
  const Rect box{std::clamp(x - 4, bar.x, bar.x + bar.width - 9), bar.y - 2, 9, 15};
  const bool dragged = shown.dragged == key;
  paint.fillRect(box, (*this)(dragged ? Cell::Ink : hovered(key) ? Cell::White : Cell::Paper));
  paint.frame(box, (*this)(Cell::Ink));
  paint.vline(box.x + 4, box.y + 4, 7, (*this)(dragged ? Cell::White : Cell::Ink));
}

/// Draws one bar of length 1: ambient light dark, point light dotted, the rest unused. The bar belongs to the
/// control of Ia.
void ColumnPen::intensities(const ControlPlace& place) {
  const Illumination& light = shown.setup.picture.light;
  const int x = place.x, y = place.y;
  if (shown.focus == 'i' || shown.focus == 'p')
    drawFocus(*this, {x, y - 14, kControls, at.compact ? 37 : 44}, 6);
  key(x, y - 11, "i");
  bold(ink(x + 24, y, "Ia "), y, fixed(light.Ia, 2));
  key(x + 124, y - 11, "p");
  bold(ink(x + 146, y, "Ip "), y, fixed(light.Ip, 2));
  const double unused = std::max(0.0, 1.0 - light.Ia - light.Ip);
  paint.textRight(x + kControls, y, "unused " + fixed(unused, 2), (*this)(Cell::Soft));

  const Rect& bar = place.track;
  const int ia = onBar(bar, light.Ia), sum = onBar(bar, light.Ia + light.Ip);
  paint.fillRect(bar, (*this)(Cell::Panel));
  paint.fillRect({ia, bar.y, sum - ia, bar.height}, (*this)(Cell::Rule));
  paint.stipple({ia, bar.y, sum - ia, bar.height}, Stipple::Quarter, (*this)(Cell::Soft));
  paint.fillRect({x, bar.y, ia - x, bar.height}, (*this)(Cell::Soft));
  paint.frame(bar, (*this)(Cell::Faint));
  for (int quarter = 0; quarter <= 4; ++quarter)
    paint.vline(onBar(bar, quarter / 4.0), bar.y + 13, 3, (*this)(Cell::Faint));
  thumb(ia, bar, 'i');
  thumb(sum, bar, 'p');
}

void ColumnPen::button(const ControlPlace& place) {
  const auto* const row = std::ranges::find(kButtons, place.key, &ButtonRow::key);
  const Rect& box = place.row;
  const bool pressed = shown.dragged == row->key;
  paint.fillRect(box, (*this)(pressed ? Cell::Rule : hovered(row->key) ? Cell::White : Cell::Panel));
  paint.frame(box, (*this)(Cell::Faint));
  paint.hline(box.x + 1, box.y + box.height, box.width, (*this)(Cell::Rule));
  const int width = textWidth(row->label) + 12, x = box.x + (box.width - width) / 2;
  ink(x, place.y, row->label);
  soft(x + width - 6, place.y, std::string_view{&row->key, 1});
}

}  // namespace

const ControlPlace* ControlColumn::find(char key) const {
  const auto place = std::ranges::find(places, key, &ControlPlace::key);
  return place == places.end() ? nullptr : &*place;
}

ControlColumn layoutOfControls(const Layout& at) {
  constexpr int kLeastPitch = 13;  // the height of the text
  constexpr int kBelow = 4;        // pixels between the last button and the strip of colours
  for (int pitch = at.compact ? 17 : 21;; --pitch) {
    ControlColumn column = Walk{at, pitch}.column();
    const Rect& last = column.places.back().row;
    const int bottom = at.controls.y + at.controls.height - kBelow;
    if (pitch == kLeastPitch || last.y + last.height <= bottom) return column;
  }
}

std::optional<ControlHit> controlAt(const ControlColumn& at, const Setup& setup, int x, int y) {
  if (at.ball.has(x, y)) return ControlHit{'l'};
  for (const ControlPlace& place : at.places) {
    if (place.kind == Kind::Intensity) {
      const Rect& bar = place.track;
      if (!Rect{bar.x, bar.y - 4, bar.width, bar.height + 8}.has(x, y)) {
        if (place.row.has(x, y)) return ControlHit{place.key};
        continue;
      }
      // If both thumbs are at one place, the left side belongs to Ia and the right side to Ip.
      const Illumination& light = setup.picture.light;
      const int ia = onBar(bar, light.Ia), sum = onBar(bar, light.Ia + light.Ip);
      return ControlHit{2 * x < ia + sum || (2 * x == ia + sum && ia == bar.x + bar.width - 1) ? 'i' : 'p'};
    }
    for (std::size_t k = 0; k < place.options.size(); ++k)
      if (place.options[k].has(x, y)) return ControlHit{place.key, static_cast<int>(k)};
    if (place.row.has(x, y)) return ControlHit{place.key};
  }
  return std::nullopt;
}

void drawControls(IndexImage& image, const ControlColumn& at, const ControlsShown& shown,
                  const CellPlan& plan) {
  ColumnPen pen{{Painter{image}, plan}, at, shown};
  for (const ControlColumn::Heading& heading : at.headings) {
    if (&heading != &at.headings.front()) pen.rule(at.area.x, heading.y - 16, kControls);
    pen.paint.text(at.area.x, heading.y, heading.name, plan[Cell::Soft], Voice::Caps);
  }
  pen.ball();
  // The mark of the focus comes first: where rows are close, it must not cover the thumb of the row above.
  if (const ControlPlace* const place = at.find(shown.focus); place && place->kind == Kind::Slider)
    drawFocus(pen, place->row, 6);
  for (const ControlPlace& place : at.places) {
    switch (place.kind) {
      case Kind::Slider:
        pen.slider(place);
        break;
      case Kind::Choice:
        pen.choice(place);
        break;
      case Kind::Toggle:
        pen.toggle(place);
        break;
      case Kind::Light:
        pen.light(place);
        break;
      case Kind::Intensity:
        if (place.key == 'i') pen.intensities(place);
        break;
      case Kind::Button:
        pen.button(place);
        break;
    }
  }
}

glm::dvec3 directionOnBall(const ControlColumn& at, int x, int y) {
  const double dx = x - (at.ball.x + at.ball.width / 2), dy = at.ball.y + at.ball.height / 2 - y;
  const double length = std::hypot(dx, dy), far = length / at.radius;
  if (length == 0) return {0, 0, 1};
  const double across = far <= 1 ? far : std::max(0.0, 2 - far), z = std::sqrt(1 - across * across);
  return {across * dx / length, across * dy / length, far <= 1 ? z : -z};
}

}  // namespace xnewell
