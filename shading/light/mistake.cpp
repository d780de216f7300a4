#include "shading/light/mistake.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/exact/power.h"
#include "geometry/exact/trig.h"
#include "geometry/exact/unit.h"

namespace xnewell {

namespace {

constexpr double kMostPower = 1e6;

double same(double cosine) { return cosine; }
double absolute(double cosine) { return std::abs(cosine); }
double positive(double cosine) { return std::max(0.0, cosine); }
double between0And1(double cosine) { return std::clamp(cosine, 0.0, 1.0); }

/// 1 at 0 degrees, 0 at 90 degrees and beyond.
double byAngle(double cosine) {
  return std::max(0.0, 1.0 - degreesOf(std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), cosine) / 90.0);
}

double boundedPower(double cosine, int n) { return std::clamp(power(cosine, n), -kMostPower, kMostPower); }

/// (kd N.L + ks R.V)^n. Each of the two has its share of the power.
DiffuseSpecular powerOfSum(const TermNumbers& t) {
  const double sum = t.kd * t.facing + t.ks * t.cosine;
  if (t.n == 0) return {t.f * t.Ip, 0.0};
  const double rest = t.f * t.Ip * boundedPower(sum, t.n - 1);
  return {rest * t.kd * t.facing, rest * t.ks * t.cosine};
}

DiffuseSpecular courseTerms(const TermNumbers& t) {
  return {t.f * t.Ip * t.kd * t.facing, t.f * t.Ip * t.ks * boundedPower(t.cosine, t.n)};
}

}  // namespace

