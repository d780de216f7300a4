#pragma once

#include <array>
#include <cmath>
#include <random>
#include <string_view>

#include "geometry/exact/box.h"
#include "geometry/exact/scale.h"
#include "shading/picture/picture.h"
#include "shading/scene/units.h"

namespace xnewell {

/// Seeded views of a model.

enum class Seen { Outside, Parallel, Oblique, Inside };
struct SeenRow {
  Seen id;
  std::string_view name;
};
inline constexpr std::array kSeen{
    SeenRow{Seen::Outside, "perspective from outside"},
    SeenRow{Seen::Parallel, "parallel"},
    SeenRow{Seen::Oblique, "oblique"},
    SeenRow{Seen::Inside, "perspective, the eye in the scene's box"},
};

/// A view of the whole scene or a part of it, from any side. Back faces are kept and culled by turns, for
/// each of the four kinds.
inline PictureSettings randomView(const Scene& scene, unsigned seed, int width, int height) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  const auto [low, high] = boxOf(scene.mesh.points);
  const auto within = [&, from = low, size = high - low] {
    return from + size * glm::dvec3{unit(rng), unit(rng), unit(rng)};
  };
  const double size = glm::length(high - low);
  glm::dvec3 towards;
  do towards = {unit(rng) - 0.5, unit(rng) - 0.5, unit(rng) - 0.5};
  while (glm::length(towards) < 0.1);

  PictureSettings s;
  s.width = width;
  s.height = height;
  s.cull = seed / kSeen.size() % 2 ? Cull::Back : Cull::Keep;
  CameraSettings& camera = s.camera;
  camera.lookAt = 0.25 * within() + 0.375 * (low + high);
  camera.up = glm::dvec3{0.3, 0.2, 0.9};
  camera.eye = *camera.lookAt + glm::normalize(towards) * size * (0.7 + 1.5 * unit(rng));
  switch (kSeen[seed % kSeen.size()].id) {
    case Seen::Outside:
      camera.fov = 15.0 + 40.0 * unit(rng);
      break;
    case Seen::Parallel:
      camera.parallel = true;
      camera.height = size * (0.2 + unit(rng));
      break;
    case Seen::Oblique:
      camera.oblique = Oblique{0.2 + unit(rng), 360.0 * unit(rng)};
      camera.height = size * (0.2 + unit(rng));
      break;
    case Seen::Inside:
      camera.eye = within();
      camera.fov = 40.0 + 60.0 * unit(rng);
      break;
  }
  camera.eye = inFileUnits(*camera.eye, scene), camera.lookAt = inFileUnits(*camera.lookAt, scene);
  if (camera.height) camera.height = std::ldexp(*camera.height, scene.exponent);
  return s;
}

}  // namespace xnewell
