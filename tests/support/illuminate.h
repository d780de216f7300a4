#pragma once

#include <glm/geometric.hpp>

#include "geometry/exact/scale.h"
#include "shading/light/equation.h"

namespace xnewell {

/// The terms at the place P, for one light. Ip is its intensity in this channel; light.Ip is not used. Where
/// there are several lights, `ambient` counts once. `unitLength` is the length that 1/d and 1/d^2 take for 1.
[[nodiscard]] inline IlluminationTerms illuminate(double Ia, double Ip, const Light& light,
                                                  const Reflection& surface, const glm::dvec3& N,
                                                  const glm::dvec3& V, const glm::dvec3& P, Form form,
                                                  double unitLength = 1) {
  const bool directional = light.kind == LightKind::Directional;
  const glm::dvec3 towards = directional ? light.direction : light.position - P;
  const glm::dvec3 L = unit(towards);  // 0 at the light's own place, which it does not light
  const double fatt = directional ? 1.0 : attenuation(light, glm::dot(towards, L), unitLength);
  return termsOf(Ia, Ip, fatt, spotShare(light, L), surface, glm::dot(N, L), specularCosine(form, N, L, V));
}

}  // namespace xnewell
