#include "shading/scene/units.h"

#include <cmath>
#include <optional>
#include <utility>

#include "geometry/exact/box.h"
#include "geometry/exact/scale.h"

namespace xnewell {

namespace {

double toScene(double length, const Scene& scene) {
  const double v = std::ldexp(length, -scene.exponent);
  if (!std::isfinite(v)) throw ViewError{"the camera or the light is too far away for the size of the scene"};
  return v;
}

/// Every length and every place of the camera becomes what `convert` makes of each of its numbers.
template <class Convert>
CameraSettings converted(CameraSettings c, const Convert& convert) {
  for (std::optional<glm::dvec3>* p : {&c.eye, &c.lookAt, &c.vrp, &c.prp})
    if (*p)
      for (int k = 0; k < 3; ++k) (**p)[k] = convert((**p)[k]);
  for (std::optional<double>* v : {&c.height, &c.front, &c.back})
    if (*v) *v = convert(**v);
  if (c.window)
    for (int k = 0; k < 4; ++k) (*c.window)[k] = convert((*c.window)[k]);
  return c;
}

CameraSettings inFileUnits(CameraSettings camera, const Scene& scene) {
  return converted(std::move(camera), [&](double v) { return std::ldexp(v, scene.exponent); });
}

Illumination inSceneUnits(Illumination light, const Scene& scene) {
  if (light.lightPosition) light.lightPosition = inSceneUnits(*light.lightPosition, scene);
  if (light.range) light.range = toScene(*light.range, scene);
  // c2 is per unit of length, c3 per unit of length squared.
  if (light.c)
    light.c = {light.c->x, std::ldexp(light.c->y, scene.exponent),
               std::ldexp(light.c->z, 2 * scene.exponent)};
  return light;
}

}  // namespace

CameraSettings inSceneUnits(CameraSettings camera, const Scene& scene) {
  return converted(std::move(camera), [&](double v) { return toScene(v, scene); });
}

glm::dvec3 inSceneUnits(glm::dvec3 point, const Scene& scene) {
  for (int k = 0; k < 3; ++k) point[k] = toScene(point[k], scene);
  return point;
}

PictureSettings inSceneUnits(PictureSettings settings, const Scene& scene) {
  settings.camera = inSceneUnits(settings.camera, scene);
  settings.light = inSceneUnits(settings.light, scene);
  return settings;
}

glm::dvec3 inFileUnits(glm::dvec3 point, const Scene& scene) { return scaled(point, scene.exponent); }

glm::dvec3 centreOf(const Scene& scene) { return inFileUnits(boxOf(scene.mesh.points).centre(), scene); }

Camera placeCamera(const Scene& scene, const CameraSettings& settings, double aspect, Cull cull) {
  return placeCamera(inSceneUnits(settings, scene), scene.mesh.points, scene.up, aspect, scene.parts, cull);
}

CameraSettings saidOf(const Camera& camera, const Scene& scene) {
  CameraSettings said;
  said.eye = camera.eye, said.lookAt = camera.lookAt, said.up = camera.up;
  said.parallel = camera.view.projection == Projection::Parallel;
  if (said.parallel) said.height = camera.view.windowMax.y - camera.view.windowMin.y;
  return inFileUnits(said, scene);
}

CameraSettings textbooksOf(const Camera& camera, const Scene& scene) {
  const ViewSpec& view = camera.view;
  CameraSettings said;
  said.parallel = view.projection == Projection::Parallel;
  said.vrp = view.vrp, said.vpn = view.vpn, said.vup = view.vup, said.prp = view.prp;
  said.window = glm::dvec4{view.windowMin.x, view.windowMax.x, view.windowMin.y, view.windowMax.y};
  said.front = view.front, said.back = view.back;
  return inFileUnits(said, scene);
}

CameraSettings moved(const CameraSettings& settings, const Camera& camera, const Scene& scene, double azimuth,
                     double elevation, double zoom) {
  return inFileUnits(moved(settings, camera, azimuth, elevation, zoom), scene);
}

std::vector<Light> lightsOf(const Scene& scene, const Illumination& user) {
  return lightsOf(scene.light, inSceneUnits(user, scene), boxOf(scene.mesh.points));
}

}  // namespace xnewell
