#include "x11/window/control_column.h"

#include <algorithm>
#include <cmath>

#include "geometry/exact/trig.h"
#include "shading/light/equation.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

using Kind = Control::Kind;

constexpr int kName = 24;  // units from the left edge of a row to the name
constexpr int kButton = 20;
constexpr std::string_view kForBeginners = "lsnSO";

Section sectionOf(char key) {
  if (const Setting* const setting = settingOf(key)) return setting->section;
  return key == 'W' || key == 'P' ? Section::Method : Section::Hidden;
}

int onBar(const Rect& bar, double value) {
  return bar.x + static_cast<int>(std::lround(value * (bar.width - 1)));
}

/// Places the controls, from the top of the column to the bottom.
class Walk {
 public:
  Walk(const Layout& at, const Controls& controls, glm::dvec2 thumbs, int pitch, bool forBeginners)
      : controls_{controls},
        thumbs_{thumbs},
        forBeginners_{forBeginners},
        low_{at.low},
        x_{at.controls.x},
        y_{at.controls.y + 11} {
    column_.compact = at.compact;
    column_.area = at.controls;
    row_.pitch = pitch;
    row_.boxAfterKey = true;
  }

  ControlColumn column() && {
    light();
    heading("SURFACE", 20);
    rows(Section::Surface, {Kind::Toggle, Kind::Slider, Kind::Choice});
    heading("METHOD", 22);
    rows(Section::Method, {Kind::Toggle, Kind::Choice});
    if (!forBeginners_) heading("COLOUR TABLE", 22);
    rows(Section::ColourTable, {Kind::Toggle, Kind::Choice, Kind::Slider});
    buttons();
    return std::move(column_);
  }

 private:
  void add(const Control& control, ControlPlace place) {
    column_.places.emplace_back(control.id(), std::move(place));
  }

  void light() {
    const bool compact = column_.compact;
    const int size = compact ? 112 : 152;
    column_.ball = {x_ + kControls - size, column_.area.y, size, compact ? 78 : 128};
    column_.radius = column_.ball.height * 54 / 128;
    column_.headings.push_back({y_, "LIGHT"});
    y_ += compact ? 19 : 24;
    RowStyle narrow = row_;
    narrow.width = column_.ball.x - kMargin - x_;
    for (const Control& control : controls_)
      if (control.id() == ControlId{'l'})
        add(control, {.x = x_,
                      .y = y_,
                      .area = {x_, y_ - 14, narrow.width, compact ? 18 : 58},
                      .grip = column_.ball,
                      .bare = true});
    y_ += compact ? 19 : 61;
    narrow.pitch = compact ? 20 : 22;
    rows(Section::Light, {Kind::Toggle}, narrow);
    y_ += compact ? 7 : 11;
    if (forBeginners_) {
      y_ = std::max(y_, column_.ball.y + column_.ball.height + 24);
    } else {
      intensities();
      y_ += compact ? 35 : 44;
    }
    rows(Section::Light, {Kind::Slider, Kind::Choice});
  }

  /// The part of the bar that is nearer to a thumb drags this thumb. If both are at one place, the left side
  /// belongs to Ia and the right side to Ip.
  void intensities() {
    const Rect bar = column_.bar = {x_, y_ + 9, kControls, 10};
    const int ia = onBar(bar, thumbs_.x), sum = onBar(bar, std::min(1.0, thumbs_.y));
    const bool atEnd = ia == bar.x + bar.width - 1;
    const int border = atEnd ? bar.x + bar.width : (ia + sum + 1) / 2;
    const Rect reach{bar.x, bar.y - 4, bar.width, bar.height + 8};
    for (const Control& control : controls_) {
      const bool first = control.key == 'i';
      if (!first && control.key != 'p') continue;
      const int left = first ? bar.x : border, right = first ? border : bar.x + bar.width;
      const int name = first ? x_ : x_ + kControls / 2;
      add(control, {.x = x_,
                    .y = y_,
                    .area = {name, y_ - 14, kControls / 2, 15},
                    .track = bar,
                    .grip = {left, reach.y, right - left, reach.height},
                    .bare = true});
    }
  }

  void heading(std::string_view name, int advance) {
    y_ += low_ ? 4 : column_.compact ? 5 : 8;
    column_.headings.push_back({y_, name});
    y_ += low_ ? 17 : column_.compact ? 18 : advance;
  }

