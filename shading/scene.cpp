#include "shading/scene.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "geometry/bezier.h"
#include "geometry/bpt.h"
#include "geometry/obj.h"
#include "geometry/parse_error.h"
#include "geometry/teapot.h"

namespace {

glm::dvec3 scaled(glm::dvec3 v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

/// Drops the vertices that no face uses: they are not to be framed, nor to be transformed in every picture.
void keepUsedPoints(Mesh& mesh) {
  std::vector<int> place(mesh.points.size(), -1);
  std::vector<glm::dvec3> used;
  used.reserve(mesh.points.size());
  for (int& corner : mesh.corners) {
    if (place[corner] < 0) {
      place[corner] = static_cast<int>(used.size());
      used.push_back(mesh.points[corner]);
    }
    corner = place[corner];
  }
  mesh.points = std::move(used);
}

}  // namespace

Scene makeScene(std::string name, Mesh mesh, UpAxis up, int divisions) {
  if (mesh.faceCount() == 0) throw std::invalid_argument{name + ": holds no face"};
  keepUsedPoints(mesh);
  double largest = 0.0;
  for (const glm::dvec3& p : mesh.points)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  Scene scene{std::move(name), std::move(mesh), {}, up, 0, divisions};
  if (largest > 0.0) std::frexp(largest, &scene.exponent);
  for (glm::dvec3& p : scene.mesh.points) p = scaled(p, -scene.exponent);
  scene.mesh.rounding = std::ldexp(scene.mesh.rounding, -scene.exponent);
  scene.pieces = divideFaces(scene.mesh);
  return scene;
}

Scene readScene(const std::string& nameOrFile, int divisions) {
  std::filesystem::path file = nameOrFile;
  const auto* const builtIn = std::ranges::find(kBuiltInScenes, nameOrFile, &BuiltInScene::name);
  if (builtIn != kBuiltInScenes.end()) file = std::filesystem::path{XNEWELL_DATA_DIR} / builtIn->file;

  const std::string extension = file.extension().string();
  if (extension == ".bpt") {
    const std::vector<BezierPatch> patches = readBpt(file);
    const std::span<const PatchPart> parts =
        nameOrFile == "teapot" ? std::span<const PatchPart>{kTeapotParts} : std::span<const PatchPart>{};
    return makeScene(nameOrFile, tessellate(patches, divisions, parts), UpAxis::Z, divisions);
  }
  if (extension == ".obj") return makeScene(nameOrFile, readObj(file), UpAxis::Y);
  if (extension == ".json")
    throw ParseError{nameOrFile, 0, "scene files are not built yet; .obj and .bpt are"};
  if (std::filesystem::is_directory(file))
    throw std::system_error{EISDIR, std::generic_category(), nameOrFile};
  throw ParseError{nameOrFile, 0,
                   !std::filesystem::exists(file) && extension.empty()
                       ? "no built-in scene of that name; `xnewell scenes` lists them"
                       : "not a scene: .obj and .bpt files are"};
}

glm::dvec3 defaultLight(UpAxis up) {
  return up == UpAxis::Z ? glm::dvec3{-0.54, -0.64, 0.55} : glm::dvec3{-0.54, 0.55, 0.64};
}

double inSceneUnits(double length, const Scene& scene) {
  const double v = std::ldexp(length, -scene.exponent);
  if (!std::isfinite(v)) throw ViewError{"the camera or the light is too far away for the size of the scene"};
  return v;
}

glm::dvec3 inSceneUnits(glm::dvec3 p, const Scene& scene) {
  return {inSceneUnits(p.x, scene), inSceneUnits(p.y, scene), inSceneUnits(p.z, scene)};
}

CameraSettings inSceneUnits(CameraSettings c, const Scene& scene) {
  for (std::optional<glm::dvec3>* p : {&c.eye, &c.lookAt, &c.vrp, &c.prp})
    if (*p) *p = inSceneUnits(**p, scene);
  for (std::optional<double>* v : {&c.height, &c.front, &c.back})
    if (*v) *v = inSceneUnits(**v, scene);
  if (c.window)
    for (int k = 0; k < 4; ++k) (*c.window)[k] = inSceneUnits((*c.window)[k], scene);
  return c;
}
