#include "shading/scene/save_scene.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace xnewell {

namespace {

using Json = nlohmann::ordered_json;

Json list(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

template <class Rows, class Id>
std::string nameOf(const Rows& rows, Id id) {
  for (const auto& row : rows)
    if (row.id == id) return std::string{row.name};
  return {};
}

/// From the scene's units to the file's, exactly: a power of two.
struct FileUnits {
  int exponent;
  [[nodiscard]] double operator()(double length) const { return std::ldexp(length, exponent); }
  [[nodiscard]] Json operator()(const glm::dvec3& p) const {
    return list({(*this)(p.x), (*this)(p.y), (*this)(p.z)});
  }
};

Json camera(const CameraSettings& c, const FileUnits& units) {
  Json json = Json::object();
  const auto place = [&](const char* key, const std::optional<glm::dvec3>& p) {
    if (p) json[key] = units(*p);
  };
  const auto direction = [&](const char* key, const std::optional<glm::dvec3>& v) {
    if (v) json[key] = list(*v);
  };
  const auto length = [&](const char* key, const std::optional<double>& v) {
    if (v) json[key] = units(*v);
  };
  place("eye", c.eye), place("look_at", c.lookAt), direction("up", c.up);
  place("vrp", c.vrp), direction("vpn", c.vpn), direction("vup", c.vup), place("prp", c.prp);
  if (c.window)
    json["window"] = {units(c.window->x), units(c.window->y), units(c.window->z), units(c.window->w)};
  length("front", c.front), length("back", c.back);
  const bool parallel = c.parallel || c.oblique;
  if (c.fov && !parallel) json["fov"] = *c.fov;
  if (c.height)
    json["parallel"] = units(*c.height);
  else if (c.parallel)
    json["parallel"] = true;
  if (c.oblique)
    json["oblique"] = {{"kind", c.oblique->length == 0.5 ? "cabinet" : "cavalier"},
                       {"angle", c.oblique->angle}};
  return json;
}

void addLight(Json& json, const Illumination& l, const FileUnits& units) {
  json["Ia"] = l.Ia, json["Ip"] = l.Ip;
  json["ka"] = l.ka, json["kd"] = l.kd, json["ks"] = l.ks, json["n"] = l.n;
  json["light"] = list(l.light);
  if (l.lightPosition) json["light_at"] = units(*l.lightPosition);
  json["attenuation"] = nameOf(kAttenuations, l.attenuation);
  if (l.range) json["range"] = units(*l.range);
  if (l.c)  // for a unit of length and its square
    json["c"] = {l.c->x, std::ldexp(l.c->y, -units.exponent), std::ldexp(l.c->z, -2 * units.exponent)};
  json["form"] = nameOf(kForms, l.form);
  json["constant_l"] = l.constantL, json["constant_v"] = l.constantV;
  json["sided"] = l.twoSided ? "two" : "one";
}

Json table(const TableSettings& t) {
  return {{"kind", nameOf(kTables, t.kind)}, {"shades", t.shades}, {"i0", t.I0},
          {"pick", nameOf(kPicks, t.pick)},  {"hue", list(t.hue)}, {"bits", t.bits}};
}

Json shading(const PictureSettings& s, const FileUnits& units) {
  Json json{{"method", nameOf(kShadings, s.shading)},
            {"normals", nameOf(kNormalRules, s.normals)},
            {"crease", s.crease},
            {"polygons", nameOf(kPolygons, s.polygons)},
            {"adapt", s.adapt},
            {"environment", nameOf(kEnvironmentForms, s.environment)},
            {"mapping", nameOf(kTextureMappings, s.mapping)},
            {"order", nameOf(kOrders, s.order)},
            {"cull", s.cull == Cull::Back ? "back" : "none"},
            {"fill", s.inPixels ? "x11" : "scanline"},
            {"colors", nameOf(kColorPlans, s.colors)},
            {"dither", s.dither},
            {"table", table(s.table)}};
  addLight(json, s.light, units);
  return json;
}

/// As seen from the folder where it is inside of it, else from the root.
std::string seenFrom(const std::filesystem::path& folder, const std::string& file) {
  namespace fs = std::filesystem;
  const fs::path whole = fs::weakly_canonical(file),
                 base = fs::weakly_canonical(folder.empty() ? "." : folder);
  const fs::path relative = whole.lexically_relative(base);
  return relative.empty() || *relative.begin() == ".." ? whole.string() : relative.string();
}

}  // namespace

std::string savedScene(const Scene& scene, const PictureSettings& settings,
                       const std::filesystem::path& folder) {
  const SceneOrigin& origin = scene.origin;
  const FileUnits units{scene.exponent};
  Json json;
  json["shows"] = "a set-up of " + titleOf(scene);
  json["scene"] = isBuiltIn(origin.of) ? origin.of : seenFrom(folder, origin.of);
  json["divisions"] = origin.divisions;
  if (!origin.without.empty()) json["without"] = origin.without;
  if (!origin.texture.empty()) json["texture"] = seenFrom(folder, origin.texture);
  json["camera"] = camera(settings.camera, units);
  json["shading"] = shading(settings, units);
  return json.dump(2) + "\n";
}

Scene redivided(const Scene& scene, int divisions) {
  Scene other = readScene(scene.origin.of, divisions);
  for (const std::string& what : scene.origin.without) strip(other, what);
  if (!scene.origin.texture.empty()) wear(other, readTexture(scene.origin.texture));
  other.origin = scene.origin;
  other.origin.divisions = divisions;
  other.name = scene.name;
  other.camera = scene.camera;
  other.settings = scene.settings;
  return other;
}

}  // namespace xnewell
