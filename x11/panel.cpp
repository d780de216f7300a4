#include "x11/panel.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/power.h"

namespace {

constexpr std::string_view kNoRoom = "the controls need a window of 800 x 600";
constexpr int kMargin = 16, kControls = 320, kStatusHeight = 44, kStripHeight = 60, kViewsHeight = 32;

/// Draws into the image with the plan's cells: every part of the panel is one function of it.
struct Pen {
  Painter paint;
  const CellPlan& plan;
  const PanelState& state;

  [[nodiscard]] std::uint8_t operator()(Cell c) const { return plan[c]; }
  [[nodiscard]] KeyCapCells keyCells() const {
    return {plan[Cell::Panel], plan[Cell::Rule], plan[Cell::Faint], plan[Cell::Soft]};
  }
  int key(int x, int y, std::string_view name) { return paint.keyCap(x, y, name, keyCells()); }
  int arrow(int x, int y, Direction d) { return paint.keyCap(x, y, d, keyCells()); }
  int soft(int x, int y, std::string_view s) { return paint.text(x, y, s, plan[Cell::Soft]); }
  int ink(int x, int y, std::string_view s) { return paint.text(x, y, s, plan[Cell::Ink]); }
  int bold(int x, int y, std::string_view s) { return paint.text(x, y, s, plan[Cell::Ink], Voice::Bold); }
  void boldRight(int x, int y, std::string_view s) { paint.textRight(x, y, s, plan[Cell::Ink], Voice::Bold); }
  void rule(int x, int y, int width) { paint.hline(x, y, width, plan[Cell::Rule]); }
};

std::string_view chosen(const ChoiceRow& row, const Setup& setup) { return row.options[row.get(setup)]; }

const ChoiceRow& choice(char key) { return *std::ranges::find(choices(), key, &ChoiceRow::key); }

void drawViews(Pen& pen, const Layout& at) {
  pen.paint.fillRect(at.views, pen(Cell::Panel));
  pen.rule(0, at.views.height, at.width);
  int x = 6;
  for (const WindowViewRow& row : kWindowViews) {
    const Rect tab{x, 5, 36 + textWidth(row.name), at.views.height - 4};
    const bool shown = row.id == pen.state.view;
    if (shown) {
      pen.paint.fillRect(tab, pen(Cell::Paper));
      pen.paint.fillRect({tab.x, tab.y, tab.width, 2}, pen(Cell::Ink));
      for (const int edge : {tab.x, tab.x + tab.width - 1})
        pen.paint.vline(edge, tab.y, at.views.height - tab.y, pen(Cell::Rule));
    }
    pen.soft(x + 9, 23, std::string_view{&row.key, 1});
    pen.paint.text(x + 24, 23, row.name, pen(shown ? Cell::Ink : Cell::Soft),
                   shown ? Voice::Bold : Voice::Plain);
    x += tab.width + 4;
  }
  // A long name keeps its end, which tells files apart.
  std::string title = pen.state.sceneTitle;
  const auto room = static_cast<std::size_t>(at.width - 2 * kMargin - x) / 6;
  if (title.size() > room) title = "..." + title.substr(title.size() - room + 3);
  pen.paint.textRight(at.width - kMargin, 23, title, pen(Cell::Soft));
}

void drawTrack(Pen& pen, const SliderRow& row, int x, int y, bool enabled) {
  constexpr int kTrack = 168;
  const auto place = [&](double v) {
    return x + static_cast<int>(std::lround(trackPosition(row, v) * kTrack));
  };
  const int thumb = place(row.get(pen.state.setup)), middle = y - 4;
  const std::uint8_t strong = pen(enabled ? Cell::Soft : Cell::Rule);
  pen.paint.fillRect({x, middle - 1, kTrack, 2}, pen(Cell::Rule));
  pen.paint.fillRect({x, middle - 1, thumb - x, 2}, strong);
  for (int quarter = 0; quarter <= 4; ++quarter)
    pen.paint.vline(x + quarter * kTrack / 4, middle + 7, 2, pen(Cell::Faint));
  if (enabled)
    pen.paint.triangle(place(row.get(pen.state.defaults)) - 2, middle - 8, 3, Direction::Down,
                       pen(Cell::Faint));
  const Rect box{thumb - 4, middle - 7, 9, 15};
  pen.paint.fillRect(box, pen(enabled ? Cell::Paper : Cell::Panel));
  pen.paint.frame(box, pen(enabled ? Cell::Ink : Cell::Faint));
  if (!enabled) return;
  pen.paint.vline(box.x + 7, box.y + 1, 13, pen(Cell::Rule));
  pen.paint.vline(thumb, middle - 3, 7, pen(Cell::Ink));
}

/// The row that has the keyboard stands on its own colour with an ink bar before it.
void drawFocus(Pen& pen, char key, int x, int y, int pitch) {
  if (pen.state.focus != key) return;
  pen.paint.fillRect({x - 2, y - 14, kControls + 8, pitch}, pen(Cell::Focus));
  pen.paint.fillRect({x - 6, y - 14, 2, pitch}, pen(Cell::Ink));
}

void drawSlider(Pen& pen, const SliderRow& row, int x, int y, int pitch) {
  drawFocus(pen, row.key, x, y, pitch);
  const bool enabled = row.enabled(pen.state.setup);
  pen.key(x, y - 11, std::string_view{&row.key, 1});
  pen.paint.text(x + 24, y, row.label, pen(enabled ? Cell::Ink : Cell::Faint));
  drawTrack(pen, row, x + 84, y, enabled);
  const std::string value = formatted(row.get(pen.state.setup), row.decimals);
  if (enabled)
    pen.boldRight(x + kControls, y, value);
  else
    pen.paint.textRight(x + kControls, y, value, pen(Cell::Faint));
}

void drawChoice(Pen& pen, const ChoiceRow& row, int x, int y) {
  pen.key(x, y - 11, std::string_view{&row.key, 1});
  pen.ink(x + 24, y, row.label);
  int at = x + 84, words = 0;
  for (const std::string_view option : row.options) words += textWidth(option);
  const int between = static_cast<int>(row.options.size()) - 1;
  const int gap = std::min(14, (kControls - 84 - words) / std::max(1, between));
  for (int i = 0; i < static_cast<int>(row.options.size()); ++i) {
    const int width = textWidth(row.options[i]);
    if (i == row.get(pen.state.setup)) {
      const Rect box{at - 6, y - 14, width + 13, 19};
      pen.paint.fillRect(box, pen(Cell::White));
      pen.paint.frame(box, pen(Cell::Ink));
      pen.bold(at, y, row.options[i]);
    } else {
      pen.soft(at, y, row.options[i]);
    }
    at += width + gap;
  }
}

void drawToggle(Pen& pen, const ToggleRow& row, int x, int y) {
  pen.key(x, y - 11, std::string_view{&row.key, 1});
  const Rect box{x + 24, y - 10, 11, 11};
  pen.paint.fillRect(box, pen(Cell::White));
  pen.paint.frame(box, pen(Cell::Ink));
  if (pen.state.setup.picture.light.*row.value) pen.paint.tick(box.x + 2, box.y + 2, pen(Cell::Ink));
  pen.ink(x + 41, y, row.label);
}

/// A sphere with the present material in the present table, the light marked by a ring: L is read off it.
void drawLightBall(Pen& pen, const Rect& box) {
  pen.paint.fillRect(box, pen(Cell::Well));
  const int radius = box.height * 54 / 128, cx = box.x + box.width / 2, cy = box.y + box.height / 2;
  pen.paint.hline(cx - radius - 5, cy, 2 * radius + 11, pen(Cell::WellLine));
  pen.paint.vline(cx, cy - radius - 5, 2 * radius + 11, pen(Cell::WellLine));
  const Illumination& light = pen.state.setup.picture.light;
  const glm::dvec3& L = pen.state.lightInView;
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x) {
      const double rest = static_cast<double>(radius) * radius - x * x - y * y;
      if (rest < 0) continue;
      const glm::dvec3 N = glm::dvec3{x, -y, std::sqrt(rest)} / static_cast<double>(radius);
      const double NdotL = glm::dot(N, L), RdotV = 2 * NdotL * N.z - L.z;
      const double lit =
          NdotL <= 0 ? 0.0 : light.kd * NdotL + light.ks * power(std::clamp(RdotV, 0.0, 1.0), light.n);
      pen.paint.point(cx + x, cy + y,
                      pen.state.ball[static_cast<std::size_t>(
                          255.0 * std::min(1.0, light.ka * light.Ia + light.Ip * lit) + 0.5)]);
    }
  const int lx = cx + static_cast<int>(std::lround(radius * L.x)),
            ly = cy - static_cast<int>(std::lround(radius * L.y));
  pen.paint.ring(lx, ly, 5, pen(Cell::White));
  if (L.z < 0)
    pen.paint.point(lx, ly, pen(Cell::White));  // behind the sphere
  else
    pen.paint.disc(lx, ly, 1, pen(Cell::White));
}

