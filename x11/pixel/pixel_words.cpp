#include "x11/pixel/pixel_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>

#include "shading/color/quantize.h"
#include "shading/explain/rounded_terms.h"
#include "shading/explain/term_values.h"
#include "shading/picture/cell_use.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

std::array<int, 3> wantedColor(const Explanation& e) {
  return {channelByte(e.value[0]), channelByte(e.value[1]), channelByte(e.value[2])};
}
glm::u8vec3 heldColor(const Rgb16& held) { return {held.r >> 8, held.g >> 8, held.b >> 8}; }
std::string colorInWords(const std::array<int, 3>& color) {
  return std::to_string(color[0]) + ", " + std::to_string(color[1]) + ", " + std::to_string(color[2]);
}

}  // namespace

PixelStory::PixelStory(const Picture& of, int column, int row)
    : picture{of}, i{column}, j{row}, history{historyOf(of, column, row)} {
  PixelExplainer explain{of};
  for (const PaintedHere& one : history.painted) explained.push_back(explain(one.fragment.face, i, j));
}

bool PixelStory::isExplained() const {
  if (!shown()) return true;
  if (!inColors()) return shown()->value[0] == cell();
  // One block of the places of ordered dithering, all in the wanted colour.
  constexpr int kBlock = 8;
  RgbImage wanted{kBlock, kBlock};
  const std::array<int, 3> color = wantedColor(*shown());
  for (std::size_t k = 0; k < wanted.rgb.size(); ++k) wanted.rgb[k] = static_cast<std::uint8_t>(color[k % 3]);
  IndexImage cells{kBlock, kBlock, 0};
  const bool dither = picture.settings().dither;
  const CellRange range = sceneCells(picture);
  if (picture.colors().plan() == ColorPlan::Cube) {
    paintCube(wanted, {}, range.first, dither, cells);
  } else {
    const Palette palette = picture.palette(CellPlan{picture.settings().table.kind});
    std::vector<glm::u8vec3> held;
    for (int c = range.first; c <= range.last(); ++c)
      held.push_back(heldColor(palette[static_cast<std::size_t>(c)]));
    paintNearest(wanted, {}, held, dither, range.first, cells);
  }
  return cells.row(j % kBlock)[i % kBlock] == cell();
}

std::string_view PixelStory::verdict() const {
  if (!shown()) return "ground";
  if (isWrong(history.check)) return "wrong face";
  return shown()->clamped ? "clamped" : "shaded";
}

std::string fateOf(const PixelStory& story, std::size_t k) {
  if (static_cast<int>(k) == story.history.shown) return "shows";
  if (rowOf(story.picture.settings().order).bySample) return "another one is nearer";
  return "painted over by " + std::to_string(k + 2);
}

namespace {

/// With Gouraud shading the vertices know no texel.
bool showsTexel(const Explanation& e) { return e.texel && e.method != Shading::Gouraud; }

std::string asItIs(std::string_view word) { return std::string{word}; }

/// A term of MistakeRow with its words replaced, and `times` for each product.
template <class OfWord>
std::string writtenOut(std::string_view term, std::string_view times, const OfWord& ofWord) {
  std::string text;
  for (std::size_t k = 0; k < term.size();) {
    std::size_t end = k;
    while (end < term.size() && std::isalpha(static_cast<unsigned char>(term[end]))) ++end;
    if (end > k) {
      text += ofWord(term.substr(k, end - k));
      k = end;
      continue;
    }
    if (term[k] == '*')
      text += times;
    else
      text += term[k];
    ++k;
  }
  return text;
}

}  // namespace

std::string formulaOf(const Explanation& e, const Illumination& light) {
  const MistakeRow& row = rowOf(light.mistake);
  const std::string cosine{cosineName(light.form)};
  const std::string_view terms = row.lightTerms;
  const bool alone = terms.find("|RV|") != std::string_view::npos;  // its bars are brackets enough
  const std::string NL = std::string{"N.L"} + (showsTexel(e) ? " x texel" : "");
  const std::string shown = writtenOut(terms, " ", [&](std::string_view word) -> std::string {
    if (word == "NL") return NL;
    if (word == "RV") return alone ? cosine : "(" + cosine + ")";
    return std::string{word};
  });
  return "I = " + (row.ambientTerm.empty() ? "" : writtenOut(row.ambientTerm, " ", asItIs) + " + ") + shown;
}