constinit const std::array<MistakeRow, 24> kMistakes{
    MistakeRow{.id = Mistake::None,
               .name = "none",
               .label = "the course's",
               .words = "the course's equation",
               .is = "The equation of the course."},
    MistakeRow{.id = Mistake::FacingUnclamped,
               .name = "NL-unclamped",
               .label = "no max(0, N.L)",
               .words = "N.L not clamped",
               .is = "N.L is not clamped, so a light behind a surface takes light away.",
               .facing = same},
    MistakeRow{.id = Mistake::FacingAbsolute,
               .name = "NL-abs",
               .label = "|N.L|",
               .words = "N.L without its sign",
               .is = "N.L loses its sign, so a light behind a surface shines through it.",
               .lightTerms = "f*Ip [ kd*|NL| + ks*RV^n ]",
               .facing = absolute},
    MistakeRow{.id = Mistake::FacingByAngle,
               .name = "NL-angle",
               .label = "1 - angle/90",
               .words = "the angle in place of N.L",
               .is = "The angle between N and L takes the place of its cosine.",
               .lightTerms = "f*Ip [ kd*(1 - angle/90) + ks*RV^n ]",
               .facing = byAngle},
    MistakeRow{.id = Mistake::ReflectedUnclamped,
               .name = "RV-unclamped",
               .label = "no max(0, R.V)",
               .words = "R.V not clamped",
               .is = "R.V is not clamped: an even n makes a second highlight opposite the first.",
               .clamped = same},
    MistakeRow{.id = Mistake::ReflectedAbsolute,
               .name = "RV-abs",
               .label = "|R.V|",
               .words = "R.V without its sign",
               .is = "R.V loses its sign: a second highlight is opposite the first.",
               .lightTerms = "f*Ip [ kd*NL + ks*|RV|^n ]",
               .clamped = absolute},
    MistakeRow{.id = Mistake::HighlightBehind,
               .name = "highlight-behind",
               .label = "highlight behind",
               .words = "highlights where N.L < 0",
               .is = "The highlight is not tied to N.L > 0, so surfaces that face away from the light shine.",
               .highlightBehind = true},
    MistakeRow{
        .id = Mistake::NotUnitN,
        .name = "N-not-unit",
        .label = "N not unit",
        .words = "N not of unit length",
        .is = "N is the cross product, or the sum of those around a vertex, not divided by its length.",
        .longN = true,
        .clamped = positive},
    MistakeRow{.id = Mistake::InwardN,
               .name = "N-inward",
               .label = "N inward",
               .words = "N inward",
               .is = "N points into the solid, so the far side from the light is lit.",
               .vectors =
                   [](EquationVectors at) {
                     return EquationVectors{-at.N, at.L, at.V};
                   }},
    MistakeRow{.id = Mistake::ReversedL,
               .name = "L-sign",
               .label = "L away",
               .words = "L from the light",
               .is = "L points away from the light, so the light comes from the opposite side.",
               .vectors =
                   [](EquationVectors at) {
                     return EquationVectors{at.N, -at.L, at.V};
                   }},
    MistakeRow{.id = Mistake::ReversedV,
               .name = "V-sign",
               .label = "V away",
               .words = "V from the eye",
               .is = "V points away from the eye, so the highlights are on the side that is not seen.",
               .vectors =
                   [](EquationVectors at) {
                     return EquationVectors{at.N, at.L, -at.V};
                   }},
    MistakeRow{
        .id = Mistake::ReversedR,
        .name = "R-sign",
        .label = "R reversed",
        .words = "R reversed",
        .is = "R is L - 2 N (N.L), the direction into the surface. The highlights vanish.",
        .R = "L - 2 N (N.L)",
        .reflected = [](const glm::dvec3& N, const glm::dvec3& L) { return L - 2.0 * N * glm::dot(N, L); }},
    MistakeRow{.id = Mistake::RWithout2,
               .name = "R-without-2",
               .label = "R without 2",
               .words = "R without its 2",
               .is = "R is N (N.L) - L, which lies in the surface. The highlights fade or vanish.",
               .R = "N (N.L) - L",
               .reflected = [](const glm::dvec3& N, const glm::dvec3& L) { return N * glm::dot(N, L) - L; }},
    MistakeRow{.id = Mistake::PowerOfSum,
               .name = "n-on-the-sum",
               .label = "n on the sum",
               .words = "n on the sum",
               .is = "The exponent is on the sum of both terms, so the diffuse light shrinks to a spot.",
               .lightTerms = "f*Ip (kd*NL + ks*RV)^n",
               .terms = powerOfSum},
    MistakeRow{.id = Mistake::NoPower,
               .name = "n-forgotten",
               .label = "no exponent",
               .words = "no exponent",
               .is = "The exponent is forgotten, so the highlight spreads over half the surface.",
               .lightTerms = "f*Ip [ kd*NL + ks*RV ]",
               .terms =
                   [](const TermNumbers& t) {
                     return DiffuseSpecular{t.f * t.Ip * t.kd * t.facing, t.f * t.Ip * t.ks * t.cosine};
                   }},
    MistakeRow{.id = Mistake::KsInPower,
               .name = "ks-in-the-power",
               .label = "(ks R.V)^n",
               .words = "ks in the power",
               .is = "ks is inside the power, so a ks below 1 leaves no highlight.",
               .lightTerms = "f*Ip [ kd*NL + (ks*RV)^n ]",
               .terms =
                   [](const TermNumbers& t) {
                     return DiffuseSpecular{t.f * t.Ip * t.kd * t.facing,
                                            t.f * t.Ip * boundedPower(t.ks * t.cosine, t.n)};
                   }},
    MistakeRow{.id = Mistake::HighlightTimesFacing,
               .name = "spec-times-NL",
               .label = "ks N.L (R.V)^n",
               .words = "highlights times N.L",
               .is = "The highlight is multiplied by N.L, so it is too dark where light comes from the side.",
               .lightTerms = "f*Ip [ kd*NL + ks*NL*RV^n ]",
               .terms =
                   [](const TermNumbers& t) {
                     return DiffuseSpecular{t.f * t.Ip * t.kd * t.facing,
                                            t.f * t.Ip * t.ks * t.facing * boundedPower(t.cosine, t.n)};
                   }},
    MistakeRow{.id = Mistake::SwappedKs,
               .name = "kd-ks-swapped",
               .label = "kd, ks swapped",
               .words = "kd and ks swapped",
               .is = "kd and ks are in each other's place.",
               .lightTerms = "f*Ip [ ks*NL + kd*RV^n ]",
               .terms =
                   [](const TermNumbers& t) {
                     return DiffuseSpecular{t.f * t.Ip * t.ks * t.facing,
                                            t.f * t.Ip * t.kd * boundedPower(t.cosine, t.n)};
                   }},
    MistakeRow{.id = Mistake::NoIp,
               .name = "Ip-forgotten",
               .label = "no Ip",
               .words = "no Ip",
               .is = "Ip is forgotten, so every light counts as 1, and the picture is clamped.",
               .lightTerms = "f [ kd*NL + ks*RV^n ]",
               .terms =
                   [](const TermNumbers& t) {
                     return DiffuseSpecular{t.f * t.kd * t.facing, t.f * t.ks * boundedPower(t.cosine, t.n)};
                   }},
    MistakeRow{
        .id = Mistake::IpNotOnHighlight,
        .name = "Ip-not-on-spec",
        .label = "no Ip on ks",
        .words = "no Ip on highlights",
        .is = "Only the diffuse term has Ip, so highlights are too bright.",
        .lightTerms = "f [ Ip*kd*NL + ks*RV^n ]",
        .terms =
            [](const TermNumbers& t) {
              return DiffuseSpecular{t.f * t.Ip * t.kd * t.facing, t.f * t.ks * boundedPower(t.cosine, t.n)};
            }},
    MistakeRow{.id = Mistake::NoAmbient,
               .name = "Ia-forgotten",
               .label = "no ambient",
               .words = "no ambient term",
               .is = "The ambient term is left out, so what no light reaches is black.",
               .ambientTerm = "",
               .ambient = 0},
    MistakeRow{.id = Mistake::TwiceAmbient,
               .name = "Ia-twice",
               .label = "ambient twice",
               .words = "the ambient term twice",
               .is = "The ambient term is added twice, so shadows are too bright.",
               .ambientTerm = "2*ka*Ia",
               .ambient = 2},
    MistakeRow{.id = Mistake::NoDiffuse,
               .name = "diffuse-forgotten",
               .label = "no diffuse",
               .words = "no diffuse term",
               .is = "The diffuse term is left out: highlights on a surface of one shade.",
               .lightTerms = "f*Ip*ks*RV^n",
               .terms =
                   [](const TermNumbers& t) {
                     return DiffuseSpecular{0.0, t.f * t.Ip * t.ks * boundedPower(t.cosine, t.n)};
                   }},
    MistakeRow{.id = Mistake::NoSpecular,
               .name = "spec-forgotten",
               .label = "no specular",
               .words = "no specular term",
               .is = "The specular term is left out, so the surface is matt.",
               .lightTerms = "f*Ip*kd*NL",
               .terms =
                   [](const TermNumbers& t) {
                     return DiffuseSpecular{t.f * t.Ip * t.kd * t.facing, 0.0};
                   }},
};

