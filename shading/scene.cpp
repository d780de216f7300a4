#include "shading/scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "geometry/bezier.h"
#include "geometry/bpt.h"
#include "geometry/obj.h"
#include "geometry/parse_error.h"
#include "geometry/teapot.h"

namespace {

glm::dvec3 scaled(glm::dvec3 v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

}  // namespace

Scene makeScene(std::string name, Mesh mesh, UpAxis up, int divisions) {
  if (mesh.faceCount() == 0) throw std::invalid_argument{name + ": holds no face"};
  double largest = 0.0;
  for (const int corner : mesh.corners) {
    const glm::dvec3& p = mesh.points[corner];
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
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
  throw ParseError{nameOrFile, 0,
                   extension.empty() ? "no built-in scene of that name; `xnewell scenes` lists them"
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
