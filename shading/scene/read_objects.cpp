#include "shading/scene/read_objects.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <map>
#include <optional>
#include <string>

#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"
#include "geometry/files/bpt.h"
#include "geometry/files/model_file.h"
#include "geometry/model/bezier.h"
#include "geometry/model/solids.h"
#include "shading/scene/json_text.h"
#include "shading/scene/mesh_textures.h"

namespace xnewell {

namespace {

/// Calls `read` for the file of an object. An error of the system names the place in the scene file as well.
template <class Read>
auto fromFile(const Node& file, const Read& read) -> decltype(read()) {
  try {
    return read();
  } catch (const std::system_error& e) {
    throw std::system_error{e.code(), file.place() + ": " + inQuotes(file.text())};
  }
}

/// Reads "color": [r, g, b] from 0 to 1, or "color255": [r, g, b] from 0 to 255.
std::optional<glm::dvec3> readColor(const Node& node, const std::string& key) {
  const std::string bytes = key + "255";
  if (node.has(key) && node.has(bytes)) node.at(bytes).fail("the colour is given twice");
  if (node.has(key)) return node.at(key).color();
  if (!node.has(bytes)) return std::nullopt;
  const Node of255 = node.at(bytes);
  glm::dvec3 color = of255.point();
  for (int c = 0; c < 3; ++c) color[c] = of255.item(c).numberFrom(0, 255) / 255.0;
  return color;
}

/// Reads a material, except its texture.
MeshMaterial readMaterial(const Node& node, const std::string& name) {
  node.expectKeys({"color", "color255", "specular", "specular255", "ka", "kd", "ks", "n", "texture"});
  MeshMaterial material;
  material.name = name;
  material.diffuse = readColor(node, "color").value_or(material.diffuse);
  material.specular = readColor(node, "specular").value_or(material.specular);
  const auto coefficient = [&](const char* key, std::optional<double>& k) {
    if (node.has(key)) k = node.at(key).numberFrom(0, 1);
  };
  coefficient("ka", material.ka), coefficient("kd", material.kd), coefficient("ks", material.ks);
  if (node.has("n")) material.n = node.at("n").whole(0, 1'000'000);
  return material;
}

/// The rotation about an axis through the origin, counter-clockwise as seen from the axis' tip. @see
/// Rodrigues 1840
glm::dmat3 rotation(const glm::dvec3& axis, double degrees) {
  const auto [sine, cosine] = sinCosDegrees(degrees);
  const glm::dvec3 a = unit(axis);
  glm::dmat3 turn;
  for (int k = 0; k < 3; ++k) {
    glm::dvec3 e{0.0};
    e[k] = 1.0;
    turn[k] = cosine * e + sine * glm::cross(a, e) + (1.0 - cosine) * a[k] * a;
  }
  return turn;
}

glm::dmat3 readRotation(const Node& node) {
  const auto degrees = [](const Node& angle) {
    const double v = angle.number();
    if (std::abs(v) > 1e6) angle.fail("an angle within 1,000,000 degrees is needed");
    return v;
  };
  if (node.isObject()) {
    node.expectKeys({"axis", "degrees"});
    for (const char* key : {"axis", "degrees"})
      if (!node.has(key)) node.fail(std::string{key} + " is needed");
    return rotation(node.at("axis").direction(), degrees(node.at("degrees")));
  }
  (void)node.point();
  const auto about = [&](int axis) {
    glm::dvec3 e{0.0};
    e[axis] = 1.0;
    return rotation(e, degrees(node.item(axis)));
  };
  return about(2) * about(1) * about(0);
}

/// The transformation of one object: scale, then rotate, then move.
class Transform {
 public:
  explicit Transform(const Node& node) : node_{node} {
    if (node.has("scale")) {
      const Node by = node.at("scale");
      if (by.isList()) (void)by.point();
      for (int k = 0; k < 3; ++k) scale_[k] = (by.isList() ? by.item(k) : by).numberAbove(0);
    }
    if (node.has("rotate")) turn_ = readRotation(node.at("rotate"));
    if (node.has("move")) move_ = node.at("move").point();
  }
  [[nodiscard]] glm::dvec3 operator()(glm::dvec3 p) const {
    p *= scale_;
    if (turn_) p = *turn_ * p;
    p += move_;
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      node_.fail("the object is scaled out of range");
    return p;
  }
  /// A normal, by the inverse and transposed linear part, which keeps it perpendicular to its surface.
  [[nodiscard]] glm::dvec3 normal(const glm::dvec3& N) const {
    // Multiplied by the smallest factor, so that no quotient leaves the range of doubles.
    const glm::dvec3 by = std::min({scale_.x, scale_.y, scale_.z}) / scale_;
    return unit(turn_ ? *turn_ * (N * by) : N * by);
  }
  /// The linear part, and what is added.
  [[nodiscard]] glm::dmat3 axes() const {
    glm::dmat3 axes{1.0};
    for (int k = 0; k < 3; ++k) axes[k] = scale_[k] * (turn_ ? (*turn_)[k] : axes[k]);
    return axes;
  }
  [[nodiscard]] const glm::dvec3& move() const { return move_; }
  /// Scales the rounding of the coordinates by the largest factor. A rotation combines the roundings of three
  /// axes, which gives at most sqrt 3 times one of them. It also adds its own: eight roundings of coordinates
  /// up to the largest.
  void round(Mesh& mesh) const {
    double largest = 0.0;
    for (const glm::dvec3& p : mesh.points)
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    for (double& u : mesh.rounding) {
      u *= std::max({scale_.x, scale_.y, scale_.z});
      if (turn_) u = u * std::sqrt(3.0) + 0x1p-50 * largest;
    }
  }

