#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string_view>

#include "shading/light/equation.h"

namespace xnewell {

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

/// The three vectors of the equation for one light.
struct EquationVectors {
  glm::dvec3 N, L, V;
};
/// The numbers of a light's terms. `facing` and `cosine` are what counts for N.L and R.V.
struct TermNumbers {
  double f = 1, Ip = 0, kd = 0, ks = 0;
  int n = 1;
  double facing = 0, cosine = 0;
};
struct DiffuseSpecular {
  double diffuse = 0, specular = 0;
};

/// What a mistake computes: each step that is not null takes the place of the course's.
struct MistakeRow {
  Mistake id;
  std::string_view name, label;
  std::string_view words;  ///< "R reversed": what a picture has
  std::string_view is;     ///< a sentence
  /// The ambient term, and the terms of one light. x is a product; N, L, R and the others are words of it.
  /// NL and RV are the two cosines, each with what the mistake makes of it.
  std::string_view ambientTerm = "ka*Ia";
  std::string_view lightTerms = "f*Ip [ kd*NL + ks*RV^n ]";
  std::string_view R = "2 N (N.L) - L";
  double ambient = 1;            ///< how often the ambient term counts
  bool highlightBehind = false;  ///< whether the specular term counts also where N.L <= 0
  bool longN = false;            ///< whether N is as long as the cross product that made it
  EquationVectors (*vectors)(EquationVectors) = nullptr;
  glm::dvec3 (*reflected)(const glm::dvec3& N, const glm::dvec3& L) = nullptr;  ///< R of the textbook's form
  double (*facing)(double NdotL) = nullptr;                                     ///< for max(0, N.L)
  double (*clamped)(double cosine) = nullptr;                                   ///< for max(0, R.V)
  DiffuseSpecular (*terms)(const TermNumbers&) = nullptr;
};
extern const std::array<MistakeRow, 24> kMistakes;
[[nodiscard]] inline const MistakeRow& rowOf(Mistake mistake) {
  return kMistakes[static_cast<std::size_t>(mistake)];
}

/// The terms of one light, and what they were made of.
struct LightTerms {
  EquationVectors at;                         ///< as the terms took them
  glm::dvec3 R{0};                            ///< R, H or L, as the form says
  double NdotL = 0, cosine = 0;               ///< before they were clamped
  double facing = 0, counted = 0, power = 0;  ///< what counts for N.L and R.V, and the power of the latter
  double diffuse = 0, specular = 0;
};

/// Evaluates the equation for one light, with a mistake or without. `f` is fatt spot. Without a mistake these
/// are the course's terms (termsOf). A power above 1,000,000 counts as that: N may be any length, and a
/// picture clamps I to 1.
[[nodiscard]] LightTerms lightTerms(Mistake mistake, double f, double Ip, const Reflection& surface,
                                    const EquationVectors& at, Form form);

}  // namespace xnewell
