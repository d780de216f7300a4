#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string_view>
#include <vector>

#include "depthsort/oracle.h"
#include "shading/picture.h"
#include "shading/scanline.h"

/// Seeded views of a model, and what is known of each sample of a picture of it.

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

/// Of the whole scene or a part, from any side; back faces are kept and culled by turns of all four kinds.
inline PictureSettings randomView(const Scene& scene, unsigned seed, int width, int height) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  glm::dvec3 low{1.0}, high{-1.0};
  for (const glm::dvec3& p : scene.mesh.points) low = glm::min(low, p), high = glm::max(high, p);
  const auto within = [&] { return low + (high - low) * glm::dvec3{unit(rng), unit(rng), unit(rng)}; };
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
  return s;
}

/// |zP - zQ| at the centre of sample k, in z steps.
inline double depthBetween(const SnappedScene& scene, int p, int q, int k, int width) {
  const std::int64_t x = std::int64_t{k % width} * kGrid + kGrid / 2,
                     y = std::int64_t{k / width} * kGrid + kGrid / 2;
  return std::abs(depthAt(scene.planes[scene.faces[p].plane], x, y) -
                  depthAt(scene.planes[scene.faces[q].plane], x, y));
}

/// Whether the two may touch at sample k for all that is known of the model: they lie in two planes,
/// nearer to each other than the rounding of both.
inline bool mayTouch(const SnappedScene& scene, int p, int q, int k, int width) {
  const SnappedFace &P = scene.faces[p], &Q = scene.faces[q];
  return P.plane != Q.plane && depthBetween(scene, p, q, k, width) <= double{P.doubt} + Q.doubt;
}

/// Calls visit(k, face) for each sample of each face.
template <class Visit>
void forEachSample(const SnappedScene& scene, int width, int height, Visit&& visit) {
  for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f)
    forEachSpan(&scene.vertices[scene.faces[f].first], scene.faces[f].count, width, height,
                [&](int row, int from, int to) {
                  for (int i = from; i < to; ++i) visit(row * width + i, f);
                });
}

/// The doubtful samples: where a face may touch the one that is seen.
inline std::vector<char> doubtful(const SnappedScene& scene, const std::vector<int>& seen, int width,
                                  int height) {
  std::vector<char> samples(seen.size(), false);
  forEachSample(scene, width, height, [&](int k, int face) {
    samples[k] |= face != seen[k] && mayTouch(scene, face, seen[k], k, width);
  });
  return samples;
}
