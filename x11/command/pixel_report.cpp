#include "x11/command/pixel_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string_view>

#include "shading/explain/term_values.h"
#include "shading/scene/units.h"
#include "x11/drawing/wording.h"
#include "x11/pixel/pixel_words.h"
#include "x11/viewing/viewing_words.h"

namespace xnewell {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> kChannels{"red", "green", "blue"};

std::string number(double v) { return fixed(v, kPixelDecimals); }
char letterOf(std::size_t vertex) { return static_cast<char>('A' + vertex % 26); }

void printHistory(const PixelStory& story, std::ostream& out) {
  out << "1 history: polygons in the order of painting; z in pixels of the view plane, larger is nearer\n";
  for (std::size_t k = 0; k < story.history.painted.size(); ++k) {
    const PaintedHere& one = story.history.painted[k];
    std::string name =
        faceName(story.picture, one.fragment.face) + (one.fragment.piece < 0 ? "" : " (a piece)");
    if (name.size() < 36) name.resize(36, ' ');
    out << "  " << std::setw(3) << k + 1 << "  face " << name << std::setw(12) << fixed(one.z, 3) << "  "
        << fateOf(story, k) << '\n';
  }
  if (std::ranges::any_of(story.history.painted, [&](const PaintedHere& one) {
        return faceName(story.picture, one.fragment.face).find('.') < 8;
      }))
    out << "       a face is named by its number in the scene, .1 or .2 for its first or second convex part, "
           "and its group\n";
  if (story.history.notPainted > 0)
    out << "       hidden everywhere: " << counted(story.history.notPainted, "more polygon")
        << " at this sample, not painted\n";
  if (isWrong(story.history.check))
    out << "       face " << faceName(story.picture, story.history.nearest)
        << " is nearer and should show: choose --order newell\n";
}

void printVertices(const Explanation& e, std::ostream& out) {
  if (e.vertices.empty()) return;
  const bool weights = e.vertices.size() == 3, normals = e.method != Shading::Gouraud;
  out << "      vertex" << std::setw(20) << "x, y" << (weights ? "   on screen   in world" : "")
      << (normals ? "        N" : "        I");
  if (weights) out << "   (" << weightsThatCount(e) << ')';
  out << '\n';
  for (std::size_t k = 0; k < e.vertices.size(); ++k) {
    const ExplainedVertex& v = e.vertices[k];
    out << "      " << letterOf(k) << std::setw(25) << fixed(v.at.x, 2) + ", " + fixed(v.at.y, 2);
    if (weights) out << std::setw(12) << number(v.onScreen) << std::setw(11) << number(v.inWorld);
    if (normals) out << componentsOf(v.N);
    for (int c = 0; c < e.channels && !normals; ++c) out << std::setw(9) << number(v.I[c]);
    out << '\n';
  }
}

void printSurface(const PixelStory& story, const Explanation& e, std::ostream& out) {
  out << "2 surface: face " << faceName(story.picture, e.face) << ", "
      << (story.picture.snapped().faces[e.face].back ? "back" : "front") << "; shading "
      << rowOf(e.method).name << "\n      " << rowOf(e.method).evaluates << '\n';
  printVertices(e, out);
  if (e.method == Shading::Phong && e.sum != glm::dvec3{0.0})
    out << "      weighted sum" << std::setw(37) << "" << componentsOf(e.sum)
        << (keepsLengthOfN(story.picture.settings()) ? "\n      it stays as long as it is, "
                                                     : "\n      divided by its length, ")
        << number(glm::length(e.sum)) << '\n';
  if (e.texel) {
    out << "      texture: u " << number(e.texel->u) << ", v " << number(e.texel->v)
        << "; the texel in column " << e.texel->column << ", row " << e.texel->row << " leaves";
    for (int c = 0; c < e.channels; ++c) out << ' ' << number(e.texel->share[c]);
    out << " of the diffuse term\n";
  }
  if (e.place)
    out << "      the normal's place in the map: column " << e.place->column << ", row " << e.place->row
        << (e.place->away ? ", of the side that faces away\n" : "\n");
}

void printVectors(const Picture& picture, const ExplainedEquation& at, std::ostream& out) {
  const Illumination& user = picture.settings().light;
  const Form form = user.form;
  const auto place = [&](const glm::dvec3& p) {
    std::string all;
    for (int axis = 0; axis < 3; ++axis)
      all += (axis > 0 ? ", " : "") + fitted(inFileUnits(p, picture.scene())[axis], kPixelDecimals, 11);
    return all;
  };
  out << "        at " << place(at.P) << "; the eye is at " << place(picture.camera().eye) << '\n';
  if (const std::string lengths = lengthsInWords(picture.scene()); !lengths.empty())
    out << "        " << lengths << '\n';
  out << "        N " << componentsOf(at.N) << "\n        V " << componentsOf(at.V) << "   to the eye\n";
  for (std::size_t k = 0; k < at.lights.size(); ++k) {
    const ExplainedLight& light = at.lights[k];
    const std::string which = at.lights.size() > 1 ? std::to_string(k + 1) : " ";
    out << "        L" << which << componentsOf(light.L) << "   to the light"
        << (at.lights.size() > 1 ? ' ' + which : "") << "; N.L " << number(light.NdotL)
        << (light.NdotL > 0.0 ? "" : ": it does not reach this side");
    if (light.fatt != 1.0 || light.spot != 1.0)
      out << "; f = " << number(light.fatt) << " by distance x " << number(light.spot) << " by the cone";
    out << '\n';
    const MistakeRow& row = rowOf(user.mistake);
    if (form == Form::Tutorial || (light.NdotL <= 0.0 && !row.highlightBehind)) continue;
    out << "        " << (form == Form::Textbook ? 'R' : 'H') << which << componentsOf(light.R) << "   "
        << (form == Form::Textbook ? row.R : "half way from L to V") << "; " << cosineName(form) << ' '
        << number(light.cosine) << (light.counted == 0.0 ? ", counts as 0" : "") << ", its power "
        << number(light.power) << '\n';
  }
}

void printEquation(const PixelStory& story, const Explanation& e, const ExplainedEquation& at,
                   const std::string& where, std::ostream& out) {
  const Illumination& user = story.picture.settings().light;
  out << "      " << where << formulaOf(e, user)
      << (at.lights.size() > 1 ? ", the last part for each light\n" : "\n");
  if (const std::string wrong = mistakeWords(e, user); !wrong.empty())
    out << "        a mistake: " << wrong << '\n';
  for (int c = 0; c < e.channels; ++c) {
    if (e.channels > 1) out << "      " << kChannels[c] << '\n';
    for (const std::string& line : numbersPutIn(e, at, c, user.mistake)) out << "        " << line << '\n';
    out << "        " << sumOf(at, c) << '\n';
  }
  if (at.lights.empty())
    out << "        no light but the ambient reaches the scene, so no normal counts\n";
  else
    printVectors(story.picture, at, out);
}

void printEquations(const PixelStory& story, const Explanation& e, std::ostream& out) {
  out << "3 equation" << (e.channels > 1 ? ", by channel" : "") << '\n';
  if (e.depth) {
    for (const std::string& line : depthWords(e)) out << "      " << line << '\n';
    return;
  }
  if (e.equations.empty()) {
    out << "      " << (e.method == Shading::Environment ? "the map holds" : "no light is computed:") << " I "
        << number(e.I[0]) << '\n';
    return;
  }
  if (e.method != Shading::Gouraud)
    return printEquation(story, e, e.equations.front(), e.method == Shading::Flat ? "at the centroid: " : "",
                         out);
  for (std::size_t k = 0; k < e.vertices.size(); ++k)
    if (const int at = e.vertices[k].equation; at >= 0)
      printEquation(story, e, e.equations[at], std::string{"at "} + letterOf(k) + ": ", out);
  out << "      interpolated to the sample: I";
  for (int c = 0; c < e.channels; ++c) out << (c > 0 ? ", " : " ") << number(e.I[c]);
  out << (e.texel ? "; the diffuse part is multiplied by the texel\n" : "\n");
}

void printTable(const PixelStory& story, const Explanation& e, std::ostream& out) {
  out << "4 table\n";
  const auto verdictOfChain = [&] {
    out << "      the picture has cell " << story.cell()
        << " here: " << (story.isExplained() ? "the chain explains it" : "THE CHAIN DOES NOT EXPLAIN IT")
        << '\n';
  };
  if (story.inColors()) {
    const Palette palette = story.picture.palette(CellPlan{story.picture.settings().table.kind});
    out << "      " << channelsInWords(e) << "\n      "
        << heldInWords(story, palette[static_cast<std::size_t>(story.cell())]) << '\n';
    return verdictOfChain();
  }
  if (e.luminance)
    out << "      one hue for all colours: the luminance 0.30 R + 0.59 G + 0.11 B is " << number(e.intensity)
        << '\n';
  const PickedWords words = pickedWords(story, e);
  const ColorTable& table = tableOf(story, e);
  const Rgb16 color = table.color(std::clamp(e.value[0] - table.first(), 0, table.shades() - 1));
  out << "      " << words.picks << "\n      " << words.range << "; the cell holds " << color.r << ", "
      << color.g << ", " << color.b << " of 65535 (" << kTables[static_cast<int>(table.settings().kind)].holds
      << ")\n";
  if (std::abs(e.inLoop - e.intensity) > 1e-4)
    out << "      the picture's loop has I " << number(e.inLoop)
        << (story.picture.settings().interpolated == Interpolated::Cell
                ? ": it interpolates the numbers of cells\n"
                : "\n");
  verdictOfChain();
}

Json asJson(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
Json asJson(const ByChannel& v, int channels) {
  if (channels == 1) return v[0];
  return {v[0], v[1], v[2]};
}

Json asJson(const ExplainedEquation& at, int channels, const Scene& scene) {
  Json lights = Json::array();
  for (const ExplainedLight& light : at.lights)
    lights.push_back({{"L", asJson(light.L)},
                      {"R", asJson(light.R)},
                      {"N.L", light.NdotL},
                      {"cosine", light.cosine},
                      {"power", light.power},
                      {"fatt", light.fatt},
                      {"spot", light.spot},
                      {"Ip", asJson(light.Ip, channels)},
                      {"diffuse", asJson(light.diffuse, channels)},
                      {"specular", asJson(light.specular, channels)}});
  const auto ofSurface = [&](double Reflection::*k) {
    return asJson(ByChannel{at.surface[0].*k, at.surface[1].*k, at.surface[2].*k}, channels);
  };
  return {{"at", asJson(inFileUnits(at.P, scene))},
          {"N", asJson(at.N)},
          {"V", asJson(at.V)},
          {"ka", ofSurface(&Reflection::ka)},
          {"kd", ofSurface(&Reflection::kd)},
          {"ks", ofSurface(&Reflection::ks)},
          {"n", at.surface[0].n},
          {"Ia", asJson(at.Ia, channels)},
          {"ambient", asJson(at.ambient, channels)},
          {"lights", lights},
          {"I", asJson(at.I, channels)}};
}

/// The terms of the one equation that counts at the sample; null where several are interpolated, or none is.
Json termsAsJson(const Explanation& e) {
  if (e.equations.size() != 1 || e.method == Shading::Gouraud) return nullptr;
  const ExplainedEquation& at = e.equations.front();
  ByChannel diffuse{}, specular{};
  for (const ExplainedLight& light : at.lights)
    for (int c = 0; c < e.channels; ++c) diffuse[c] += light.diffuse[c], specular[c] += light.specular[c];
  return {{"ambient", asJson(at.ambient, e.channels)},
          {"diffuse", asJson(diffuse, e.channels)},
          {"specular", asJson(specular, e.channels)}};
}

Json asJson(const PixelStory& story, const Explanation& e) {
  Json vertices = Json::array();
  for (const ExplainedVertex& v : e.vertices) {
    vertices.push_back({{"x", v.at.x},
                        {"y", v.at.y},
                        {"on_screen", v.onScreen},
                        {"in_world", v.inWorld},
                        {"N", asJson(v.N)}});
    if (e.method == Shading::Gouraud) vertices.back()["I"] = asJson(v.I, e.channels);
  }
  Json equations = Json::array();
  for (const ExplainedEquation& one : e.equations)
    equations.push_back(asJson(one, e.channels, story.picture.scene()));
  Json all{{"shading", rowOf(e.method).name},
           {"I", asJson(e.I, e.channels)},
           {"intensity", e.intensity},
           {"terms", termsAsJson(e)},
           {"vertices", vertices},
           {"equations", equations},
           {"value", e.value[0]}};
  if (e.depth) all["depth"] = {{"z", e.depth->z}, {"a", e.depth->a()}};
  if (e.texel)
    all["texel"] = {{"u", e.texel->u},
                    {"v", e.texel->v},
                    {"column", e.texel->column},
                    {"row", e.texel->row},
                    {"share", asJson(e.texel->share, e.channels)}};
  if (e.place) all["place"] = {{"column", e.place->column}, {"row", e.place->row}, {"away", e.place->away}};
  if (!story.inColors()) {
    const ColorTable& table = tableOf(story, e);
    const int shade = std::clamp(e.value[0] - table.first(), 0, table.shades() - 1);
    const ColorTable::Picked picked = table.picked(shade);
    const Rgb16 color = table.color(shade);
    all["shade"] = shade;
    all["table"] = {{"name", kTables[static_cast<int>(table.settings().kind)].name},
                    {"first", table.first()},
                    {"shades", table.shades()}};
    all["interval"] = {picked.from, picked.to};
    all["color"] = {color.r, color.g, color.b};
  }
  if (e.value[1] > 0) all["value"] = {e.value[0], e.value[1], e.value[2]};  // three channels
  return all;
}

}  // namespace

void printPixel(const Picture& picture, int i, int j, std::ostream& out) {
  const PixelStory story{picture, i, j};
  out << "pixel " << i << ", " << j << " of " << titleOf(picture.scene()) << " at "
      << sizeText(picture.settings().width, picture.settings().height) << ": " << story.verdict() << '\n';
  if (story.history.painted.empty()) {
    out << "no polygon covers its sample; the background is cell " << story.cell() << '\n';
    return;
  }
  printHistory(story, out);
  if (!story.shown()) return;
  printSurface(story, *story.shown(), out);
  printEquations(story, *story.shown(), out);
  printTable(story, *story.shown(), out);
}

void printPixelAsJson(const Picture& picture, int i, int j, std::ostream& out) {
  const PixelStory story{picture, i, j};
  Json history = Json::array();
  for (const PaintedHere& one : story.history.painted)
    history.push_back({{"face", picture.snapped().faces[one.fragment.face].number},
                       {"name", faceName(picture, one.fragment.face)},
                       {"piece", one.fragment.piece >= 0},
                       {"z", one.z}});
  Json all{{"pixel", {i, j}},
           {"size", {picture.settings().width, picture.settings().height}},
           {"verdict", story.verdict()},
           {"cell", story.cell()},
           {"explained", story.isExplained()},
           {"history", history},
           {"not_painted", story.history.notPainted},
           {"mistake", rowOf(picture.settings().light.mistake).name}};
  if (story.shown()) {
    all["shown"] = story.history.shown;
    all.update(asJson(story, *story.shown()));
  }
  out << all.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace xnewell
