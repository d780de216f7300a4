#include "shading/light/equation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/exact/power.h"
#include "geometry/exact/trig.h"
#include "geometry/exact/unit.h"

namespace xnewell {

namespace {

double clamped(Clamp way, double cosine) {
  switch (way) {
    case Clamp::Cosine:
      return std::clamp(cosine, 0.0, 1.0);  // before the power: an even n would turn -1 into a highlight
    case Clamp::Positive:
      return std::max(0.0, cosine);
    case Clamp::Signed:
      return cosine;
    case Clamp::Absolute:
      return std::abs(cosine);
    case Clamp::ByAngle:
      break;
  }
  return std::max(0.0, 1.0 - degreesOf(std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), cosine) / 90.0);
}

double boundedPower(double cosine, int n) {
  constexpr double kMost = 1e6;
  return std::clamp(power(cosine, n), -kMost, kMost);
}

/// R of the textbook's form, H half way from L to V, or L. `inR` is what R takes for N.L.
glm::dvec3 highlightVector(const EquationWay& way, Form form, const EquationVectors& at, double inR) {
  if (form == Form::Tutorial) return at.L;
  return form == Form::HalfVector ? unit(at.L + at.V) : way.NinR * at.N * inR + way.LinR * at.L;
}
double highlightCosine(const EquationWay& way, Form form, const EquationVectors& at, const glm::dvec3& R) {
  return form == Form::Textbook ? glm::dot(R, way.highlightAtL ? at.L : at.V) : glm::dot(at.N, R);
}

}  // namespace

double attenuation(const Light& light, double d, double unit, bool atMost1) {
  const double u = d / unit, least = atMost1 ? 1.0 : 0.0;
  switch (light.attenuation) {
    case Attenuation::None:
      break;
    case Attenuation::Inverse:
      return 1.0 / std::max(least, u);
    case Attenuation::InverseSquare:
      return 1.0 / std::max(least, u * u);
    case Attenuation::Linear:
      return std::max(0.0, 1.0 - d / light.range);
    case Attenuation::Textbook:
      return 1.0 / std::max(least, light.c[0] + light.c[1] * d + light.c[2] * d * d);
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
  const EquationVectors at{N, L, V};
  return highlightCosine(kCourse, form, at, highlightVector(kCourse, form, at, glm::dot(N, L)));
}

IlluminationTerms termsOf(double Ia, double Ip, double fatt, double spot, const Reflection& surface,
                          double NdotL, double cosine, const EquationWay& way) {
  IlluminationTerms terms{.ambient = Ia * surface.ka * way.ambient,
                          .facing = clamped(way.facing, NdotL),
                          .counted = clamped(way.reflected, cosine),
                          .fatt = fatt,
                          .spot = spot};
  const bool shines = (way.facingFlowsOn ? terms.facing : NdotL) > 0.0 || way.highlightBehind;
  if (shines) terms.power = boundedPower(terms.counted, surface.n);
  const double f = fatt * spot, kd = way.swapsKdKs ? surface.ks : surface.kd,
               ks = way.swapsKdKs ? surface.kd : surface.ks;
  const double arrives = f * (way.IpOnDiffuse ? Ip : 1.0);
  double highlight = f * (way.IpOnHighlight ? Ip : 1.0);
  if (way.power == PowerOf::Sum) {  // (kd N.L + ks R.V)^n: each of the two has its share of the power
    const double shine = shines ? ks : 0.0, sum = kd * terms.facing + shine * terms.counted;
    const double rest = surface.n == 0 ? 0.0 : arrives * boundedPower(sum, surface.n - 1);
    terms.diffuse = surface.n == 0 ? arrives : rest * kd * terms.facing;
    terms.specular = rest * shine * terms.counted;
  } else {
    terms.diffuse = arrives * kd * terms.facing * way.diffuse;
    if (way.power != PowerOf::KsToo) highlight *= ks;
    if (way.highlightTimesFacing) highlight *= terms.facing;
    highlight *= way.power == PowerOf::Nothing  ? terms.counted
                 : way.power == PowerOf::Factor ? surface.n * terms.counted
                 : way.power == PowerOf::KsToo  ? boundedPower(ks * terms.counted, surface.n)
                                                : terms.power;
    if (shines) terms.specular = highlight * way.specular;
  }
  terms.I = terms.ambient + terms.diffuse + terms.specular;
  return terms;
}

EquationVectors taken(const EquationWay& way, const EquationVectors& at) {
  EquationVectors all{way.N * at.N, way.L * at.L, way.V * at.V};
  if (way.turnsByV && glm::dot(all.N, all.V) < 0.0) all.N = -all.N;
  return all;
}

LightTerms lightTerms(const EquationWay& way, double f, double Ip, const Reflection& surface,
                      const EquationVectors& vectors, Form form) {
  const EquationVectors at = taken(way, vectors);
  const double NdotL = glm::dot(at.N, at.L), inR = way.facingFlowsOn ? clamped(way.facing, NdotL) : NdotL;
  const glm::dvec3 R = highlightVector(way, form, at, inR);
  const double cosine = highlightCosine(way, form, at, R);
  return {termsOf(0.0, Ip, f, 1.0, surface, NdotL, cosine, way), at, R, NdotL, cosine};
}

}  // namespace xnewell
