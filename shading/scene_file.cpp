#include "shading/scene_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "geometry/bezier.h"
#include "geometry/bpt.h"
#include "geometry/number.h"
#include "geometry/obj.h"
#include "geometry/parse_error.h"
#include "geometry/solids.h"
#include "geometry/text_file.h"

namespace {

using Json = nlohmann::ordered_json;

/// A value and where it stands, so that every complaint names the place.
class Node {
 public:
  Node(const Json& value, const std::string& file, std::string path)
      : value_{value}, file_{file}, path_{std::move(path)} {}

  [[noreturn]] void fail(const std::string& what) const {
    throw ParseError{file_, 0, path_.empty() ? what : path_ + ": " + what};
  }
  /// An object with no key but these.
  void expectKeys(std::initializer_list<std::string_view> keys) const {
    if (!value_.is_object()) fail("an object { } is needed");
    for (const auto& [key, unused] : value_.items())
      if (std::ranges::find(keys, key) == keys.end()) {
        std::string all;
        for (const std::string_view k : keys) all += (all.empty() ? "" : ", ") + std::string{k};
        fail("unknown key " + inQuotes(key) + "; there are " + all);
      }
  }
  [[nodiscard]] bool has(const char* key) const { return value_.contains(key); }
  [[nodiscard]] Node at(const char* key) const {
    return {value_.at(key), file_, path_.empty() ? key : path_ + "." + key};
  }
  [[nodiscard]] int size() const {
    if (!value_.is_array()) fail("a list [ ] is needed");
    return static_cast<int>(value_.size());
  }
  [[nodiscard]] Node item(int i) const {
    return {value_[static_cast<std::size_t>(i)], file_, path_ + "[" + std::to_string(i) + "]"};
  }
  [[nodiscard]] double number() const {
    if (!value_.is_number()) fail("a number is needed");
    const double v = value_.get<double>();
    if (!std::isfinite(v)) fail("the number is too large");
    return v;
  }
  [[nodiscard]] double numberAbove(double low) const {
    const double v = number();
    if (!(v > low)) fail("a number above " + std::to_string(static_cast<int>(low)) + " is needed");
    return v;
  }
  [[nodiscard]] int whole(int low, int high) const {
    if (!value_.is_number_integer() || value_.get<std::int64_t>() < low || value_.get<std::int64_t>() > high)
      fail("a whole number from " + std::to_string(low) + " to " + std::to_string(high) + " is needed");
    return value_.get<int>();
  }
  [[nodiscard]] std::string text() const {
    if (!value_.is_string()) fail("a string is needed");
    return value_.get<std::string>();
  }
  template <int N>
  [[nodiscard]] glm::vec<N, double> numbers() const {
    if (size() != N) fail("a list of " + std::to_string(N) + " numbers is needed");
    glm::vec<N, double> v;
    for (int k = 0; k < N; ++k) v[k] = item(k).number();
    return v;
  }
  [[nodiscard]] glm::dvec3 point() const { return numbers<3>(); }

