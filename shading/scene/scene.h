#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/model/bezier.h"
#include "geometry/model/divide.h"
#include "geometry/model/mesh.h"
#include "geometry/model/solids.h"
#include "geometry/view/camera.h"
#include "shading/fill/texture.h"
#include "shading/light/illumination.h"
#include "shading/scene/picture_settings.h"

namespace xnewell {

/// The faces of the mesh that come from one set of Bezier patches.
struct PatchRun {
  int firstCorner = 0;  ///< index of their first corner in the mesh; the others follow in the order of
                        ///< tessellate()
  std::vector<BezierPatch> patches;  ///< in file coordinates
  int divisions = 0;
  bool own = false;  ///< the file sets the divisions, so readScene() has no say
};
/// The number of the run's first face, and how many faces it has.
[[nodiscard]] int firstFaceOf(const Mesh& mesh, const PatchRun& run);
[[nodiscard]] int facesOf(const PatchRun& run);

/// The faces of the mesh that approximate a round solid.
struct RoundRun {
  int firstFace = 0, faces = 0;
  RoundSolid solid = RoundSolid::Sphere;
  /// A point p of the solid is at axes p + centre, in file coordinates.
  glm::dmat3 axes{1.0};
  glm::dvec3 centre{0.0};
  int columns = 1;  ///< the faces in a row: around a sphere, or across the tube of a torus
};

/// Where a scene came from and what was done to it since, so that a scene file can name it.
struct SceneOrigin {
  std::string of;                         ///< the argument of readScene(): a built-in name, or a file
  int divisions = 0;                      ///< the divisions that were asked for
  std::vector<std::string> without = {};  ///< what strip() removed, in words of kStrippable
  std::string texture = {};               ///< the file of the texture that wear() applied; "" for none
  bool relit = false;                     ///< its lights are those of the set-up that named it
};

/// What is drawn over a scene's picture: edges of its model, and lines and words that have a place in space,
/// in the units of the mesh.
struct SceneLine {
  std::vector<glm::dvec3> points;
  glm::dvec3 color{0};
  double width = 1;  ///< in pixels
};
struct SceneLabel {
  std::string text;  ///< UTF-8, of characters that the font has
  glm::dvec3 at{0};  ///< where it begins, on its base line
  glm::dvec3 color{0};
  double size = 12;  ///< of the font, in pixels
};
/// Which edges of the model a picture shows as lines.
enum class ModelEdges { None, Visible, All };
struct ModelEdgesRow {
  ModelEdges id;
  std::string_view name;
};
inline constexpr std::array kModelEdges{ModelEdgesRow{ModelEdges::None, "none"},
                                        ModelEdgesRow{ModelEdges::Visible, "visible"},
                                        ModelEdgesRow{ModelEdges::All, "all"}};
struct SceneMarks {
  std::vector<SceneLine> lines;
  std::vector<SceneLabel> labels;
  ModelEdges edges = ModelEdges::None;
  glm::dvec3 edgeColor{0};
  [[nodiscard]] bool empty() const { return lines.empty() && labels.empty() && edges == ModelEdges::None; }
};

/// What is to be drawn. World coordinates are scaled by a power of two so that the largest is in [1/2, 1).
/// This step is exact, and everything after it can handle files of any magnitude (1e-300, 1e300).
struct Scene {
  std::string name;
  Mesh mesh;
  ConvexParts parts;  ///< the faces of the mesh as convex planar polygons
  UpAxis up = UpAxis::Y;
  int exponent = 0;          ///< file coordinate = mesh coordinate * 2^exponent
  CameraSettings camera;     ///< from the scene file, in its units; empty if the file has none
  PictureSettings settings;  ///< the settings that the scene asks for; size and camera are not among them
  int divisions = 0;         ///< of the Bezier patches that do not set their own; 0 if there are none
  std::vector<PatchRun> patches;  ///< in the order of their faces
  std::vector<RoundRun> rounds;   ///< in the order of their faces
  SceneLight light;               ///< from the scene file, with lengths in the mesh's units
  SceneOrigin origin;
  std::vector<Texture> textures;
  SceneMarks marks;
};

/// True if the lights, surfaces and textures of the scene have no colour, only shades of gray.
[[nodiscard]] bool isGray(const Scene& scene);

/// The normals that are known at the corners of the mesh: for NormalRule::Exact those of the patches, for
/// File also those of Mesh::normals; 0 at other corners. Empty if there are none.
[[nodiscard]] std::vector<glm::dvec3> exactNormals(const Scene& scene, NormalRule rule);

struct BuiltInScene {
  std::string name, shows;
};
/// The teapot, then every scene file of the data folder, sorted by name.
[[nodiscard]] std::vector<BuiltInScene> builtInScenes();
[[nodiscard]] std::vector<std::string> namesOf(const std::vector<BuiltInScene>& scenes);
[[nodiscard]] bool isBuiltIn(const std::string& name);

inline constexpr int kDefaultDivisions = 8;

/// Reads a built-in scene, or a model file (model_file.h) or `.json`. A built-in name wins over a file of
/// that name; a path such as `./teapot` always means the file. `divisions` applies to Bezier patches.
/// @throws ParseError, std::system_error
[[nodiscard]] Scene readScene(const std::string& nameOrFile, int divisions = kDefaultDivisions);

/// Makes a scene from a mesh in file coordinates. It drops the vertices that no face uses.
/// @throws std::invalid_argument if the mesh has no face
[[nodiscard]] Scene makeScene(std::string name, Mesh mesh, UpAxis up, int divisions = 0);

/// The direction towards the light if none is given: from the upper left of the default view.
[[nodiscard]] glm::dvec3 defaultLight(UpAxis up);

/// What a scene file may set and strip() can remove, so that the user's choice counts.
inline constexpr std::array<std::string_view, 6> kStrippable{"ambient", "lights", "ka", "kd", "ks", "n"};
/// Removes `what`, one of kStrippable, from the scene.
void strip(Scene& scene, std::string_view what);

/// Gives the texture to all surfaces that have texture coordinates. @throws ViewError if no face has texture
/// coordinates
void wear(Scene& scene, Texture texture);

/// The scene's name as people see it: without its folders, and with the divisions of its patches.
[[nodiscard]] std::string titleOf(const Scene& scene);

/// The user's camera, completed with the scene's own. Each part that the user gives takes the place of the
/// same part of the scene, and all others stay. Some parts have two names: `eye` is the same part as `vpn`
/// with `prp`, `lookAt` as `vrp`, `up` as `vup`. How much is seen is one part: the user's `fov`, `parallel`
/// or `oblique` takes the place of all that the scene says of these and of `window`. The user's `window`
/// takes the place of the scene's `window` and `fov`.
[[nodiscard]] CameraSettings completed(CameraSettings said, const CameraSettings& scene);

}  // namespace xnewell