/// One bar of length 1: ambient dark, point dotted, the rest unused.
void drawIntensities(Pen& pen, int x, int y) {
  const Illumination& light = pen.state.setup.picture.light;
  for (const char key : {'i', 'p'})
    if (pen.state.focus == key) {
      pen.paint.fillRect({x - 2, y - 14, kControls + 8, 44}, pen(Cell::Focus));
      pen.paint.fillRect({x - 6, y - 14, 2, 44}, pen(Cell::Ink));
    }
  pen.key(x, y - 11, "i");
  pen.bold(pen.ink(x + 24, y, "Ia "), y, formatted(light.Ia, 2));
  pen.key(x + 124, y - 11, "p");
  pen.bold(pen.ink(x + 146, y, "Ip "), y, formatted(light.Ip, 2));
  const double unused = std::max(0.0, 1.0 - light.Ia - light.Ip);
  pen.paint.textRight(x + kControls, y, "unused " + formatted(unused, 2), pen(Cell::Soft));

  const auto place = [&](double v) { return x + static_cast<int>(std::lround(v * (kControls - 1))); };
  const Rect bar{x, y + 9, kControls, 10};
  const int ia = place(light.Ia), sum = place(light.Ia + light.Ip);
  pen.paint.fillRect(bar, pen(Cell::Panel));
  pen.paint.fillRect({ia, bar.y, sum - ia, bar.height}, pen(Cell::Rule));
  pen.paint.stipple({ia, bar.y, sum - ia, bar.height}, Stipple::Quarter, pen(Cell::Soft));
  pen.paint.fillRect({x, bar.y, ia - x, bar.height}, pen(Cell::Soft));
  pen.paint.frame(bar, pen(Cell::Faint));
  for (int quarter = 0; quarter <= 4; ++quarter)
    pen.paint.vline(place(quarter / 4.0), bar.y + 13, 3, pen(Cell::Faint));
  for (const int thumb : {ia, sum}) {
    const Rect box{std::clamp(thumb - 4, x, x + kControls - 9), bar.y - 2, 9, 15};
    pen.paint.fillRect(box, pen(Cell::Paper));
    pen.paint.frame(box, pen(Cell::Ink));
    pen.paint.vline(box.x + 4, box.y + 4, 7, pen(Cell::Ink));
  }
}

