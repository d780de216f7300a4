#pragma once

#include <array>

#include "geometry/view/project.h"

namespace xnewell {

/// The triangles over which the values at the corners of a face are interpolated: a plane over the screen
/// passes through three values. A polygon with more corners becomes a fan around the corner that the model
/// lists first, so the view does not choose it. Two faces agree along the edge that they share.

/// A triangle of an outline, counter-clockwise on the screen.
struct FaceTriangle {
  std::array<glm::ivec3, 3> p;
  std::array<int, 3> vertex;  ///< index into SnappedScene::vertices
};

/// Calls use(triangle) for each triangle that has an area.
template <class Use>
void forEachTriangle(const SnappedScene& scene, const SnappedFace& face, Use&& use) {
  const auto triangle = [&](int a, int b, int c) {
    const std::array vertex{face.first + a, face.first + b, face.first + c};
    return FaceTriangle{{scene.vertices[vertex[0]], scene.vertices[vertex[1]], scene.vertices[vertex[2]]},
                        vertex};
  };
  if (face.count == 3) return use(triangle(0, 1, 2));
  int apex = 0;
  const auto listed = [&](int v) { return static_cast<unsigned>(scene.source[face.first + v]); };
  for (int v = 1; v < face.count; ++v)
    if (listed(v) < listed(apex))
      apex = v;  // the source of a vertex made by clipping is negative: larger than all others
  for (int k = 1; k + 1 < face.count; ++k) {
    const FaceTriangle t = triangle(apex, (apex + k) % face.count, (apex + k + 1) % face.count);
    if (doubleArea(t.p.data(), 3) > 0) use(t);
  }
}

}  // namespace xnewell
