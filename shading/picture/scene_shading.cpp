#include "shading/picture/scene_shading.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "geometry/exact/box.h"
#include "geometry/exact/plane.h"

namespace xnewell {

namespace {

constexpr std::size_t kLarge = 1 << 17;     // points; beyond it memory counts more than a moved eye
constexpr std::size_t kInCaches = 1 << 12;  // points whose terms stay in the caches of a processor

/// One point for each material, the first for none: where all light is ambient, it stands for all places.
ShadingPoints materialPoints(const Mesh& mesh) {
  ShadingPoints points;
  points.material.resize(mesh.materials.size() + 1);
  std::iota(points.material.begin(), points.material.end(), -1);
  return points;
}

/// Each corner has the point of its face's material.
Vertices materialVertices(const Mesh& mesh) {
  Vertices vertices;
  vertices.ofCorner.reserve(mesh.corners.size());
  for (int f = 0; f < mesh.faceCount(); ++f)
    vertices.ofCorner.insert(vertices.ofCorner.end(), mesh.face(f).size(), mesh.material[f] + 1);
  return vertices;
}

}  // namespace

Vertices smoothVertices(const Scene& scene, const PictureSettings& settings) {
  return smoothVertices(scene.mesh, settings.normals, settings.crease, exactNormals(scene, settings.normals));
}

namespace {

/// Gives each normal the length of the cross products that made it, in the scene's units: a face's own, or
/// the sum of those of the faces around a vertex. `ofCorner` is empty for faces.
void lengthenNormals(const Scene& scene, ShadingPoints& points, const std::vector<int>& ofCorner) {
  const Mesh& mesh = scene.mesh;
  std::vector<glm::dvec3> sums(points.count(), glm::dvec3{0.0});
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const glm::dvec3 product = newellVector(mesh.points, mesh.face(f));
    if (ofCorner.empty())
      sums[f] = product;
    else
      for (int corner = mesh.firstCorner[f]; corner < mesh.firstCorner[f + 1]; ++corner)
        sums[ofCorner[corner]] += product;
  }
  for (std::size_t k = 0; k < sums.size(); ++k)
    points.N[k] *= std::ldexp(glm::length(sums[k]), 2 * scene.exponent);
}

}  // namespace

SceneShading SceneShading::next(const Scene& scene, const PictureSettings& settings, Channels channels,
                                const Camera& camera) const {
  const ShadingRow& method = rowOf(settings.shading);
  const bool keepsIntensities = settings.shading == Shading::Flat || settings.shading == Shading::Gouraud;
  const bool hasMaps = settings.shading == Shading::Environment;
  SceneShading next = *this;
  Light light{settings.light, channels, settings.lights};
  // A map does not show textures, and it has a formula of its own.
  if (hasMaps) light.light.texel = TexelUse::Multiplies, light.light.mistake = Mistake::None;

  // The lights come first: where all light is ambient, nothing asks for a normal, and nothing is divided.
  const Eye eye{camera.eye, camera.lookAt};
  const bool mistaken = light.light.mistake != Mistake::None;
  if (mistaken) light.eye = eye;
  next.lighting_.update({light, eye}, [&] {
    return resolve(scene.mesh, scene.light, light.light, channels, eye.eye, eye.lookAt,
                   channels == Channels::Luminance && !isGray(scene));
  });
  if (!method.lit) return next.onlyLights();  // nothing is lit, so nothing else is kept
  const Lighting& lighting = next.lighting();

  // The places at which the light is evaluated, and their normals.
  OfPoints points{.ofVertices = method.interpolates, .withNormals = !lighting.onlyAmbient() || hasMaps};
  if (points.withNormals) {
    points.normals = settings.normals;
    points.crease = method.interpolates ? settings.crease : 0.0;
    points.longN = rowOf(light.light.mistake).longN;
  }
  next.own_.update(points, [&] { return ownPlaces(scene, settings, points); });

  // More places, where polygons are divided.
  const Shared<Own>& own = next.own_.shared();
  const HighlightEye highlightEye = lighting.asksForEye() ? HighlightEye{eye} : std::nullopt;
  // The bounds of a division are those of the course's equation.
  const double adapt = keepsIntensities && points.withNormals && !mistaken ? settings.adapt : 0.0;
  if (adapt > 0.0)
    next.refined_.update({own, adapt, light, highlightEye}, [&] { return next.refine(scene, settings); });
  else
    next.refined_.drop();

  // The intensities there.
  const bool keepsTerms = !scene.textures.empty() || next.points().count() <= kLarge;
  if (keepsIntensities)
    for (int c = 0; c < lighting.channels; ++c)
      next.light(c, {{own, next.refined_.shared(), light}, highlightEye}, keepsTerms);
  else
    next.lit_ = {};
  if (keepsIntensities && lighting.luminance)
    next.luminance_.update({next.lit_[0].intensities.shared(), next.lit_[1].intensities.shared(),
                            next.lit_[2].intensities.shared()},
                           [&] { return next.luminanceOfAll(); });
  else
    next.luminance_.drop();

  // The maps of all directions.
  if (hasMaps)
    next.maps_.update({own, light, settings.environment,
                       settings.environment == EnvironmentForm::Published ? camera.view : ViewSpec{}},
                      [&] { return next.makeMaps(scene, settings, camera); });
  else
    next.maps_.drop();
  return next;
}