 private:
  const Node& node_;
  glm::dvec3 scale_{1.0}, move_{0.0};
  std::optional<glm::dmat3> turn_;
};

Mesh readPolygons(const Node& node) {
  Mesh mesh;
  std::vector<int> corners, uv;
  const Node polygons = node.at("polygons");
  const bool textured = node.has("uv");
  if (textured && node.at("uv").size() != polygons.size())
    node.at("uv").fail("a list for each polygon is needed");
  for (int f = 0; f < polygons.size(); ++f) {
    const Node polygon = polygons.item(f);
    corners.clear(), uv.clear();
    for (int c = 0; c < polygon.size(); ++c) {
      const glm::dvec3 p = polygon.item(c).point();
      const auto known = std::ranges::find(mesh.points, p);
      corners.push_back(static_cast<int>(known - mesh.points.begin()));
      if (known == mesh.points.end()) mesh.points.push_back(p);
    }
    if (corners.size() < 3) polygon.fail("a polygon needs at least 3 corners");
    if (textured) {
      const Node ofCorners = node.at("uv").item(f);
      if (ofCorners.size() != polygon.size()) ofCorners.fail("[u, v] for each corner is needed");
      for (int c = 0; c < ofCorners.size(); ++c) {
        uv.push_back(static_cast<int>(mesh.uv.size()));
        mesh.uv.push_back(ofCorners.item(c).numbers<2>());
      }
    }
    mesh.addFace(corners, 0, -1, uv);
  }
  return mesh;
}

/// Tells which surface the faces approximate; `round` stays as it is if they are the surface.
Mesh readSolid(const Node& node, RoundRun& round) {
  const std::string solid = node.at("solid").text();
  const auto count = [&](const char* key, int low, int otherwise) {
    return node.has(key) ? node.at(key).whole(low, 4096) : otherwise;
  };
  if (solid == "cube") return cube();
  if (solid == "sphere") {
    const int around = count("around", 3, 24), down = count("down", 2, 12);
    round.faces = around * down, round.solid = RoundSolid::Sphere, round.columns = around;
    return sphere(around, down);
  }
  if (solid == "torus") {
    const int around = count("around", 3, 32), across = count("across", 3, 16);
    round.faces = around * across, round.solid = RoundSolid::Torus, round.columns = across;
    return torus(around, across);
  }
  node.at("solid").fail("cube, sphere or torus is needed");
}

/// Refuses "around", "down" and "across" for anything but the round solids that they divide.
void expectDividable(const Node& node) {
  const std::string solid = node.has("solid") ? node.at("solid").text() : "";
  if (node.has("around") && solid != "sphere" && solid != "torus")
    node.at("around").fail("applies only to a sphere or a torus");
  if (node.has("down") && solid != "sphere") node.at("down").fail("applies only to a sphere");
  if (node.has("across") && solid != "torus") node.at("across").fail("applies only to a torus");
}

/// Collects the objects in one mesh, one after the other.
class Collector {
 public:
  Collector(const Node& root, const std::filesystem::path& folder, int divisions)
      : folder_{folder}, divisions_{divisions} {
    if (!root.has("materials")) return;
    const Node all = root.at("materials");
    for (const std::string& name : all.keys()) {
      const Node node = all.at(name);
      Named& named = materials_[name];
      named.material = readMaterial(node, name);
      if (!node.has("texture")) continue;
      named.texture.emplace(node.at("texture"));
      (void)named.texture->text();  // check it even if no object uses it
    }
  }

