#include "shading/light/equation.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "geometry/exact/power.h"
#include "geometry/exact/trig.h"
#include "geometry/exact/unit.h"

namespace xnewell {

double attenuation(const Light& light, double d, double unit) {
  const double u = d / unit;
  switch (light.attenuation) {
    case Attenuation::None:
      break;
    case Attenuation::Inverse:
      return 1.0 / std::max(1.0, u);
    case Attenuation::InverseSquare:
      return 1.0 / std::max(1.0, u * u);
    case Attenuation::Linear:
      return std::max(0.0, 1.0 - d / light.range);
    case Attenuation::Textbook:
      return 1.0 / std::max(1.0, light.c[0] + light.c[1] * d + light.c[2] * d * d);
  }
  return 1.0;
}

double spotShare(const Light& light, const glm::dvec3& L) {
  if (light.kind != LightKind::Spot) return 1.0;
  const double cosine = glm::dot(unit(light.direction), -L);
  const double inner = sinCosDegrees(light.inner).cos, outer = sinCosDegrees(light.outer).cos;
  if (cosine >= inner) return 1.0;
  if (cosine <= outer) return 0.0;
  return power((cosine - outer) / (inner - outer), light.falloff);
}

double specularCosine(Form form, const glm::dvec3& N, const glm::dvec3& L, const glm::dvec3& V) {
  switch (form) {
    case Form::Textbook: {
      const glm::dvec3 R = 2.0 * N * glm::dot(N, L) - L;
      return glm::dot(R, V);
    }
    case Form::HalfVector: {
      const glm::dvec3 H = unit(L + V);
      return glm::dot(N, H);
    }
    case Form::Tutorial:
      break;
  }
  return glm::dot(N, L);
}

IlluminationTerms termsOf(double Ia, double Ip, double fatt, double spot, const Reflection& surface,
                          double NdotL, double cosine) {
  IlluminationTerms terms{.ambient = Ia * surface.ka, .fatt = fatt, .spot = spot};
  if (NdotL > 0.0) {
    // Clamped before the power: an even n would turn a negative cosine into a highlight.
    terms.diffuse = fatt * spot * Ip * surface.kd * NdotL;
    terms.specular = fatt * spot * Ip * surface.ks * power(std::clamp(cosine, 0.0, 1.0), surface.n);
  }
  terms.I = terms.ambient + terms.diffuse + terms.specular;
  return terms;
}

}  // namespace xnewell
