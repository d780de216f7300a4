#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string_view>

#include "shading/light/light.h"

namespace xnewell {

/// The illumination equation, as the textbook writes it, for one channel:
///   I = Ia ka + sum over the lights of  fatt spot Ip [ kd (N.L) + ks (R.V)^n ],   R = 2 N (N.L) - L.
/// N, L, V and R are unit vectors in world coordinates. The bracket is 0 where N.L <= 0, and R.V counts as 0
/// where it is negative. ka, kd and ks include the surface's colour.
/// @see Foley & van Dam 2e §16.1
///
/// equation.cpp is the definition, written to be read. Pictures are computed by loops that take several
/// places at once (reflect.h and phong_row.h of shading/fill); tests hold those loops against this file.

/// The cosine whose n-th power is the specular term.
enum class Form { Textbook, HalfVector, Tutorial };
struct FormRow {
  Form id;
  std::string_view name, cosine;
};
inline constexpr std::array kForms{
    FormRow{Form::Textbook, "textbook", "R.V, R the reflected L (Phong 1975)"},
    FormRow{Form::HalfVector, "half-vector", "N.H, H half way from L to V (Blinn 1977)"},
    FormRow{Form::Tutorial, "tutorial", "N.L: c = ambient + cos x diffuse + cos^n x specular"},
};

/// What a surface reflects, in one channel.
struct Reflection {
  double ka = 0, kd = 0, ks = 0;
  int n = 1;  ///< 0..1,000,000; x^0 = 1
};

/// What counts for a cosine: from 0 to 1; from 0; itself; without its sign; or 1 at 0 degrees and 0 at 90.
enum class Clamp { Cosine, Positive, Signed, Absolute, ByAngle };
/// What n is the power of.
enum class PowerOf { Cosine, Sum, KsToo, Nothing, Factor };

/// How a program computes the equation. The default is the course's; a mistake differs in a field or two.
struct EquationWay {
  double N = 1, L = 1, V = 1;      ///< -1 reverses the vector
  bool longN = false;              ///< N is as long as the cross product that made it
  bool turnsByV = false;           ///< N is turned by its product with V, not by the side that the eye sees
  double NinR = 2, LinR = -1;      ///< R = NinR N (N.L) + LinR L, of the textbook's form
  bool highlightAtL = false;       ///< R.L in place of R.V
  Clamp facing = Clamp::Positive;  ///< what counts for N.L
  Clamp reflected = Clamp::Cosine;
  bool facingFlowsOn = false;    ///< R, and whether there is a highlight, have what counts for N.L
  bool highlightBehind = false;  ///< the highlight does not ask for N.L > 0
  PowerOf power = PowerOf::Cosine;
  bool highlightTimesFacing = false;
  double ambient = 1, diffuse = 1, specular = 1;  ///< how often each term counts
  bool swapsKdKs = false, IpOnDiffuse = true, IpOnHighlight = true;

