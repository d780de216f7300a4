#include "shading/light/mistake.h"

namespace xnewell {

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
