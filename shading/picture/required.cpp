#include "shading/picture/required.h"

#include <algorithm>

#include "shading/picture/facts.h"

namespace xnewell {

namespace {

std::string lightsWhy(std::size_t needed, std::size_t all) {
  if (all == needed) return "all reach the scene, and a surface reflects them";
  return std::to_string(all - needed) + " of " + std::to_string(all) + (all - needed == 1 ? " does" : " do") +
         " not count: they have no intensity, do not reach the scene, or no surface reflects them";
}

std::string channelsWhy(const Lighting& lighting, ColorPlan plan) {
  if (lighting.luminance) return "the scene has colours; their luminance is taken last";
  if (lighting.channels == 3) return "the picture shows colours";
  return plan == ColorPlan::Hues ? "each hue has a ramp of its own" : "the scene has no colours";
}

/// The materials that faces of the scene have; none for a method that uses no light.
std::vector<const Material*> usedMaterials(const Scene& scene, const Lighting& lighting) {
  if (lighting.materials.empty()) return {};
  std::vector<bool> used(lighting.materials.size(), false);
  for (const int m : scene.mesh.material) used[m + 1] = true;
  std::vector<const Material*> materials;
  for (std::size_t m = 0; m < used.size(); ++m)
    if (used[m]) materials.push_back(&lighting.materials[m]);
  return materials;
}

bool isShiny(const Material* m) { return *std::ranges::max_element(m->ks) > 0.0; }

/// Which faces a light meets, and which of them show, is not asked: a highlight is computed for all.
std::string specularWhy(const Scene& scene, const Lighting& lighting) {
  if (lighting.specular) return "a surface has ks above 0, and a light of its colour reaches the scene";
  return std::ranges::any_of(usedMaterials(scene, lighting), isShiny)
             ? "a surface has ks above 0, but no light of its colour reaches the scene"
             : "no surface has ks above 0";
}

std::string eyeWhy(const Scene& scene, const Lighting& lighting, const Illumination& user) {
  if (!lighting.specular) return "nothing has a highlight";
  if (!lighting.asksForEye()) return "the highlight of this form is N.L";
  if (std::ranges::none_of(usedMaterials(scene, lighting),
                           [](const Material* m) { return isShiny(m) && m->n > 0; }))
    return "n is 0: a highlight is the same from everywhere";
  if (user.constantV) return "V is held constant";
  return lighting.constantV ? "the eye is so far away that V is the same everywhere"
                            : "V of a highlight ends at the eye";
}

std::string placesWhy(const Lighting& lighting) {
  if (lighting.placed())
    return lighting.variesV() ? "a light and the eye are at places" : "a light is at a place";
  return lighting.variesV() ? "V of a highlight differs from place to place"
                            : "L and V are the same everywhere";
}

std::string normalsWhy(const SceneShading& shading, const ShadingRow& method, bool ofVertices) {
  if (shading.points().N.empty()) return "all light is ambient: an intensity does not ask for a normal";
  if (ofVertices)
    return std::string{method.label} + (method.interpolates ? " shading interpolates what it has at vertices"
                                                            : " shading interpolates nothing");
  return std::string{method.label} +
         (method.interpolates ? " shading has normals at vertices" : " shading evaluates the light at faces");
}

std::string texturesWhy(const Scene& scene, const Lighting& lighting) {
  if (!hasTextures(scene)) return "no surface has a texture";
  return lighting.onlyAmbient() ? "all light is ambient, which shows no texture" : "a surface has a texture";
}

}  // namespace

std::vector<Required> requiredBy(const Picture& picture) {
  const PictureSettings& s = picture.settings();
  const Scene& scene = picture.scene();
  const ShadingRow& method = rowOf(s.shading);
  const auto count = [](std::size_t n) { return static_cast<std::int64_t>(n); };
  std::vector<Required> required;
  const auto add = [&](std::string_view name, std::variant<bool, std::int64_t> what, std::string why) {
    required.push_back({name, what, std::move(why)});
  };
  const std::string unlit = std::string{method.label} + " shading uses no light";
  const auto lit = [&](std::string why) { return method.lit ? std::move(why) : unlit; };

  const Lighting& lighting = picture.shading().lighting();
  const auto any = [&](auto&& has) { return method.lit && std::ranges::any_of(lighting.sources, has); };
  const bool fades = any([](const Lighting::Source& l) { return l.linear || l.c != glm::dvec3{1, 0, 0}; });
  const bool spots = any([](const Lighting::Source& l) { return l.spot; });
  const ColorPlan plan = picture.colors().plan();
  add("illumination", method.lit, method.lit ? std::string{method.label} + " shading uses light" : unlit);
  add("channels", count(method.lit ? lighting.channels : 1), lit(channelsWhy(lighting, plan)));
  const std::size_t all = scene.light.lights.empty() ? 1 : scene.light.lights.size();
  add("lights", count(method.lit ? lighting.sources.size() : 0),
      lit(lightsWhy(lighting.sources.size(), all)));
  add("specular", method.lit && lighting.specular, lit(specularWhy(scene, lighting)));
  add("eye", method.lit && lighting.variesV(), lit(eyeWhy(scene, lighting, s.light)));
  add("places", method.lit && lighting.needsPlaces(), lit(placesWhy(lighting)));
  add("spots", spots, lit(spots ? "the cone of a spot can reach the scene" : "no cone of a spot reaches it"));
  add("attenuation", fades, lit(fades ? "a light fades with distance" : "no light fades with distance"));
  const SceneShading& shading = picture.shading();
  add("face_normals", count(method.interpolates ? 0 : shading.points().N.size()),
      lit(normalsWhy(shading, method, false)));
  add("vertex_normals", count(shading.vertices().vertices.size()), lit(normalsWhy(shading, method, true)));
  add("textures", method.lit && !lighting.onlyAmbient() && hasTextures(scene),
      lit(texturesWhy(scene, lighting)));
  const bool planes = !picture.snapped().planes.empty();
  add("planes", planes, planes ? "the order compares planes" : "the order compares only z");
  const bool rgb = channelsOf(plan) == Channels::Rgb;
  add("ramps", count(rgb ? 0 : picture.colors().tables().size()),
      rgb ? "the cells hold colours" : "one for each hue");
  const std::int64_t cuts = std::int64_t{scene.parts.count()} - scene.mesh.faceCount();
  add("cuts_of_concave_faces", cuts,
      cuts > 0 ? "faces are concave or bent" : "all faces are planar and convex");
  return required;
}

}  // namespace xnewell
