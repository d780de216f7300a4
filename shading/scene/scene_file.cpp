#include "shading/scene/scene_file.h"

#include <algorithm>
#include <vector>

#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "geometry/model/bezier.h"
#include "shading/scene/json_node.h"
#include "shading/scene/json_text.h"
#include "shading/scene/read_camera.h"
#include "shading/scene/read_light.h"
#include "shading/scene/read_objects.h"
#include "shading/scene/read_shading.h"
#include "shading/scene/scene_marks.h"

namespace xnewell {

namespace {

/// Reads the scene of a set-up. Such a file names another scene instead of listing its own objects.
Scene otherScene(const Node& root, const std::filesystem::path& folder, int divisions) {
  root.expectKeys({"shows", "scene", "divisions", "without", "texture", "camera", "shading"});
  const Node other = root.at("scene");
  if (root.has("divisions")) divisions = root.at("divisions").whole(1, kMaxDivisions);
  const std::string of = isBuiltIn(other.text()) ? other.text() : namedFile(folder, other.text()).string();
  if (!isBuiltIn(of) && isSetup(of))
    other.fail(inQuotes(other.text()) + " is itself a set-up of another scene; name that scene");
  Scene scene;
  if (!isBuiltIn(of) && !std::filesystem::path{of}.has_extension())
    other.fail(inQuotes(other.text()) + " is not a built-in scene; `xnewell scenes` lists them");
  try {
    scene = readScene(of, divisions);
  } catch (const std::system_error& e) {
    throw std::system_error{e.code(), other.place() + ": " + inQuotes(other.text())};
  }
  if (root.has("without"))
    for (int i = 0; i < root.at("without").size(); ++i) {
      const Node what = root.at("without").item(i);
      if (std::ranges::find(kStrippable, what.text()) == kStrippable.end())
        what.fail(inQuotes(what.text()) + " is not one of ambient, lights, ka, kd, ks, n");
      strip(scene, what.text());
    }
  if (root.has("texture")) {
    const Node texture = root.at("texture");
    scene.origin.texture = namedFile(folder, texture.text()).string();
    try {
      wear(scene, readTexture(scene.origin.texture));
    } catch (const ViewError& e) {
      texture.fail(e.what());
    } catch (const std::system_error& e) {
      throw std::system_error{e.code(), texture.place() + ": " + inQuotes(texture.text())};
    }
  }
  return scene;
}

/// Makes the scene from the file's own objects.
Scene ownScene(const Node& root, std::string_view text, const std::string& name,
               const std::filesystem::path& folder, int divisions) {
  root.expectKeys(
      {"shows", "up", "camera", "ambient", "lights", "shading", "materials", "objects", "lines", "labels"});
  UpAxis up = UpAxis::Y;
  if (root.has("up")) {
    const std::string axis = root.at("up").text();
    if (axis != "y" && axis != "z") root.at("up").fail("\"y\" or \"z\" is needed");
    up = axis == "z" ? UpAxis::Z : UpAxis::Y;
  }
  Objects objects = readObjects(root, text, folder, divisions);
  if (objects.mesh.faceCount() == 0) root.fail("the scene has no faces");
  const bool open = std::ranges::any_of(objects.patches, [](const PatchRun& run) { return !run.own; });
  Scene scene = makeScene(name, std::move(objects.mesh), up, open ? divisions : 0);
  scene.patches = std::move(objects.patches);
  scene.rounds = std::move(objects.rounds);
  scene.textures = std::move(objects.textures);
  scene.marks = readMarks(root, scene.exponent);
  return scene;
}

}  // namespace

Scene parseSceneFile(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                     int divisions) {
  const JsonText json{text, name};
  const Node root = json.root();
  if (root.has("shows")) (void)root.at("shows").text();
  const bool other = root.has("scene");
  Scene scene = other ? otherScene(root, folder, divisions) : ownScene(root, text, name, folder, divisions);
  if (root.has("camera")) {
    scene.camera = readCamera(root.at("camera"));
    expectSees(scene.camera, scene, root.at("camera"));
  }
  if (root.has("shading")) {
    readShading(scene.settings, root.at("shading"));
    expectCounts(scene.settings, scene.light, root.at("shading"));
    if (!other) expectDivides(scene.settings, root.at("shading"));
  }
  if (!other) readLight(scene, root);
  return scene;
}

Scene readSceneFile(const std::filesystem::path& file, int divisions) {
  return parseSceneFile(readTextFile(file), file.string(), file.parent_path(), divisions);
}

bool isSetup(const std::filesystem::path& file) {
  return file.extension() == ".json" && std::filesystem::is_regular_file(file) &&
         JsonText{readTextFile(file), file.string()}.root().has("scene");
}

std::string sentenceOf(const std::filesystem::path& file) {
  const JsonText json{readTextFile(file), file.string(), {"shows"}};
  return json.root().has("shows") ? json.root().at("shows").text() : "";
}

}  // namespace xnewell
