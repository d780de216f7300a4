#include "shading/scene_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "geometry/parse_error.h"
#include "geometry/text_file.h"
#include "shading/json_node.h"
#include "shading/read_camera.h"
#include "shading/read_light.h"
#include "shading/read_objects.h"
#include "shading/read_shading.h"

namespace {

/// Of two values of one key a parser keeps the last; here nobody should have to guess which counts.
class KeysOnce {
 public:
  explicit KeysOnce(const std::string& file) : file_{file} {}
  bool operator()(int, Node::Json::parse_event_t event, const Node::Json& parsed) {
    using Event = Node::Json::parse_event_t;
    if (event == Event::object_start) open_.emplace_back();
    if (event == Event::object_end) open_.pop_back();
    if (event == Event::key && !open_.back().insert(parsed.get<std::string>()).second)
      throw ParseError{file_, 0,
                       "the key " + inQuotes(parsed.get<std::string>()) + " stands twice in an object"};
    return true;
  }

 private:
  const std::string& file_;
  std::vector<std::set<std::string>> open_;  ///< the keys so far of the objects that are being read
};

/// JSON or a ParseError with its line.
Node::Json parsed(std::string_view text, const std::string& name) {
  try {
    return Node::Json::parse(text, KeysOnce{name});
  } catch (const Node::Json::parse_error& e) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(e.byte, text.size()));
    throw ParseError{name, 1 + static_cast<int>(std::count(text.begin(), end, '\n')), "not JSON here"};
  } catch (const Node::Json::out_of_range&) {
    throw ParseError{name, 0, "a number is too large"};
  }
}

}  // namespace

Scene parseSceneFile(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                     int divisions) {
  const Node::Json json = parsed(text, name);
  const Node root{json, name, ""};
  root.expectKeys({"shows", "up", "camera", "ambient", "lights", "shading", "materials", "objects"});
  if (root.has("shows")) (void)root.at("shows").text();
  UpAxis up = UpAxis::Y;
  if (root.has("up")) {
    const std::string axis = root.at("up").text();
    if (axis != "y" && axis != "z") root.at("up").fail("\"y\" or \"z\" is needed");
    up = axis == "z" ? UpAxis::Z : UpAxis::Y;
  }
  Objects objects = readObjects(root, text, folder, divisions);
  if (objects.mesh.faceCount() == 0) root.fail("holds no face");
  const int divided = objects.patches.empty() ? 0 : objects.patches.front().divisions;
  const bool alike =
      std::ranges::all_of(objects.patches, [&](const auto& run) { return run.divisions == divided; });
  Scene scene = makeScene(name, std::move(objects.mesh), up, alike ? divided : 0);
  scene.patches = std::move(objects.patches);
  scene.textures = std::move(objects.textures);
  if (root.has("camera")) scene.camera = readCamera(root.at("camera"));
  if (root.has("shading")) readShading(scene.settings, root.at("shading"));
  readLight(scene, root);
  return scene;
}

Scene readSceneFile(const std::filesystem::path& file, int divisions) {
  return parseSceneFile(readTextFile(file), file.string(), file.parent_path(), divisions);
}

std::string sentenceOf(const std::filesystem::path& file) {
  return parsed(readTextFile(file), file.string()).value("shows", std::string{});
}
