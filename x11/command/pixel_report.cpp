#include "x11/command/pixel_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>
#include <string_view>
#include <vector>

#include "shading/explain/explain.h"
#include "shading/explain/pixel_history.h"
#include "shading/explain/rounded_terms.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kDecimals = 4;
constexpr std::array<std::string_view, 3> kChannels{"red", "green", "blue"};

/// What a pixel report is about.
struct Pixel {
  const Picture& picture;
  int i, j;
  PixelHistory history;
  std::optional<Explanation> e;  ///< none where no face shows

  Pixel(const Picture& of, int column, int row)
      : picture{of}, i{column}, j{row}, history{historyOf(of, column, row)} {
    if (history.shown >= 0) e = explain(of, history.painted[history.shown].fragment.face, i, j);
  }
  [[nodiscard]] int cell() const { return picture.image().row(j)[i]; }
  [[nodiscard]] bool inColors() const { return channelsOf(picture.colors().plan()) == Channels::Rgb; }
  /// True if the chain ends in the picture's cell.
  [[nodiscard]] bool isExplained() const { return !e || inColors() || e->value[0] == cell(); }
};

std::string_view verdictOf(const Pixel& pixel) {
  if (!pixel.e) return "ground";
  if (isWrong(pixel.history.check)) return "wrong face";
  return pixel.e->clamped ? "clamped" : "shaded";
}

/// "1954.2, spout": the face's number, the convex part of it, and the name of its group.
std::string nameOf(const Picture& picture, int face) {
  const SnappedFace& f = picture.snapped().faces[face];
  const Mesh& mesh = picture.scene().mesh;
  const ConvexParts& parts = picture.scene().parts;
  std::string name = std::to_string(f.number);
  if (!picture.shading().refined()) {
    const bool several = (f.part > 0 && parts.face[f.part - 1] == f.number) ||
                         (f.part + 1 < parts.count() && parts.face[f.part + 1] == f.number);
    const auto first = std::ranges::lower_bound(parts.face, f.number) - parts.face.begin();
    if (several) name += '.' + std::to_string(f.part - first + 1);
  }
  return name + ", " + mesh.groupNames[mesh.group[f.number]];
}

std::string numbersOf(const glm::dvec3& v) {
  std::string all;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string number = fixed(v[axis], kDecimals);
    all += std::string(9 - std::min<std::size_t>(9, number.size()), ' ') + number;
  }
  return all;
}

std::string padded(const std::string& text, int width) {
  return text + std::string(std::max(0, width - static_cast<int>(text.size())), ' ');
}

void printHistory(const Pixel& pixel, std::ostream& out) {
  out << "1 history: polygons in the order of painting; z in pixels of the view plane, larger is nearer\n";
  const bool bySample = rowOf(pixel.picture.settings().order).bySample;
  for (std::size_t k = 0; k < pixel.history.painted.size(); ++k) {
    const PaintedHere& one = pixel.history.painted[k];
    const bool shown = static_cast<int>(k) == pixel.history.shown;
    const std::string piece = one.fragment.piece < 0 ? "" : " (a piece)";
    out << "  " << std::setw(3) << k + 1 << "  face "
        << padded(nameOf(pixel.picture, one.fragment.face) + piece, 36) << std::setw(12) << fixed(one.z, 3)
        << (shown      ? "  shows"
            : bySample ? "  another is nearer, or as near and later"
                       : "  painted over by " + std::to_string(k + 2))
        << '\n';
  }
  if (pixel.history.notPainted > 0)
    out << "       hidden everywhere: " << counted(pixel.history.notPainted, "more polygon")
        << " at this sample, not painted\n";
  if (isWrong(pixel.history.check))
    out << "       face " << nameOf(pixel.picture, pixel.history.nearest)
        << " is nearer and should show: choose --order newell\n";
}

