#include <algorithm>
#include <array>
#include <cmath>

#include "shading/explain/rounded_terms.h"
#include "shading/explain/term_values.h"
#include "x11/drawing/wording.h"
#include "x11/pixel/pixel_drawings.h"
#include "x11/pixel/pixel_pen.h"

namespace xnewell {

namespace {

constexpr int kTableLines = 7;
constexpr int kVectorWords = 372, kMapWords = 260;  // units that lines beside a drawing take
constexpr std::array<std::string_view, 3> kChannelNames{"red", "green", "blue"};

}  // namespace

Rect PixelPen::beside(int words, int linesBelow) const {
  if (!hasRoom(7) || at.column.width < 500) return {};
  const int left = at.column.y + at.column.height - (y - 11) - linesBelow * at.pitch;
  const int widest = at.column.width - words - 12;
  if (widest < 5 * at.pitch) return {};
  const int height = std::max(7 * at.pitch - 4, std::min({left, at.column.height * 2 / 5, widest * 3 / 4}));
  const int width = std::min(widest, height * 4 / 3);
  return {right() - width, y - 11, width, height};
}

/// A bar of length 1: ambient light dark, diffuse dotted, specular hatched; what exceeds 1 is red.
void PixelPen::bar(const ExplainedEquation& of) {
  if (!hasRoom(2)) return;
  const int width = at.column.width - 24, top = y - 9, height = 11;
  paint.fillRect({x(), top, width, height}, (*this)(Cell::Panel));
  const double diffuse = of.diffuse(page.channel), specular = of.specular(page.channel);
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
  std::string aside =
      e().channels > 1 ? std::string{kChannelNames[static_cast<std::size_t>(page.channel)]} : "";
  if (lights > 1) aside += (aside.empty() ? "" : ", ") + counted(lights, "light");
  if (gouraud)
    aside = std::string{"at vertex "} + letterOfVertex(page.vertex) + (aside.empty() ? "" : ", ") + aside;
  section("3 equation", aside);
  if (e().depth) {
    const std::vector<std::string> words =
        depthWords(e(), static_cast<std::size_t>(at.column.width / textWidth("0")));
    for (std::size_t k = 0; k < words.size(); ++k) line(words[k], k == 0);
    return;
  }
  const ExplainedEquation* const equation = equationShown(e(), page.vertex);
  if (!equation) {
    line(!e().equations.empty() ? "Clipping made this vertex: its I is interpolated along the edge."
         : e().method == Shading::Environment
             ? "The map holds the equation for every normal: I " + number(e().I[0])
             : "No light is computed: I " + number(e().I[0]));
    if (e().method == Shading::Environment) {
      const Rect map = beside(kMapWords, kTableLines);
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
  const ExplainedEquation& of = *equation;
  const Illumination& user = story().picture.settings().light;
  const Form form = user.form;
  constexpr int kBelow = 8;  // lines: the sum, the bar, and the table with its verdict
  line(formulaOf(e(), user), true);
  if (const std::string wrong = mistakeWords(e(), user); !wrong.empty() && hasRoom(kBelow + 2)) {
    paint.text(x() + 12, y, "a mistake: " + wrong, (*this)(Cell::Alarm));
    y += at.pitch;
  }
  const std::vector<std::string> put =
      numbersPutIn(e(), of, page.channel, user.mistake, {hides(Predicted::NdotL), hides(Predicted::Cosine)});
  if (!of.lights.empty()) {
    int widest = kVectorWords;
    for (const std::string& numbers : put) widest = std::max(widest, 12 + textWidth(numbers));
    places.ball = beside(widest, kTableLines + 3);  // and the bar
    if (places.ball.height > 0) drawBall(*this, places.ball, story(), e(), of, page.channel, page.ball);
  }
  for (std::size_t k = 0; k < put.size(); ++k) {
    if (k > 1 && !hasRoom(kBelow + 1)) {
      line("+ " + std::to_string(put.size() - k) + " more", false, 12);
      break;
    }
    line(put[k], false, 12);
  }
  if (hides(Predicted::I)) {
    const int given =
        static_cast<int>(*page.asked) - static_cast<int>(Predicted::Diffuse);  // and the ambient one
    line(sumOf(of, page.channel, true, static_cast<std::size_t>(std::max(0, given) + 1)), true, 12);
  } else {
    line(sumOf(of, page.channel, lights > 2), true, 12);
  }
  if (of.lights.empty()) line("No light but the ambient reaches the scene, so no normal counts.");
  if (!of.lights.empty() && hasRoom(kBelow)) line("N" + componentsOf(of.N) + "    V" + componentsOf(of.V));
  for (std::size_t k = 0; k < of.lights.size(); ++k) {
    const bool several = lights > 1;
    const auto left = static_cast<std::int64_t>(of.lights.size() - k);
    if (!hasRoom(kBelow + (several && left == 1 ? 1 : 2)) && k > 0) {
      line("L and R of " + counted(left, "more light") + ": there is no room");
      break;
    }
    if (!hasRoom(kBelow + 1)) break;
    const ExplainedLight& light = of.lights[k];
    const std::string which = several ? std::to_string(k + 1) : "";
    const std::string L = "L" + which + componentsOf(light.L);
    const bool hasR = form != Form::Tutorial && !hides(Predicted::NdotL) &&  // R would tell N.L
                      (light.NdotL > 0.0 || rowOf(user.mistake).highlightBehind);
    const std::string R =
        hasR ? (form == Form::Textbook ? "R" : "H") + which + componentsOf(light.R) : std::string{};
    if (several) {  // one line for each: their cosines are in the lines above
      line(L + (hasR ? "    " + R : ""));
      continue;
    }
    line(L + "    N.L " + numberOf(Predicted::NdotL, light.NdotL) +
         (light.NdotL > 0.0 || hides(Predicted::NdotL) ? "" : ": behind"));
    if (hasR)
      line(R + "    " + std::string{cosineName(form)} + ' ' + numberOf(Predicted::Cosine, light.cosine) +
           (hides(Predicted::Cosine) ? ""
            : light.counted == 0.0   ? ", counts as 0"
                                     : ", its power " + number(light.power)));
  }
  passBy(places.ball);
  if (!hides(Predicted::I)) bar(of);
  if (gouraud && !hides(Predicted::I)) line("interpolated to this sample: I " + number(e().I[page.channel]));
}

void PixelPen::table() {
  section("4 table", "");
  const bool shown = page.chosen == story().history.shown;
  if (hides(Predicted::I)) return line("?");
  const auto verdictOfChain = [&] {
    if (!shown || !hasRoom()) return;
    const int end = bold(ink(x(), y, "the picture has cell "), y, std::to_string(story().cell()));
    if (story().isExplained()) {
      paint.tick(ink(end, y, " here: the chain explains it ") + 4, y - 8, (*this)(Cell::Good));
    } else {
      paint.text(end, y, " here, and the chain does not end there", (*this)(Cell::Alarm));
    }
    y += at.pitch;
  };
  if (story().inColors()) {
    line(channelsInWords(e()));
    if (!shown) return;
    line(heldInWords(story(), page.palette[static_cast<std::size_t>(story().cell())]));
    return verdictOfChain();
  }
  if (e().luminance)
    line("one hue: the luminance 0.30 R + 0.59 G + 0.11 B of " + fixed(e().I[0], 2) + ", " +
         fixed(e().I[1], 2) + ", " + fixed(e().I[2], 2));
  const PickedWords words = pickedWords(story(), e());
  const ColorTable& table = tableOf(story(), e());
  if (hides(Predicted::Cell))
    return line("I " + number(e().intensity) + " picks shade ? of " + std::to_string(table.shades()) + " (" +
                std::string{kTables[static_cast<int>(table.settings().kind)].name} + "), cell " +
                std::to_string(table.first()) + " + ? = ?");
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
  if (page.shownBits > 0 && hasRoom(2)) line(shownInWords(stored, page.shownBits));
  verdictOfChain();
}

}  // namespace xnewell
