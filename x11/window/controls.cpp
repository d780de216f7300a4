#include "x11/window/controls.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "geometry/exact/trig.h"
#include "geometry/exact/unit.h"

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

glm::dvec3 towardsLight(const Illumination& light, glm::dvec3 centre) {
  return unit(light.lightPosition ? *light.lightPosition - centre : light.light);
}

LightAngles lightAngles(const Illumination& light, UpAxis up, glm::dvec3 centre) {
  const Horizon h = horizon(up);
  const glm::dvec3 L = towardsLight(light, centre);
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  return {std::atan2(glm::dot(L, h.right), glm::dot(L, h.towards)) * kDegrees,
          std::asin(std::clamp(glm::dot(L, h.up), -1.0, 1.0)) * kDegrees};
}

void turnLight(Illumination& light, UpAxis up, double azimuth, double elevation, glm::dvec3 centre) {
  const Horizon h = horizon(up);
  const LightAngles now = lightAngles(light, up, centre);
  const double e = std::clamp(std::round(now.elevation + elevation), -90.0, 90.0);
  double a = std::round(now.azimuth + azimuth);
  a -= 360.0 * std::floor((a + 180.0) / 360.0);
  const SinCos sa = sinCosDegrees(a), se = sinCosDegrees(e);
  aimLight(light, se.cos * (sa.sin * h.right + sa.cos * h.towards) + se.sin * h.up, centre);
}

void aimLight(Illumination& light, glm::dvec3 towards, glm::dvec3 centre) {
  light.light = towards;
  if (light.lightPosition)
    // Without squares: the file's units may be as large as 1e300.
    *light.lightPosition =
        centre + glm::dot(*light.lightPosition - centre, towardsLight(light, centre)) * towards;
}

}  // namespace xnewell