 private:
  const Json& value_;
  const std::string& file_;
  std::string path_;
};

CameraSettings readCamera(const Node& node) {
  node.expectKeys({"eye", "look_at", "up", "fov", "parallel", "oblique", "vrp", "vpn", "vup", "prp", "window",
                   "front", "back"});
  CameraSettings camera;
  const auto point = [&](const char* key, std::optional<glm::dvec3>& p) {
    if (node.has(key)) p = node.at(key).point();
  };
  point("eye", camera.eye), point("look_at", camera.lookAt), point("up", camera.up);
  point("vrp", camera.vrp), point("vpn", camera.vpn), point("vup", camera.vup), point("prp", camera.prp);
  if (node.has("window")) camera.window = node.at("window").numbers<4>();
  if (node.has("front")) camera.front = node.at("front").number();
  if (node.has("back")) camera.back = node.at("back").number();
  if (node.has("fov")) {
    camera.fov = node.at("fov").numberAbove(0);
    if (*camera.fov >= 180) node.at("fov").fail("an angle between 0 and 180 degrees is needed");
    if (node.has("parallel") || node.has("oblique"))
      node.at("fov").fail("a field of view is for perspective");
  }
  if (node.has("parallel")) {
    camera.height = node.at("parallel").numberAbove(0);
    camera.parallel = true;
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

Mesh readPolygons(const Node& node) {
  Mesh mesh;
  std::vector<int> corners;
  for (int f = 0; f < node.size(); ++f) {
    const Node polygon = node.item(f);
    corners.clear();
    for (int c = 0; c < polygon.size(); ++c) {
      const glm::dvec3 p = polygon.item(c).point();
      const auto known = std::ranges::find(mesh.points, p);
      corners.push_back(static_cast<int>(known - mesh.points.begin()));
      if (known == mesh.points.end()) mesh.points.push_back(p);
    }
    if (corners.size() < 3) polygon.fail("a polygon needs at least 3 corners");
    mesh.addFace(corners, 0);
  }
  return mesh;
}

Mesh readSolid(const Node& node) {
  const std::string solid = node.at("solid").text();
  const auto count = [&](const char* key, int low, int otherwise) {
    return node.has(key) ? node.at(key).whole(low, 4096) : otherwise;
  };
  if (solid == "cube") return cube();
  if (solid == "sphere") return sphere(count("around", 3, 24), count("down", 2, 12));
  if (solid == "torus") return torus(count("around", 3, 32), count("across", 3, 16));
  node.at("solid").fail("cube, sphere or torus is needed");
}

Mesh readMesh(const Node& node, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / node.at("file").text();
  if (file.extension() == ".obj") return readObj(file);
  if (file.extension() != ".bpt") node.at("file").fail("an .obj or .bpt file is needed");
  const int divisions =
      node.has("divisions") ? node.at("divisions").whole(1, kMaxDivisions) : kDefaultDivisions;
  return tessellate(readBpt(file), divisions);
}

Mesh readObject(const Node& node, const std::filesystem::path& folder, double rounding) {
  node.expectKeys({"file", "polygons", "solid", "name", "color", "divisions", "around", "down", "across",
                   "scale", "move"});
  if (node.has("file") + node.has("polygons") + node.has("solid") != 1)
    node.fail("one of file, polygons and solid is needed");
  Mesh mesh = node.has("file")    ? readMesh(node, folder)
              : node.has("solid") ? readSolid(node)
                                  : readPolygons(node.at("polygons"));
  if (node.has("polygons")) mesh.rounding = {rounding};
  if (node.has("name")) {
    mesh.groupNames = {node.at("name").text()};
    std::ranges::fill(mesh.group, 0);
    if (mesh.rounding.size() > 1) mesh.rounding = {mesh.rounding.front()};  // the same for all of a file
  }
  if (node.has("color")) {
    const glm::dvec3 color = node.at("color").point();
    if (std::min({color.r, color.g, color.b}) < 0.0 || std::max({color.r, color.g, color.b}) > 1.0)
      node.at("color").fail("r, g, b from 0 to 1 are needed");
    mesh.materials = {{"", color}};
    std::ranges::fill(mesh.material, 0);
  }
  const double scale = node.has("scale") ? node.at("scale").numberAbove(0) : 1.0;
  const glm::dvec3 move = node.has("move") ? node.at("move").point() : glm::dvec3{0.0};
  for (glm::dvec3& p : mesh.points) {
    p = p * scale + move;
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      node.fail("the object is scaled out of range");
  }
  for (double& u : mesh.rounding) u *= scale;
  return mesh;
}

/// Object by object; each keeps the rounding of its own coordinates.
void append(Mesh& whole, const Mesh& part) {
  const int points = static_cast<int>(whole.points.size()),
            groups = static_cast<int>(whole.groupNames.size());
  const int materials = static_cast<int>(whole.materials.size());
  whole.points.insert(whole.points.end(), part.points.begin(), part.points.end());
  whole.groupNames.insert(whole.groupNames.end(), part.groupNames.begin(), part.groupNames.end());
  if (part.groupNames.empty()) whole.groupNames.emplace_back();
  whole.rounding.insert(whole.rounding.end(), part.rounding.begin(), part.rounding.end());
  whole.rounding.resize(whole.groupNames.size(), 0.0);
  whole.materials.insert(whole.materials.end(), part.materials.begin(), part.materials.end());
  std::vector<int> corners;
  for (int f = 0; f < part.faceCount(); ++f) {
    corners.assign(part.face(f).begin(), part.face(f).end());
    for (int& c : corners) c += points;
    whole.addFace(corners, part.group[f] + groups, part.material[f] < 0 ? -1 : part.material[f] + materials);
  }
}

/// Reads nothing but the decimals that numbers below a key "polygons" carry in their text.
class DecimalsOfPolygons : public nlohmann::json_sax<Json> {
 public:
  /// Of the k-th `polygons` of the file.
  [[nodiscard]] double rounding(std::size_t k) const {
    return k < numbers_.size() ? numbers_[k].rounding() : 0.0;
  }

  bool number_float(double value, const std::string& text) override {
    if (inside_ > 0) numbers_.back().add(text, value);
    return true;
  }
  bool key(std::string& name) override {
    polygonsNext_ = name == "polygons";
    return true;
  }
  bool start_array(std::size_t) override {
    if (inside_ == 0 && polygonsNext_) numbers_.emplace_back();
    if (inside_ > 0 || polygonsNext_) ++inside_;
    polygonsNext_ = false;
    return true;
  }
  bool end_array() override {
    if (inside_ > 0) --inside_;
    return true;
  }
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(std::int64_t) override { return true; }
  bool number_unsigned(std::uint64_t) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(Json::binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool end_object() override { return true; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  std::vector<RoundingOfNumbers> numbers_;
  int inside_ = 0;
  bool polygonsNext_ = false;
};

/// JSON or a ParseError with its line.
Json parsed(std::string_view text, const std::string& name) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& e) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(e.byte, text.size()));
    throw ParseError{name, 1 + static_cast<int>(std::count(text.begin(), end, '\n')), "not JSON here"};
  } catch (const Json::out_of_range&) {
    throw ParseError{name, 0, "a number is too large"};
  }
}

}  // namespace

