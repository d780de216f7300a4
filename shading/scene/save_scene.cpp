#include "shading/scene/save_scene.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "shading/scene/settings.h"
#include "shading/scene/units.h"

namespace xnewell {

namespace {

using Json = nlohmann::ordered_json;

Json list(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Json camera(const CameraSettings& c) {
  Json json = Json::object();
  const auto triple = [&](const char* key, const std::optional<glm::dvec3>& v) {
    if (v) json[key] = list(*v);
  };
  triple("eye", c.eye), triple("look_at", c.lookAt), triple("up", c.up);
  triple("vrp", c.vrp), triple("vpn", c.vpn), triple("vup", c.vup), triple("prp", c.prp);
  if (c.window) json["window"] = {c.window->x, c.window->y, c.window->z, c.window->w};
  if (c.front) json["front"] = *c.front;
  if (c.back) json["back"] = *c.back;
  const bool parallel = c.parallel || c.oblique;
  if (c.fov && !parallel) json["fov"] = *c.fov;
  if (c.height)
    json["parallel"] = *c.height;
  else if (c.parallel)
    json["parallel"] = true;
  if (c.oblique)
    json["oblique"] = {{"kind", c.oblique->length == 0.5 ? "cabinet" : "cavalier"},
                       {"angle", c.oblique->angle}};
  return json;
}

Json json(const Setting& setting, const Value& value) {
  if (const auto* v = std::get_if<glm::dvec3>(&value)) return list(*v);
  const double v = std::get<double>(value);
  switch (setting.field.kind) {
    case ValueKind::Whole:
      return static_cast<int>(v);
    case ValueKind::Flag:
      return v != 0.0;
    case ValueKind::Choice: {
      const std::string name = textOf(setting, value);
      return name.find_first_not_of("0123456789") == std::string::npos ? Json(std::stoi(name)) : Json(name);
    }
    default:
      return v;
  }
}

Json shading(const PictureSettings& settings) {
  Json all = Json::object();
  for (const Setting& setting : settingRows()) {
    const Value value = setting.field.get(settings);
    if (std::holds_alternative<std::monostate>(value)) continue;
    const std::size_t dot = setting.key.find('.');
    Json& object = dot == std::string_view::npos ? all : all[std::string{setting.key.substr(0, dot)}];
    object[std::string{setting.key.substr(dot + 1)}] = json(setting, value);
  }
  return all;
}

Json json(const Light& light, const Scene& scene) {
  Json json;
  json["kind"] = kLights[static_cast<std::size_t>(light.kind)].name;
  json["Ip"] = list(light.Ip);
  if (light.kind == LightKind::Directional) {
    json["towards"] = list(light.direction);
    return json;
  }
  const auto length = [&](double v, int power) { return std::ldexp(v, power * scene.exponent); };
  json["at"] = list(inFileUnits(light.position, scene));
  json["attenuation"] = kAttenuations[static_cast<std::size_t>(light.attenuation)].name;
  if (light.attenuation == Attenuation::Linear) json["range"] = length(light.range, 1);
  if (light.attenuation == Attenuation::Textbook)
    json["c"] = {light.c.x, length(light.c.y, -1), length(light.c.z, -2)};
  if (light.kind == LightKind::Spot) {
    json["shines"] = list(light.direction);
    json["inner"] = light.inner, json["outer"] = light.outer, json["falloff"] = light.falloff;
  }
  return json;
}

/// The path relative to `folder` if the file is inside that folder; otherwise the absolute path.
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
  Json json;
  json["shows"] = "a set-up of " + titleOf(scene);
  json["scene"] = isBuiltIn(origin.of) ? origin.of : seenFrom(folder, origin.of);
  json["divisions"] = origin.divisions;
  if (!origin.without.empty()) json["without"] = origin.without;
  if (!origin.texture.empty()) json["texture"] = seenFrom(folder, origin.texture);
  if (settings.lights || origin.relit)
    for (const Light& light : settings.lights.value_or(scene.light.lights))
      json["lights"].push_back(xnewell::json(light, scene));
  json["camera"] = camera(settings.camera);
  json["shading"] = shading(settings);
  return json.dump(2) + "\n";
}

}  // namespace xnewell