void printSurface(const Pixel& pixel, std::ostream& out) {
  const Explanation& e = *pixel.e;
  const SnappedFace& face = pixel.picture.snapped().faces[e.face];
  out << "2 surface: face " << nameOf(pixel.picture, e.face) << ", " << (face.back ? "back" : "front")
      << "; shading " << rowOf(e.method).name << ": " << rowOf(e.method).evaluates << '\n';
  const bool weights = e.vertices.size() == 3;
  const bool normals = e.method != Shading::Gouraud;
  if (!e.vertices.empty()) {
    out << "      vertex" << std::setw(20) << "x, y";
    if (weights) out << "   on screen   in world";
    out << (normals ? "        N" : "        I") << '\n';
  }
  for (std::size_t k = 0; k < e.vertices.size(); ++k) {
    const ExplainedVertex& v = e.vertices[k];
    out << "      " << static_cast<char>('A' + k % 26) << std::setw(25)
        << fixed(v.at.x, 2) + ", " + fixed(v.at.y, 2);
    if (weights)
      out << std::setw(12) << fixed(v.onScreen, kDecimals) << std::setw(11) << fixed(v.inWorld, kDecimals);
    if (normals) {
      out << numbersOf(v.N);
    } else {
      for (int c = 0; c < e.channels; ++c) out << std::setw(9) << fixed(v.I[c], kDecimals);
    }
    out << '\n';
  }
  if (e.method == Shading::Phong && e.sum != glm::dvec3{0.0})
    out << "      weighted sum" << std::setw(36) << "" << numbersOf(e.sum)
        << "\n      divided by its length, " << fixed(glm::length(e.sum), kDecimals) << '\n';
  if (e.texel) {
    out << "      texture: u " << fixed(e.texel->u, kDecimals) << ", v " << fixed(e.texel->v, kDecimals)
        << "; the texel in column " << e.texel->column << ", row " << e.texel->row << " leaves";
    for (int c = 0; c < e.channels; ++c) out << ' ' << fixed(e.texel->share[c], kDecimals);
    out << " of the diffuse term\n";
  }
  if (e.place)
    out << "      the normal's place in the map: column " << e.place->column << ", row " << e.place->row
        << (e.place->away ? ", of the side that faces away\n" : "\n");
}

/// The terms of one channel, rounded so that they add up.
void printSum(const ExplainedEquation& at, int c, std::ostream& out) {
  std::vector<double> terms{at.ambient[c]};
  for (const ExplainedLight& light : at.lights) {
    terms.push_back(light.diffuse[c]);
    terms.push_back(light.specular[c]);
  }
  const std::vector<double> rounded = roundedTerms(terms, kDecimals);
  out << "        = " << fixed(rounded[0], kDecimals);
  for (std::size_t k = 1; k < rounded.size(); ++k) out << " + " << fixed(rounded[k], kDecimals);
  const double sum = std::accumulate(rounded.begin(), rounded.end(), 0.0);
  out << " = " << fixed(sum, kDecimals) << (at.I[c] > 1.0 ? ", clamped to 1\n" : "\n");
}

/// "R.V", or what the form of the equation takes for it.
std::string cosineOf(Form form) {
  return form == Form::Textbook ? "R.V" : form == Form::HalfVector ? "N.H" : "N.L";
}

/// The numbers put in. `texel` is what the texture leaves of the diffuse term; 1 without one.
void printNumbers(const ExplainedEquation& at, int c, bool textured, double texel, std::ostream& out) {
  out << "        = " << fixed(at.surface[c].ka, 2) << " x " << fixed(at.Ia[c], 2);
  for (const ExplainedLight& light : at.lights) {
    if (at.lights.size() > 1) out << "\n       ";
    out << " + " << fixed(light.fatt * light.spot, kDecimals) << " x " << fixed(light.Ip[c], 2) << " [ "
        << fixed(at.surface[c].kd, 2) << " x " << fixed(std::max(0.0, light.NdotL), kDecimals);
    if (textured) out << " x " << fixed(texel, kDecimals);
    out << " + " << fixed(at.surface[c].ks, 2) << " x "
        << fixed(light.NdotL > 0.0 ? std::max(0.0, light.cosine) : 0.0, kDecimals) << '^' << at.surface[c].n
        << " ]";
  }
  out << '\n';
}