std::string withDegree(double degrees) { return formatted(degrees, 0) + "\u00B0"; }

/// Walks down the column: the next baseline after `advance` pixels.
void drawControls(Pen& pen, const Layout& at) {
  const int x = at.controls.x, pitch = at.compact ? 18 : 22;
  int y = at.controls.y + 11;
  const auto section = [&](std::string_view title, bool boxed) {  // boxes of choices stand a little lower
    y += at.compact ? 5 : 8;
    pen.rule(x, y - 16, kControls);
    pen.paint.text(x, y, title, pen(Cell::Soft), Voice::Caps);
    y += at.compact ? 18 : boxed ? 22 : 20;
  };

  pen.paint.text(x, y, "LIGHT", pen(Cell::Soft), Voice::Caps);
  const Rect ball = at.compact ? Rect{x + kControls - 112, at.controls.y, 112, 78}
                               : Rect{x + kControls - 152, at.controls.y, 152, 128};
  drawLightBall(pen, ball);
  y += at.compact ? 19 : 24;
  const int valueEnd = ball.x - kMargin;
  if (pen.state.focus == 'l') {
    pen.paint.fillRect({x - 2, y - 14, valueEnd - x + 4, at.compact ? 18 : 40}, pen(Cell::Focus));
    pen.paint.fillRect({x - 6, y - 14, 2, at.compact ? 18 : 40}, pen(Cell::Ink));
  }
  pen.key(x, y - 11, "l");
  if (at.compact) {
    pen.ink(
        x + 24, y,
        "azimuth " + withDegree(pen.state.light.azimuth) + " elev. " + withDegree(pen.state.light.elevation));
    y += 19;
  } else {
    pen.ink(x + 24, y, "azimuth");
    pen.boldRight(valueEnd, y, withDegree(pen.state.light.azimuth));
    pen.ink(x + 24, y + 18, "elevation");
    pen.boldRight(valueEnd, y + 18, withDegree(pen.state.light.elevation));
    pen.ink(x + 24, y + 36, "distance");
    pen.boldRight(valueEnd, y + 36, pen.state.setup.picture.light.lightPosition ? "near" : "far");
    y += 61;
  }
  for (const ToggleRow& row : kToggles) {
    drawToggle(pen, row, x, y);
    y += at.compact ? 21 : 22;
  }
  y += at.compact ? 7 : 11;
  drawIntensities(pen, x, y);
  y += at.compact ? 36 : 45;

  const auto sliders = [&](Section s) {
    for (const SliderRow& row : kSliders)
      if (row.section == s) drawSlider(pen, row, x, y, pitch), y += pitch;
  };
  const auto rows = [&](Section s) {
    for (const ChoiceRow& row : choices())
      if (row.section == s) drawChoice(pen, row, x, y), y += pitch;
  };
  section("SURFACE", false);
  sliders(Section::Surface);
  section("METHOD", true);
  rows(Section::Method);
  section("COLOUR TABLE", true);
  rows(Section::ColourTable);
  sliders(Section::ColourTable);
}

