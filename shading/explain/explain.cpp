#include "shading/explain/explain.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "depthsort/oracle.h"
#include "shading/explain/term_values.h"
#include "shading/scene/units.h"

namespace xnewell {

namespace {

/// With a mistake in the equation an intensity may be below 0.
constexpr bool isOutside(double I) { return I < 0.0 || I > 1.0; }
constexpr double clampedToOne(double I) { return std::clamp(I, 0.0, 1.0); }

class OnePixel {
 public:
  OnePixel(const Picture& picture, EquationOf& equations, std::optional<DepthRange>& range, int face, int i,
           int j)
      : picture_{picture},
        s_{picture.surfaces()},
        on_{s_, s_.snapped.faces[face]},
        equations_{equations},
        range_{range},
        lit_{rowOf(s_.settings.shading).lit} {
    e_.i = i, e_.j = j, e_.face = face;
    e_.method = s_.settings.shading;
    const bool map = e_.method == Shading::Environment;  // it has the luminance of the three already
    e_.luminance = lit_ && s_.shading.lighting().luminance && !map;
    e_.channels = !lit_ || (map && s_.shading.lighting().luminance) ? 1 : s_.shading.lighting().channels;
  }

  Explanation make() {
    const bool interpolates = rowOf(e_.method).interpolates;
    if (interpolates || on_.isTextured()) on_.moveTo(e_.i, e_.j);  // flat shading may have a texture
    if (interpolates) addVertices();
    if (on_.isTextured()) e_.texel = on_.texel(e_.channels);
    if (e_.method == Shading::Flat) evaluate(on_.centroid().P, on_.centroid().N);
    if (e_.method == Shading::Gouraud) interpolateIntensities();
    if (e_.method == Shading::Phong) {
      e_.sum = on_.sumOfNormals();
      evaluate(on_.place(), on_.normal());
    }
    if (e_.method == Shading::Depth) takeDepths();
    if (e_.method == Shading::Full || e_.method == Shading::Environment) takeFromPicture();
    finish();
    return std::move(e_);
  }

 private:
  [[nodiscard]] const EquationAt& equation() { return equations_(on_.face().number); }

  void addVertices() {
    for (std::size_t k = 0; k < on_.vertices().size(); ++k) {
      const int vertex = on_.vertices()[k];
      const glm::ivec3& p = s_.snapped.vertices[vertex];
      ExplainedVertex v{.at = glm::dvec2{p.x, p.y} / double{kGrid},
                        .P = on_.atVertex(vertex, [&](int corner) { return on_.placeOf(corner); }),
                        .N = on_.atVertex(vertex, [&](int corner) { return on_.normalOf(corner); })};
      if (!on_.byRows()) v.onScreen = on_.onScreen()[k], v.inWorld = on_.inWorld()[k];
      e_.vertices.push_back(v);
    }
  }

  void evaluate(const glm::dvec3& P, const glm::dvec3& N) {
    e_.equations.push_back(equation()(P, N, e_.texel ? e_.texel->share : ByChannel{1, 1, 1}));
    e_.I = e_.equations.front().I;
    for (int c = 0; c < e_.channels; ++c) e_.clamped = e_.clamped || isOutside(e_.I[c]);
  }

  /// The intensities at the vertices, or with a texture their terms, and from them those at the sample.
  void interpolateIntensities() {
    const EquationAt& equationHere = equation();
    const auto at = [&](int corner) { return equationHere(on_.placeOf(corner), on_.normalOf(corner)); };
    for (std::size_t k = 0; k < e_.vertices.size(); ++k) {
      ExplainedVertex& vertex = e_.vertices[k];
      if (const int source = s_.snapped.source[on_.vertices()[k]]; source >= 0) {
        vertex.equation = static_cast<int>(e_.equations.size());
        e_.equations.push_back(at(source));
      }
      for (int c = 0; c < e_.channels; ++c)
        vertex.I[c] =
            on_.atVertex(on_.vertices()[k], [&](int corner) { return clampedToOne(at(corner).I[c]); });
    }
    if (e_.luminance && !e_.texel) {  // the luminance is interpolated, not the three
      for (const ExplainedVertex& v : e_.vertices)
        luminances_.push_back(xnewell::luminance({v.I[0], v.I[1], v.I[2]}));
    }
    for (int c = 0; c < e_.channels; ++c) {
      if (e_.texel)
        e_.I[c] = sumOfTerms(at, c);
      else
        e_.I[c] = on_.valueHere([&](std::size_t k) { return e_.vertices[k].I[c]; });
    }
    for (const ExplainedEquation& one : e_.equations)
      for (int c = 0; c < e_.channels; ++c) e_.clamped = e_.clamped || isOutside(one.I[c]);
  }
  template <class At>
  [[nodiscard]] double sumOfTerms(const At& at, int c) const {
    const auto here = [&](const auto& term) {
      return on_.valueHere([&](std::size_t k) {
        return on_.atVertex(on_.vertices()[k], [&](int corner) { return term(at(corner)); });
      });
    };
    const auto diffuse = [c](const ExplainedEquation& e) { return e.diffuse(c); };
    return here([&](const ExplainedEquation& e) { return e.I[c] - diffuse(e); }) +
           here(diffuse) * e_.texel->share[c];
  }

  void takeDepths() {
    const Scene& scene = picture_.scene();
    const ViewSpec& view = picture_.camera().view;
    if (!range_) range_ = depthRange(scene.mesh, s_.snapped, view);
    DepthTerms terms = depthTerms(scene.mesh, view, *range_, on_.face().number);
    const double sum = std::accumulate(terms.z.begin(), terms.z.end(), 0.0);
    e_.I[0] = terms.range > 0.0 ? clampedToOne(1.0 - sum / terms.a()) : 1.0;  // rounding may miss 0 or 1
    const auto inFile = [&](double length) { return inFileUnits(glm::dvec3{length, 0.0, 0.0}, scene).x; };
    std::ranges::transform(terms.z, terms.z.begin(), inFile);
    terms.range = inFile(terms.range);
    e_.depth = std::move(terms);
  }

  /// Full intensity, and what an environment's map holds.
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
      e_.intensity = on_.valueHere([&](std::size_t k) { return luminances_[k]; });
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
  OnFace on_;
  EquationOf& equations_;
  std::optional<DepthRange>& range_;  ///< found when it is needed first
  bool lit_;
  Explanation e_;
  std::vector<double> luminances_;  ///< of the vertices
};

}  // namespace

Explanation PixelExplainer::operator()(int face, int i, int j) {
  return OnePixel{picture_, equations_, range_, face, i, j}.make();
}

std::string nameOfFace(const Picture& picture, int face) {
  const SnappedFace& f = picture.snapped().faces[face];
  const ConvexParts& parts = picture.scene().parts;
  std::string name = std::to_string(f.number);
  const auto own = std::ranges::equal_range(parts.face, f.number);
  if (own.size() > 1 && !picture.shading().refined())
    name += '.' + std::to_string(f.part - (own.begin() - parts.face.begin()) + 1);
  return name;
}

std::string faceName(const Picture& picture, int face) {
  const Mesh& mesh = picture.scene().mesh;
  const std::string name = nameOfFace(picture, face);
  const std::string& group = mesh.groupNames[mesh.group[picture.snapped().faces[face].number]];
  return group.empty() ? name : name + ", " + group;
}

}  // namespace xnewell
