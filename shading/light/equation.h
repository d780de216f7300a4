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

/// The terms for one light. All are 0 or more.
struct IlluminationTerms {
  double ambient = 0;   ///< Ia ka
  double diffuse = 0;   ///< fatt spot Ip kd (N.L)
  double specular = 0;  ///< fatt spot Ip ks (R.V)^n
  double fatt = 1, spot = 1;
  double I = 0;  ///< ambient + diffuse + specular. It may exceed 1; a picture clamps it
};

/// The terms where both cosines are known: N.L, and the one that `form` chooses.
[[nodiscard]] IlluminationTerms termsOf(double Ia, double Ip, double fatt, double spot,
                                        const Reflection& surface, double NdotL, double cosine);

/// fatt: what the distance d leaves of a light. The relative error is at most 2^-50 (5 roundings), or
/// 2^-1022. `linear` is within 2^-51.
[[nodiscard]] double attenuation(const Light& light, double d, double unit = 1);
/// spot: 1 inside the inner cone, 0 outside the outer cone, in between ((cos a - cos outer) / (cos inner -
/// cos outer))^falloff, where a is the angle from the axis to -L. The result is the exact share of some
/// angle: the cosines of the two angles differ by at most 2^-48. cos a has 7 roundings, the cones' cosines
/// have 4 each, and the quotient and the power have 8.
[[nodiscard]] double spotShare(const Light& light, const glm::dvec3& L);
/// R.V, N.H or N.L of unit vectors. It is not clamped. R.V is off by at most 2^-48 (18 roundings), N.H by
/// 2^-49 (9 roundings).
[[nodiscard]] double specularCosine(Form form, const glm::dvec3& N, const glm::dvec3& L, const glm::dvec3& V);

}  // namespace xnewell
