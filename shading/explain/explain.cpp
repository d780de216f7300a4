#include "shading/explain/explain.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "depthsort/oracle.h"
#include "geometry/exact/unit.h"
#include "geometry/view/at_source.h"
#include "shading/course/interpolation.h"
#include "shading/explain/loop_value.h"

namespace xnewell {

namespace {

/// With a mistake in the equation an intensity may be below 0.
constexpr bool isOutside(double I) { return I < 0.0 || I > 1.0; }
constexpr double clampedToOne(double I) { return std::clamp(I, 0.0, 1.0); }

class Explainer {
 public:
  Explainer(const Picture& picture, int face, int i, int j)
      : picture_{picture},
        s_{picture.surfaces()},
        face_{s_.snapped.faces[face]},
        material_{s_.mesh.material[face_.number]},
        lit_{rowOf(s_.settings.shading).lit} {
    e_.i = i, e_.j = j, e_.face = face;
    e_.method = s_.settings.shading;
    const bool map = e_.method == Shading::Environment;  // it has the luminance of the three already
    e_.luminance = lit_ && s_.shading.lighting().luminance && !map;
    e_.channels = !lit_ || (map && s_.shading.lighting().luminance) ? 1 : s_.shading.lighting().channels;
  }

  Explanation make() {
    if (rowOf(e_.method).interpolates) addVertices();
    if (isTextured()) addTexel();
    if (e_.method == Shading::Flat) evaluateFlat();
    if (e_.method == Shading::Gouraud) interpolateIntensities();
    if (e_.method == Shading::Phong) evaluateHere();
    if (!lit_ || e_.method == Shading::Environment) takeFromPicture();
    finish();
    return std::move(e_);
  }

 private:
  [[nodiscard]] bool onlyAmbient() const { return s_.shading.lighting().onlyAmbient(); }
  [[nodiscard]] bool isTextured() const {
    return lit_ && e_.method != Shading::Environment && !onlyAmbient() && material_ >= 0 &&
           s_.mesh.materials[material_].texture >= 0;
  }
  [[nodiscard]] bool byRows() const {
    return e_.method == Shading::Gouraud && !isTextured() && s_.settings.polygons == Polygons::Rows &&
           face_.count > 3;
  }
  [[nodiscard]] EquationAt equationAt() const { return {s_, material_ + 1}; }

  [[nodiscard]] glm::dvec3 placeOf(int corner) const { return s_.mesh.points[s_.mesh.corners[corner]]; }
  [[nodiscard]] glm::dvec3 normalOf(int corner) const {
    if (onlyAmbient()) return glm::dvec3{0.0};
    return s_.side(face_) * s_.shading.points().N[s_.shading.vertices().ofCorner[corner]];
  }

  void addVertices() {
    if (byRows()) {
      for (int k = 0; k < face_.count; ++k) addVertex(face_.first + k);
      return;
    }
    triangle_ = triangleAt(s_.snapped, face_, e_.i, e_.j);
    onScreen_ = weightsOnScreen(triangle_.p, e_.i, e_.j);
    inWorld_ = weightsInWorld(onScreen_, SurfaceEvaluator{s_, 0}.overDepths(triangle_));
    for (int k = 0; k < 3; ++k) {
      addVertex(triangle_.vertex[k]);
      e_.vertices.back().onScreen = onScreen_[k], e_.vertices.back().inWorld = inWorld_[k];
    }
  }
  void addVertex(int vertex) {
    const glm::ivec3& p = s_.snapped.vertices[vertex];
    const int source = s_.snapped.source[vertex];
    e_.vertices.push_back({.at = glm::dvec2{p.x, p.y} / double{kGrid},
                           .P = atSource(s_.snapped, source, [&](int corner) { return placeOf(corner); }),
                           .N = atSource(s_.snapped, source, [&](int corner) { return normalOf(corner); })});
    sources_.push_back(source);
  }

  void addTexel() {
    if (e_.vertices.empty()) {  // flat shading has no vertices, but its texture has
      triangle_ = triangleAt(s_.snapped, face_, e_.i, e_.j);
      onScreen_ = weightsOnScreen(triangle_.p, e_.i, e_.j);
      inWorld_ = weightsInWorld(onScreen_, SurfaceEvaluator{s_, 0}.overDepths(triangle_));
    }
    ExplainedTexel texel;
    glm::dvec2 uv{0.0};
    for (int k = 0; k < 3; ++k)
      uv += inWorld_[k] * atSource(s_.snapped, s_.snapped.source[triangle_.vertex[k]],
                                   [&](int corner) { return s_.mesh.uv[s_.mesh.uvOfCorner[corner]]; });
    const Texture& texture = s_.scene.textures[s_.mesh.materials[material_].texture];
    // v runs up the columns, and rows run down. The texture repeats.
    const auto place = [](double share, int size) {
      return std::min(static_cast<int>(share * size), size - 1);
    };
    texel.u = uv.x, texel.v = uv.y;
    texel.column = place(uv.x - std::floor(uv.x), texture.width);
    texel.row = place(1.0 - (uv.y - std::floor(uv.y)), texture.height);
    const auto at = static_cast<std::size_t>(texel.row) * texture.width + texel.column;
    for (int c = 0; c < e_.channels; ++c)
      texel.share[c] = (e_.channels == 3 ? texture.channel[c][at] : texture.gray[at]) / 255.0;
    e_.texel = texel;
  }

  [[nodiscard]] ByChannel texelShare() const { return e_.texel ? e_.texel->share : ByChannel{1, 1, 1}; }

