#include "shading/picture/scene_shading.h"

#include <algorithm>
#include <utility>

#include "geometry/exact/box.h"

namespace xnewell {

SceneShading SceneShading::next(const Scene& scene, const PictureSettings& settings, Channels channels,
                                const Camera& camera) const {
  const ShadingRow& method = rowOf(settings.shading);
  if (!method.lit) return {};  // nothing is lit, so nothing is kept
  const bool flat = !method.interpolates;
  const bool keepsIntensities = settings.shading == Shading::Flat || settings.shading == Shading::Gouraud;
  const double adapt = keepsIntensities ? settings.adapt : 0.0;
  const Points points{method.interpolates, settings.normals, flat ? 0.0 : settings.crease, adapt};
  const Light light{settings.light, channels, settings.shading};
  const Eye eye{camera.eye, camera.lookAt};

  SceneShading next = pointsMade_ == points ? *this : SceneShading{};
  if (next.pointsMade_ != points) {
    if (method.interpolates) {
      Vertices vertices = smoothVertices(
          scene.mesh, settings.normals, settings.crease,
          settings.normals == NormalRule::Exact ? exactNormals(scene) : std::vector<glm::dvec3>{});
      next.points_ = vertexPoints(scene.mesh, vertices);
      next.vertices_ = std::move(vertices);
    } else {
      next.points_ = facePoints(scene.mesh);
    }
    next.pointsMade_ = points;
  }

  bool newLight = next.lightMade_ != light;
  const bool newEye = next.eyeMade_ != eye;
  if (newLight || newEye)
    next.lighting_ = resolve(scene.mesh, scene.light, settings.light, channels, camera.eye, camera.lookAt,
                             channels == Channels::Luminance && !isGray(scene));
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
