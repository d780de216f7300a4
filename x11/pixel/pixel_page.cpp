#include "x11/pixel/pixel_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "shading/explain/rounded_terms.h"
#include "x11/drawing/wording.h"
#include "x11/pixel/pixel_drawings.h"

namespace xnewell {

namespace {

constexpr std::array<std::string_view, 3> kChannels{"red", "green", "blue"};

std::string number(double v) { return fixed(v, kPixelDecimals); }
char letterOf(int vertex) { return static_cast<char>('A' + vertex % 26); }

/// Writes the explanation from top to bottom.
struct PixelPen : Pen {
  const PixelLayout& at;
  const PixelPage& page;
  int y;
  PixelPlaces places = {};

  [[nodiscard]] const PixelStory& story() const { return page.story; }
  [[nodiscard]] const Explanation& e() const {
    return story().explained[static_cast<std::size_t>(page.chosen)];
  }
  [[nodiscard]] int x() const { return at.column.x; }
  [[nodiscard]] int right() const { return at.column.x + at.column.width; }
  [[nodiscard]] bool hasRoom(int lines = 1) const {
    return y + (lines - 1) * at.pitch + 3 <= at.column.y + at.column.height;
  }

  /// Writes a line if there is room for it.
  void line(std::string_view text, bool bold = false, int indent = 0) {
    if (hasRoom()) paint.text(x() + indent, y, text, (*this)(Cell::Ink), bold ? Voice::Bold : Voice::Plain);
    y += at.pitch;
  }
  void section(std::string_view name, std::string_view aside) {
    y += at.pitch / 2;
    if (hasRoom()) {
      rule(x(), y - at.pitch + 1, at.column.width);
      caps(x(), y + 1, name);
      softRight(right(), y + 1, aside);
    }
    y += at.pitch + 2;
  }