  /// Adds an object. `numbers` are those of its polygons' coordinates.
  void add(const Node& node, const RoundingOfNumbers& numbers) {
    node.expectKeys({"file", "polygons", "uv", "solid", "name", "color", "color255", "material", "divisions",
                     "around", "down", "across", "scale", "rotate", "move"});
    if (node.has("file") + node.has("polygons") + node.has("solid") != 1)
      node.fail("exactly one of file, polygons and solid is needed");
    expectDividable(node);
    if (node.has("uv") && !node.has("polygons"))
      node.at("uv").fail("texture coordinates apply only to polygons");
    const Transform transform{node};
    PatchRun run;
    RoundRun round;
    Mesh mesh = meshOf(node, transform, run, round);
    const bool keepsOwn = !node.has("material") && !node.has("color") && !node.has("color255");
    if (keepsOwn) textures_.readAll(mesh);
    if (node.has("polygons")) {
      mesh.rounding = {numbers.rounding()};
      if (const std::string doubtful = numbers.doubtful(); !doubtful.empty())
        mesh.notes.push_back("polygons: " + doubtful);
    }
    mesh.rounding.resize(std::max<std::size_t>(mesh.groupNames.size(), 1), 0.0);
    if (node.has("name")) {
      mesh.groupNames = {node.at("name").text()};
      std::ranges::fill(mesh.group, 0);
      mesh.rounding.resize(1);  // one group for the whole file, so one rounding
    }
    if (run.patches.empty()) {
      for (glm::dvec3& p : mesh.points) p = transform(p);
      for (glm::dvec3& N : mesh.normals) N = transform.normal(N);
      transform.round(mesh);
    }
    const std::optional<int> material = materialOf(node, !mesh.uvOfCorner.empty());
    run.firstCorner = static_cast<int>(all_.mesh.corners.size());
    if (round.faces > 0) {
      round.firstFace = all_.mesh.faceCount();
      round.axes = transform.axes(), round.centre = transform.move();
      all_.rounds.push_back(round);
    }
    append(mesh, material);
    if (!run.patches.empty()) all_.patches.push_back(std::move(run));
  }

  [[nodiscard]] Objects take() {
    all_.textures = textures_.take();
    return std::move(all_);
  }

 private:
  struct Named {
    MeshMaterial material;
    std::optional<Node> texture;
    std::optional<int> number;  ///< its index in the mesh, once an object uses it
  };

  /// The mesh of an object. Patches are transformed before they are divided, because exact normals are
  /// computed from the patches themselves.
  /// Tells of which patches or of which round solid it is, if any.
  Mesh meshOf(const Node& node, const Transform& transform, PatchRun& run, RoundRun& round) const {
    std::filesystem::path file;
    if (node.has("file")) file = namedFile(folder_, node.at("file").text());
    const ModelFileRow* const model = modelFile(file);
    if (node.has("divisions") && (!model || model->polygons))
      node.at("divisions").fail("divisions apply only to the patches of a .bpt file");
    if (node.has("solid")) return readSolid(node, round);
    if (node.has("polygons")) return readPolygons(node);
    if (!model) node.at("file").fail("a model file is needed: " + modelExtensions());
    if (model->polygons) return fromFile(node.at("file"), [&] { return model->polygons(file); });
    run.own = node.has("divisions");
    run.divisions = run.own ? node.at("divisions").whole(1, kMaxDivisions) : divisions_;
    run.patches = fromFile(node.at("file"), [&] { return readBpt(file); });
    for (BezierPatch& patch : run.patches)
      for (glm::dvec3& p : patch.p) p = transform(p);
    return tessellate(run.patches, run.divisions);
  }

