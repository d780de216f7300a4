#pragma once

#include <array>

#include "geometry/model/solids.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"
#include "shading/scene/units.h"

namespace xnewell {

/// Coarse floors under light that is narrower than their polygons, so that flat and Gouraud shading miss it.

/// The square |x|, |y| <= 1 in z = 0 as n by n squares, seen from above. The texture's (0, 0) and (1, 1) are
/// its corners.
inline Mesh floorOf(int n) {
  Mesh mesh;
  mesh.groupNames = {"floor"};
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      mesh.uv.push_back({double(i) / n, double(j) / n});
      mesh.points.emplace_back(2.0 * mesh.uv.back() - 1.0, 0.0);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      const std::array corners{a, a + 1, a + n + 2, a + n + 1};
      mesh.addFace(corners, 0, -1, corners);
    }
  return mesh;
}

/// A scene with a spotlight above the floor. Angles are in degrees.
inline Scene underSpot(Mesh mesh, double inner = 14, double outer = 20) {
  Scene scene = makeScene("spot", std::move(mesh), UpAxis::Z);
  scene.light.lights = {{.kind = LightKind::Spot,
                         .Ip = glm::dvec3{0.7},
                         .direction = {0.2, 0.3, -1.0},
                         .position = inSceneUnits(glm::dvec3{-0.1, -0.2, 1.3}, scene),
                         .inner = inner,
                         .outer = outer}};
  return scene;
}

/// A parallel view straight from above: interpolated places are those of the floor.
inline PictureSettings fromAbove(Shading shading) {
  PictureSettings s;
  s.width = s.height = 480;
  s.shading = shading;
  s.camera.eye = glm::dvec3{0.0, 0.0, 2.0};
  s.camera.lookAt = glm::dvec3{0.0};
  s.camera.up = glm::dvec3{0, 1, 0};
  s.camera.parallel = true;
  s.camera.height = 2.1;
  s.light.kd = 0.8;
  s.light.ks = 0.0;
  return s;
}

/// Light from far away, such that R meets V at (0.26, 0.42, 0) of the floor.
inline PictureSettings withHighlight(PictureSettings s) {
  s.light.light = {0.13, 0.21, 1.0};
  s.light.kd = 0.5;
  s.light.ks = 0.5;
  s.light.n = 80;
  return s;
}

}  // namespace xnewell
