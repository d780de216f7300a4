#include "x11/pixel/pixel_page.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "shading/color/quantize.h"
#include "shading/explain/term_values.h"
#include "shading/picture/cell_use.h"
#include "shading/scene/units.h"
#include "x11/drawing/wording.h"
#include "x11/views/cell_facts.h"

namespace xnewell {

namespace {

constexpr int kD = 4;  ///< decimals

std::string number(double v) { return fixed(v, kD); }
/// A factor that may say nothing.
std::string factor(double v) { return v == 1.0 ? "1" : number(v); }

std::array<int, 3> wantedColor(const Explanation& e) {
  return {channelByte(e.value[0]), channelByte(e.value[1]), channelByte(e.value[2])};
}

}  // namespace

PixelStory::PixelStory(Picture of, int column, int row)
    : picture{std::move(of)}, i{column}, j{row}, history{historyOf(picture, column, row)} {
  PixelExplainer explain{picture};
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
    for (int c = range.first; c <= range.last(); ++c) {
      const Rgb16 one = palette[static_cast<std::size_t>(c)];
      held.push_back({one.r >> 8, one.g >> 8, one.b >> 8});
    }
    paintNearest(wanted, {}, held, dither, range.first, cells);
  }
  return cells.row(j % kBlock)[i % kBlock] == cell();
}

std::string_view PixelStory::verdict() const {
  if (!shown()) return "ground";
  if (isWrong(history.check)) return "wrong face";
  return shown()->clamped ? "clamped" : "shaded";
}

std::string intensityWords(const PixelStory& story, const Explanation& e) {
  if (!story.inColors() || e.channels == 1) return number(e.intensity);
  std::string all;
  for (int c = 0; c < 3; ++c) all += (c > 0 ? " " : "") + fixed(std::clamp(e.I[c], 0.0, 1.0), 2);
  return all;
}