  void evaluateFlat() {
    glm::dvec3 P{0.0}, N{0.0};
    if (const ShadingPoints& points = s_.shading.points(); !points.at.empty()) {
      const int point = s_.shading.pointOf(face_);
      P = points.at[point], N = s_.side(face_) * points.N[point];
    }
    e_.equations.push_back(equationAt()(P, N, texelShare()));
    takeFrom(e_.equations.front().I);
  }

  /// The intensities at the vertices, or with a texture their terms, and from them those at the sample.
  void interpolateIntensities() {
    const EquationAt equation = equationAt();
    const auto at = [&](int corner) { return equation(placeOf(corner), normalOf(corner)); };
    for (std::size_t k = 0; k < e_.vertices.size(); ++k) {
      ExplainedVertex& vertex = e_.vertices[k];
      if (sources_[k] >= 0) {
        vertex.equation = static_cast<int>(e_.equations.size());
        e_.equations.push_back(at(sources_[k]));
      }
      for (int c = 0; c < e_.channels; ++c)
        vertex.I[c] =
            atSource(s_.snapped, sources_[k], [&](int corner) { return clampedToOne(at(corner).I[c]); });
    }
    ByChannel I{};
    if (e_.luminance && !e_.texel) {  // the luminance is interpolated, not the three
      for (const ExplainedVertex& v : e_.vertices)
        luminances_.push_back(xnewell::luminance({v.I[0], v.I[1], v.I[2]}));
    }
    for (int c = 0; c < e_.channels; ++c) {
      if (e_.texel)
        I[c] = sumOfTerms(at, c);
      else
        I[c] = valueHere([&](std::size_t k) { return e_.vertices[k].I[c]; });
    }
    for (const ExplainedEquation& one : e_.equations)
      for (int c = 0; c < e_.channels; ++c) e_.clamped = e_.clamped || isOutside(one.I[c]);
    e_.I = I;
  }
  /// Interpolates over the triangle; by rows, along the edges and the row.
  template <class OfVertex>
  [[nodiscard]] double valueHere(const OfVertex& of) const {
    std::vector<double> v;
    for (std::size_t k = 0; k < e_.vertices.size(); ++k) v.push_back(of(k));
    if (byRows()) return alongRow(s_.snapped, face_, v, e_.i, e_.j);
    return interpolated(onScreen_, std::array{v[0], v[1], v[2]});
  }
  template <class At>
  [[nodiscard]] double sumOfTerms(const At& at, int c) const {
    const auto ofVertex = [&](std::size_t k, const auto& term) {
      return atSource(s_.snapped, sources_[k], [&](int corner) { return term(at(corner)); });
    };
    const auto diffuse = [c](const ExplainedEquation& e) {
      double sum = 0.0;
      for (const ExplainedLight& light : e.lights) sum += light.diffuse[c];
      return sum;
    };
    const double here = valueHere([&](std::size_t k) { return ofVertex(k, diffuse); });
    const double rest = valueHere(
        [&](std::size_t k) { return ofVertex(k, [&](const auto& e) { return e.I[c] - diffuse(e); }); });
    return rest + here * e_.texel->share[c];
  }

  void evaluateHere() {
    glm::dvec3 P{0.0};
    for (int k = 0; k < 3; ++k) {
      P += inWorld_[k] * e_.vertices[k].P;
      // Their length does not matter, unless they stay as long as they are.
      e_.sum += (keepsLengthOfN(s_.settings) ? onScreen_ : inWorld_)[k] * e_.vertices[k].N;
    }
    e_.equations.push_back(
        equationAt()(P, keepsLengthOfN(s_.settings) ? e_.sum : unit(e_.sum), texelShare()));
    takeFrom(e_.equations.front().I);
  }

  void takeFrom(const ByChannel& I) {
    e_.I = I;
    for (int c = 0; c < e_.channels; ++c) e_.clamped = e_.clamped || isOutside(I[c]);
  }

  /// Full intensity, depth, and what an environment's map holds.
  void takeFromPicture() {
    SeenRows here{s_.settings.width, e_.j,
                  std::vector<int>(static_cast<std::size_t>(s_.settings.width), kNothing)};
    here.faces[static_cast<std::size_t>(e_.i)] = e_.face;
    for (int c = 0; c < e_.channels; ++c)
      e_.I[c] = picture_.intensities(here, c)[static_cast<std::size_t>(e_.i)];
  }

  void finish() {
    ByChannel I{};
    std::ranges::transform(e_.I, I.begin(), clampedToOne);
    e_.intensity = e_.channels == 1 ? I[0] : xnewell::luminance({I[0], I[1], I[2]});
    if (e_.luminance && !luminances_.empty())
      e_.intensity = valueHere([&](std::size_t k) { return luminances_[k]; });
    const bool colors = channelsOf(picture_.colors().plan()) == Channels::Rgb;
    for (int c = 0; c < (colors ? 3 : 1); ++c) {
      const LoopValue loop = loopValueOf(picture_, e_.face, c, e_.i, e_.j);
      if (c == 0) e_.inLoop = loop.I;
      if (c == 0 && loop.place) e_.place = ExplainedPlace{loop.place->x, loop.place->y, loop.away};
      e_.value[c] = loop.cell;
    }
  }

  const Picture& picture_;
  Surfaces s_;
  const SnappedFace& face_;
  int material_;
  bool lit_;
  Explanation e_;
  FaceTriangle triangle_{};
  Weights onScreen_{}, inWorld_{};
  std::vector<int> sources_;        ///< of the vertices
  std::vector<double> luminances_;  ///< of the vertices
};

}  // namespace

Explanation explain(const Picture& picture, int face, int i, int j) {
  return Explainer{picture, face, i, j}.make();
}

}  // namespace xnewell
