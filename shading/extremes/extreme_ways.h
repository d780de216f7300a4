#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/view/camera.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// The ways on which extremes.h drives a scene.

/// A scene and its settings at one step of the way.
struct Case {
  Scene scene;
  PictureSettings settings;
};

/// What a way starts from.
struct Start {
  Scene scene;  ///< its points are those of the file times a power of two
  PictureSettings settings;
  Camera camera;
  double size;        ///< the longest side of the scene's box
  double pixel;       ///< what a pixel shows of it at the look-at point, in the scene's units
  glm::dvec3 target;  ///< the point of a surface that shows nearest to the picture's middle
  glm::dvec3 facing;  ///< its normal, towards the eye; a unit vector
};

/// One way to an extreme.
struct Way {
  std::string_view name, unit, drives;
  std::vector<double> values;
  bool changesNothing = false;  ///< the picture should stay the same
  std::function<Case(const Start&, double)> at;
  std::function<std::string(const Start&, double)> why;
};

[[nodiscard]] const std::vector<Way>& extremeWays();

}  // namespace xnewell
