#pragma once

#include "shading/picture/picture.h"

namespace xnewell {

/// Scenes with light and a camera, as users have them: cubes, spheres, tori, teapots, single polygons; a lamp
/// far or near; any of the methods flat, Gouraud and Phong. The same seed gives the same scene.
struct LitScene {
  Scene scene;
  PictureSettings settings;  ///< 160 x 120; the camera is turned by a random angle
};
[[nodiscard]] LitScene randomLitScene(unsigned seed);

}  // namespace xnewell
