#include "x11/window/controls.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "geometry/exact/trig.h"
#include "geometry/exact/unit.h"
#include "shading/scene/units.h"

namespace xnewell {

std::string_view keepFillable(Setup& setup) {
  if (setup.fill != Fill::XFillPolygon) return {};
  const Order order = setup.picture.order;
  const bool bySample = rowOf(order).bySample;
  if (!bySample && !rowOf(setup.picture.shading).interpolates) return {};
  setup.fill = Fill::Scanline;
  return order == Order::Oracle
             ? "The oracle decides each sample by itself: there is no polygon for the server to fill."
         : bySample ? "A z-buffer decides each sample by itself: there is no polygon for the server to fill."
                    : "XFillPolygon gives a polygon one cell: the server cannot interpolate.";
}

namespace {
/// Axes of the world as the default view of a scene with this up axis sees them: right, towards the viewer,
/// up.
struct Horizon {
  glm::dvec3 right, towards, up;
};
Horizon horizon(UpAxis up) {
  if (up == UpAxis::Z) return {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  return {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
}
}  // namespace

std::vector<Light> lampsOf(const Setup& setup, const Scene& scene) {
  SceneLight own;
  own.lights = setup.picture.lights.value_or(scene.light.lights);
  Illumination light = setup.picture.light;
  if (light.lightPosition) light.lightPosition = inSceneUnits(*light.lightPosition, scene);
  light.attenuation.reset();  // it belongs to the picture
  return lightsOf(own, light, {});
}

bool hasOwnLamps(const Setup& setup, const Scene& scene) {
  return !setup.picture.lights.value_or(scene.light.lights).empty();
}

void putLamp(Setup& setup, const Scene& scene, std::size_t lamp, const Light& light) {
  if (hasOwnLamps(setup, scene)) {
    setup.picture.lights = lampsOf(setup, scene);
    (*setup.picture.lights)[lamp] = light;
    return;
  }
  setup.picture.light.light = light.direction;
  if (light.kind != LightKind::Directional)
    setup.picture.light.lightPosition = inFileUnits(light.position, scene);
}

glm::dvec3 towardsLight(const Light& light, glm::dvec3 centre) {
  return unit(light.kind == LightKind::Directional ? light.direction : light.position - centre);
}

LightAngles lightAngles(const Light& light, UpAxis up, glm::dvec3 centre) {
  const Horizon h = horizon(up);
  const glm::dvec3 L = towardsLight(light, centre);
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  return {std::atan2(glm::dot(L, h.right), glm::dot(L, h.towards)) * kDegrees,
          std::asin(std::clamp(glm::dot(L, h.up), -1.0, 1.0)) * kDegrees};
}

void turnLight(Light& light, UpAxis up, double azimuth, double elevation, glm::dvec3 centre) {
  const Horizon h = horizon(up);
  const LightAngles now = lightAngles(light, up, centre);
  const double e = std::clamp(std::round(now.elevation + elevation), -90.0, 90.0);
  double a = std::round(now.azimuth + azimuth);
  a -= 360.0 * std::floor((a + 180.0) / 360.0);
  const SinCos sa = sinCosDegrees(a), se = sinCosDegrees(e);
  aimLight(light, se.cos * (sa.sin * h.right + sa.cos * h.towards) + se.sin * h.up, centre);
}

void aimLight(Light& light, glm::dvec3 towards, glm::dvec3 centre) {
  const glm::dvec3 before = towardsLight(light, centre);
  if (light.kind != LightKind::Directional)
    light.position = centre + glm::dot(light.position - centre, before) * towards;
  if (light.kind != LightKind::Spot) {
    light.direction = towards;
    return;
  }
  // The axis turns as the light does: about the normal of both directions. Opposite ones have none.
  const glm::dvec3 about = glm::cross(before, towards);
  const double cosine = glm::dot(before, towards);
  const glm::dvec3 across = glm::cross(about, light.direction);
  light.direction = cosine > -1.0 ? light.direction + across + glm::cross(about, across) / (1.0 + cosine)
                                  : -light.direction;
}

}  // namespace xnewell