void printVectors(const ExplainedEquation& at, Form form, std::ostream& out) {
  out << "        N " << numbersOf(at.N) << "\n        V " << numbersOf(at.V) << "   to the eye\n";
  for (std::size_t k = 0; k < at.lights.size(); ++k) {
    const ExplainedLight& light = at.lights[k];
    out << "        L " << numbersOf(light.L) << "   to the light";
    if (at.lights.size() > 1) out << ' ' << k + 1;
    out << "; N.L " << fixed(light.NdotL, kDecimals);
    if (light.NdotL <= 0.0) out << ": it does not reach this side";
    out << '\n';
    if (form == Form::Tutorial || light.NdotL <= 0.0) continue;
    out << "        " << (form == Form::Textbook ? 'R' : 'H') << ' ' << numbersOf(light.R)
        << (form == Form::Textbook ? "   2 N (N.L) - L; " : "   half way from L to V; ") << cosineOf(form)
        << ' ' << fixed(light.cosine, kDecimals) << ", its power " << fixed(light.power, kDecimals) << '\n';
  }
}

void printEquation(const Pixel& pixel, const ExplainedEquation& at, const std::string& where,
                   std::ostream& out) {
  const Explanation& e = *pixel.e;
  const Form form = pixel.picture.settings().light.form;
  const bool textured = e.texel && e.method != Shading::Gouraud;  // Gouraud's vertices know no texel
  out << "      " << where << "I = ka Ia + f Ip [ kd N.L" << (textured ? " x texel" : "") << " + ks ("
      << cosineOf(form) << ")^n ]" << (at.lights.size() > 1 ? ", the last part for each light\n" : "\n");
  for (int c = 0; c < e.channels; ++c) {
    if (e.channels > 1) out << "      " << kChannels[c] << '\n';
    printNumbers(at, c, textured, textured ? e.texel->share[c] : 1.0, out);
    printSum(at, c, out);
  }
  if (at.lights.empty())
    out << "        no light but the ambient reaches the scene, so no normal counts\n";
  else
    printVectors(at, form, out);
}

/// What comes of the intensities at the vertices.
void printInterpolated(const Explanation& e, std::ostream& out) {
  out << "      interpolated to the sample: I";
  for (int c = 0; c < e.channels; ++c) out << (c > 0 ? ", " : " ") << fixed(e.I[c], kDecimals);
  if (e.texel) out << "; the diffuse part is multiplied by the texel";
  out << '\n';
}

void printEquations(const Pixel& pixel, std::ostream& out) {
  const Explanation& e = *pixel.e;
  out << "3 equation" << (e.channels > 1 ? ", by channel" : "") << '\n';
  if (e.equations.empty()) {
    out << "      " << (e.method == Shading::Environment ? "the map holds" : "no light is computed:") << " I "
        << fixed(e.I[0], kDecimals) << '\n';
    return;
  }
  for (std::size_t k = 0; k < e.vertices.size() && e.method == Shading::Gouraud; ++k)
    if (const int number = e.vertices[k].equation; number >= 0)
      printEquation(pixel, e.equations[number], std::string{"at "} + static_cast<char>('A' + k % 26) + ": ",
                    out);
  if (e.method != Shading::Gouraud)
    printEquation(pixel, e.equations.front(), e.method == Shading::Flat ? "at the centroid: " : "", out);
  if (e.method == Shading::Gouraud) printInterpolated(e, out);
}

/// As many decimals, four or more, as it takes to tell the value from the borders.
int decimalsFor(double value, const ColorTable::Picked& picked) {
  int decimals = kDecimals;
  while (decimals < 12 && (fixed(value, decimals) == fixed(picked.from, decimals) ||
                           fixed(value, decimals) == fixed(picked.to, decimals)))
    ++decimals;
  return decimals;
}