  [[nodiscard]] constexpr bool changesR() const { return NinR != 2 || LinR != -1; }
  [[nodiscard]] constexpr bool changesVectors() const {
    return N != 1 || L != 1 || V != 1 || longN || changesR();
  }
  bool operator==(const EquationWay&) const = default;
};
inline constexpr EquationWay kCourse;

/// The terms for one light. The course's are 0 or more.
struct IlluminationTerms {
  double ambient = 0;                         ///< Ia ka
  double diffuse = 0;                         ///< fatt spot Ip kd (N.L)
  double specular = 0;                        ///< fatt spot Ip ks (R.V)^n
  double I = 0;                               ///< the sum of the three. It may exceed 1; a picture clamps it
  double facing = 0, counted = 0, power = 0;  ///< what counts for N.L and R.V, and the power of the latter
  double fatt = 1, spot = 1;
};

/// The terms where both cosines are known: N.L, and the one that the form chooses. A power above 1,000,000
/// counts as that: with a mistake N may be any length, and a picture clamps I to 1.
[[nodiscard]] IlluminationTerms termsOf(double Ia, double Ip, double fatt, double spot,
                                        const Reflection& surface, double NdotL, double cosine,
                                        const EquationWay& way = kCourse);

/// The three vectors of the equation for one light.
struct EquationVectors {
  glm::dvec3 N, L, V;
};
/// As a way takes them.
[[nodiscard]] EquationVectors taken(const EquationWay& way, const EquationVectors& at);

struct LightTerms : IlluminationTerms {
  EquationVectors at;            ///< as the terms took them
  glm::dvec3 R{0};               ///< R, H or L, as the form says
  double NdotL = 0, cosine = 0;  ///< before they were clamped
};
/// Evaluates the equation for one light in any way; without the ambient term. `f` is fatt spot.
[[nodiscard]] LightTerms lightTerms(const EquationWay& way, double f, double Ip, const Reflection& surface,
                                    const EquationVectors& at, Form form);

/// fatt: what the distance d leaves of a light. The relative error is at most 2^-50 (5 roundings), or
/// 2^-1022. `linear` is within 2^-51. It is at most 1, but for programs that forget that.
[[nodiscard]] double attenuation(const Light& light, double d, double unit = 1, bool atMost1 = true);
/// spot: 1 inside the inner cone, 0 outside the outer cone, in between ((cos a - cos outer) / (cos inner -
/// cos outer))^falloff, where a is the angle from the axis to -L. The result is the exact share of some
/// angle: the cosines of the two angles differ by at most 2^-48. cos a has 7 roundings, the cones' cosines
/// have 4 each, and the quotient and the power have 8.
[[nodiscard]] double spotShare(const Light& light, const glm::dvec3& L);
/// R.V, N.H or N.L of unit vectors. It is not clamped. R.V is off by at most 2^-48 (18 roundings), N.H by
/// 2^-49 (9 roundings).
[[nodiscard]] double specularCosine(Form form, const glm::dvec3& N, const glm::dvec3& L, const glm::dvec3& V);

/// The illumination equation with a mistake: terms left out, and the errors that programs for this assignment
/// have most often. The equation itself stays as it is (equation.h). A row here says which of its steps is
/// another one, so that a picture shows what comes of it. Mistakes apply where the equation is evaluated:
/// flat, Gouraud and Phong shading.

enum class Mistake {
  None,
  FacingUnclamped,
  FacingAbsolute,
  FacingByAngle,
  ReflectedUnclamped,
  ReflectedAbsolute,
  HighlightBehind,
  NotUnitN,
  InwardN,
  ReversedL,
  ReversedV,
  ReversedR,
  RWithout2,
  PowerOfSum,
  NoPower,
  KsInPower,
  HighlightTimesFacing,
  SwappedKs,
  NoIp,
  IpNotOnHighlight,
  NoAmbient,
  TwiceAmbient,
  NoDiffuse,
  NoSpecular,
};

/// What a mistake computes, and its words.
struct MistakeRow : EquationWay {
  Mistake id = Mistake::None;
  std::string_view name, label;
  std::string_view words;  ///< "R reversed": what a picture has
  std::string_view is;     ///< a sentence
  /// The terms of one light, R, and the ambient term. x is a product; N, L, R and the others are words of it.
  /// NL and RV are the two cosines, each with what the mistake makes of it.
  std::string_view lightTerms = "f*Ip [ kd*NL + ks*RV^n ]";
  std::string_view R = "2 N (N.L) - L";
  std::string_view ambientTerm = "ka*Ia";
};
extern const std::array<MistakeRow, 24> kMistakes;
[[nodiscard]] inline const MistakeRow& rowOf(Mistake mistake) {
  return kMistakes[static_cast<std::size_t>(mistake)];
}

[[nodiscard]] inline LightTerms lightTerms(Mistake mistake, double f, double Ip, const Reflection& surface,
                                           const EquationVectors& at, Form form) {
  return lightTerms(rowOf(mistake), f, Ip, surface, at, form);
}

}  // namespace xnewell