LightTerms lightTerms(Mistake mistake, double f, double Ip, const Reflection& surface,
                      const EquationVectors& at, Form form) {
  const MistakeRow& row = rowOf(mistake);
  LightTerms terms{.at = row.vectors ? row.vectors(at) : at};
  const auto& [N, L, V] = terms.at;
  terms.NdotL = glm::dot(N, L);
  switch (form) {
    case Form::Textbook:
      terms.R = row.reflected ? row.reflected(N, L) : 2.0 * N * terms.NdotL - L;
      break;
    case Form::HalfVector:
      terms.R = unit(L + V);
      break;
    case Form::Tutorial:
      terms.R = L;
      break;
  }
  terms.cosine =
      row.reflected && form == Form::Textbook ? glm::dot(terms.R, V) : specularCosine(form, N, L, V);
  const bool lit = terms.NdotL > 0.0;
  terms.facing = row.facing ? row.facing(terms.NdotL) : std::max(0.0, terms.NdotL);
  terms.counted = (row.clamped ? row.clamped : between0And1)(terms.cosine);
  if (lit || row.highlightBehind) terms.power = boundedPower(terms.counted, surface.n);
  if (mistake == Mistake::None) {
    const IlluminationTerms course = termsOf(0.0, Ip, f, 1.0, surface, terms.NdotL, terms.cosine);
    terms.diffuse = course.diffuse, terms.specular = course.specular;
    return terms;
  }
  const TermNumbers numbers{f, Ip, surface.kd, surface.ks, surface.n, terms.facing, terms.counted};
  const DiffuseSpecular both = (row.terms ? row.terms : courseTerms)(numbers);
  terms.diffuse = both.diffuse;
  if (lit || row.highlightBehind) terms.specular = both.specular;
  return terms;
}

}  // namespace xnewell
