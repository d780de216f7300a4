#include "shading/picture/scene_shading.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/exact/box.h"

namespace xnewell {

namespace {

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
  return smoothVertices(
      scene.mesh, settings.normals, settings.crease,
      settings.normals == NormalRule::Exact ? exactNormals(scene) : std::vector<glm::dvec3>{});
}

SceneShading SceneShading::next(const Scene& scene, const PictureSettings& settings, Channels channels,
                                const Camera& camera) const {
  const ShadingRow& method = rowOf(settings.shading);
  if (!method.lit) return {};  // nothing is lit, so nothing is kept
  const bool keepsIntensities = settings.shading == Shading::Flat || settings.shading == Shading::Gouraud;
  Light light{settings.light, channels, settings.shading};
  // A map does not show textures: its surfaces keep their own colours.
  if (settings.shading == Shading::Environment) light.light.texel = TexelUse::Multiplies;
  const Eye eye{camera.eye, camera.lookAt};

  // The lights come first: where all light is ambient, nothing asks for a normal, and nothing is divided.
  Shared<Lighting> lighting = lighting_;
  if (lightMade_ != light || eyeMade_ != eye)
    lighting = resolve(scene.mesh, scene.light, light.light, channels, camera.eye, camera.lookAt,
                       channels == Channels::Luminance && !isGray(scene));
  Points points{.ofVertices = method.interpolates,
                .withNormals = !lighting->onlyAmbient() || settings.shading == Shading::Environment};
  if (points.withNormals) {
    points.normals = settings.normals;
    points.crease = method.interpolates ? settings.crease : 0.0;
    points.adapt = keepsIntensities ? settings.adapt : 0.0;
  }
  const double adapt = points.adapt;

  SceneShading next = pointsMade_ == points ? *this : SceneShading{};
  if (next.pointsMade_ != points) next.makePoints(scene, settings, points);
  next.lighting_ = lighting;
  bool newLight = next.lightMade_ != light;
  const bool newEye = next.eyeMade_ != eye;
  const bool newHighlight = newLight || (newEye && next.lighting().asksForEye());
  if (adapt > 0.0 && newHighlight) {
    next.refined_ = std::optional{next.refine(scene, settings)};
    newLight = true;  // points() has changed
  }
  if (!keepsIntensities)
    next.lit_ = {}, next.luminance_ = {};
  else if (newLight || newEye) {
    for (int c = 0; c < next.lighting().channels; ++c) next.light(c, newLight, newHighlight);
    if (next.lighting().luminance) next.luminance_ = next.luminanceOfAll();
  }

  if (settings.shading == Shading::Environment) {
    const Frame frame{settings.environment,
                      settings.environment == EnvironmentForm::Published ? camera.view : ViewSpec{}};
    if (newLight || next.frameMade_ != frame) next.maps_ = next.makeMaps(scene, settings, camera);
    next.frameMade_ = frame;
  } else {
    next.frameMade_.reset();
    next.maps_ = {};
  }
  next.lightMade_ = light;
  next.eyeMade_ = eye;
  return next;
}

void SceneShading::makePoints(const Scene& scene, const PictureSettings& settings, const Points& points) {
  if (!points.withNormals) {
    points_ = points.ofVertices ? materialPoints(scene.mesh) : ShadingPoints{{}, {}, scene.mesh.material};
    vertices_ = points.ofVertices ? materialVertices(scene.mesh) : Vertices{};
  } else if (points.ofVertices) {
    Vertices vertices = smoothVertices(scene, settings);
    points_ = vertexPoints(scene.mesh, vertices);
    vertices_ = std::move(vertices);
  } else {
    points_ = facePoints(scene.mesh);
  }
  pointsMade_ = points;
}

Refined SceneShading::refine(const Scene& scene, const PictureSettings& settings) const {
  const RefineSettings asked{.tolerance = settings.adapt};
  return settings.shading == Shading::Flat
             ? refineFlat(scene.mesh, scene.parts, *points_, lighting(), asked)
             : refineSmooth(scene.mesh, scene.parts, *vertices_, lighting(), asked);
}

void SceneShading::light(int channel, bool newLight, bool newHighlight) {
  Lit& lit = lit_[channel];
  if (newLight) {
    Terms diffuse;
    diffuseIntensities(diffuse, points(), lighting(), channel);
    lit.diffuse = std::move(diffuse);
  }
  if (newHighlight) {
    Terms specular;
    specularIntensities(specular, points(), lighting(), channel);
    lit.specular = std::move(specular);
  }
  Intensities intensities;
  addTerms(intensities, *lit.diffuse, *lit.specular, points(), lighting(), channel);
  lit.intensities = std::move(intensities);
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
