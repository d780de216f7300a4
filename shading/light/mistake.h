#pragma once

#include <array>
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