  /// The index of the one material for all faces of an object; no value if the faces keep their own.
  std::optional<int> materialOf(const Node& node, bool hasUv) {
    const std::optional<glm::dvec3> color = readColor(node, "color");
    const int next = static_cast<int>(all_.mesh.materials.size());
    if (!node.has("material")) {
      if (!color) return std::nullopt;
      all_.mesh.materials.push_back({"", *color});
      return next;
    }
    const Node said = node.at("material");
    if (color) said.fail("the object has both a material and a colour; give one of them");
    const auto found = materials_.find(said.text());
    if (found == materials_.end()) {
      std::string names;
      for (const auto& [name, unused] : materials_) names += (names.empty() ? "" : ", ") + name;
      said.fail(names.empty() ? "the file has no materials"
                              : inQuotes(said.text()) + " is not one of " + names);
    }
    Named& named = found->second;
    if (named.texture && !hasUv)
      said.fail(inQuotes(said.text()) + " has a texture, but the object has no texture coordinates");
    if (!named.number) {
      named.number = next;
      if (named.texture)
        named.material.texture = fromFile(
            *named.texture, [&] { return textures_.read(namedFile(folder_, named.texture->text())); });
      all_.mesh.materials.push_back(named.material);
    }
    return named.number;
  }

  /// Appends an object's mesh to the whole. Each object keeps the rounding of its own coordinates.
  void append(const Mesh& part, std::optional<int> material) {
    Mesh& whole = all_.mesh;
    const auto sizeOf = [](const auto& list) { return static_cast<int>(list.size()); };
    const auto extend = [](auto& list, const auto& by) { list.insert(list.end(), by.begin(), by.end()); };
    const int points = sizeOf(whole.points), groups = sizeOf(whole.groupNames), uvs = sizeOf(whole.uv);
    const int materials = sizeOf(whole.materials);
    extend(whole.points, part.points);
    extend(whole.groupNames, part.groupNames);
    if (part.groupNames.empty()) whole.groupNames.emplace_back();
    extend(whole.rounding, part.rounding);
    extend(whole.notes, part.notes);
    extend(whole.uv, part.uv);
    if (!material) extend(whole.materials, part.materials);
    std::vector<int> corners, uv;
    for (int f = 0; f < part.faceCount(); ++f) {
      corners.assign(part.face(f).begin(), part.face(f).end());
      for (int& c : corners) c += points;
      if (!part.uvOfCorner.empty()) {
        uv.assign(part.uvOfCorner.begin() + part.firstCorner[f],
                  part.uvOfCorner.begin() + part.firstCorner[f + 1]);
        for (int& k : uv) k += k < 0 ? 0 : uvs;
      }
      const int own = part.material[f] < 0 ? -1 : part.material[f] + materials;
      whole.addFace(corners, part.group[f] + groups, material.value_or(own), uv, part.normalsOf(f));
    }
  }

  const std::filesystem::path& folder_;
  int divisions_;
  std::map<std::string, Named> materials_;
  TextureReader textures_;
  Objects all_;
};

}  // namespace

Objects readObjects(const Node& root, std::string_view text, const std::filesystem::path& folder,
                    int divisions) {
  const std::vector<RoundingOfNumbers> rounding = roundingOfPolygons(text);
  Collector collector{root, folder, divisions};
  if (root.has("objects"))
    for (std::size_t i = 0, polygons = 0; i < static_cast<std::size_t>(root.at("objects").size()); ++i) {
      const Node object = root.at("objects").item(static_cast<int>(i));
      collector.add(object, polygons < rounding.size() ? rounding[polygons] : RoundingOfNumbers{});
      polygons += object.has("polygons");
    }
  return collector.take();
}

}  // namespace xnewell