namespace page {

/// The order of this file is that of the page: words of the equation; 1 history; 2 surface; 3 equation, with
/// its vectors and questions; 4 table; what only JSON has; and at the end the pages that these make.

namespace {

using Story = std::shared_ptr<const PixelStory>;
/// The ranks of what may be asked, in the order of the chain.
enum Rank { kNL = 1, kRV, kDiffuse, kSpecular, kI, kCell };
constexpr std::array<std::string_view, 3> kChannelNames{"red", "green", "blue"};

std::string letterOf(std::size_t vertex) { return {static_cast<char>('A' + vertex % 26)}; }
std::string listed(const std::array<int, 3>& c) {
  return std::to_string(c[0]) + ", " + std::to_string(c[1]) + ", " + std::to_string(c[2]);
}
std::string listed(const Rgb16& c, int below) { return listed({c.r >> below, c.g >> below, c.b >> below}); }
Data data(const ByChannel& v, int channels) {
  return channels == 1 ? Data{v[0]} : Data{List{v[0], v[1], v[2]}};
}
std::string components(const glm::dvec3& v) {
  std::string all;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string text = number(v[axis]);
    all += std::string(9 - std::min<std::size_t>(9, text.size()), ' ') + text;
  }
  return all;
}

/// With Gouraud shading the vertices know no texel.
bool showsTexel(const Explanation& e) { return e.texel && e.method != Shading::Gouraud; }

/// A term of MistakeRow with its words replaced, and `times` for each product.
template <class OfWord>
std::string writtenOut(std::string_view term, std::string_view times, const OfWord& ofWord) {
  std::string text;
  for (std::size_t k = 0; k < term.size();) {
    std::size_t end = k;
    while (end < term.size() && std::isalpha(static_cast<unsigned char>(term[end]))) ++end;
    if (end > k)
      text += ofWord(term.substr(k, end - k)), k = end;
    else if (term[k++] == '*')
      text += times;
    else
      text += term[k - 1];
  }
  return text;
}

/// "I = ka Ia + f Ip [ kd N.L + ks (R.V)^n ]", with the mistake that is in force.
std::string formulaOf(const Explanation& e, const Illumination& light) {
  const MistakeRow& row = rowOf(light.mistake);
  const std::string cosine{cosineName(light.form)};
  const bool alone = row.lightTerms.find("|RV|") != std::string_view::npos;  // its bars are brackets enough
  const auto shown = [&](std::string_view word) -> std::string {
    if (word == "NL") return std::string{"N.L"} + (showsTexel(e) ? " x texel" : "");
    if (word == "RV") return alone ? cosine : "(" + cosine + ")";
    return std::string{word};
  };
  return "I = " + (row.ambientTerm.empty() ? "" : writtenOut(row.ambientTerm, " ", shown) + " + ") +
         writtenOut(row.lightTerms, " ", shown);
}

/// Shading by depth: the formula, the numbers put into it, and what they mean. The z of all corners are in
/// it, or their sum where that line would be long.
std::vector<std::string> depthWords(const Explanation& e) {
  if (!e.depth) return {};
  constexpr std::size_t kWidest = 90;
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
  const std::string result = " = " + number(e.I[0]);
  const auto putIn = [&](const std::string& numbers) {
    return "  = 1 - (" + numbers + ") / " + length(a) + result;
  };
  std::string names = "z1", numbers = length(z[0]);
  for (std::size_t k = 1; k < z.size(); ++k) {
    names += " + z" + std::to_string(k + 1);
    numbers += (z[k] < 0.0 ? " - " : " + ") + length(std::abs(z[k]));
    if (numbers.size() > kWidest) break;  // a face may have a million corners
  }
  const double sum = std::accumulate(z.begin(), z.end(), 0.0);
  std::string line = putIn(numbers);
  if (line.size() > kWidest) {
    names = "z1 + ... + z" + std::to_string(z.size());
    line = putIn(length(sum));
  }
  if (!std::isfinite(a) || !std::isfinite(sum))
    line = " " + result;  // the lengths are near the largest double
  return {"I = 1 - (" + names + ") / a", line, "z: how far a corner lies behind the mean of the nearest face",
          "a = " + std::to_string(z.size()) + " x " + length(range) + ": the farthest face gets 0"};
}

/// The numbers put into the formula in one channel: one line, or one for the ambient term and each light.
std::vector<std::string> numbersPutIn(const Explanation& e, const ExplainedEquation& at, int c,
                                      const MistakeRow& row) {
  const Reflection& surface = at.surface[c];
  const auto ofSurface = [&](std::string_view word) {
    return word == "ka"   ? fixed(surface.ka, 2)
           : word == "kd" ? fixed(surface.kd, 2)
           : word == "ks" ? fixed(surface.ks, 2)
           : word == "Ia" ? fixed(at.Ia[c], 2)
                          : std::to_string(surface.n);
  };
  const auto inBrackets = [](double v) { return v < 0.0 ? "(" + number(v) + ")" : number(v); };
  std::vector<std::string> lines{
      "= " + (row.ambientTerm.empty() ? "0" : writtenOut(row.ambientTerm, " x ", ofSurface))};
  for (const ExplainedLight& light : at.lights) {
    const bool highlight = light.NdotL > 0.0 || row.highlightBehind;
    const bool nothing = !highlight && light.facing == 0.0;
    const auto ofLight = [&](std::string_view word) {
      if (word == "f") return factor(light.fatt * light.spot);
      if (word == "Ip") return fixed(light.Ip[c], 2);
      if (word == "RV") return asked(kRV, inBrackets(highlight ? light.counted : 0.0));
      if (word == "angle") return asked(kNL, fixed(90.0 * (1.0 - light.facing), 2));
      if (word != "NL") return ofSurface(word);
      return asked(kNL, inBrackets(row.facing != Clamp::Positive ? light.NdotL : light.facing)) +
             (showsTexel(e) ? " x " + number(e.texel->share[c]) : "");
    };
    std::string part = "+ " + (nothing ? asked(kNL, "0: a light is behind this side")
                                       : writtenOut(row.lightTerms, " x ", ofLight));
    if (at.lights.size() == 1 && !nothing)
      lines.front() += ' ' + part;
    else
      lines.push_back(std::move(part));
  }
  return lines;
}

/// "= 0.1800 + 0.5637 + 0.1012 = 0.8449": rounded so that they add up. If `together`, all lights have one
/// diffuse and one specular term.
std::string sumOf(const ExplainedEquation& at, int c, bool together) {
  std::vector<double> terms{at.ambient[c]};
  if (together)
    terms.insert(terms.end(), {at.diffuse(c), at.specular(c)});
  else
    for (const ExplainedLight& light : at.lights)
      terms.insert(terms.end(), {light.diffuse[c], light.specular[c]});
  const std::vector<double> rounded = roundedTerms(terms, kD);
  std::string text = "= " + number(rounded[0]);
  for (std::size_t k = 1; k < rounded.size(); ++k)
    text += (rounded[k] < 0.0 ? " - " : " + ") +
            asked(k % 2 ? kDiffuse : kSpecular, number(std::abs(rounded[k])));
  if (rounded.size() > 1)
    text += " = " + asked(kI, number(std::accumulate(rounded.begin(), rounded.end(), 0.0)));
  const std::string clamped = at.I[c] > 1.0 ? ", clamped to 1" : at.I[c] < 0.0 ? ", clamped to 0" : "";
  return clamped.empty() ? text : text + asked(kI, clamped);
}

const ColorTable& tableOf(const PixelStory& story, const Explanation& e) {
  const Picture& picture = story.picture;
  return picture.colors().tableOf(picture.scene().mesh.material[picture.snapped().faces[e.face].number]);
}

/// "painted over by 2"
std::string fateOf(const PixelStory& story, std::size_t k) {
  if (static_cast<int>(k) == story.history.shown) return "shows";
  return rowOf(story.picture.settings().order).bySample ? "another one is nearer"
                                                        : "painted over by " + std::to_string(k + 2);
}

Section historyPart(const PixelStory& story, int chosen) {
  const PixelHistory& h = story.history;
  Section s{"1 history", "z in pixels of the view plane, larger is nearer"};
  Table t{.key = "history",
          .columns = {{},
                      {.key = "face"},
                      {.key = "name"},
                      {.key = "piece"},
                      {.lane = true},
                      {.key = "z", .right = true},
                      {}},
          .chosen = chosen,
          .rowWeight = 3,
          .id = kPressHistory};
  bool hasParts = false;
  for (std::size_t k = 0; k < h.painted.size(); ++k) {
    const auto [low, high] = std::ranges::minmax(h.painted, {}, &PaintedHere::z);
    const PaintedHere& one = h.painted[k];
    const std::string name = faceName(story.picture, one.fragment.face);
    const bool piece = one.fragment.piece >= 0;
    hasParts = hasParts || nameOfFace(story.picture, one.fragment.face).find('.') != std::string::npos;
    t.rows.push_back({{std::to_string(k + 1)},
                      {{}, story.picture.snapped().faces[one.fragment.face].number},
                      {name + (piece ? " (a piece)" : ""), name},
                      {{}, piece},
                      {.share = high.z > low.z ? (one.z - low.z) / (high.z - low.z) : 1.0},
                      {.data = one.z, .number = one.z, .decimals = 3},
                      {.words = fateOf(story, k), .tone = Tone::Soft}});
  }
  s.add(std::move(t));
  if (hasParts) s.say("face 7.2: the second convex part of face 7 of the scene; behind it its group", 0);
  s.fact("not_painted", h.notPainted,
         h.notPainted > 0
             ? "hidden everywhere: " + std::to_string(h.notPainted) + " more at this sample, not painted"
             : "",
         8);
  if (isWrong(h.check))
    s.say("face " + faceName(story.picture, h.nearest) +
              " is nearer and should show, as it does with Newell's order",
          6)
        .tone = Tone::Alarm;
  return s;
}

Section surfacePart(const PixelStory& story, const Explanation& e, int channel) {
  const bool gouraud = e.method == Shading::Gouraud, weights = e.vertices.size() == 3;
  const std::string side = story.picture.snapped().faces[e.face].back ? "back side" : "front side";
  const std::string which = e.method == Shading::Phong ? "the weights in the world count"
                            : e.texel                  ? "in the world for u and v, on the screen for I"
                                                       : "the weights on the screen count";
  Section s{"2 surface", std::string{rowOf(e.method).label} + ", " + side + (weights ? ": " + which : "")};
  s.fact("shading", rowOf(e.method).name,
         e.method == Shading::Flat ? "one normal and one place: the centroid of the face"
                                   : std::string{rowOf(e.method).evaluates},
         e.vertices.empty() ? 7 : 1);
  Table t{.key = "vertices",
          .columns = {{"vertex"}, {"x, y", "x"}, {{}, "y"}, {"screen", "on_screen"}, {"world", "in_world"}},
          .most = 4,
          .weight = 7};
  for (const char* name : {"Nx", "Ny", "Nz"})
    t.columns.push_back({gouraud ? "" : name, *(name + 1) == 'x' ? "N" : "", true});
  if (gouraud) t.columns.push_back({"I", "I"});
  const auto addN = [&](std::vector<Entry>& row, const glm::dvec3& N) {
    for (int k = 0; k < 3; ++k) row.push_back({gouraud ? "" : number(N[k]), k == 0 ? Data{N} : Data{}});
  };
  for (std::size_t k = 0; k < e.vertices.size(); ++k) {
    const ExplainedVertex& v = e.vertices[k];
    std::string I;
    for (int c = 0; c < e.channels; ++c) I += (c > 0 ? "  " : "") + asked(kI, number(v.I[c]));
    t.rows.push_back({{letterOf(k)},
                      {fixed(v.at.x, 2) + ", " + fixed(v.at.y, 2), v.at.x},
                      {{}, v.at.y},
                      {weights ? number(v.onScreen) : "", v.onScreen},
                      {weights ? number(v.inWorld) : "", v.inWorld}});
    addN(t.rows.back(), v.N);
    if (gouraud) t.rows.back().push_back({I, data(v.I, e.channels)});
  }
  if (e.method == Shading::Phong && e.sum != glm::dvec3{0.0}) {
    const bool kept = keepsLengthOfN(story.picture.settings());
    t.foot = {{{.words = std::string{"weighted sum, "} + (kept ? "kept at length " : "length ") +
                         number(glm::length(e.sum)),
                .span = 5}}};
    addN(t.foot.back(), e.sum);
  }
  s.add(std::move(t));
  const auto at = [](const auto& place) {
    return std::to_string(place.column) + ", row " + std::to_string(place.row);
  };
  if (e.texel)
    s.fact("texel",
           Object{{"u", e.texel->u},
                  {"v", e.texel->v},
                  {"column", e.texel->column},
                  {"row", e.texel->row},
                  {"share", data(e.texel->share, e.channels)}},
           "texel in column " + at(*e.texel) + ": u " + number(e.texel->u) + ", v " + number(e.texel->v) +
               ", leaves " + number(e.texel->share[channel]) + " of the diffuse term",
           7);
  if (e.place)
    s.add(Fact{
        "place", Object{{"column", e.place->column}, {"row", e.place->row}, {"away", e.place->away}},
        "place in the map: column " + at(*e.place) + (e.place->away ? ", of the side that faces away" : ""),
        Tone::Ink, 7});
  return s;
}

/// In a text (`whole`), each light has a line with its cosines.
void addVectors(Section& s, const PixelStory& story, const ExplainedEquation& at, bool whole) {
  const Illumination& user = story.picture.settings().light;
  if (at.lights.empty()) {
    s.say("No light but the ambient reaches the scene, so no normal counts.", 6);
    return;
  }
  const auto place = [&](const glm::dvec3& p) {
    const glm::dvec3 q = inFileUnits(p, story.picture.scene());
    return fitted(q.x, kD, 11) + ", " + fitted(q.y, kD, 11) + ", " + fitted(q.z, kD, 11);
  };
  s.say("N" + components(at.N) + "    V" + components(at.V));
  const bool several = at.lights.size() > 1;
  Table t{.columns = {{}}, .least = 2, .rowWeight = 3, .weight = 3};
  for (std::size_t k = 0; k < at.lights.size(); ++k) {
    const ExplainedLight& light = at.lights[k];
    const std::string which = several ? std::to_string(k + 1) : "";
    const std::string L = "L" + which + components(light.L);
    const bool hasR =
        user.form != Form::Tutorial && (light.NdotL > 0.0 || rowOf(user.mistake).highlightBehind);
    const std::string R =
        hasR ? (user.form == Form::Textbook ? "R" : "H") + which + asked(kNL, components(light.R))
             : "";  // R would tell N.L
    if (several && !whole) {
      t.rows.push_back({{L + (hasR ? "    " + R : "")}});
    } else {
      s.say(L + "    N.L " + asked(kNL, number(light.NdotL) + (light.NdotL > 0.0 ? "" : ": behind")));
      if (hasR)
        s.say(
            R + "    " + std::string{cosineName(user.form)} + ' ' +
            asked(kRV, number(light.cosine) +
                           (light.counted == 0.0 ? ", counts as 0" : ", its power " + number(light.power))) +
            (whole && user.form == Form::Textbook ? "; R is " + std::string{rowOf(user.mistake).R} : ""));
    }
    if (light.fatt != 1.0 || light.spot != 1.0)
      s.say(
          "f" + which + " = " + factor(light.fatt) + " by distance x " + factor(light.spot) + " by the cone",
          2);
    if (light.ownL)
      s.say("from here, for the cone alone, L is" + components(*light.ownL) + ": L" + which +
                " and the distance are those of the scene's centre",
            3);
  }
  s.add(std::move(t));
  s.say("at " + place(at.P) + "; the eye is at " + place(story.picture.camera().eye), 1);
}

/// An equation in one channel, or in all.
void addEquation(Section& s, const Story& story, const Explanation& e, const ExplainedEquation& at,
                 const std::string& where, const PixelChoice& choice) {
  const Illumination& user = story->picture.settings().light;
  const auto lights = static_cast<int>(at.lights.size());
  const int first = choice.channel.value_or(0);
  s.say(where + formulaOf(e, user), 9).tone = Tone::Bold;
  if (user.mistake != Mistake::None) {
    Fact& wrong = s.say("a mistake: " + std::string{rowOf(user.mistake).is}, 6);
    wrong.tone = Tone::Alarm, wrong.indent = 2;
  }
  if (lights > 0)
    s.add(Sketch{.draw = [story, &e, &at, first, ball = choice.ball](
                             Pen& pen, const Rect& area) { drawBall(pen, area, *story, e, at, first, ball); },
                 .lines = 7,
                 .beside = true,
                 .id = kPressBall,
                 .weight = 6});
  for (int c = first; c < (choice.channel ? first + 1 : e.channels); ++c) {
    if (!choice.channel && e.channels > 1) s.say(std::string{kChannelNames[static_cast<std::size_t>(c)]});
    Table put{.columns = {{}}, .least = 2, .most = 9, .rowWeight = 6, .indent = 2};
    for (std::string& line : numbersPutIn(e, at, c, rowOf(user.mistake)))
      put.rows.push_back({{std::move(line)}});
    s.add(std::move(put));
    Fact& sum = s.say(sumOf(at, c, lights > 2 && choice.channel), 9);
    sum.tone = Tone::Bold, sum.indent = 2;
  }
  addVectors(s, *story, at, !choice.channel);
  const std::array<double, 3> terms{at.ambient[first], at.diffuse(first), at.specular(first)};
  const std::vector<double> rounded = roundedTerms({terms.begin(), terms.end()}, kD);
  s.add(Sketch{.draw = [terms](Pen& pen, const Rect& area) { drawTerms(pen, area, terms); }, .tells = kI});
  if (choice.channel)
    s.say("ambient " + number(rounded[0]) + "   diffuse " + number(rounded[1]) + "   specular " +
              number(rounded[2]) + "\tI " + number(at.I[first]) + " of 1",
          5, kI)
        .tone = Tone::Soft;
}

/// The equations that a window shows, or a text: of a vertex, or all; and the questions about the first.
void addEquations(Page& page, const Story& story, const Explanation& e, const PixelChoice& choice) {
  Section& s = page.sections.emplace_back(Section{"3 equation"});
  const int lights = e.equations.empty() ? 0 : static_cast<int>(e.equations.front().lights.size());
  const int c = choice.channel.value_or(0);
  if (e.channels > 1)
    s.aside = choice.channel ? std::string{kChannelNames[static_cast<std::size_t>(c)]} : "by channel";
  if (lights > 1) s.aside += (s.aside.empty() ? "" : ", ") + counted(lights, "light");
  for (const std::string& line : depthWords(e))
    s.say(line).tone = s.parts.size() > 1 ? Tone::Ink : Tone::Bold;
  const bool gouraud = e.method == Shading::Gouraud, map = e.method == Shading::Environment;
  const ExplainedEquation* first = nullptr;
  for (std::size_t k = 0; k < (gouraud ? e.vertices.size() : e.equations.size()); ++k) {
    if (gouraud && choice.vertex && static_cast<std::size_t>(*choice.vertex) != k) continue;
    const int at = gouraud ? e.vertices[k].equation : static_cast<int>(k);
    if (at < 0) continue;
    const ExplainedEquation& one = e.equations[static_cast<std::size_t>(at)];
    if (!first) first = &one;
    addEquation(s, story, e, one,
                gouraud                     ? "at " + letterOf(k) + ": "
                : e.method == Shading::Flat ? "at the centroid: "
                                            : "",
                choice);
  }
  if (first && gouraud) {
    std::string I;
    for (int k = 0; k < e.channels; ++k) I += (k > 0 ? ", " : " ") + number(e.I[k]);
    s.say("interpolated to this sample: I" + I +
              (e.texel ? "; the diffuse part is multiplied by the texel" : ""),
          7, kI);
  } else if (!first && !e.depth) {
    if (map)
      s.add(Sketch{.draw = [story, &e, c](Pen& pen, const Rect& area) { drawMap(pen, area, *story, e, c); },
                   .lines = 7,
                   .beside = true,
                   .left = true,
                   .weight = 4});
    s.say(!e.equations.empty() ? "Clipping made this vertex: its I is interpolated along the edge."
          : map                ? "The map holds the equation for every normal: I " + number(e.I[0])
                               : "No light is computed: I " + number(e.I[0]));
    if (map) {
      s.say(e.place && e.place->away ? "normals that face away from the light" : "the map of this material",
            3)
          .tone = Tone::Soft;
      if (choice.channel) s.say("The ring is the place that is looked up.", 3).tone = Tone::Soft;
    }
  }
  if (!first || first->lights.empty()) return;
  const Form form = story->picture.settings().light.form;
  const ExplainedLight& light = first->lights.front();
  const std::vector<double> t = roundedTerms({first->ambient[c], first->diffuse(c), first->specular(c)}, kD);
  const std::string ofFirst = lights > 1 ? " of the first light" : "",
                    ofAll = lights > 1 ? ", of all lights" : "";
  page.questions.push_back({kNL, "N.L" + ofFirst, light.NdotL, light.NdotL});
  if (form != Form::Tutorial && light.NdotL > 0.0)
    page.questions.push_back({kRV, std::string{cosineName(form)} + ofFirst, light.cosine, light.cosine});
  page.questions.push_back({kDiffuse, "the diffuse term" + ofAll, first->diffuse(c), t[1]});
  page.questions.push_back({kSpecular, "the specular term" + ofAll, first->specular(c), t[2]});
  page.questions.push_back({kI, "I, the sum of the terms", first->I[c], t[0] + t[1] + t[2]});
  if (e.channels == 1 && !story->inColors())
    page.questions.back().lands = [story, &e](double I) { return tableOf(*story, e).cell(I); };
}

/// The shades of the table around one.
void drawShades(Pen& pen, const Rect& area, const ColorTable& table, int shade) {
  const int width = area.width / 6;
  for (int j = std::max(0, shade - 2); j <= std::min(table.shades() - 1, shade + 2); ++j) {
    const Rect one{area.x + (j - shade + 2) * width, area.y, width, area.height};
    pen.paint.fillRect(one, static_cast<std::uint8_t>(table.first() + j));
    if (j != shade) continue;
    pen.paint.frame(one, pen(Cell::Black));
    pen.paint.frame({one.x + 1, one.y + 1, one.width - 2, one.height - 2}, pen(Cell::White));
  }
}

/// From the intensity to a shade of the table.
void addShade(Section& s, const Story& story, const Explanation& e, const PixelChoice& choice) {
  const ColorTable& table = tableOf(*story, e);
  const auto& kind = kTables[static_cast<int>(table.settings().kind)];
  const int shade = std::clamp(e.value[0] - table.first(), 0, table.shades() - 1);
  const ColorTable::Picked picked = table.picked(shade);
  const Rgb16 color = table.color(shade),
              stored = choice.palette ? (*choice.palette)[static_cast<std::size_t>(e.value[0])] : color;
  // At a border the rounding of the loop decides.
  const bool own = picked.has(e.intensity);
  const double I = own ? e.intensity : e.inLoop;
  constexpr int kMostDecimals = 12;
  int decimals = kD;  // as many as it takes to tell I from the borders
  const auto written = [&](double v) {
    return decimals <= kMostDecimals ? fixed(v, decimals) : significant(v, decimals - kMostDecimals);
  };
  const auto lies = [&] { return picked.has(std::stod(written(I))) || !picked.has(I); };
  while (!lies()) ++decimals;
  if (e.luminance)
    s.say("one hue: the luminance 0.30 R + 0.59 G + 0.11 B of " + fixed(e.I[0], 2) + ", " + fixed(e.I[1], 2) +
              ", " + fixed(e.I[2], 2),
          7, kI);
  s.add(Sketch{
      .draw = [story, &table, shade](Pen& pen, const Rect& area) { drawShades(pen, area, table, shade); },
      .tells = kCell});
  const auto hidden = [](int v) { return asked(kCell, std::to_string(v)); };
  s.fact("shade", shade,
         (own ? "I " : "in the picture's loop, I ") + asked(kI, written(I)) + " picks shade " +
             hidden(shade) + " of " + std::to_string(table.shades()) + " (" + std::string{kind.name} +
             "), cell " + std::to_string(table.first()) + " + " + hidden(shade) + " = " + hidden(e.value[0]),
         9, kI);
  s.fact("table", Object{{"name", kind.name}, {"first", table.first()}, {"shades", table.shades()}});
  if (!own) s.fact("in_loop", e.inLoop);
  s.fact("interval", List{picked.from, picked.to},
         "that shade is for " + pickedText(table, shade, decimals) + "; it holds " + listed(stored, 0), 7,
         kCell);
  s.fact("color", List{color.r, color.g, color.b}, "of 65535, as " + holdsText(table), 1, kCell);
  if (choice.shownBits > 0)
    s.say("this screen shows " +
              (choice.shownBits == 16 ? "all 16 bits"
                                      : "the upper " + std::to_string(choice.shownBits) + " bits") +
              ": " + listed(stored, 16 - choice.shownBits),
          2, kCell);
  if (std::abs(e.inLoop - e.intensity) > 1e-4)
    s.say("the picture's loop has I " + number(e.inLoop) +
              (story->picture.settings().interpolated == Interpolated::Cell
                   ? ": it interpolates the numbers of cells"
                   : ""),
          6, kI);
}

Section tablePart(const Story& story, const Explanation& e, bool shown, const PixelChoice& choice) {
  Section s{"4 table"};
  s.fact("value", e.value[1] > 0 ? Data{List{e.value[0], e.value[1], e.value[2]}} : Data{e.value[0]});
  const std::string cell = std::to_string(story->cell());
  if (story->inColors()) {
    s.say(
        "each channel is 1 + 254 I, rounded: " + listed(e.value) + "; as a colour " + listed(wantedColor(e)),
        8, kI);
    const Palette palette = choice.palette
                                ? *choice.palette
                                : story->picture.palette(CellPlan{story->picture.settings().table.kind});
    if (shown)
      s.say((story->picture.settings().dither ? "one of two colours that share these places: cell "
                                              : "the nearest colour that a cell holds: cell ") +
                cell + " has " + listed(palette[static_cast<std::size_t>(story->cell())], 8) + " of 255",
            8, kI);
  } else {
    addShade(s, story, e, choice);
  }
  if (!shown) return s;
  const bool explained = story->isExplained();
  s.say("the picture has cell " + strong(cell) + " here" +
            (explained ? ": the chain explains it" + std::string{kTick}
                       : ", and THE CHAIN DOES NOT END THERE"),
        9, kCell)
      .tone = explained ? Tone::Ink : Tone::Alarm;
  return s;
}

/// What only JSON has: all equations with all their numbers.
Section dataOf(const PixelStory& story) {
  const Picture& picture = story.picture;
  Section s;
  s.fact("pixel", List{story.i, story.j});
  s.fact("size", List{picture.settings().width, picture.settings().height});
  s.fact("verdict", story.verdict());
  s.fact("cell", story.cell());
  s.fact("explained", story.isExplained());
  s.fact("mistake", rowOf(picture.settings().light.mistake).name);
  const Explanation* const e = story.shown();
  if (!e) return s;
  const auto channels = [&](const ByChannel& v) { return data(v, e->channels); };
  List equations;
  for (const ExplainedEquation& at : e->equations) {
    List lights;
    for (const ExplainedLight& light : at.lights) {
      Object told{{"L", light.L},           {"R", light.R},         {"N.L", light.NdotL},
                  {"cosine", light.cosine}, {"power", light.power}, {"fatt", light.fatt},
                  {"spot", light.spot}};
      if (light.ownL) told.emplace_back("L_for_cone", *light.ownL);
      told.insert(told.end(), {{"Ip", channels(light.Ip)},
                               {"diffuse", channels(light.diffuse)},
                               {"specular", channels(light.specular)}});
      lights.push_back(std::move(told));
    }
    const auto ofSurface = [&](double Reflection::*k) {
      return channels({at.surface[0].*k, at.surface[1].*k, at.surface[2].*k});
    };
    equations.push_back(Object{{"at", inFileUnits(at.P, picture.scene())},
                               {"N", at.N},
                               {"V", at.V},
                               {"ka", ofSurface(&Reflection::ka)},
                               {"kd", ofSurface(&Reflection::kd)},
                               {"ks", ofSurface(&Reflection::ks)},
                               {"n", at.surface[0].n},
                               {"Ia", channels(at.Ia)},
                               {"ambient", channels(at.ambient)},
                               {"lights", lights},
                               {"I", channels(at.I)}});
  }
  Data terms;  // null where several equations are interpolated, or none is evaluated
  if (e->equations.size() == 1 && e->method != Shading::Gouraud) {
    const ExplainedEquation& at = e->equations.front();
    terms = Object{{"ambient", channels(at.ambient)},
                   {"diffuse", channels({at.diffuse(0), at.diffuse(1), at.diffuse(2)})},
                   {"specular", channels({at.specular(0), at.specular(1), at.specular(2)})}};
  }
  s.fact("shown", story.history.shown);
  s.fact("I", channels(e->I));
  s.fact("intensity", e->intensity);
  s.fact("terms", std::move(terms));
  s.fact("equations", std::move(equations));
  if (e->depth)
    s.fact("depth", Object{{"z", List(e->depth->z.begin(), e->depth->z.end())}, {"a", e->depth->a()}});
  return s;
}

}  // namespace