SceneShading::Own SceneShading::ownPlaces(const Scene& scene, const PictureSettings& settings,
                                          const OfPoints& points) {
  if (!points.withNormals && points.ofVertices)
    return {materialVertices(scene.mesh), materialPoints(scene.mesh)};
  if (!points.withNormals) return {{}, ShadingPoints{{}, {}, scene.mesh.material}};
  Own own;
  if (points.ofVertices) {
    own.vertices = smoothVertices(scene, settings);
    own.points = vertexPoints(scene.mesh, own.vertices);
  } else {
    own.points = facePoints(scene.mesh);
  }
  if (points.longN) lengthenNormals(scene, own.points, own.vertices.ofCorner);
  return own;
}

Refined SceneShading::refine(const Scene& scene, const PictureSettings& settings) const {
  const RefineSettings asked{.tolerance = settings.adapt};
  return settings.shading == Shading::Flat
             ? refineFlat(scene.mesh, scene.parts, own_->points, lighting(), asked)
             : refineSmooth(scene.mesh, scene.parts, own_->vertices, lighting(), asked);
}

void SceneShading::light(int channel, const OfSpecular& by, bool keepsTerms) {
  Lit& lit = lit_[channel];
  const auto addUp = [&](const Terms& diffuse, const Terms& specular, const ShadingPoints& at) {
    Intensities intensities;
    addTerms(intensities, diffuse, specular, at, lighting(), channel);
    return intensities;
  };
  if (!keepsTerms) {
    lit.diffuse.drop(), lit.specular.drop();
    lit.intensities.update(by, [&] {
      Intensities all;
      Terms diffuse, specular;
      all.I.reserve(points().count());
      for (std::size_t first = 0; first < points().count(); first += kInCaches) {
        const ShadingPoints some = points().slice(first, std::min(points().count(), first + kInCaches));
        diffuseIntensities(diffuse, some, lighting(), channel);
        specularIntensities(specular, some, lighting(), channel);
        const Intensities part = addUp(diffuse, specular, some);
        all.I.insert(all.I.end(), part.I.begin(), part.I.end());
        all.clamped += part.clamped;
      }
      return all;
    });
    return;
  }
  lit.diffuse.update(by.diffuse, [&] {
    Terms diffuse;
    diffuseIntensities(diffuse, points(), lighting(), channel);
    return diffuse;
  });
  lit.specular.update(by, [&] {
    Terms specular;
    specularIntensities(specular, points(), lighting(), channel);
    return specular;
  });
  // The ambient term is as old as the diffuse one.
  lit.intensities.update(by, [&] { return addUp(*lit.diffuse, *lit.specular, points()); });
}

Intensities SceneShading::luminanceOfAll() const {
  const Intensities &r = *lit_[0].intensities, &g = *lit_[1].intensities, &b = *lit_[2].intensities;
  Intensities all{std::vector<FrontBack<double>>(r.I.size()), r.clamped + g.clamped + b.clamped};
  for (std::size_t k = 0; k < all.I.size(); ++k)
    all.I[k] = {xnewell::luminance({r.I[k].front, g.I[k].front, b.I[k].front}),
                xnewell::luminance({r.I[k].back, g.I[k].back, b.I[k].back})};
  return all;
}

SceneShading::Maps SceneShading::makeMaps(const Scene& scene, const PictureSettings& settings,
                                          const Camera& camera) const {
  Maps maps;
  const glm::dvec3 centre = boxOf(scene.mesh.points).centre();
  for (int c = 0; c < lighting().channels; ++c) {
    for (const Material& material : lighting().materials)
      maps.environments[c].push_back(
          makeEnvironment(settings.environment, lighting(), material, c, vrcRotation(camera.view), centre));
    // Each channel has a frame of its own; it does not depend on the material.
    const glm::dmat3 frame = maps.environments[c].front().frame;
    maps.N[c].reserve(points().N.size());
    for (const glm::dvec3& N : points().N) maps.N[c].push_back(frame * N);
  }
  if (lighting().luminance) {
    const auto mix = [](std::vector<float>& r, const std::vector<float>& g, const std::vector<float>& b) {
      const auto cut = [](float v) { return std::min(1.0, double{v}); };
      for (std::size_t k = 0; k < r.size(); ++k)
        r[k] = static_cast<float>(xnewell::luminance({cut(r[k]), cut(g[k]), cut(b[k])}));
    };
    auto& [r, g, b] = maps.environments;
    for (std::size_t m = 0; m < r.size(); ++m)
      mix(r[m].front, g[m].front, b[m].front), mix(r[m].away, g[m].away, b[m].away);
  }
  return maps;
}

}  // namespace xnewell
