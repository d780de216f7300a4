#include "shading/light/illumination.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"

namespace xnewell {

namespace {

/// The direction of a point that is farther away than this differs by less than 2^-29 between the places of a
/// scene of size 1.
constexpr double kFar = 0x1p30;

double lengthOf(const glm::dvec3& v) {
  const glm::dvec3 along = unit(v);
  return glm::dot(v, along);  // without a square that could overflow
}

/// The largest x with x^n < 2^-40, by bisection.
double leastCosine(int n) {
  if (n == 0) return -1.0;  // x^0 = 1
  double low = 0.0, high = 1.0;
  for (;;) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) return low;
    (power(middle, n) < 0x1p-40 ? low : high) = middle;
  }
}

/// The user's light, for a scene that has none.
Light usersLight(const Illumination& user) {
  return {.kind = user.lightPosition ? LightKind::Point : LightKind::Directional,
          .Ip = glm::dvec3{user.Ip},
          .direction = user.light,
          .position = user.lightPosition.value_or(glm::dvec3{0})};
}

/// c of fatt = 1 / max(1, c.x + c.y d + c.z d^2). For `linear`, c.x is what each unit of length takes away.
glm::dvec3 coefficients(const Light& light, double unitLength) {
  const double perUnit = 1.0 / unitLength;
  switch (light.attenuation) {
    case Attenuation::None:
      break;
    case Attenuation::Inverse:
      return {0.0, perUnit, 0.0};
    case Attenuation::InverseSquare:
      return {0.0, 0.0, perUnit * perUnit};
    case Attenuation::Linear:
      return {1.0 / light.range, 0.0, 0.0};
    case Attenuation::Textbook:
      return light.c;
  }
  return {1.0, 0.0, 0.0};
}

Lighting::Source sourceOf(const Light& light, const glm::dvec3& centre, double unitLength, bool constantL) {
  Lighting::Source source;
  if (light.kind == LightKind::Directional) {
    source.L = unit(light.direction);
    return source;
  }
  source.placed = true;
  source.position = light.position;
  source.linear = light.attenuation == Attenuation::Linear;
  source.c = coefficients(light, unitLength);
  const double distance = lengthOf(light.position - centre);
  source.L = unit(light.position - centre);
  const bool far = distance > kFar;
  source.constantL = constantL || far;
  if (source.constantL) source.f = attenuation(light, distance, unitLength);
  if (light.kind == LightKind::Spot) {
    source.spot = true;
    source.axis = unit(light.direction);
    source.cosInner = sinCosDegrees(light.inner).cos;
    source.cosOuter = sinCosDegrees(light.outer).cos;
    source.falloff = light.falloff;
  }
  source.placed = source.spot || !source.constantL;
  return source;
}

/// Whether the cone of a spot can hold any place of the box, to within 2^-20 degrees. A ball around the box
/// is taken for it.
bool coneMeets(const Lighting::Source& spot, double outer, const Box& box) {
  const glm::dvec3 to = box.centre() - spot.position;
  const double distance = lengthOf(to), radius = lengthOf(box.high - box.low) / 2.0;
  if (distance <= radius) return true;
  const glm::dvec3 across = glm::cross(spot.axis, to);
  const double away = degreesOf(lengthOf(across), glm::dot(spot.axis, to));
  const double halfAngle = degreesOf(radius, std::sqrt((distance - radius) * (distance + radius)));
  return away - halfAngle < outer + 0x1p-20;
}

/// Whether the light can reach any place of the box.
bool reaches(const Lighting::Source& source, const Light& light, const Box& box) {
  if (!source.placed) return source.f > 0.0;
  if (source.spot && !coneMeets(source, light.outer, box)) return false;
  if (!source.linear || source.constantL) return true;
  const glm::dvec3 nearest = glm::clamp(source.position, box.low, box.high);
  return lengthOf(nearest - source.position) * source.c.x < 1.0;
}

/// The colour of the diffuse term, or what the texel multiplies.
glm::dvec3 diffuseColor(const MeshMaterial& m, TexelUse texel) {
  return m.texture >= 0 && texel == TexelUse::Replaces ? glm::dvec3{1.0} : m.diffuse;
}

}  // namespace

void attenuate(Light& light, Attenuation attenuation, const std::optional<double>& range,
               const std::optional<glm::dvec3>& c, const Box& scene) {
  if (light.kind == LightKind::Directional) return;
  const double d = std::max(lengthOf(light.position - scene.centre()), std::ldexp(scene.side(), -20));
  light.attenuation = attenuation;
  light.range = range.value_or(2.0 * d);
  light.c = c.value_or(glm::dvec3{1.0, 0.0, 1.0 / (d * d)});
}

double luminance(glm::dvec3 color) {
  if (color.r == color.g && color.r == color.b) return color.r;  // exactly
  return 0.30 * color.r + 0.59 * color.g + 0.11 * color.b;
}

