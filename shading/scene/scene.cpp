#include "shading/scene/scene.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "geometry/exact/plane.h"
#include "geometry/exact/scale.h"
#include "geometry/files/input_file.h"
#include "geometry/files/model_file.h"
#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "geometry/model/bezier.h"
#include "geometry/model/coplanar.h"
#include "shading/scene/mesh_textures.h"
#include "shading/scene/scene_file.h"

namespace xnewell {

namespace {

/// The file of a built-in scene; empty if the name is not one. Built-in names are plain words, with no folder
/// and no extension.
std::filesystem::path fileOfBuiltIn(const std::string& name) {
  if (name == "teapot") return dataFolder() / "teapot.bpt";
  if (name.empty() || name.find_first_of("./") != std::string::npos) return {};
  const std::filesystem::path file = dataFolder() / "scenes" / (name + ".json");
  return isThere(file) ? file : std::filesystem::path{};
}

bool isGray(const glm::dvec3& color) { return color.r == color.g && color.g == color.b; }

/// Drops the vertices that no face uses. Otherwise the camera would frame them, and every picture would
/// transform them.
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

/// Some files have normals to one side of a face, and its outline to the other. The outline decides which
/// side is the front, so the normals of a face are turned to where most of them belong.
void turnNormals(Mesh& mesh) {
  if (std::ranges::all_of(mesh.normals, [](const glm::dvec3& N) { return N == glm::dvec3{0.0}; }))
    mesh.normals.clear();
  for (int f = 0; !mesh.normals.empty() && f < mesh.faceCount(); ++f) {
    const glm::dvec3 front = unit(newellVector(mesh.points, mesh.face(f)));
    double along = 0.0;
    for (const glm::dvec3& N : mesh.normalsOf(f)) along += glm::dot(N, front);
    if (along < 0.0)
      for (int k = mesh.firstCorner[f]; k < mesh.firstCorner[f + 1]; ++k)
        mesh.normals[k] = 0.0 - mesh.normals[k];
  }
}

}  // namespace

Scene makeScene(std::string name, Mesh mesh, UpAxis up, int divisions) {
  if (mesh.faceCount() == 0) throw std::invalid_argument{name + ": the scene has no faces"};
  keepUsedPoints(mesh);
  partTextures(mesh);
  countRounding(mesh);
  double largest = 0.0;
  for (const glm::dvec3& p : mesh.points)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  Scene scene;
  scene.name = std::move(name);
  scene.mesh = std::move(mesh);
  scene.up = up;
  scene.settings.light.light = defaultLight(up);
  scene.divisions = divisions;
  if (largest > 0.0) std::frexp(largest, &scene.exponent);
  scene.light.unit = std::ldexp(1.0, -scene.exponent);
  for (glm::dvec3& p : scene.mesh.points) p = scaled(p, -scene.exponent);
  for (double& u : scene.mesh.rounding) u = std::ldexp(u, -scene.exponent);
  turnNormals(scene.mesh);
  if (!scene.mesh.normals.empty()) scene.settings.normals = NormalRule::File;
  scene.parts = divideFaces(scene.mesh);
  uniteCoplanar(scene.mesh, scene.parts);
  return scene;
}

bool isGray(const Scene& scene) {
  const auto light = [](const Light& l) { return isGray(l.Ip); };
  const auto surface = [](const MeshMaterial& m) { return isGray(m.diffuse) && isGray(m.specular); };
  return isGray(scene.light.Ia.value_or(glm::dvec3{0.0})) && std::ranges::all_of(scene.light.lights, light) &&
         std::ranges::all_of(scene.mesh.materials, surface) &&
         std::ranges::none_of(scene.textures, &Texture::colored);
}

int firstFaceOf(const Mesh& mesh, const PatchRun& run) {
  const auto face = std::ranges::lower_bound(mesh.firstCorner, run.firstCorner);
  return static_cast<int>(face - mesh.firstCorner.begin());
}

int facesOf(const PatchRun& run) {
  return static_cast<int>(run.patches.size()) * run.divisions * run.divisions;
}

std::vector<glm::dvec3> exactNormals(const Scene& scene, NormalRule rule) {
  std::vector<glm::dvec3> normals;
  if (rule == NormalRule::File) normals = scene.mesh.normals;
  if (rule < NormalRule::Exact) return normals;
  for (const PatchRun& run : scene.patches) {
    normals.resize(scene.mesh.corners.size(), glm::dvec3{0.0});
    std::ranges::copy(cornerNormals(run.patches, run.divisions), normals.begin() + run.firstCorner);
  }
  return normals;
}

std::vector<BuiltInScene> builtInScenes() {
  std::vector<BuiltInScene> scenes;
  for (const auto& entry : std::filesystem::directory_iterator{dataFolder() / "scenes"})
    if (entry.path().extension() == ".json")
      scenes.push_back({entry.path().stem().string(), sentenceOf(entry.path())});
  std::ranges::sort(scenes, {}, &BuiltInScene::name);
  scenes.insert(
      scenes.begin(),
      {"teapot", "Martin Newell's teapot: 32 Bezier patches; handle and spout pass through the body"});
  return scenes;
}

std::vector<std::string> namesOf(const std::vector<BuiltInScene>& scenes) {
  std::vector<std::string> names;
  for (const BuiltInScene& scene : scenes) names.push_back(scene.name);
  return names;
}

bool isBuiltIn(const std::string& name) { return !fileOfBuiltIn(name).empty(); }

namespace {

Scene readAny(const std::string& nameOrFile, int divisions) {
  const std::filesystem::path builtIn = fileOfBuiltIn(nameOrFile);
  const std::filesystem::path file = builtIn.empty() ? std::filesystem::path{nameOrFile} : builtIn;
  const std::string extension = extensionOf(file);
  const ModelFileRow* const model = modelFile(file);
  if (model && !model->polygons) {
    const std::vector<BezierPatch> patches = readBpt(file);
    const std::span<const PatchPart> parts =
        builtIn.empty() ? std::span<const PatchPart>{} : std::span<const PatchPart>{kTeapotParts};
    Scene scene = makeScene(nameOrFile, tessellate(patches, divisions, parts), UpAxis::Z, divisions);
    scene.patches.push_back({0, patches, divisions});
    return scene;
  }
  if (model) {
    Mesh mesh = model->polygons(file);
    TextureReader textures;
    textures.readAll(mesh);
    Scene scene = makeScene(nameOrFile, std::move(mesh), UpAxis::Y);
    scene.textures = textures.take();
    if (!scene.textures.empty()) scene.settings.light.texel = TexelUse::Multiplies;  // as MTL defines map_Kd
    return scene;
  }
  if (extension == ".json") {
    Scene scene = readSceneFile(file, divisions);
    scene.name = nameOrFile;
    return scene;
  }
  if (std::error_code none; std::filesystem::is_directory(file, none))
    throw std::system_error{EISDIR, std::generic_category(), nameOrFile};
  throw ParseError{nameOrFile, 0,
                   !isThere(file) && extension.empty()
                       ? "there is no built-in scene of that name; " +
                             didYouMean(nameOrFile, namesOf(builtInScenes()), "`xnewell scenes` lists them")
                       : "not a scene file: scenes are .json files and models: " + modelExtensions()};
}

/// Notes the faces that people rarely mean, but for those that stand for a curved surface: those that cross
/// themselves, and those whose parts lie in several planes.
void noteOddFaces(Scene& scene) {
  std::vector<bool> curved(static_cast<std::size_t>(scene.mesh.faceCount()), false);
  const auto curves = [&](int first, int count) { std::fill_n(curved.begin() + first, count, true); };
  for (const PatchRun& run : scene.patches) curves(firstFaceOf(scene.mesh, run), facesOf(run));
  for (const RoundRun& run : scene.rounds) curves(run.firstFace, run.faces);
  std::vector<int> crossing, bent;
  const ConvexParts& parts = scene.parts;
  for (int k = 0; k < parts.count();) {
    const int face = parts.face[k], first = k;
    bool onePlane = true;
    for (; k < parts.count() && parts.face[k] == face; ++k) onePlane &= parts.plane[k] == parts.plane[first];
    if (curved[static_cast<std::size_t>(face)]) continue;
    if (crossesItself(scene.mesh, face))
      crossing.push_back(face);
    else if (!onePlane)
      bent.push_back(face);
  }
  const auto note = [&](const std::vector<int>& faces, const std::string& one, const std::string& several) {
    if (faces.empty()) return;
    const std::string first = "face " + std::to_string(faces.front());
    const std::string what =
        faces.size() == 1 ? first + one
                          : std::to_string(faces.size()) + " faces, the first is " + first + "," + several;
    scene.mesh.notes.emplace_back(ParseError{scene.name, 0, what}.what());
  };
  note(crossing, " crosses itself: where it overlaps itself, it may cover too much or nothing",
       " cross themselves: where they overlap themselves, they may cover too much or nothing");
  note(bent, " is bent: its corners lie in no plane, so it is cut into triangles",
       " are bent: their corners lie in no plane, so they are cut into triangles");
}

}  // namespace

Scene readScene(const std::string& nameOrFile, int divisions) {
  Scene scene = readAny(nameOrFile, divisions);
  noteOddFaces(scene);
  if (scene.origin.of.empty()) scene.origin = {.of = nameOrFile, .divisions = divisions};
  return scene;
}

glm::dvec3 defaultLight(UpAxis up) {
  const glm::dvec3 L = Illumination{}.light;  // in a world whose up axis is z
  return up == UpAxis::Z ? L : glm::dvec3{L.x, L.z, -L.y};
}

CameraSettings completed(CameraSettings said, const CameraSettings& scene) {
  const CameraSettings user = said;
  const auto fill = [](auto& mine, const auto& theirs, bool replaced = false) {
    if (!mine && !replaced) mine = theirs;
  };
  fill(said.eye, scene.eye, user.vpn || user.prp);
  fill(said.vpn, scene.vpn, user.eye.has_value()), fill(said.prp, scene.prp, user.eye.has_value());
  fill(said.lookAt, scene.lookAt, user.vrp.has_value());
  fill(said.vrp, scene.vrp, user.lookAt.has_value());
  fill(said.up, scene.up, user.vup.has_value()), fill(said.vup, scene.vup, user.up.has_value());
  fill(said.front, scene.front), fill(said.back, scene.back);
  if (!user.parallel && !user.oblique && !user.fov) {
    said.parallel = scene.parallel;
    fill(said.height, scene.height), fill(said.oblique, scene.oblique);
    fill(said.fov, scene.fov, user.window.has_value());
    fill(said.window, scene.window);
  }
  return said;
}

void strip(Scene& scene, std::string_view what) {
  bool had = false;
  const auto end = [&](std::string_view name, auto& own) {
    if (name == what) had |= std::exchange(own, {}).has_value();
  };
  for (MeshMaterial& m : scene.mesh.materials)
    end("ka", m.ka), end("kd", m.kd), end("ks", m.ks), end("n", m.n);
  end("ambient", scene.light.Ia);
  if (what == "lights") had = !std::exchange(scene.light.lights, {}).empty(), scene.origin.relit = false;
  if (had) scene.origin.without.emplace_back(what);
}

void wear(Scene& scene, Texture texture) {
  Mesh& mesh = scene.mesh;
  if (mesh.uvOfCorner.empty())
    throw ViewError{scene.name + ": the scene has no texture coordinates, so it cannot show a texture"};
  const int number = static_cast<int>(scene.textures.size()), bare = static_cast<int>(mesh.materials.size());
  scene.textures.push_back(std::move(texture));
  if (std::ranges::find(mesh.material, -1) != mesh.material.end()) mesh.materials.emplace_back();
  std::ranges::replace(mesh.material, -1, bare);
  for (MeshMaterial& m : mesh.materials) m.texture = number;
  partTextures(mesh);
}

std::string titleOf(const Scene& scene) {
  const std::string name = visible(scene.name.substr(scene.name.find_last_of('/') + 1));
  const int all = scene.patches.empty() ? scene.divisions : scene.patches.front().divisions;
  const bool alike =
      std::ranges::all_of(scene.patches, [&](const PatchRun& run) { return run.divisions == all; });
  if (all == 0 || !alike) return name;
  const std::string divisions = std::to_string(all);
  return name + " \u00B7 " + divisions + " x " + divisions + " divisions";
}

}  // namespace xnewell
