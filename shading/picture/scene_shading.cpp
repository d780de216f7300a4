#include "shading/picture/scene_shading.h"

#include "geometry/exact/box.h"

namespace xnewell {

bool SceneShading::make(const Scene& scene, const PictureSettings& settings, Channels channels,
                        const Camera& camera) {
  const bool wasRefined = refined_.has_value();
  const ShadingRow& method = rowOf(settings.shading);
  if (!method.lit) {
    *this = {};  // what was lit before would be stale afterwards
    return wasRefined;
  }
  const bool flat = !method.interpolates;
  const bool keepsIntensities = settings.shading == Shading::Flat || settings.shading == Shading::Gouraud;
  const double adapt = keepsIntensities ? settings.adapt : 0.0;
  const Points wanted{method.interpolates, settings.normals, flat ? 0.0 : settings.crease, adapt};
  if (pointsMade_ != wanted) {
    *this = {};
    if (method.interpolates) {
      vertices_ = smoothVertices(
          scene.mesh, settings.normals, settings.crease,
          settings.normals == NormalRule::Exact ? exactNormals(scene) : std::vector<glm::dvec3>{});
      points_ = vertexPoints(scene.mesh, vertices_);
    } else {
      points_ = facePoints(scene.mesh);
    }
    pointsMade_ = wanted;
  }

  bool newLight = lightMade_ != Light{settings.light, channels, settings.shading};
  const Eye eye{camera.eye, camera.lookAt};
  if (newLight || eyeMade_ != eye)
    lighting_ = resolve(scene.mesh, scene.light, settings.light, channels, camera.eye, camera.lookAt);
  const bool newHighlight = newLight || (eyeMade_ != eye && lighting_.asksForEye());
  if (adapt > 0.0 && newHighlight) {
    refine(scene, settings);
    newLight = true;  // for points()
  }
  if (keepsIntensities) {
    for (int c = 0; c < lighting_.channels; ++c) {
      if (newLight) diffuseIntensities(intensities_[c], points(), lighting_, c);
      if (newHighlight) specularIntensities(intensities_[c], points(), lighting_, c);
      if (newLight || eyeMade_ != eye) addTerms(intensities_[c], points(), lighting_, c);
    }
  } else {
    intensities_ = {};
  }
  if (settings.shading == Shading::Environment) {
    const Frame frame{settings.environment,
                      settings.environment == EnvironmentForm::Published ? camera.view : ViewSpec{}};
    if (newLight || frameMade_ != frame) makeEnvironments(scene, settings, camera);
    frameMade_ = frame;
  } else {
    frameMade_.reset();
    environments_ = {};
    mapped_.clear();
  }
  lightMade_ = Light{settings.light, channels, settings.shading};
  eyeMade_ = eye;
  return refined_ ? newHighlight : wasRefined;
}

void SceneShading::refine(const Scene& scene, const PictureSettings& settings) {
  const RefineSettings asked{.tolerance = settings.adapt};
  refined_ = settings.shading == Shading::Flat
                 ? refineFlat(scene.mesh, scene.parts, points_, lighting_, asked)
                 : refineSmooth(scene.mesh, scene.parts, vertices_, lighting_, asked);
}

void SceneShading::makeEnvironments(const Scene& scene, const PictureSettings& settings,
                                    const Camera& camera) {
  const glm::dvec3 centre = boxOf(scene.mesh.points).centre();
  for (int c = 0; c < 3; ++c) {
    environments_[c].clear();
    if (c < lighting_.channels)
      for (const Material& material : lighting_.materials)
        environments_[c].push_back(
            makeEnvironment(settings.environment, lighting_, material, c, vrcRotation(camera.view), centre));
  }
  const glm::dmat3 frame = environments_[0].front().frame;  // of the light, so the same for all
  mapped_.resize(points_.N.size());
  for (std::size_t k = 0; k < mapped_.size(); ++k) mapped_[k] = frame * points_.N[k];
}

}  // namespace xnewell