  /// A row for each control of a section that has no place yet.
  void rows(Section section, std::initializer_list<Kind> kinds) { rows(section, kinds, row_); }
  void rows(Section section, std::initializer_list<Kind> kinds, const RowStyle& style) {
    for (const Kind kind : kinds)
      for (const Control& control : controls_) {
        if (low_ && control.key == 'R') continue;  // no room: the status line shows it
        // The crease angle stands beside the normals.
        const bool among = control.kind == kind || (section == Section::Method && kind == Kind::Choice &&
                                                    control.kind == Kind::Slider);
        if (!among || sectionOf(control.key) != section || has(control)) continue;
        if (forBeginners_ && kForBeginners.find(control.key) == kForBeginners.npos) continue;
        ControlPlace place = placeInRow(control, x_, y_, style);
        y_ += place.area.height;
        add(control, std::move(place));
      }
  }
  [[nodiscard]] bool has(const Control& control) const {
    return std::ranges::any_of(column_.places, [&](const auto& one) { return one.first == control.id(); });
  }

  void buttons() {
    y_ += low_ ? 6 : column_.compact ? 3 : 4;
    const int inRow = column_.compact ? 5 : 4, width = column_.compact ? 58 : 68;
    const int pitch = (kControls - width) / (inRow - 1);
    int placed = 0;
    for (const Control& control : controls_) {
      const auto* const row = std::ranges::find(kButtons, control.key, &ButtonRow::key);
      if (control.kind != Kind::Button || control.key == 0) continue;
      if ((column_.compact || forBeginners_) && !row->always) continue;
      const int x = x_ + pitch * (placed % inRow);
      const Rect box{x, y_ - 14, width, column_.compact ? kButton - 2 : kButton};
      add(control, {.x = x, .y = y_, .area = box, .box = box});
      if (++placed % inRow == 0) y_ += kButton + 4;
    }
  }

  const Controls& controls_;
  glm::dvec2 thumbs_;
  bool forBeginners_;
  ControlColumn column_;
  RowStyle row_;
  bool low_;
  int x_, y_;
};

/// Draws the ball of the light and the bar of the intensities.
struct LightPen : Pen {
  const ControlColumn& at;
  const LightShown& shown;

  [[nodiscard]] const ControlPlace& place(char key) const {
    const auto found =
        std::ranges::find(at.places, ControlId{key}, &std::pair<ControlId, ControlPlace>::first);
    return found->second;
  }
  void light();
  void ball();
  void ring(const Light& lamp);
  void intensities();
  void thumb(int x, const Rect& bar, const Look& look);
};

std::string withDegree(double degrees) { return fixed(degrees, 0) + "\u00B0"; }

void LightPen::light() {
  const ControlPlace& place = this->place('l');
  const Rect& row = place.area;
  if (shown.light.focused) drawFocus(*this, {row.x, row.y, row.width, at.compact ? 18 : 58}, 2);
  const int x = place.x, y = place.y, end = row.x + row.width;
  key(x, y - 11, "l");
  const Light& lamp = shown.lamps[shown.lamp];
  const std::size_t count = shown.lamps.size();
  const std::string which = std::to_string(shown.lamp + 1) + " of " + std::to_string(count);
  if (at.compact) {
    const std::string angles =
        withDegree(shown.angles.azimuth) + " elev. " + withDegree(shown.angles.elevation);
    ink(x + kName, y, (count > 1 ? which + ", " : "azimuth ") + angles);
    return;
  }
  ink(x + kName, y, "azimuth");
  boldRight(end, y, withDegree(shown.angles.azimuth));
  ink(x + kName, y + 18, "elevation");
  boldRight(end, y + 18, withDegree(shown.angles.elevation));
  ink(x + kName, y + 36, count > 1 ? which : "distance");
  boldRight(end, y + 36,
            lamp.kind == LightKind::Directional ? "far"
            : lamp.kind == LightKind::Point     ? "near"
                                                : "spot " + withDegree(lamp.outer));
}