void drawStatus(Pen& pen, const Layout& at) {
  pen.paint.fillRect(at.status, pen(Cell::Panel));
  pen.rule(0, at.status.y, at.width);
  const int y = at.status.y + 15, keys = at.status.y + 33;
  const PanelState& s = pen.state;
  if (!s.notice.empty()) {
    pen.paint.text(kMargin, y, s.notice, pen(Cell::Alarm));
  } else {
    const int end = pen.ink(kMargin, y, s.counts);
    if (!at.compact) pen.soft(end + 18, y, s.times);
  }
  pen.paint.textRight(at.width - kMargin, y, s.visual, pen(Cell::Soft));

  int x = kMargin;
  const auto legend = [&](std::initializer_list<std::string_view> names, std::string_view does) {
    int width = textWidth(does) + 12;
    for (const std::string_view name : names) width += std::max(kKeyCap, textWidth(name) + 9) + 2;
    if (x + width > at.width - kMargin) return;
    for (const std::string_view name : names) x += pen.key(x, keys - 11, name) + 2;
    x = pen.soft(x + 4, keys, does) + 12;
  };
  x += pen.arrow(x, keys - 11, Direction::Left) + 2;
  x += pen.arrow(x, keys - 11, Direction::Right) + (s.view == WindowView::Colors ? 2 : 6);
  if (s.view == WindowView::Colors) {
    x += pen.arrow(x, keys - 11, Direction::Up) + 2;
    x += pen.arrow(x, keys - 11, Direction::Down) + 6;
    x = pen.soft(x, keys, "cell") + 12;
    legend({"h"}, "light it up");
    const bool ramps = s.words.what == "shades";  // else there is no table to change
    if (ramps) {
      legend({"T"}, "table");
      legend({"j"}, "nearest");
      legend({"H"}, "hue");
      legend({"B"}, "bits");
    }
    legend({"g"}, "gamma");
    if (ramps) {
      legend({"i"}, "hold indices");
      legend({"m"}, "move the ramp");
    }
    legend({"Esc"}, "put back");
    legend({"?"}, "all keys");
    return;
  }
  const auto* const row = std::ranges::find(kSliders, s.focus, &SliderRow::key);
  std::string focus = s.focus == 'l' ? "light" : s.focus == 't' ? "turn" : s.focus == 'z' ? "zoom" : "";
  if (row != kSliders.end()) focus = row->label;
  x = pen.soft(x, keys, focus) + 12;
  legend({"drag"}, "turn");
  legend({"+", "-"}, "zoom");
  legend({"["}, "Ia = 1");
  legend({"]"}, "Ip = 1");
  legend({"H"}, "hue");
  legend({"3"}, "colours");
  legend({"u"}, "undo");
  legend({"r"}, "reset");
  legend({"?"}, "all keys");
  legend({"q"}, "quit");
}