std::vector<Light> lightsOf(const SceneLight& scene, const Illumination& user, const Box& box) {
  std::vector<Light> lights = scene.lights;
  if (lights.empty()) lights.push_back(usersLight(user));
  if (user.attenuation)
    for (Light& light : lights) attenuate(light, *user.attenuation, user.range, user.c, box);
  return lights;
}

Reflection reflectionOf(const MeshMaterial& m, const Illumination& user, int channel) {
  return {.ka = m.ka.value_or(user.ka) * m.diffuse[channel],
          .kd = m.kd.value_or(user.kd) * diffuseColor(m, user.texel)[channel],
          .ks = m.ks.value_or(user.ks) * m.specular[channel],
          .n = m.n.value_or(user.n)};
}

Lighting resolve(const Mesh& mesh, const SceneLight& scene, const Illumination& user, Channels channels,
                 glm::dvec3 eye, glm::dvec3 lookAt, bool colored) {
  const bool rgb = channels == Channels::Rgb || (channels == Channels::Luminance && colored);
  const auto share = [&](glm::dvec3 color) {
    if (rgb) return std::array{color.r, color.g, color.b};
    const bool brightness = channels == Channels::Brightness;
    return std::array{brightness ? std::max({color.r, color.g, color.b}) : luminance(color), 0.0, 0.0};
  };
  const Box box = boxOf(mesh.points);
  const glm::dvec3 centre = box.centre();

  Lighting lighting;
  lighting.channels = rgb ? 3 : 1;
  lighting.luminance = rgb && channels == Channels::Luminance;
  lighting.form = user.form;
  lighting.mistake = user.mistake;
  lighting.twoSided = user.twoSided;
  lighting.eye = eye;
  lighting.farV = unit(eye - lookAt);
  lighting.constantV = user.constantV || lengthOf(eye - centre) > kFar;

  for (const Light& light : lightsOf(scene, user, box)) {
    Lighting::Source source = sourceOf(light, centre, scene.unit, user.constantL);
    // Ramps of several hues are for white lights; others count with their luminance.
    source.Ip = rgb ? share(light.Ip) : std::array{luminance(light.Ip), 0.0, 0.0};
    const bool shines = *std::ranges::max_element(source.Ip) > 0.0 || user.mistake != Mistake::None;
    if (shines && reaches(source, light, box)) lighting.sources.push_back(source);
  }

  const glm::dvec3 Ia = ambientOf(scene, user);
  const std::array ambientLight = rgb ? share(Ia) : std::array{luminance(Ia), 0.0, 0.0};
  const auto resolved = [&](const MeshMaterial& m) {
    const std::array Oa = share(m.diffuse), Od = share(diffuseColor(m, user.texel)), Os = share(m.specular);
    Material material;
    for (int c = 0; c < 3; ++c) {
      material.ka[c] = m.ka.value_or(user.ka) * Oa[c];
      material.ambient[c] = rowOf(user.mistake).ambient * material.ka[c] * ambientLight[c];
      material.kd[c] = m.kd.value_or(user.kd) * Od[c];
      material.ks[c] = m.ks.value_or(user.ks) * Os[c];
    }
    material.n = m.n.value_or(user.n);
    material.leastCosine = leastCosine(material.n);
    return material;
  };
  lighting.materials.push_back(resolved({}));
  for (const MeshMaterial& m : mesh.materials) lighting.materials.push_back(resolved(m));
  if (user.mistake != Mistake::None) {  // it may take any light and any coefficient for another
    lighting.specular = !lighting.sources.empty();
    return lighting;
  }

  // Only what a face of the scene reflects counts.
  std::vector<bool> used(lighting.materials.size(), false);
  for (const int m : mesh.material) used[m + 1] = true;
  const auto isReflected = [&](const Lighting::Source& source, std::array<double, 3> Material::*k) {
    for (std::size_t m = 0; m < used.size(); ++m)
      for (int c = 0; c < lighting.channels; ++c)
        if (used[m] && source.Ip[c] * (lighting.materials[m].*k)[c] > 0.0) return true;
    return false;
  };
  std::erase_if(lighting.sources, [&](const Lighting::Source& source) {
    return !isReflected(source, &Material::kd) && !isReflected(source, &Material::ks);
  });
  lighting.specular = std::ranges::any_of(
      lighting.sources, [&](const Lighting::Source& source) { return isReflected(source, &Material::ks); });
  // x^0 = 1: where n is 0, a highlight is the same whatever V is.
  bool turns = false;
  for (std::size_t m = 0; m < used.size(); ++m)
    turns |=
        used[m] && lighting.materials[m].n > 0 && *std::ranges::max_element(lighting.materials[m].ks) > 0.0;
  lighting.constantV |= !turns;
  return lighting;
}

}  // namespace xnewell