Page ofPixel(const Story& story, const PixelChoice& choice) {
  const Picture& picture = story->picture;
  const PixelHistory& h = story->history;
  const int chosen = choice.chosen >= 0 ? choice.chosen : h.shown;
  const std::string cell = std::to_string(story->cell());
  Page all{.of = "pixel " + std::to_string(story->i) + ", " + std::to_string(story->j) + " of " +
                 titleOf(picture.scene()) + " at " +
                 sizeText(picture.settings().width, picture.settings().height),
           .title = std::string{story->verdict()},
           .alarms = isWrong(h.check),
           .sections = {dataOf(*story), historyPart(*story, chosen)},
           .order =
               "pixel size verdict cell explained history not_painted mistake shown shading I intensity "
               "terms vertices equations value depth texel place shade table in_loop interval color"};
  if (h.painted.empty()) {
    all.under = {"No polygon covers this sample.", "The background is cell " + cell + "."};
    all.sections.back().title.clear();
    return all;
  }
  const auto times = static_cast<std::int64_t>(h.painted.size());
  all.under = {times == 1 ? "One polygon is at this sample."
                          : "The " + std::string{h.shown + 1 == times ? "last" : "nearest"} + " of " +
                                counted(times, "polygon") + " at this sample shows."};
  if (isWrong(h.check))
    all.under.push_back("Face " + faceName(picture, h.nearest) + " is nearer.");
  else if (const Explanation* const shown = story->shown())
    all.under.push_back(std::string{rowOf(shown->method).label} + ": I " +
                        asked(kI, intensityWords(*story, *shown)) + ", cell " + asked(kCell, cell));
  if (chosen < 0) return all;
  const Explanation& e = story->explained[static_cast<std::size_t>(chosen)];
  all.sections.push_back(surfacePart(*story, e, choice.channel.value_or(0)));
  addEquations(all, story, e, choice);
  all.sections.push_back(tablePart(story, e, chosen == h.shown, choice));
  if (!story->inColors()) {
    const auto value = static_cast<double>(e.value[0]);
    all.questions.push_back({kCell, "the cell", value, value, 0,
                             [](double typed) { return static_cast<int>(std::lround(typed)); }});
  }
  return all;
}

