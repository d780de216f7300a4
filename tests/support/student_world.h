#pragma once

#include <cmath>

#include "shading/diagnose/handed_in.h"
#include "shading/picture/picture.h"
#include "shading/scene/units.h"
#include "tests/support/student.h"

namespace xnewell {

/// What a student is given: the numbers of the scene, in the units of its file.
inline student::World studentsWorld(const Picture& picture) {
  const Scene& scene = picture.scene();
  const Illumination& user = picture.settings().light;
  const double unit = std::ldexp(1.0, scene.exponent);
  const auto triple = [](const glm::dvec3& v) { return student::Triple{v.x, v.y, v.z}; };
  student::World world;
  for (const glm::dvec3& p : scene.mesh.points) world.points.push_back(triple(unit * p));
  for (int f = 0; f < scene.mesh.faceCount(); ++f) {
    world.faces.emplace_back(scene.mesh.face(f).begin(), scene.mesh.face(f).end());
    const int m = scene.mesh.material[f];
    const Reflection r = reflectionOf(m < 0 ? MeshMaterial{} : scene.mesh.materials[m], user, 0);
    world.surfaces.push_back({r.ka, r.kd, r.ks, r.n});
  }
  const Camera& camera = picture.camera();
  world.eye = triple(unit * camera.eye), world.at = triple(unit * camera.lookAt),
  world.up = triple(camera.up);
  world.fov = picture.settings().camera.fov.value_or(kDefaultFov);
  const Light light = lightsOf(scene, user).front();
  world.lamp = light.kind == LightKind::Point;
  world.light = world.lamp ? triple(unit * light.position) : triple(light.direction);
  world.Ia = scene.light.Ia ? scene.light.Ia->r : user.Ia, world.Ip = light.Ip.r;
  return world;
}

/// The picture as a file of red, or with its cells.
inline HandedIn handedInBy(const student::Result& drawn, bool indexed = false) {
  HandedIn in{.picture = RgbImage{drawn.width, drawn.height}, .cells = {}, .held = {}};
  for (std::size_t k = 0; k < drawn.red.size(); ++k) {
    in.picture.rgb[3 * k] = drawn.red[k];
    if (drawn.cell[k] == 0) in.picture.rgb[3 * k + 1] = in.picture.rgb[3 * k + 2] = 40;  // the ground is gray
  }
  if (!indexed) return in;
  in.cells.emplace(drawn.width, drawn.height, std::uint8_t{0});
  for (std::size_t k = 0; k < drawn.cell.size(); ++k)
    in.cells->pixels[k] = static_cast<std::uint8_t>(drawn.cell[k]);
  for (int c = 1; c < 256; ++c) in.held[c] = {drawn.held[c], 0, 0};
  in.held[0] = {40, 40, 40};
  return in;
}

}  // namespace xnewell