std::vector<std::string> depthWords(const Explanation& e, std::size_t widest) {
  if (!e.depth) return {};
  const std::vector<double>& z = e.depth->z;
  const double range = e.depth->range, a = e.depth->a();
  if (range == 0.0) return {"I = 1: all faces have the same depth"};
  // A model may be of any size, so its lengths have no fixed decimals. Their digits go down to range / 10^5.
  const auto length = [range](double v) {
    const double more =
        v == 0.0 || !std::isfinite(v) ? 0.0 : std::floor(std::log10(std::abs(v)) - std::log10(range));
    std::array<char, 32> text;
    const int digits = std::clamp(6 + static_cast<int>(more), 1, 17);
    const auto end = std::to_chars(text.begin(), text.end(), v, std::chars_format::general, digits).ptr;
    return std::string{text.begin(), end};
  };
  const std::string result = " = " + fixed(e.I[0], kPixelDecimals);
  const auto putIn = [&](const std::string& numbers) {
    return "  = 1 - (" + numbers + ") / " + length(a) + result;
  };
  std::string names = "z1", numbers = length(z[0]);
  for (std::size_t k = 1; k < z.size(); ++k) {
    names += " + z" + std::to_string(k + 1);
    numbers += (z[k] < 0.0 ? " - " : " + ") + length(std::abs(z[k]));
    if (numbers.size() > widest) break;  // a face may have a million corners
  }
  const double sum = std::accumulate(z.begin(), z.end(), 0.0);
  std::string line = putIn(numbers);
  if (line.size() > widest) {
    names = "z1 + ... + z" + std::to_string(z.size());
    line = putIn(length(sum));
  }
  if (!std::isfinite(a) || !std::isfinite(sum))
    line = " " + result;  // the lengths are near the largest double
  return {"I = 1 - (" + names + ") / a", line, "z: how far a corner lies behind the mean of the nearest face",
          "a = " + std::to_string(z.size()) + " x " + length(range) + ": the farthest face gets 0"};
}

std::string mistakeWords(const Explanation& e, const Illumination& light) {
  if (light.mistake == Mistake::None || e.equations.empty()) return {};
  return std::string{rowOf(light.mistake).is};
}

std::vector<std::string> numbersPutIn(const Explanation& e, const ExplainedEquation& at, int c,
                                      Mistake mistake, HiddenCosines hidden) {
  const MistakeRow& row = rowOf(mistake);
  const Reflection& surface = at.surface[c];
  const auto ofSurface = [&](std::string_view word) {
    return word == "ka"   ? fixed(surface.ka, 2)
           : word == "kd" ? fixed(surface.kd, 2)
           : word == "ks" ? fixed(surface.ks, 2)
           : word == "Ia" ? fixed(at.Ia[c], 2)
                          : std::to_string(surface.n);
  };
  const auto inBrackets = [](double v) {
    const std::string text = fixed(v, kPixelDecimals);
    return v < 0.0 ? "(" + text + ")" : text;
  };
  std::vector<std::string> lines{
      "= " + (row.ambientTerm.empty() ? "0" : writtenOut(row.ambientTerm, " x ", ofSurface))};
  for (const ExplainedLight& light : at.lights) {
    const bool highlight = light.NdotL > 0.0 || row.highlightBehind;
    if (!highlight && light.facing == 0.0 && !hidden.NL) {
      lines.push_back("+ 0: a light is behind this side");
      continue;
    }
    const auto ofLight = [&](std::string_view word) {
      if (word == "f") return fixed(light.fatt * light.spot, kPixelDecimals);
      if (word == "Ip") return fixed(light.Ip[c], 2);
      if (word == "RV" && hidden.RV) return std::string{"?"};
      if ((word == "NL" || word == "angle") && hidden.NL) return std::string{"?"};
      if (word == "RV") return inBrackets(highlight ? light.counted : 0.0);
      if (word == "angle") return fixed(90.0 * (1.0 - light.facing), 2);
      if (word != "NL") return ofSurface(word);
      const double shown = row.facing ? light.NdotL : light.facing;
      return inBrackets(shown) + (showsTexel(e) ? " x " + fixed(e.texel->share[c], kPixelDecimals) : "");
    };
    std::string part = "+ " + writtenOut(row.lightTerms, " x ", ofLight);
    if (at.lights.size() == 1)
      lines.front() += ' ' + part;
    else
      lines.push_back(std::move(part));
  }
  return lines;
}

const ExplainedEquation* equationShown(const Explanation& e, int vertex) {
  if (e.equations.empty()) return nullptr;
  const int k = e.method == Shading::Gouraud ? e.vertices[static_cast<std::size_t>(vertex)].equation : 0;
  return k < 0 ? nullptr : &e.equations[static_cast<std::size_t>(k)];
}

std::string_view weightsThatCount(const Explanation& e) {
  if (e.method == Shading::Phong) return "the weights in the world count";
  return e.texel ? "in the world for u and v, on the screen for I" : "the weights on the screen count";
}

std::string intensityWords(const PixelStory& story, const Explanation& e) {
  if (!story.inColors() || e.channels == 1) return fixed(e.intensity, kPixelDecimals);
  std::string all;
  for (int c = 0; c < 3; ++c) all += (c > 0 ? " " : "") + fixed(std::clamp(e.I[c], 0.0, 1.0), 2);
  return all;
}