void printTable(const Pixel& pixel, std::ostream& out) {
  const Explanation& e = *pixel.e;
  out << "4 table\n";
  if (pixel.inColors()) {
    out << "      red, green and blue are " << e.value[0] << ", " << e.value[1] << " and " << e.value[2]
        << " of 1 to 255; the cells hold colours (--colors), and this one's is in cell " << pixel.cell()
        << '\n';
    return;
  }
  const int material = pixel.picture.scene().mesh.material[pixel.picture.snapped().faces[e.face].number];
  const ColorTable& table = pixel.picture.colors().tableOf(material);
  const int shade = e.value[0] - table.first();
  if (e.luminance)
    out << "      one hue for all colours: the luminance 0.30 R + 0.59 G + 0.11 B is "
        << fixed(e.intensity, kDecimals) << '\n';
  const ColorTable::Picked picked = table.picked(std::clamp(shade, 0, table.shades() - 1));
  const Rgb16 color = table.color(std::clamp(shade, 0, table.shades() - 1));
  const int decimals = decimalsFor(e.intensity, picked);
  out << "      I " << fixed(e.intensity, decimals) << " picks shade " << shade << " of " << table.shades()
      << " (" << kTables[static_cast<int>(table.settings().kind)].name << "), cell " << table.first() << " + "
      << shade << " = " << e.value[0] << "\n      that shade is for " << fixed(picked.from, decimals)
      << " <= I < " << fixed(picked.to, decimals) << "; the cell holds " << color.r << ", " << color.g << ", "
      << color.b << " of 65535\n";
  if (std::abs(e.inLoop - e.intensity) > 1e-4)
    out << "      the picture's loop has I " << fixed(e.inLoop, kDecimals)
        << (pixel.picture.settings().interpolated == Interpolated::Cell
                ? ": it interpolates the numbers of cells\n"
                : "\n");
  out << "      the picture has cell " << pixel.cell()
      << " here: " << (pixel.isExplained() ? "the chain explains it" : "THE CHAIN DOES NOT EXPLAIN IT")
      << '\n';
}

Json asJson(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
Json asJson(const ByChannel& v, int channels) {
  if (channels == 1) return v[0];
  return {v[0], v[1], v[2]};
}

Json asJson(const ExplainedEquation& at, int channels) {
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
  return {{"at", asJson(at.P)},
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

}  // namespace

std::string verdictOf(const Picture& picture, int i, int j) {
  return std::string{verdictOf(Pixel{picture, i, j})};
}

void printPixel(const Picture& picture, int i, int j, std::ostream& out) {
  const Pixel pixel{picture, i, j};
  out << "pixel " << i << ", " << j << " of " << titleOf(picture.scene()) << " at "
      << sizeText(picture.settings().width, picture.settings().height) << ": " << verdictOf(pixel) << '\n';
  if (pixel.history.painted.empty()) {
    out << "no polygon covers its sample; the background is cell " << pixel.cell() << '\n';
    return;
  }
  printHistory(pixel, out);
  if (!pixel.e) return;
  printSurface(pixel, out);
  printEquations(pixel, out);
  printTable(pixel, out);
}

void printPixelAsJson(const Picture& picture, int i, int j, std::ostream& out) {
  const Pixel pixel{picture, i, j};
  Json history = Json::array();
  for (const PaintedHere& one : pixel.history.painted)
    history.push_back({{"face", picture.snapped().faces[one.fragment.face].number},
                       {"name", nameOf(picture, one.fragment.face)},
                       {"piece", one.fragment.piece >= 0},
                       {"z", one.z}});
  Json all{{"pixel", {i, j}},
           {"size", {picture.settings().width, picture.settings().height}},
           {"verdict", verdictOf(pixel)},
           {"cell", pixel.cell()},
           {"explained", pixel.isExplained()},
           {"history", history},
           {"not_painted", pixel.history.notPainted}};
  if (pixel.e) {
    const Explanation& e = *pixel.e;
    Json vertices = Json::array();
    for (const ExplainedVertex& v : e.vertices)
      vertices.push_back({{"x", v.at.x},
                          {"y", v.at.y},
                          {"on_screen", v.onScreen},
                          {"in_world", v.inWorld},
                          {"N", asJson(v.N)},
                          {"I", asJson(v.I, e.channels)}});
    Json equations = Json::array();
    for (const ExplainedEquation& one : e.equations) equations.push_back(asJson(one, e.channels));
    all["shown"] = pixel.history.shown;
    all["shading"] = rowOf(e.method).name;
    all["I"] = asJson(e.I, e.channels);
    all["intensity"] = e.intensity;
    all["terms"] = termsAsJson(e);
    all["vertices"] = vertices;
    if (e.texel)
      all["texel"] = {{"u", e.texel->u},
                      {"v", e.texel->v},
                      {"column", e.texel->column},
                      {"row", e.texel->row},
                      {"share", asJson(e.texel->share, e.channels)}};
    if (e.place) all["place"] = {{"column", e.place->column}, {"row", e.place->row}, {"away", e.place->away}};
    all["equations"] = equations;
    all["value"] = e.value[0];
    if (pixel.inColors()) all["value"] = {e.value[0], e.value[1], e.value[2]};
  }
  out << all.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace xnewell
