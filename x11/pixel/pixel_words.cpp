#include "x11/pixel/pixel_words.h"

#include <algorithm>
#include <numeric>

#include "shading/explain/rounded_terms.h"
#include "x11/drawing/wording.h"

namespace xnewell {

PixelStory::PixelStory(const Picture& of, int column, int row)
    : picture{of}, i{column}, j{row}, history{historyOf(of, column, row)} {
  for (const PaintedHere& one : history.painted) explained.push_back(explain(of, one.fragment.face, i, j));
}

std::string_view PixelStory::verdict() const {
  if (!shown()) return "ground";
  if (isWrong(history.check)) return "wrong face";
  return shown()->clamped ? "clamped" : "shaded";
}

std::string faceName(const Picture& picture, int face) {
  const SnappedFace& f = picture.snapped().faces[face];
  const Mesh& mesh = picture.scene().mesh;
  const ConvexParts& parts = picture.scene().parts;
  std::string name = std::to_string(f.number);
  const auto own = std::ranges::equal_range(parts.face, f.number);
  if (own.size() > 1 && !picture.shading().refined())
    name += '.' + std::to_string(f.part - (own.begin() - parts.face.begin()) + 1);
  return name + ", " + mesh.groupNames[mesh.group[f.number]];
}

std::string fateOf(const PixelStory& story, std::size_t k) {
  if (static_cast<int>(k) == story.history.shown) return "shows";
  if (rowOf(story.picture.settings().order).bySample) return "another one is nearer";
  return "painted over by " + std::to_string(k + 2);
}

std::string_view cosineName(Form form) {
  return form == Form::Textbook ? "R.V" : form == Form::HalfVector ? "N.H" : "N.L";
}

namespace {

/// With Gouraud shading the vertices know no texel.
bool showsTexel(const Explanation& e) { return e.texel && e.method != Shading::Gouraud; }

}  // namespace

std::string formulaOf(const Explanation& e, Form form) {
  return std::string{"I = ka Ia + f Ip [ kd N.L"} + (showsTexel(e) ? " x texel" : "") + " + ks (" +
         std::string{cosineName(form)} + ")^n ]";
}

std::vector<std::string> numbersPutIn(const Explanation& e, const ExplainedEquation& at, int c) {
  std::vector<std::string> lines{"= " + fixed(at.surface[c].ka, 2) + " x " + fixed(at.Ia[c], 2)};
  for (const ExplainedLight& light : at.lights) {
    if (light.NdotL <= 0.0) {
      lines.push_back("+ 0: a light is behind this side");
      continue;
    }
    std::string part = "+ " + fixed(light.fatt * light.spot, kPixelDecimals) + " x " + fixed(light.Ip[c], 2) +
                       " [ " + fixed(at.surface[c].kd, 2) + " x " + fixed(light.NdotL, kPixelDecimals);
    if (showsTexel(e)) part += " x " + fixed(e.texel->share[c], kPixelDecimals);
    part += " + " + fixed(at.surface[c].ks, 2) + " x " + fixed(std::max(0.0, light.cosine), kPixelDecimals) +
            '^' + std::to_string(at.surface[c].n) + " ]";
    if (at.lights.size() == 1)
      lines.front() += ' ' + part;
    else
      lines.push_back(std::move(part));
  }
  return lines;
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

std::string sumOf(const ExplainedEquation& at, int c, bool together) {
  std::vector<double> terms{at.ambient[c]};
  if (together) terms.resize(3);
  for (const ExplainedLight& light : at.lights) {
    if (together) {
      terms[1] += light.diffuse[c], terms[2] += light.specular[c];
      continue;
    }
    terms.push_back(light.diffuse[c]);
    terms.push_back(light.specular[c]);
  }
  const std::vector<double> rounded = roundedTerms(terms, kPixelDecimals);
  std::string text = "= " + fixed(rounded[0], kPixelDecimals);
  for (std::size_t k = 1; k < rounded.size(); ++k) text += " + " + fixed(rounded[k], kPixelDecimals);
  const double sum = std::accumulate(rounded.begin(), rounded.end(), 0.0);
  return text + " = " + fixed(sum, kPixelDecimals) + (at.I[c] > 1.0 ? ", clamped to 1" : "");
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
  while (decimals < 12 && (alike(picked.from) || alike(picked.to))) ++decimals;
  const bool last = shade + 1 == table.shades();
  return {"I " + fixed(e.intensity, decimals) + " picks shade " + std::to_string(shade) + " of " +
              std::to_string(table.shades()) + " (" +
              std::string{kTables[static_cast<int>(table.settings().kind)].name} + "), cell " +
              std::to_string(table.first()) + " + " + std::to_string(shade) + " = " +
              std::to_string(e.value[0]),
          "that shade is for " + fixed(picked.from, decimals) + (last ? " <= I <= " : " <= I < ") +
              fixed(picked.to, decimals)};
}

std::vector<std::string> shortStory(const PixelStory& story, int chosen) {
  if (story.explained.empty()) return {};
  const Explanation& e = story.explained[static_cast<std::size_t>(chosen)];
  std::vector<std::string> lines{"face " + faceName(story.picture, e.face) + ": " + fateOf(story, chosen) +
                                 ", I " + intensityWords(story, e)};
  for (const ExplainedEquation& at : e.equations) {
    lines.push_back(formulaOf(e, story.picture.settings().light.form));
    for (int c = 0; c < e.channels; ++c) {
      for (std::string& numbers : numbersPutIn(e, at, c)) lines.push_back(std::move(numbers));
      lines.push_back(sumOf(at, c));
    }
  }
  if (story.inColors()) return lines;
  const PickedWords picked = pickedWords(story, e);
  lines.insert(lines.end(), {picked.picks, picked.range});
  return lines;
}

}  // namespace xnewell
