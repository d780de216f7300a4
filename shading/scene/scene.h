#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/model/bezier.h"
#include "geometry/model/divide.h"
#include "geometry/model/mesh.h"
#include "geometry/view/camera.h"
#include "shading/fill/texture.h"
#include "shading/light/illumination.h"
#include "shading/scene/picture_settings.h"

namespace xnewell {

/// Faces of the mesh that are Bezier patches, divided.
struct PatchRun {
  int firstCorner = 0;  ///< of the mesh: theirs follow one another, as tessellate() has them
  std::vector<BezierPatch> patches;
  int divisions = 0;
};

/// Where a scene came from, and what was done to it since: enough to name it in a scene file.
struct SceneOrigin {
  std::string of;                         ///< as readScene() takes it: a built-in name, or a file
  int divisions = 0;                      ///< that were asked for
  std::vector<std::string> without = {};  ///< of kStrippable
  std::string texture = {};               ///< the file of wear(); "" for none
};

/// What is to be drawn, in world coordinates scaled by a power of two so that the largest is in [1/2, 1):
/// an exact step that keeps files of any magnitude (1e-300, 1e300) within reach of everything after it.
struct Scene {
  std::string name;
  Mesh mesh;
  Pieces pieces;  ///< the mesh's faces as convex planar polygons
  UpAxis up = UpAxis::Y;
  int exponent = 0;          ///< file coordinate = mesh coordinate * 2^exponent
  CameraSettings camera;     ///< of the scene file, in its units; empty where it has none
  PictureSettings settings;  ///< what the scene asks for, size and camera aside: to begin a picture with
  int divisions = 0;         ///< of each Bezier patch; 0 where there are none, or some differ
  std::vector<PatchRun> patches;
  SceneLight light;  ///< of the scene file, lengths in the mesh's units
  SceneOrigin origin;
  std::vector<Texture> textures;
};

/// The normals of the patches at the mesh's corners, 0 at all others; empty where there are no patches.
[[nodiscard]] std::vector<glm::dvec3> exactNormals(const Scene& scene);

struct BuiltInScene {
  std::string name, shows;
};
/// The teapot, then every scene file of the data folder by name.
[[nodiscard]] std::vector<BuiltInScene> builtInScenes();
[[nodiscard]] bool isBuiltIn(const std::string& name);

inline constexpr int kDefaultDivisions = 8;

/// A built-in name or a file, `.obj`, `.bpt` or `.json`. The built-in name wins over a file of
/// that name; a path such as `./teapot` does not mean it. @throws ParseError, std::system_error
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
/// The user's light, its place and attenuation.
void toSceneUnits(Illumination& light, const Scene& scene);
/// And back, exactly.
void toFileUnits(Illumination& light, const Scene& scene);

/// What a scene may say of itself and can be made to forget, so that the user's choice counts.
inline constexpr std::array<std::string_view, 6> kStrippable{"ambient", "lights", "ka", "kd", "ks", "n"};
/// `what` is one of them.
void strip(Scene& scene, std::string_view what);

/// All surfaces get the texture. @throws ViewError if no face has texture coordinates
void wear(Scene& scene, Texture texture);

/// For people: the name without its folders, and how finely patches are divided.
[[nodiscard]] std::string titleOf(const Scene& scene);

/// What was said, and the scene's own camera for the rest: a projection or a textbook specification that was
/// said replaces the scene's as a whole.
[[nodiscard]] CameraSettings completed(CameraSettings said, const CameraSettings& scene);

}  // namespace xnewell