/// Draws a sphere with the current material, form and table, in the light of all lights. A ring marks each,
/// so that the user can see L, and two lines the cone of a spot.
void LightPen::ball() {
  paint.fillRect(at.ball, (*this)(Cell::Well));
  const int radius = at.radius, cx = at.ball.x + at.ball.width / 2, cy = at.ball.y + at.ball.height / 2;
  paint.hline(cx - radius - 5, cy, 2 * radius + 11, (*this)(Cell::WellLine));
  paint.vline(cx, cy - radius - 5, 2 * radius + 11, (*this)(Cell::WellLine));
  const Illumination& light = shown.setup.picture.light;
  const glm::dvec3 V{0, 0, 1};
  const Reflection surface{light.ka, light.kd, light.ks, light.n};
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x) {
      const double rest = static_cast<double>(radius) * radius - x * x - y * y;
      if (rest < 0) continue;
      const glm::dvec3 N = glm::dvec3{x, -y, std::sqrt(rest)} / static_cast<double>(radius);
      double I = rowOf(light.mistake).ambient * shown.ambient * light.ka;
      for (const Light& lamp : shown.lamps) {
        // A light at a place is never inside the ball, which is as large as the scene.
        const bool placed = lamp.kind != LightKind::Directional;
        const double away = glm::length(lamp.position);
        const glm::dvec3 to =
            placed ? lamp.position - std::min(shown.size / 2, 0.8 * away) * N : lamp.direction;
        const glm::dvec3 L = unit(to);
        const double f = placed ? attenuation(lamp, glm::length(to), shown.unit) *
                                      (lamp.kind == LightKind::Spot ? spotShare(lamp, L) : 1.0)
                                : 1.0;
        const LightTerms terms =
            lightTerms(light.mistake, f, largest(lamp.Ip), surface, {N, L, V}, light.form);
        I += terms.diffuse + terms.specular;
      }
      const auto k = static_cast<std::size_t>(255.0 * std::clamp(I, 0.0, 1.0) + 0.5);
      const bool high = bayerRank(x & 7, y & 7) < shown.ball.share[k];
      paint.point(cx + x, cy + y, (high ? shown.ball.high : shown.ball.low)[k]);
    }
  paint.ring(cx, cy, radius + 1, (*this)(Cell::WellLine));  // dark shades are as dark as the background
  for (const Light& lamp : shown.lamps) ring(lamp);
  if (at.bar.empty()) return;  // for beginners
  const int y = at.headings.front().y;
  int x = at.area.x + 52;
  x = soft(x + key(x, y - 11, "A") + 4, y, "new") + 12;
  if (shown.lamps.size() > 1) soft(x + key(x, y - 11, "X") + 4, y, "off");
}

void LightPen::ring(const Light& lamp) {
  const glm::ivec2 to = ringOf(at, lamp);
  const glm::dvec3 L = towardsLight(lamp, glm::dvec3{0});
  const bool behind = L.z < 0, chosen = &lamp == &shown.lamps[shown.lamp];
  const std::uint8_t cell = (*this)(behind ? Cell::Faint : Cell::White);
  if (lamp.kind == LightKind::Spot) {
    const glm::dvec3 axis = unit(lamp.direction);
    const double long_ = std::max(8.0, 0.6 * at.radius * std::hypot(axis.x, axis.y));
    const SinCos half = sinCosDegrees(std::min(lamp.outer, 80.0));
    const double along = std::atan2(-axis.y, axis.x);
    const glm::dvec2 a{std::cos(along), std::sin(along)};
    for (const double side : {-half.sin, half.sin}) {
      const glm::dvec2 edge = long_ * glm::dvec2{half.cos * a.x - side * a.y, half.cos * a.y + side * a.x};
      paint.line(to.x, to.y, to.x + static_cast<int>(edge.x), to.y + static_cast<int>(edge.y), cell);
    }
  }
  paint.ring(to.x, to.y, 5, cell);
  if (chosen && !behind) paint.disc(to.x, to.y, 1, cell);
  if (chosen && behind)
    paint.text(at.ball.x + 5, at.ball.y + at.ball.height - 6, "behind", (*this)(Cell::Faint));
  if (shown.lamps.size() < 2) return;
  const std::string Ip = fixed(largest(lamp.Ip), 2);
  const int x = to.x + 8 + textWidth(Ip) > at.ball.x + at.ball.width ? to.x - 8 - textWidth(Ip) : to.x + 8;
  const int y = std::clamp(to.y + 4, at.ball.y + 11, at.ball.y + at.ball.height - 3);
  paint.fillRect({x - 1, y - 10, textWidth(Ip) + 2, 13}, (*this)(Cell::Well));
  paint.text(x, y, Ip, cell);
}

void LightPen::thumb(int x, const Rect& bar, const Look& look) {
  const Rect box{std::clamp(x - 4, bar.x, bar.x + bar.width - 9), bar.y - 2, 9, 15};
  paint.fillRect(box, (*this)(look.dragged ? Cell::Ink : look.hovered ? Cell::White : Cell::Paper));
  paint.frame(box, (*this)(Cell::Ink));
  paint.vline(box.x + 4, box.y + 4, 7, (*this)(look.dragged ? Cell::White : Cell::Ink));
}

