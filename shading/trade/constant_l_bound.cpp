#include "shading/trade/constant_l_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "geometry/exact/box.h"
#include "shading/scene/units.h"

namespace xnewell {

std::optional<double> boundOfConstantL(const Scene& scene, const Illumination& user) {
  const Box box = boxOf(scene.mesh.points);
  const double r = glm::length(box.high - box.low) / 2;
  std::vector<MeshMaterial> materials{MeshMaterial{}};
  materials.insert(materials.end(), scene.mesh.materials.begin(), scene.mesh.materials.end());

  std::array<double, 3> bound{};
  bool placed = false;
  for (const Light& light : lightsOf(scene, user)) {
    if (light.kind == LightKind::Directional) continue;
    placed = true;
    const double d = glm::length(light.position - box.centre());
    if (!(d > r)) return std::nullopt;
    const double delta = 2 * std::sin(std::asin(r / d) / 2);
    const double near = attenuation(light, d - r, scene.light.unit),
                 far = attenuation(light, d + r, scene.light.unit),
                 centre = attenuation(light, d, scene.light.unit);
    const double change = std::max(near - centre, centre - far);
    for (int channel = 0; channel < 3; ++channel) {
      double most = 0;
      for (const MeshMaterial& material : materials) {
        const Reflection k = reflectionOf(material, user, channel);
        const double highlight = user.form == Form::Tutorial && k.n > 0 ? std::min(1.0, k.n * delta) : 1;
        most = std::max(most, near * (k.kd * delta + k.ks * highlight) + change * (k.kd + k.ks));
      }
      bound[channel] += light.Ip[channel] * most;
    }
  }
  if (!placed) return std::nullopt;
  return std::ranges::max(bound);
}

}  // namespace xnewell