Scene parseSceneFile(std::string_view text, const std::string& name, const std::filesystem::path& folder) {
  const Json json = parsed(text, name);
  DecimalsOfPolygons decimalsOf;
  Json::sax_parse(text, &decimalsOf);
  const Node root{json, name, ""};
  root.expectKeys({"shows", "up", "camera", "objects"});
  if (root.has("shows")) (void)root.at("shows").text();
  UpAxis up = UpAxis::Y;
  if (root.has("up")) {
    const std::string axis = root.at("up").text();
    if (axis != "y" && axis != "z") root.at("up").fail("\"y\" or \"z\" is needed");
    up = axis == "z" ? UpAxis::Z : UpAxis::Y;
  }
  Mesh mesh;
  if (root.has("objects"))
    for (int i = 0, polygons = 0; i < root.at("objects").size(); ++i) {
      const Node object = root.at("objects").item(i);
      append(mesh, readObject(object, folder, decimalsOf.rounding(polygons)));
      polygons += object.has("polygons");
    }
  if (mesh.faceCount() == 0) root.fail("holds no face");
  Scene scene = makeScene(name, std::move(mesh), up);
  if (root.has("camera")) scene.camera = readCamera(root.at("camera"));
  return scene;
}

Scene readSceneFile(const std::filesystem::path& file) {
  return parseSceneFile(readTextFile(file), file.string(), file.parent_path());
}

std::string sentenceOf(const std::filesystem::path& file) {
  return parsed(readTextFile(file), file.string()).value("shows", std::string{});
}
