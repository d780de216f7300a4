#include "shading/light/equation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"

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

namespace {

using S = std::string_view;

constexpr MistakeRow kNone;
constexpr MistakeRow row(const EquationWay& way, Mistake id, S name, S label, S words, S is,
                         S lightTerms = kNone.lightTerms, S R = kNone.R, S ambientTerm = kNone.ambientTerm) {
  return {way, id, name, label, words, is, lightTerms, R, ambientTerm};
}

}  // namespace

constinit const std::array<MistakeRow, 24> kMistakes{
    row({}, Mistake::None, "none", "the course's", "the course's equation", "The equation of the course."),
    row({.facing = Clamp::Signed}, Mistake::FacingUnclamped, "NL-unclamped", "no max(0, N.L)",
        "N.L not clamped", "N.L is not clamped, so a light behind a surface takes light away."),
    row({.facing = Clamp::Absolute}, Mistake::FacingAbsolute, "NL-abs", "|N.L|", "N.L without its sign",
        "N.L loses its sign, so a light behind a surface shines through it.", "f*Ip [ kd*|NL| + ks*RV^n ]"),
    row({.facing = Clamp::ByAngle}, Mistake::FacingByAngle, "NL-angle", "1 - angle/90",
        "the angle in place of N.L", "The angle between N and L takes the place of its cosine.",
        "f*Ip [ kd*(1 - angle/90) + ks*RV^n ]"),
    row({.reflected = Clamp::Signed}, Mistake::ReflectedUnclamped, "RV-unclamped", "no max(0, R.V)",
        "R.V not clamped", "R.V is not clamped: an even n makes a second highlight opposite the first."),
    row({.reflected = Clamp::Absolute}, Mistake::ReflectedAbsolute, "RV-abs", "|R.V|", "R.V without its sign",
        "R.V loses its sign: a second highlight is opposite the first.", "f*Ip [ kd*NL + ks*|RV|^n ]"),
    row({.highlightBehind = true}, Mistake::HighlightBehind, "highlight-behind", "highlight behind",
        "highlights where N.L < 0",
        "The highlight is not tied to N.L > 0, so surfaces that face away from the light shine."),
    row({.longN = true, .reflected = Clamp::Positive}, Mistake::NotUnitN, "N-not-unit", "N not unit",
        "N not of unit length",
        "N is the cross product, or the sum of those around a vertex, not divided by its length."),
    row({.N = -1}, Mistake::InwardN, "N-inward", "N inward", "N inward",
        "N points into the solid, so the far side from the light is lit."),
    row({.L = -1}, Mistake::ReversedL, "L-sign", "L away", "L from the light",
        "L points away from the light, so the light comes from the opposite side."),
    row({.V = -1}, Mistake::ReversedV, "V-sign", "V away", "V from the eye",
        "V points away from the eye, so the highlights are on the side that is not seen."),
    row({.NinR = -2, .LinR = 1}, Mistake::ReversedR, "R-sign", "R reversed", "R reversed",
        "R is L - 2 N (N.L), the direction into the surface. The highlights vanish.", kNone.lightTerms,
        "L - 2 N (N.L)"),
    row({.NinR = 1}, Mistake::RWithout2, "R-without-2", "R without 2", "R without its 2",
        "R is N (N.L) - L, which lies in the surface. The highlights fade or vanish.", kNone.lightTerms,
        "N (N.L) - L"),
    row({.power = PowerOf::Sum}, Mistake::PowerOfSum, "n-on-the-sum", "n on the sum", "n on the sum",
        "The exponent is on the sum of both terms, so the diffuse light shrinks to a spot.",
        "f*Ip (kd*NL + ks*RV)^n"),
    row({.power = PowerOf::Nothing}, Mistake::NoPower, "n-forgotten", "no exponent", "no exponent",
        "The exponent is forgotten, so the highlight spreads over half the surface.",
        "f*Ip [ kd*NL + ks*RV ]"),
    row({.power = PowerOf::KsToo}, Mistake::KsInPower, "ks-in-the-power", "(ks R.V)^n", "ks in the power",
        "ks is inside the power, so a ks below 1 leaves no highlight.", "f*Ip [ kd*NL + (ks*RV)^n ]"),
    row({.highlightTimesFacing = true}, Mistake::HighlightTimesFacing, "spec-times-NL", "ks N.L (R.V)^n",
        "highlights times N.L",
        "The highlight is multiplied by N.L, so it is too dark where light comes from the side.",
        "f*Ip [ kd*NL + ks*NL*RV^n ]"),
    row({.swapsKdKs = true}, Mistake::SwappedKs, "kd-ks-swapped", "kd, ks swapped", "kd and ks swapped",
        "kd and ks are in each other's place.", "f*Ip [ ks*NL + kd*RV^n ]"),
    row({.IpOnDiffuse = false, .IpOnHighlight = false}, Mistake::NoIp, "Ip-forgotten", "no Ip", "no Ip",
        "Ip is forgotten, so every light counts as 1, and the picture is clamped.", "f [ kd*NL + ks*RV^n ]"),
    row({.IpOnHighlight = false}, Mistake::IpNotOnHighlight, "Ip-not-on-spec", "no Ip on ks",
        "no Ip on highlights", "Only the diffuse term has Ip, so highlights are too bright.",
        "f [ Ip*kd*NL + ks*RV^n ]"),
    row({.ambient = 0}, Mistake::NoAmbient, "Ia-forgotten", "no ambient", "no ambient term",
        "The ambient term is left out, so what no light reaches is black.", kNone.lightTerms, kNone.R, ""),
    row({.ambient = 2}, Mistake::TwiceAmbient, "Ia-twice", "ambient twice", "the ambient term twice",
        "The ambient term is added twice, so shadows are too bright.", kNone.lightTerms, kNone.R, "2*ka*Ia"),
    row({.diffuse = 0}, Mistake::NoDiffuse, "diffuse-forgotten", "no diffuse", "no diffuse term",
        "The diffuse term is left out: highlights on a surface of one shade.", "f*Ip*ks*RV^n"),
    row({.specular = 0}, Mistake::NoSpecular, "spec-forgotten", "no specular", "no specular term",
        "The specular term is left out, so the surface is matt.", "f*Ip*kd*NL"),
};

}  // namespace xnewell