Page besidePixel(const Story& story, const PixelChoice& choice) {
  const bool ground = story->history.painted.empty();
  const int face = ground ? -1 : story->explained[static_cast<std::size_t>(choice.chosen)].face;
  Section s;
  s.add(Sketch{
      .draw = [story, face](Pen& pen, const Rect& area) { drawNeighbourhood(pen, area, *story, face); },
      .lines = 6,
      .beside = true,
      .left = true,
      .most = 1,
      .id = kPressAround,
      .weight = 9});
  const auto fact = [&](const std::string& name, const std::string& value, int weight, int tells = 0) {
    s.say(name + '\t' + value, weight, tells);
  };
  fact("pixel", std::to_string(story->i) + ", " + std::to_string(story->j), 8);
  if (const Explanation* const shown = story->shown()) {
    const std::string name = faceName(story->picture, shown->face),
                      number = nameOfFace(story->picture, shown->face);
    fact("face", number, 2);
    if (name != number) fact("part", name.substr(number.size() + 2), 1);
  }
  fact("cell", asked(kCell, std::to_string(story->cell())), 7);
  if (story->shown()) fact("I", asked(kI, intensityWords(*story, *story->shown())), 7);
  if (choice.before) {
    fact("before: cell", std::to_string(choice.before->cell), 6, kNL);
    fact("I", choice.before->I, 6, kNL);
  }
  return {.sections = {std::move(s)}};
}

}  // namespace page

}  // namespace xnewell