  void verdict();
  void history();
  void surface();
  void equation();
  void table();
  void facts();
  void bar(const ExplainedEquation& of);
  /// Where a drawing stands beside the lines of the equation, from the line y on; empty without room.
  [[nodiscard]] Rect beside() const {
    const int height = 7 * at.pitch - 4, width = height * 4 / 3;
    if (!hasRoom(7) || at.column.width < 500) return {};
    return {right() - width, y - 11, width, height};
  }
  /// Moves below a drawing.
  void passBy(const Rect& drawn) {
    if (drawn.height > 0) y = std::max(y, drawn.y + drawn.height + 14);
  }
};

void PixelPen::verdict() {
  const bool wrong = story().verdict() == "wrong face";
  paint.text(x(), at.column.y + 22, story().verdict(), (*this)(wrong ? Cell::Alarm : Cell::Ink),
             Voice::Title);
  const int beside = x() + textWidth(story().verdict(), Voice::Title) + 16;
  const Explanation* const shown = story().shown();
  y = at.column.y + 12;
  if (!shown) {
    ink(beside, y, "No polygon covers this sample.");
    ink(beside, y + 16, "The background is cell " + std::to_string(story().cell()) + ".");
    return;
  }
  const auto times = static_cast<std::int64_t>(story().history.painted.size());
  ink(beside, y,
      times == 1 ? std::string{"One polygon is at this sample."}
                 : "The " + std::string{story().history.shown + 1 == times ? "last" : "nearest"} + " of " +
                       counted(times, "polygon") + " at this sample shows.");
  if (wrong)
    ink(beside, y + 16, "Face " + faceName(story().picture, story().history.nearest) + " is nearer.");
  else
    ink(beside, y + 16,
        std::string{rowOf(shown->method).label} + ": I " + intensityWords(story(), *shown) + ", cell " +
            std::to_string(story().cell()));
}

void PixelPen::history() {
  section("1 history", "z in pixels of the view plane, larger is nearer");
  const PixelHistory& h = story().history;
  double low = 1e300, high = -1e300;
  for (const PaintedHere& one : h.painted) low = std::min(low, one.z), high = std::max(high, one.z);
  for (const int k : shownRows(static_cast<int>(h.painted.size()), page.chosen, at.rows)) {
    if (k < 0) {
      line("...");
      continue;
    }
    const PaintedHere& one = h.painted[static_cast<std::size_t>(k)];
    places.history.emplace_back(Rect{x() - 4, y - 11, at.column.width + 8, at.pitch - 1}, k);
    if (k == page.chosen)
      paint.fillRect({x() - 4, y - 11, at.column.width + 8, at.pitch - 1}, (*this)(Cell::White));
    const Voice voice = k == page.chosen ? Voice::Bold : Voice::Plain;
    const std::string name = std::to_string(k + 1) + "  " + faceName(story().picture, one.fragment.face) +
                             (one.fragment.piece < 0 ? "" : " (a piece)");
    const int lane = x() + at.column.width * 9 / 20, width = at.column.width / 5;
    paint.text(x(), y, std::string_view{name}.substr(0, static_cast<std::size_t>((lane - x()) / 6)),
               (*this)(Cell::Ink), voice);
    paint.hline(lane, y - 4, width, (*this)(Cell::Rule));
    const double share = high > low ? (one.z - low) / (high - low) : 1.0;
    paint.fillRect({lane + static_cast<int>(share * (width - 6)), y - 7, 6, 7}, (*this)(Cell::Soft));
    paint.textRight(lane + width + 56, y, fixed(one.z, 1), (*this)(Cell::Ink), voice);
    paint.textRight(right(), y, fateOf(story(), static_cast<std::size_t>(k)), (*this)(Cell::Soft), voice);
    y += at.pitch;
  }
  if (h.notPainted > 0)
    line("hidden everywhere: " + std::to_string(h.notPainted) + " more at this sample, not painted");
}

void PixelPen::surface() {
  const SnappedFace& face = story().picture.snapped().faces[e().face];
  section("2 surface", std::string{rowOf(e().method).label} + ", " + (face.back ? "back" : "front") +
                           " side" +
                           (e().vertices.size() == 3 ? ": " + std::string{weightsThatCount(e())} : ""));
  const bool normals = e().method != Shading::Gouraud, weights = e().vertices.size() == 3;
  if (e().vertices.empty())
    line(e().method == Shading::Flat ? "one normal and one place: the centroid of the face"
                                     : std::string{rowOf(e().method).evaluates});
  const bool heads = at.pitch > 14;  // a low window has no line for them
  if (!e().vertices.empty() && heads) {
    std::string head = "vertex, x, y";
    head.resize(20, ' ');
    if (weights) head += "screen  world   ";
    soft(x(), y, head + (normals ? "      Nx       Ny       Nz" : "  I"));
    y += at.pitch;
  }
  for (std::size_t k = 0; k < e().vertices.size() && k < 4; ++k) {
    const ExplainedVertex& v = e().vertices[k];
    std::string text =
        std::string{letterOf(static_cast<int>(k))} + "  " + fixed(v.at.x, 1) + ", " + fixed(v.at.y, 1);
    text.resize(20, ' ');
    if (weights) text += number(v.onScreen) + "  " + number(v.inWorld) + "  ";
    if (normals) {
      text += componentsOf(v.N) + (heads ? "" : "  N");
    } else {
      for (int c = 0; c < e().channels; ++c) text += "  " + number(v.I[c]);
      if (!heads) text += "  I";
    }
    line(text);
  }
  if (e().method == Shading::Phong && e().sum != glm::dvec3{0.0})
    line("weighted sum, length " + number(glm::length(e().sum)) + "      " + componentsOf(e().sum));
  if (e().texel)
    line("texel: u " + number(e().texel->u) + ", v " + number(e().texel->v) + ", leaves " +
         number(e().texel->share[page.channel]) + " of the diffuse term");
  if (e().place)
    line("place in the map: column " + std::to_string(e().place->column) + ", row " +
         std::to_string(e().place->row));
}

/// A bar of length 1: ambient light dark, diffuse dotted, specular hatched; what exceeds 1 is red.
void PixelPen::bar(const ExplainedEquation& of) {
  if (!hasRoom(2)) return;
  const int width = at.column.width - 24, top = y - 9, height = 11;
  paint.fillRect({x(), top, width, height}, (*this)(Cell::Panel));
  double diffuse = 0, specular = 0;
  for (const ExplainedLight& light : of.lights)
    diffuse += light.diffuse[page.channel], specular += light.specular[page.channel];
  double from = 0;
  const auto part = [&](double term, const auto& fill) {
    const auto place = [&](double I) {
      return x() + static_cast<int>(std::lround(std::min(1.0, I) * width));
    };
    const Rect area{place(from), top, place(from + term) - place(from), height};
    from += term;
    if (area.width > 0) fill(area);
  };
  part(of.ambient[page.channel], [&](const Rect& r) { paint.fillRect(r, (*this)(Cell::Soft)); });
  part(diffuse, [&](const Rect& r) {
    paint.fillRect(r, (*this)(Cell::Rule));
    paint.stipple(r, Stipple::Quarter, (*this)(Cell::Ink));
  });
  part(specular, [&](const Rect& r) {
    paint.fillRect(r, (*this)(Cell::White));
    paint.stipple(r, Stipple::Diagonals, (*this)(Cell::Ink));
  });
  paint.frame({x(), top, width, height}, (*this)(Cell::Faint));
  if (from > 1.0)
    paint.fillRect({x() + width, top, std::min(24, static_cast<int>((from - 1.0) * width) + 1), height},
                   (*this)(Cell::Alarm));
  y += at.pitch;
  const std::vector<double> terms =  // as in the sum above
      roundedTerms({of.ambient[page.channel], diffuse, specular}, kPixelDecimals);
  const std::array words{"ambient " + number(terms[0]), "diffuse " + number(terms[1]),
                         "specular " + number(terms[2])};
  int place = x();
  for (const std::string& word : words) place = soft(place, y, word) + 18;
  softRight(right(), y, "I " + number(of.I[page.channel]) + " of 1");
  y += at.pitch;
}

void PixelPen::equation() {
  const int lights = e().equations.empty() ? 0 : static_cast<int>(e().equations.front().lights.size());
  const bool gouraud = e().method == Shading::Gouraud;
  std::string aside = e().channels > 1 ? std::string{kChannels[static_cast<std::size_t>(page.channel)]} : "";
  if (lights > 1) aside += (aside.empty() ? "" : ", ") + counted(lights, "light");
  if (gouraud)
    aside = std::string{"at vertex "} + letterOf(page.vertex) + (aside.empty() ? "" : ", ") + aside;
  section("3 equation", aside);
  const int number_ = gouraud ? e().vertices[static_cast<std::size_t>(page.vertex)].equation : 0;
  if (e().equations.empty() || number_ < 0) {
    line(number_ < 0 ? "Clipping made this vertex: its I is interpolated along the edge."
         : e().method == Shading::Environment
             ? "The map holds the equation for every normal: I " + number(e().I[0])
             : "No light is computed: I " + number(e().I[0]));
    if (e().method == Shading::Environment) {
      const Rect map = beside();
      if (map.height > 0) {
        drawMap(*this, {x(), map.y, map.height, map.height}, story(), e(), page.channel);
        const int words = x() + map.height + 16;
        soft(words, y,
             e().place && e().place->away ? "normals that face away from the light"
                                          : "the map of this material");
        soft(words, y + at.pitch, "The ring is the place that is looked up.");
        passBy(map);
      }
    }
    return;
  }
  const ExplainedEquation& of = e().equations[static_cast<std::size_t>(number_)];
  const Illumination& user = story().picture.settings().light;
  const Form form = user.form;
  constexpr int kBelow = 8;  // lines: the sum, the bar and the table
  line(formulaOf(e(), user), true);
  if (const std::string wrong = mistakeWords(e(), user); !wrong.empty() && hasRoom(kBelow + 2)) {
    paint.text(x() + 12, y, "a mistake: " + wrong, (*this)(Cell::Alarm));
    y += at.pitch;
  }
  if (!of.lights.empty()) {
    places.ball = beside();
    if (places.ball.height > 0) drawBall(*this, places.ball, story(), e(), of, page.channel, page.ball);
  }
  const std::vector<std::string> put = numbersPutIn(e(), of, page.channel, user.mistake);
  for (std::size_t k = 0; k < put.size(); ++k) {
    if (k > 1 && !hasRoom(kBelow + 1)) {
      line("+ " + std::to_string(put.size() - k) + " more", false, 12);
      break;
    }
    line(put[k], false, 12);
  }
  line(sumOf(of, page.channel, lights > 2), true, 12);
  if (of.lights.empty()) line("No light but the ambient reaches the scene, so no normal counts.");
  if (!of.lights.empty() && hasRoom(kBelow)) line("N" + componentsOf(of.N) + "    V" + componentsOf(of.V));
  for (std::size_t k = 0; k < of.lights.size() && hasRoom(kBelow + 1); ++k) {
    const ExplainedLight& light = of.lights[k];
    const std::string which = of.lights.size() > 1 ? " " + std::to_string(k + 1) : "";
    line("L" + componentsOf(light.L) + "    N.L" + which + " " + number(light.NdotL) +
         (light.NdotL > 0.0 ? "" : ": behind"));
    if (form != Form::Tutorial && (light.NdotL > 0.0 || rowOf(user.mistake).highlightBehind))
      line(std::string{form == Form::Textbook ? "R" : "H"} + componentsOf(light.R) + "    " +
           std::string{cosineName(form)} + which + " " + number(light.cosine) +
           (light.counted == 0.0 ? ", counts as 0" : ", its power " + number(light.power)));
  }
  passBy(places.ball);
  bar(of);
  if (gouraud) line("interpolated to this sample: I " + number(e().I[page.channel]));
}

void PixelPen::table() {
  section("4 table", "");
  const bool shown = page.chosen == story().history.shown;
  if (story().inColors()) {
    line("each channel is 1 + 254 I, rounded: " + std::to_string(e().value[0]) + ", " +
         std::to_string(e().value[1]) + ", " + std::to_string(e().value[2]));
    const Rgb16 held = page.palette[static_cast<std::size_t>(story().cell())];
    if (shown)
      line("the cells hold colours; cell " + std::to_string(story().cell()) + ", " +
           (story().picture.settings().dither ? "one of two that share these places" : "the nearest") +
           ", holds " + std::to_string(held.r) + ", " + std::to_string(held.g) + ", " +
           std::to_string(held.b));
    return;
  }
  if (e().luminance)
    line("one hue: the luminance 0.30 R + 0.59 G + 0.11 B of " + fixed(e().I[0], 2) + ", " +
         fixed(e().I[1], 2) + ", " + fixed(e().I[2], 2));
  const PickedWords words = pickedWords(story(), e());
  const ColorTable& table = tableOf(story(), e());
  const int shade = std::clamp(e().value[0] - table.first(), 0, table.shades() - 1);
  if (hasRoom(4)) {
    const int width = at.column.width / 6;
    for (int k = -2; k <= 2; ++k) {
      const int j = shade + k;
      if (j < 0 || j >= table.shades()) continue;
      const Rect area{x() + (k + 2) * width, y - 9, width, 11};
      paint.fillRect(area, static_cast<std::uint8_t>(table.first() + j));
      if (k == 0) {
        paint.frame(area, (*this)(Cell::Black));
        paint.frame({area.x + 1, area.y + 1, area.width - 2, area.height - 2}, (*this)(Cell::White));
      }
    }
    y += at.pitch + 2;
  }
  line(words.picks);
  const Rgb16 stored = page.palette[static_cast<std::size_t>(e().value[0])];
  line(words.range + "; it holds " + std::to_string(stored.r) + ", " + std::to_string(stored.g) + ", " +
       std::to_string(stored.b));
  if (!shown || !hasRoom()) return;
  const int end = bold(ink(x(), y, "the picture has cell "), y, std::to_string(story().cell()));
  if (story().isExplained()) {
    paint.tick(ink(end, y, " here: the chain explains it ") + 4, y - 8, (*this)(Cell::Good));
  } else {
    paint.text(end, y, " here, and the chain does not end there", (*this)(Cell::Alarm));
  }
  y += at.pitch;
}

void PixelPen::facts() {
  int row = at.neighbourhood.y + 10;
  const int left = at.facts, end = at.column.x - 16;
  const auto fact = [&](std::string_view name, const std::string& value) {
    soft(left, row, name);
    paint.textRight(end, row, value, (*this)(Cell::Ink), Voice::Bold);
    row += at.pitch;
  };
  fact("pixel", std::to_string(story().i) + ", " + std::to_string(story().j));
  fact("cell", std::to_string(story().cell()));
  if (story().shown()) fact("I", intensityWords(story(), *story().shown()));
  if (!page.before) return;
  fact("before: cell", std::to_string(page.before->cell));
  fact("I", page.before->I);
}

}  // namespace

PixelLayout layoutOfPixel(const Layout& at) {
  PixelLayout layout;
  const Rect& body = at.body;
  const int left = at.compact ? 250 : std::max(404, body.width * 2 / 5);
  const int around = (at.compact ? 8 : 14) * (2 * kAround + 1);
  layout.pitch = at.compact ? 14 : 16;
  layout.rows = at.compact ? 3 : 5;
  const int below =
      around + (at.compact ? 30 : 40) + (at.compact ? 48 : 70);  // the neighbourhood and two controls
  layout.picture = {body.x, body.y, left, std::min(left * 2 / 3, body.height - below)};
  layout.neighbourhood = {body.x, body.y + layout.picture.height + (at.compact ? 26 : 32), around, around};
  layout.facts = layout.neighbourhood.x + around + 16;
  layout.column = {body.x + left + kMargin, body.y, body.width - left - kMargin, body.height};
  layout.controls = layout.neighbourhood.y + around + (at.compact ? 20 : 30);
  return layout;
}

std::vector<int> shownRows(int count, int chosen, int room) {
  std::vector<int> rows;
  if (count <= room) {
    for (int k = 0; k < count; ++k) rows.push_back(k);
    return rows;
  }
  if (chosen < room - 1) {  // the first ones, and a gap
    for (int k = 0; k < room - 1; ++k) rows.push_back(k);
    rows.push_back(-1);
    return rows;
  }
  // The first, a gap, and the rows around the chosen one.
  const int last = std::min(chosen + (room > 3 ? 1 : 0), count - 1);
  rows = {0, -1};
  for (int k = last - (room - 3); k <= last; ++k) rows.push_back(k);
  return rows;
}

PixelPlaces drawPixelPage(Pen& pen, const PixelLayout& at, const PixelPage& page) {
  PixelPen p{pen, at, page, 0};
  const bool ground = page.story.history.painted.empty();
  drawNeighbourhood(p, at.neighbourhood, page.story, ground ? -1 : p.e().face);
  p.facts();
  p.verdict();
  p.y = at.column.y + 46;
  if (ground) return {};
  p.history();
  p.surface();
  p.equation();
  p.table();
  return p.places;
}

}  // namespace xnewell