/// Draws one bar of length 1: ambient light dark, point light dotted, the rest unused.
void LightPen::intensities() {
  const bool several = shown.lamps.size() > 1;
  const int x = place('i').x, y = place('i').y;
  if (shown.Ia.focused || shown.Ip.focused) drawFocus(*this, {x, y - 14, kControls, at.compact ? 37 : 44}, 6);
  key(x, y - 11, "i");
  const auto number = [&](int from, std::string_view name, double value, bool off) {
    const Cell cell = off ? Cell::Faint : Cell::Ink;
    paint.text(paint.text(from, y, name, (*this)(cell)), y, fixed(value, 2), (*this)(cell), Voice::Bold);
  };
  number(x + 24, "Ia ", shown.ambient, shown.IaIsOwn);
  key(x + 124, y - 11, "p");
  number(x + 146, several ? "Ip " + std::to_string(shown.lamp + 1) + " " : "Ip ",
         several ? largest(shown.lamps[shown.lamp].Ip) : shown.lights, false);
  const double unused = std::max(0.0, 1.0 - shown.ambient - shown.lights);
  paint.textRight(x + kControls, y, "unused " + fixed(unused, 2), (*this)(Cell::Soft));

  const Rect& bar = at.bar;
  const int ia = onBar(bar, shown.ambient), sum = onBar(bar, std::min(1.0, shown.ambient + shown.lights));
  paint.fillRect(bar, (*this)(Cell::Panel));
  paint.fillRect({ia, bar.y, sum - ia, bar.height}, (*this)(Cell::Rule));
  paint.stipple({ia, bar.y, sum - ia, bar.height}, Stipple::Quarter, (*this)(Cell::Soft));
  paint.fillRect({x, bar.y, ia - x, bar.height}, (*this)(Cell::Soft));
  paint.frame(bar, (*this)(Cell::Faint));
  for (int quarter = 0; quarter <= 4; ++quarter)
    paint.vline(onBar(bar, quarter / 4.0), bar.y + 13, 3, (*this)(Cell::Faint));
  if (!shown.IaIsOwn) thumb(ia, bar, shown.Ia);
  thumb(sum, bar, shown.Ip);
}

}  // namespace

Controls buttonControls(const std::function<void(char)>& press) {
  Controls all;
  for (const ButtonRow& row : kButtons)
    all.push_back({.kind = Kind::Button,
                   .key = row.key,
                   .label = std::string{row.label},
                   .set = [press, key = row.key](double) { press(key); }});
  return all;
}

ControlColumn layoutOfControls(const Layout& at, const Controls& controls, glm::dvec2 thumbs,
                               bool forBeginners) {
  constexpr int kLeastPitch = 13;  // the height of the text
  constexpr int kBelow = 4;        // units between the last button and the strip of colours
  for (int pitch = at.compact ? 17 : 21;; --pitch) {
    ControlColumn column = Walk{at, controls, thumbs, pitch, forBeginners}.column();
    const Rect& last = column.places.back().second.area;
    const int bottom = at.controls.y + at.controls.height - kBelow;
    if (pitch == kLeastPitch || last.y + last.height <= bottom) return column;
  }
}

void drawLightControls(Pen& pen, const ControlColumn& at, const LightShown& shown) {
  LightPen light{pen, at, shown};
  for (const ControlColumn::Heading& heading : at.headings) {
    if (&heading != &at.headings.front()) pen.rule(at.area.x, heading.y - 16, kControls);
    pen.caps(at.area.x, heading.y, heading.name);
  }
  light.ball();
  light.light();
  if (!at.bar.empty()) light.intensities();
}

glm::ivec2 ringOf(const ControlColumn& at, const Light& lamp) {
  const glm::dvec3 L = towardsLight(lamp, glm::dvec3{0});
  return {at.ball.x + at.ball.width / 2 + static_cast<int>(std::lround(at.radius * L.x)),
          at.ball.y + at.ball.height / 2 - static_cast<int>(std::lround(at.radius * L.y))};
}

glm::dvec3 directionOnBall(const ControlColumn& at, int x, int y) {
  const double dx = x - (at.ball.x + at.ball.width / 2), dy = at.ball.y + at.ball.height / 2 - y;
  const double length = std::hypot(dx, dy), far = length / at.radius;
  if (length == 0) return {0, 0, 1};
  const double across = far <= 1 ? far : std::max(0.0, 2 - far), z = std::sqrt(1 - across * across);
  return {across * dx / length, across * dy / length, far <= 1 ? z : -z};
}

}  // namespace xnewell
