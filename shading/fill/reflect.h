#pragma once

#include "shading/fill/lanes.h"
#include "shading/light/illumination.h"

namespace xnewell {

/// The terms of the illumination equation (equation.h) at several places at once (lanes.h): for faces,
/// vertices and pixels.

/// What arrives from a light. L is the unit vector towards it; f = fatt times spot says how much of it
/// arrives.
template <class Real>
struct Incident {
  Vec<Real> L;
  Real f;
};

/// What arrives at a place, relative to `origin`. At a light's own place L is 0, so N.L is 0 and nothing
/// becomes infinite. Let u be the unit of rounding of Real, 2^-53 or 2^-24. A coordinate of L is off by at
/// most 8 u of itself, fatt by 16 u of itself (`linear`: by 8 u), and a spot's share is that of a cosine
/// within 32 u, if `at` and the light's place less `origin` are numbers of Real and further apart than 2^-50.
/// A falloff is at most 1,024 in single precision. f below 2^-100 counts as dark.
template <class Real>
[[nodiscard, gnu::always_inline]] inline Incident<Real> incident(const Lighting::Source& light,
                                                                 const Vec<Real>& at,
                                                                 const glm::dvec3& origin = glm::dvec3{0}) {
  if (!light.placed) return {splatVec<Real>(light.L), splat<Real>(light.f)};
  const Real zero = splat<Real>(0.0), one = splat<Real>(1.0);
  const Vec<Real> to = splatVec<Real>(light.position - origin) - at, L = unitOf(to);
  Incident<Real> in{L, splat<Real>(light.f)};
  if (light.constantL) {
    in.L = splatVec<Real>(light.L);
  } else {
    const Real d = root(dot(to, to));
    if (light.linear) {
      in.f = larger(zero, one - splat<Real>(light.c.x) * d);
    } else {
      const Real fall = (splat<Real>(light.c.z) * d + splat<Real>(light.c.y)) * d + splat<Real>(light.c.x);
      in.f = one / larger(fall, one);
    }
  }
  if (light.spot) {
    const Real a = zero - dot(splatVec<Real>(light.axis), L);
    const Real inner = splat<Real>(light.cosInner), outer = splat<Real>(light.cosOuter);
    const double width = light.cosInner - light.cosOuter;
    const Real between =
        smaller(one, larger(zero, (a - outer) * splat<Real>(width > 0.0 ? 1.0 / width : 0.0)));
    in.f *= a >= inner ? one : a > outer ? powerOf(between, light.falloff) : zero;
  }
  return in;
}

/// f max(0, N.L). The caller multiplies it by kd Ip.
template <class Real>
[[nodiscard, gnu::always_inline]] inline FrontBack<Real> diffuseTerm(const Incident<Real>& in,
                                                                     const Vec<Real>& N, bool twoSided) {
  const Real zero = splat<Real>(0.0), NdotL = dot(N, in.L);
  const Real front = in.f * larger(zero, NdotL);
  return {front, twoSided ? in.f * larger(zero, zero - NdotL) : front};
}

/// R.V, for the textbook's R = 2 N (N.L) - L. Of unit vectors it is off by at most 32 u, and N.H (unitOf(L +
/// V)) by 16 u where |L + V| > 2^-50 (in doubles: 2^-500). A shorter sum may count as 0.
template <class Real>
[[nodiscard, gnu::always_inline]] inline Real reflectedCosine(const Real& NdotL, const Real& NdotV,
                                                              const Real& LdotV) {
  return splat<Real>(2.0) * NdotL * NdotV - LdotV;
}

/// The cosine that is raised to the power n. It is clamped first: an even n would turn a negative cosine into
/// a highlight. A cosine below leastCosine counts as 0: its highlight is fainter than 2^-40.
template <class Real>
[[nodiscard, gnu::always_inline]] inline Real clampedCosine(const Real& cosine, const Material& material) {
  const Real some = cosine > splat<Real>(material.leastCosine) ? cosine : splat<Real>(0.0);
  return smaller(splat<Real>(1.0), some);
}

/// f max(0, R.V)^n, or with another form's cosine. The caller multiplies it by ks Ip. R is the same for N and
/// -N.
template <class Real>
[[nodiscard, gnu::always_inline]] inline FrontBack<Real> specularTerm(const Incident<Real>& in,
                                                                      const Vec<Real>& N, const Vec<Real>& V,
                                                                      const Material& material,
                                                                      const Lighting& lighting) {
  const Real zero = splat<Real>(0.0), NdotL = dot(N, in.L);
  Real cosine = zero;
  switch (lighting.form) {
    case Form::Textbook:
      cosine = reflectedCosine(NdotL, dot(N, V), dot(in.L, V));
      break;
    case Form::HalfVector: {
      const Real NdotH = dot(N, unitOf(in.L + V));
      cosine = NdotL > zero ? NdotH : zero - NdotH;
      break;
    }
    case Form::Tutorial:
      cosine = NdotL > zero ? NdotL : zero - NdotL;
      break;
  }
  const Real term = in.f * powerOf(clampedCosine(cosine, material), material.n);
  const Real front = NdotL > zero ? term : zero;
  return {front, lighting.twoSided ? (NdotL < zero ? term : zero) : front};
}

/// The terms with Lighting::mistake, times f, Ip, kd and ks, at one place. They are computed at
/// one place at a time, because their speed does not matter.
[[nodiscard]] inline LightTerms mistakenTerms(const Lighting& lighting, const Lighting::Source& light,
                                              const Incident<double>& in, const Material& material,
                                              int channel, const glm::dvec3& N, const glm::dvec3& V) {
  const Reflection surface{0.0, material.kd[channel], material.ks[channel], material.n};
  return lightTerms(lighting.mistake, in.f, light.Ip[channel], surface,
                    {.N = N, .L = {in.L.x, in.L.y, in.L.z}, .V = V}, lighting.form);
}

/// V at each place.
template <class Real>
[[nodiscard, gnu::always_inline]] inline Vec<Real> towardsEye(const Lighting& lighting, const Vec<Real>& at) {
  return lighting.constantV ? splatVec<Real>(lighting.farV) : unitOf(splatVec<Real>(lighting.eye) - at);
}

}  // namespace xnewell
