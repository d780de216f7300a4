#pragma once

#include <array>
#include <string>
#include <string_view>

#include "geometry/bezier.h"
#include "geometry/camera.h"
#include "geometry/divide.h"
#include "geometry/mesh.h"

/// What is to be drawn, in world coordinates scaled by a power of two so that the largest is in [1/2, 1):
/// an exact step that keeps files of any magnitude (1e-300, 1e300) within reach of everything after it.
struct Scene {
  std::string name;
  Mesh mesh;
  Pieces pieces;  ///< the mesh's faces as convex planar polygons
  UpAxis up = UpAxis::Y;
  int exponent = 0;   ///< file coordinate = mesh coordinate * 2^exponent
  int divisions = 0;  ///< of each Bezier patch; 0 where there are none
};

struct BuiltInScene {
  std::string_view name, file, shows;
};
inline constexpr std::array kBuiltInScenes{
    BuiltInScene{"teapot", "teapot.bpt",
                 "Martin Newell's teapot: 32 Bezier patches, handle and spout pass through the body"},
    BuiltInScene{"cycle", "scenes/cycle.obj",
                 "three bars, each over the next: no order is right without a cut"},
    BuiltInScene{"penetrate", "scenes/penetrate.obj", "two plates that pass through each other"},
};

inline constexpr int kDefaultDivisions = 8;

/// A built-in name or a file, `.obj` or `.bpt`. A file of that name wins over nothing: built-in names have
/// no dot. @throws ParseError, std::system_error
[[nodiscard]] Scene readScene(const std::string& nameOrFile, int divisions = kDefaultDivisions);

/// The scene of a mesh in file coordinates, without the vertices that no face uses. @throws
/// std::invalid_argument if it holds no face
[[nodiscard]] Scene makeScene(std::string name, Mesh mesh, UpAxis up, int divisions = 0);

/// The direction towards the light where none is given: the upper left of the default view.
[[nodiscard]] glm::dvec3 defaultLight(UpAxis up);

/// A length or a place given in file coordinates, in the scene's. @throws ViewError where that leaves the
/// range of doubles
[[nodiscard]] double inSceneUnits(double length, const Scene& scene);
[[nodiscard]] glm::dvec3 inSceneUnits(glm::dvec3 point, const Scene& scene);
[[nodiscard]] CameraSettings inSceneUnits(CameraSettings camera, const Scene& scene);