constexpr int kHelpLines = 15, kShadow = 4;

Rect helpBox(const Layout& at) {
  const int width = std::min(at.width - 2 * kMargin, 560), height = 52 + 18 * kHelpLines;
  return {(at.width - width) / 2, std::max(0, (at.height - height) / 2), width, height};
}

void drawHelp(Pen& pen, const Layout& at) {
  struct Line {
    std::string_view keys, does;
  };
  static constexpr std::array kLines{
      Line{"drag, wheel, + -", "turn the scene; come nearer or go away"},
      Line{"i p a d s n c 0 l", "go to a slider, or to the light"},
      Line{"t z", "go to turning, or to zooming"},
      Line{"arrows", "change what the keyboard is on; with Shift by ten"},
      Line{"Tab, Shift-Tab", "next slider, previous slider"},
      Line{"Home End", "to the ends of the slider"},
      Line{"[ ]", "all light ambient, all light from the point"},
      Line{"L V", "hold L, hold V constant"},
      Line{"S N O F P K T", "next shading, normals, order, fill, projection, backs, table"},
      Line{"H B J", "next hue; 8 or 16 bits a cell; nearest in ratio or difference"},
      Line{"u U r", "undo, redo, reset"},
      Line{"1 3", "the picture; the colour table, and there:"},
      Line{"arrows, h", "  go over the cells; light one up for as long as h is held"},
      Line{"m g i", "  move the ramp; gamma; hold the indices. Esc puts all back"},
      Line{"? or Esc", "close this; q quits"},
  };
  static_assert(kLines.size() == kHelpLines);
  const Rect box = helpBox(at);
  pen.paint.fillRect({box.x + kShadow, box.y + kShadow, box.width, box.height}, pen(Cell::Ink));
  pen.paint.fillRect(box, pen(Cell::Paper));
  pen.paint.frame(box, pen(Cell::Ink));
  pen.paint.text(box.x + 16, box.y + 24, "ALL KEYS", pen(Cell::Soft), Voice::Caps);
  int y = box.y + 48;
  for (const Line& line : kLines) {
    pen.bold(box.x + 16, y, line.keys);
    pen.ink(box.x + 140, y, line.does);
    y += 18;
  }
}

void drawCaption(Pen& pen, const Layout& at) {
  const PictureSettings& p = pen.state.setup.picture;
  const int x = at.picture.x;
  int y = at.picture.y + at.picture.height + (at.compact ? 16 : 19);
  const std::string made = captionOf(pen.state.setup);
  if (at.compact)
    pen.ink(x, y, made);
  else
    pen.ink(pen.soft(x, y, "The picture: "), y, made);
  y += 16;
  const Illumination& l = p.light;
  std::string line = "Ia " + formatted(l.Ia, 2) + "  Ip " + formatted(l.Ip, 2) + "  ka " +
                     formatted(l.ka, 2) + "  kd " + formatted(l.kd, 2) + "  ks " + formatted(l.ks, 2) +
                     "  n " + std::to_string(l.n);
  if (!at.compact) {
    if (l.constantL) line += "  L constant";
    if (l.constantV) line += "  V constant";
    line += "; " + std::string{kTables[static_cast<int>(p.table.kind)].name} + " table, " +
            std::to_string(p.table.shades) + " shades";
  }
  pen.soft(x, y, line);
  if (!at.compact)
    y += 17;
  else if (!pen.state.inexact.empty())
    pen.paint.fillRect({x, y - 12, at.picture.width, 16}, pen(Cell::Paper));
  const int end = pen.paint.text(x, y, pen.state.inexact, pen(Cell::Alarm));
  if (!at.compact && !pen.state.inexact.empty()) {
    const int cap = std::max(end + 18, x + 565);
    pen.soft(cap + pen.key(cap, y - 11, "O") + 5, y, "next order");
  }
}

}  // namespace