std::string sumOf(const ExplainedEquation& at, int c, bool together, std::optional<std::size_t> known) {
  std::vector<double> terms{at.ambient[c]};
  if (together)
    terms.insert(terms.end(), {at.diffuse(c), at.specular(c)});
  else
    for (const ExplainedLight& light : at.lights)
      terms.insert(terms.end(), {light.diffuse[c], light.specular[c]});
  const std::vector<double> rounded = roundedTerms(terms, kPixelDecimals);
  std::string text = "= ";
  for (std::size_t k = 0; k < rounded.size(); ++k) {
    if (k > 0) text += rounded[k] < 0.0 ? " - " : " + ";
    text += known && k >= *known ? "?" : fixed(k > 0 ? std::abs(rounded[k]) : rounded[k], kPixelDecimals);
  }
  if (known) return text + " = ?";
  const double sum = std::accumulate(rounded.begin(), rounded.end(), 0.0);
  return text + (rounded.size() > 1 ? " = " + fixed(sum, kPixelDecimals) : "") +
         (at.I[c] > 1.0   ? ", clamped to 1"
          : at.I[c] < 0.0 ? ", clamped to 0"
                          : "");
}

std::string componentsOf(const glm::dvec3& v) {
  std::string all;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string number = fixed(v[axis], kPixelDecimals);
    all += std::string(9 - std::min<std::size_t>(9, number.size()), ' ') + number;
  }
  return all;
}

const ColorTable& tableOf(const PixelStory& story, const Explanation& e) {
  const Picture& picture = story.picture;
  return picture.colors().tableOf(picture.scene().mesh.material[picture.snapped().faces[e.face].number]);
}

PickedWords pickedWords(const PixelStory& story, const Explanation& e) {
  const ColorTable& table = tableOf(story, e);
  const int shade = std::clamp(e.value[0] - table.first(), 0, table.shades() - 1);
  const ColorTable::Picked picked = table.picked(shade);
  int decimals = kPixelDecimals;
  const auto alike = [&](double border) {
    return e.intensity != border && fixed(e.intensity, decimals) == fixed(border, decimals);
  };
  constexpr int kMostDecimals = 12;
  while (decimals < kMostDecimals && (alike(picked.from) || alike(picked.to))) ++decimals;
  if (alike(picked.from) || alike(picked.to)) decimals = kPixelDecimals;  // rounding alone tells them apart
  const bool last = shade + 1 == table.shades();
  return {"I " + fixed(e.intensity, decimals) + " picks shade " + std::to_string(shade) + " of " +
              std::to_string(table.shades()) + " (" +
              std::string{kTables[static_cast<int>(table.settings().kind)].name} + "), cell " +
              std::to_string(table.first()) + " + " + std::to_string(shade) + " = " +
              std::to_string(e.value[0]),
          "that shade is for " + fixed(picked.from, decimals) + (last ? " <= I <= " : " <= I < ") +
              fixed(picked.to, decimals)};
}

std::string channelsInWords(const Explanation& e) {
  return "each channel is 1 + 254 I, rounded: " + colorInWords(e.value) + "; as a colour " +
         colorInWords(wantedColor(e));
}

std::string heldInWords(const PixelStory& story, const Rgb16& held) {
  return (story.picture.settings().dither ? "one of two colours that share these places: cell "
                                          : "the nearest colour that a cell holds: cell ") +
         std::to_string(story.cell()) + " has " + colorInWords({held.r >> 8, held.g >> 8, held.b >> 8}) +
         " of 255";
}

std::string shownInWords(const Rgb16& stored, int bits) {
  const int below = 16 - bits;
  return "this screen shows " + (below == 0 ? "all 16 bits" : "the upper " + std::to_string(bits) + " bits") +
         ": " + colorInWords({stored.r >> below, stored.g >> below, stored.b >> below});
}

std::vector<std::string> shortStory(const PixelStory& story, int chosen) {
  if (story.explained.empty()) return {};
  const Explanation& e = story.explained[static_cast<std::size_t>(chosen)];
  std::vector<std::string> lines{"face " + faceName(story.picture, e.face) + ": " + fateOf(story, chosen) +
                                 ", I " + intensityWords(story, e)};
  for (std::string& line : depthWords(e)) lines.push_back(std::move(line));
  for (const ExplainedEquation& at : e.equations) {
    const Illumination& light = story.picture.settings().light;
    lines.push_back(formulaOf(e, light));
    for (int c = 0; c < e.channels; ++c) {
      for (std::string& numbers : numbersPutIn(e, at, c, light.mistake)) lines.push_back(std::move(numbers));
      lines.push_back(sumOf(at, c));
    }
  }
  if (story.inColors()) return lines;
  const PickedWords picked = pickedWords(story, e);
  lines.insert(lines.end(), {picked.picks, picked.range});
  return lines;
}

}  // namespace xnewell
