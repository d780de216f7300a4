#include "shading/scene/scene_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/exact/box.h"
#include "geometry/exact/scale.h"
#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "geometry/model/bezier.h"
#include "geometry/view/project.h"
#include "geometry/view/view.h"
#include "shading/color/font.h"
#include "shading/scene/json_text.h"
#include "shading/scene/read_objects.h"
#include "shading/scene/scene.h"
#include "shading/scene/settings.h"
#include "shading/scene/units.h"

namespace xnewell {

CameraSettings readCamera(const Node& node) {
  node.expectKeys({"eye", "look_at", "up", "fov", "parallel", "oblique", "vrp", "vpn", "vup", "prp", "window",
                   "front", "back"});
  const auto exclude = [&](const char* a, const char* b) {
    if (node.has(a) && node.has(b))
      node.at(b).fail("the camera has both " + std::string{a} + " and " + b + "; give one of them");
  };
  exclude("eye", "vpn"), exclude("eye", "prp"), exclude("look_at", "vrp"), exclude("up", "vup");
  exclude("fov", "window");
  CameraSettings camera;
  const auto point = [&](const char* key, std::optional<glm::dvec3>& p) {
    if (node.has(key)) p = node.at(key).point();
  };
  const auto direction = [&](const char* key, std::optional<glm::dvec3>& v) {
    if (node.has(key)) v = node.at(key).direction();
  };
  point("eye", camera.eye), point("look_at", camera.lookAt), direction("up", camera.up);
  point("vrp", camera.vrp), direction("vpn", camera.vpn), direction("vup", camera.vup);
  point("prp", camera.prp);
  if (node.has("window")) camera.window = node.at("window").numbers<4>();
  if (node.has("front")) camera.front = node.at("front").number();
  if (node.has("back")) camera.back = node.at("back").number();
  if (node.has("fov")) {
    camera.fov = node.at("fov").numberAbove(0);
    if (*camera.fov >= 180) node.at("fov").fail("an angle between 0 and 180 degrees is needed");
    if (node.has("parallel") || node.has("oblique"))
      node.at("fov").fail("a field of view applies only to perspective");
  }
  if (node.has("parallel")) {
    camera.parallel = true;
    if (!node.at("parallel").isTrue()) camera.height = node.at("parallel").numberAbove(0);
  }
  if (node.has("oblique")) {
    const Node oblique = node.at("oblique");
    oblique.expectKeys({"kind", "angle"});
    camera.oblique = Oblique{};
    if (oblique.has("kind")) {
      const std::string kind = oblique.at("kind").text();
      if (kind != "cavalier" && kind != "cabinet") oblique.at("kind").fail("cavalier or cabinet is needed");
      camera.oblique->length = kind == "cabinet" ? 0.5 : 1.0;
    }
    if (oblique.has("angle")) camera.oblique->angle = oblique.at("angle").number();
  }
  return camera;
}

void expectSees(const CameraSettings& camera, const Scene& scene, const Node& node) {
  // The parts that the file leaves out are chosen to keep clear of the scene; for a narrower picture they are
  // farther away. So what the narrowest picture cannot show, no other can.
  constexpr double kNarrowest = 1.0 / kMaxPicture;
  try {
    (void)canonicalFromVrc(placeCamera(scene, camera, kNarrowest).view);
  } catch (const ViewError& e) {
    node.fail(e.what());
  }
}

namespace {

/// The two parts of a key such as "table.i0", before and after the dot. `rest` is empty if there is no dot.
struct KeyPath {
  std::string_view first, rest;
};
KeyPath pathOf(std::string_view key) {
  const std::size_t dot = key.find('.');
  if (dot == std::string_view::npos) return {key, {}};
  return {key.substr(0, dot), key.substr(dot + 1)};
}

/// The value that `node` gives for a setting; nothing if it gives none.
std::optional<Node> findIn(const Node& node, const Setting& setting) {
  const KeyPath path = pathOf(setting.key);
  if (!node.has(path.first)) return std::nullopt;
  const Node found = node.at(path.first);
  if (path.rest.empty()) return found;
  return found.has(path.rest) ? std::optional{found.at(path.rest)} : std::nullopt;
}

/// Refuses all keys that are not keys of settings. @throws ParseError
void expectSettings(const Node& node) {
  std::vector<std::string_view> firsts;
  for (const Setting& setting : settingRows()) {
    const std::string_view first = pathOf(setting.key).first;
    if (std::ranges::find(firsts, first) == firsts.end()) firsts.push_back(first);
  }
  node.expectKeys(firsts);
  for (const std::string_view first : firsts) {
    std::vector<std::string_view> rests;
    for (const Setting& setting : settingRows())
      if (const KeyPath path = pathOf(setting.key); path.first == first && !path.rest.empty())
        rests.push_back(path.rest);
    if (!rests.empty() && node.has(first)) node.at(first).expectKeys(rests);
  }
}

Value valueOf(const Setting& setting, const Node& node) {
  switch (setting.field.kind) {
    case ValueKind::Number:
      return node.number();
    case ValueKind::Whole:
      return static_cast<double>(
          node.whole(static_cast<int>(setting.range.low), static_cast<int>(setting.range.high)));
    case ValueKind::Flag:
      return node.truth() ? 1.0 : 0.0;
    case ValueKind::Choice: {
      const std::string name = node.isNumber() ? textOf(node.number()) : node.text();
      const std::optional<int> choice = choiceNamed(setting, name);
      if (!choice) node.fail(inQuotes(name) + " is not " + expected(setting));
      return static_cast<double>(*choice);
    }
    case ValueKind::Triple:
      return node.point();
  }
  return {};
}

void expectEffect(const Setting& setting, const PictureSettings& settings, const Node& node) {
  if (!hasEffect(setting, factsOf(settings)))
    node.fail("this setting applies only to " + std::string{setting.need.appliesTo});
}

}  // namespace

void readShading(PictureSettings& settings, const Node& node) {
  expectSettings(node);
  std::vector<Override> overrides;
  for (const Setting& setting : settingRows()) {
    const std::optional<Node> found = findIn(node, setting);
    if (!found) continue;
    const Value value = valueOf(setting, *found);
    if (!allows(setting, value))
      found->fail(expected(setting) + (setting.letters.empty() ? " is" : " are") + " needed");
    overrides.push_back({&setting, value});
  }
  if (!applyOverrides(settings, overrides)) node.fail("Ia + Ip must not exceed 1");
}

void expectCounts(const PictureSettings& settings, const SceneLight& scene, const Node& node) {
  for (const Setting& setting : settingRows())
    if (setting.need.unmet == Need::Unmet::Refused)
      if (const std::optional<Node> found = findIn(node, setting)) expectEffect(setting, settings, *found);
  const Illumination& light = settings.light;
  if (node.has("attenuation") && light.attenuation != Attenuation::None && !light.lightPosition &&
      !scene.placed())
    node.at("attenuation")
        .fail("attenuation needs a point light: give light_at. " + std::string{kOwnAttenuation});
}

void expectDivides(const PictureSettings& settings, const Node& node) {
  for (const Setting& setting : settingRows())
    if (setting.need.unmet == Need::Unmet::RefusedOrKept)
      if (const std::optional<Node> found = findIn(node, setting)) expectEffect(setting, settings, *found);
}

namespace {

/// ---- Lines and labels

glm::dvec3 colorOf(const Node& node) {
  return node.has("color") ? node.at("color").color() : glm::dvec3{0.0};
}

double sizeOf(const Node& node, std::string_view key, double usual) {
  if (!node.has(key)) return usual;
  const double size = node.at(key).numberAbove(0);
  if (size > 1000) node.at(key).fail("at most 1000 pixels are allowed");
  return size;
}

/// Reads "lines" and "labels" of a scene file. A file coordinate is a mesh coordinate times 2^exponent.
/// @throws ParseError
SceneMarks readMarks(const Node& root, int exponent) {
  SceneMarks marks;
  for (int i = 0; root.has("lines") && i < root.at("lines").size(); ++i) {
    const Node node = root.at("lines").item(i);
    node.expectKeys({"points", "color", "width"});
    SceneLine line;
    for (int k = 0; k < node.at("points").size(); ++k)
      line.points.push_back(scaled(node.at("points").item(k).point(), -exponent));
    if (line.points.size() < 2) node.at("points").fail("a line needs at least 2 points");
    line.color = colorOf(node), line.width = sizeOf(node, "width", line.width);
    marks.lines.push_back(std::move(line));
  }
  for (int i = 0; root.has("labels") && i < root.at("labels").size(); ++i) {
    const Node node = root.at("labels").item(i);
    node.expectKeys({"text", "at", "color", "size"});
    SceneLabel label{node.at("text").text(), scaled(node.at("at").point(), -exponent), colorOf(node), 12};
    const std::u32string codes = codesOf(label.text);
    if (codes.empty() || std::ranges::count(codes, U'?') != std::ranges::count(label.text, '?'))
      node.at("text").fail("a label needs characters of Latin-1, Greek or mathematics");
    label.size = sizeOf(node, "size", label.size);
    marks.labels.push_back(std::move(label));
  }
  return marks;
}

/// ---- Light

/// Converts a length in file units, or a power of one, to scene units.
double scaledTo(const Scene& scene, const Node& node, double v, int power = 1) {
  v = std::ldexp(v, -power * scene.exponent);
  if (!std::isfinite(v)) node.fail("too large for the size of the scene");
  return v;
}

glm::dvec3 place(const Scene& scene, const Node& node) {
  glm::dvec3 p = node.point();
  for (int k = 0; k < 3; ++k) p[k] = scaledTo(scene, node, p[k]);
  return p;
}

void readAttenuation(Light& light, const Scene& scene, const Node& node, const Box& box) {
  Attenuation attenuation = Attenuation::None;
  std::optional<double> range;
  std::optional<glm::dvec3> c;
  if (node.has("attenuation")) attenuation = node.at("attenuation").choice(kAttenuations);
  if (node.has("range")) {
    const Node given = node.at("range");
    if (attenuation != Attenuation::Linear) given.fail("a range applies only to attenuation linear");
    range = scaledTo(scene, given, given.numberAbove(0));
  }
  if (node.has("c")) {
    const Node given = node.at("c");
    if (attenuation != Attenuation::Textbook) given.fail("c1, c2 and c3 apply only to attenuation textbook");
    c = given.point();
    if (std::min({c->x, c->y, c->z}) < 0.0) given.fail("c1, c2 and c3 must not be negative");
    c->y = scaledTo(scene, given, c->y, -1);
    c->z = scaledTo(scene, given, c->z, -2);
  }
  attenuate(light, attenuation, range, c, box);
}

void readCone(Light& light, const Scene& scene, const Node& node, const glm::dvec3& centre) {
  if (node.has("shines") && node.has("look_at"))
    node.at("look_at").fail("the spot has both shines and look_at; give one of them");
  light.direction = (node.has("look_at") ? place(scene, node.at("look_at")) : centre) - light.position;
  if (node.has("shines")) light.direction = node.at("shines").direction();
  if (light.direction == glm::dvec3{0.0}) node.fail("the spot points at its own position");
  // If only one of the two angles is given, the other one gives way to it.
  if (node.has("inner")) light.inner = node.at("inner").numberFrom(0, 180);
  if (node.has("outer")) light.outer = node.at("outer").numberFrom(0, 180);
  if (!node.has("outer")) light.outer = std::max(light.outer, light.inner);
  if (!node.has("inner")) light.inner = std::min(light.outer, light.inner);
  if (light.inner > light.outer) node.at("inner").fail("inner must not exceed outer");
  if (node.has("falloff")) light.falloff = node.at("falloff").whole(0, 1'000'000);
}

/// Reads one light, except an Ip that the file does not give.
Light readOne(const Scene& scene, const Node& node, const Box& box) {
  Light light;
  if (node.has("kind")) light.kind = node.at("kind").choice(kLights);
  switch (light.kind) {
    case LightKind::Directional:
      node.expectKeys({"kind", "color", "Ip", "towards"});
      light.direction = node.has("towards") ? node.at("towards").direction() : defaultLight(scene.up);
      break;
    case LightKind::Point:
      node.expectKeys({"kind", "color", "Ip", "at", "attenuation", "range", "c"});
      break;
    case LightKind::Spot:
      node.expectKeys({"kind", "color", "Ip", "at", "attenuation", "range", "c"},
                      {"shines", "look_at", "inner", "outer", "falloff"});
      break;
  }
  if (node.has("color") && node.has("Ip"))
    node.at("Ip").fail("the light has both color and Ip; give one of them");
  for (const char* key : {"color", "Ip"})
    if (node.has(key)) light.Ip = node.at(key).grayOrColor();
  if (light.kind == LightKind::Directional) return light;

  if (!node.has("at")) node.fail("at is missing: the position of the light");
  light.position = place(scene, node.at("at"));
  readAttenuation(light, scene, node, box);
  if (light.kind == LightKind::Spot) readCone(light, scene, node, box.centre());
  return light;
}

void check(const glm::dvec3& sum, const Node& node) {
  constexpr std::array kChannelNames{"red", "green", "blue"};
  for (int c = 0; c < 3; ++c)
    if (sum[c] > kMostLight) {
      std::array<char, 32> text;
      std::snprintf(text.data(), text.size(), "%.6g", sum[c]);
      node.fail(std::string{"Ia + the sum of Ip is "} + text.data() + " in " + kChannelNames[c] +
                "; it must not exceed 1");
    }
}

/// Refuses a light that is given twice. If "ambient" or "lights" are given, the one light of "shading" would
/// have no effect, and nobody should have to guess which one counts.
void expectOnce(const Scene& scene, const Node& root) {
  if (!root.has("shading")) return;
  const Node shading = root.at("shading");
  if (scene.light.Ia && shading.has("Ia"))
    shading.at("Ia").fail("the ambient light is given twice: here and in ambient");
  for (const char* key : {"light", "light_at"})
    if (!scene.light.lights.empty() && shading.has(key))
      shading.at(key).fail("the light is given twice: here and in lights");
  if (scene.light.placed() && shading.has("attenuation"))
    shading.at("attenuation").fail(std::string{kOwnAttenuation});
}

/// Reads "ambient" and "lights" of a scene file (scene_file.h) into scene units, or the "lights" of a set-up,
/// which take the place of those of the scene that it names. Ia + the sum of Ip must not exceed 1; if the
/// scene's own light leaves less than the Ia and Ip of scene.settings, these are lowered to fit.
/// @throws ParseError
void readLight(Scene& scene, const Node& root) {
  Illumination& user = scene.settings.light;
  const bool isSetup = root.has("scene");
  if (isSetup && !root.has("lights")) return;
  if (isSetup) scene.light.lights.clear(), scene.origin.relit = true;
  if (root.has("ambient")) scene.light.Ia = root.at("ambient").grayOrColor();
  glm::dvec3 sum = scene.light.Ia.value_or(glm::dvec3{0.0});
  if (root.has("lights")) {
    const Node lights = root.at("lights");
    if (lights.size() == 0)
      lights.fail("at least one light is needed; for a scene without lights, set Ip to 0 in shading");
    const Box box = boxOf(scene.mesh.points);
    std::vector<int> unsaid;
    for (int k = 0; k < lights.size(); ++k) {
      const Node node = lights.item(k);
      scene.light.lights.push_back(readOne(scene, node, box));
      if (node.has("Ip") || node.has("color"))
        sum += scene.light.lights.back().Ip;
      else
        unsaid.push_back(k);
    }
    // Lights without an Ip share what the others leave, but together at most the Ip of the user's light.
    const double taken = largest(sum) + (scene.light.Ia ? 0.0 : user.Ia);
    const double left = std::clamp(1.0 - taken, 0.0, user.Ip);
    for (const int k : unsaid) {
      scene.light.lights[k].Ip = glm::dvec3{left / static_cast<double>(unsaid.size())};
      sum += scene.light.lights[k].Ip;
    }
  }
  if (!isSetup) expectOnce(scene, root);
  check(sum, root);
  const auto checkWith = [&](const char* key, double I) {
    if (root.has("shading") && root.at("shading").has(key)) check(sum + I, root.at("shading").at(key));
  };
  if (!scene.light.Ia) checkWith("Ia", user.Ia);
  if (scene.light.lights.empty()) checkWith("Ip", user.Ip);
  if (!scene.light.Ia) user.Ia = std::clamp(1.0 - largest(sum), 0.0, user.Ia);
  if (scene.light.lights.empty()) user.Ip = std::clamp(1.0 - largest(sum), 0.0, user.Ip);
}

/// Reads the scene of a set-up. Such a file names another scene instead of listing its own objects.
Scene otherScene(const Node& root, const std::filesystem::path& folder, int divisions) {
  root.expectKeys({"shows", "scene", "divisions", "without", "texture", "lights", "camera", "shading"});
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
  readLight(scene, root);
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