std::string orderInWords(Order order) {
  switch (order) {
    case Order::Unsorted:
      return "not sorted";
    case Order::ZMean:
      return "sorted by mean z";
    case Order::ZSort:
      return "sorted by farthest z";
    case Order::Newell:
      return "sorted by depth, Newell's way";
    case Order::Oracle:
      return "each sample decided by itself";
  }
  return {};
}

std::string captionOf(const Setup& setup) {
  std::string shading{chosen(choice('S'), setup)};
  if (setup.picture.shading == Shading::Full) shading = "full intensity";
  if (setup.picture.shading == Shading::Environment) shading = "environment map";
  return shading + "; " + orderInWords(setup.picture.order) + "; " +
         (setup.fill == Fill::Scanline ? "own scanline" : "XFillPolygon") + "; " +
         std::string{chosen(choice('P'), setup)};
}

Layout layoutOf(int width, int height) {
  Layout at;
  at.width = width;
  at.height = height;
  at.roomy = width >= 800 && height >= 600;
  at.compact = width < 1024 || height < 768;
  if (!at.roomy) {
    at.picture = {0, 0, width, height};
    return at;
  }
  const int bodyTop = at.compact ? 43 : 48, below = at.compact ? 44 : 56;
  at.views = {0, 0, width, kViewsHeight};
  at.status = {0, height - kStatusHeight, width, kStatusHeight};
  at.strip = {0, at.status.y - kStripHeight, width, kStripHeight};
  at.controls = {width - kMargin - kControls, bodyTop, kControls, at.strip.y - bodyTop};
  at.body = {kMargin, bodyTop, width - 2 * kMargin, at.strip.y - 4 - bodyTop};
  at.picture = {kMargin, bodyTop, at.controls.x - 2 * kMargin, at.strip.y - below - bodyTop};
  return at;
}

std::vector<Rect> drawnOverPicture(const Layout& at, bool help) {
  std::vector<Rect> parts;
  if (!at.roomy) parts.push_back({8, 5, textWidth(kNoRoom), 13});
  if (const Rect box = helpBox(at); help)
    parts.push_back({box.x, box.y, box.width + kShadow, box.height + kShadow});
  return parts;
}

void drawPanel(IndexImage& image, const Layout& at, const PanelState& state, const CellPlan& plan) {
  Pen pen{Painter{image}, plan, state};
  if (!at.roomy) {
    pen.paint.text(8, 16, kNoRoom, plan[Cell::WellText]);
    if (state.help) drawHelp(pen, at);
    return;
  }
  const std::uint8_t paper = plan[Cell::Paper];
  if (state.view == WindowView::Picture) {
    const Rect& p = at.picture;
    pen.paint.fillRect({0, 0, at.width, p.y}, paper);
    pen.paint.fillRect({0, p.y, p.x, at.height - p.y}, paper);
    pen.paint.fillRect({p.x + p.width, p.y, at.width - p.x - p.width, at.height - p.y}, paper);
    pen.paint.fillRect({p.x, p.y + p.height, p.width, at.height - p.y - p.height}, paper);
    drawCaption(pen, at);
    drawControls(pen, at);
  }
  drawViews(pen, at);
  pen.rule(0, at.strip.y, at.width);
  drawColorStrip(pen.paint, at.strip, plan, state.use, state.words, at.compact, state.inspected);
  drawStatus(pen, at);
  if (state.help) drawHelp(pen, at);
}
