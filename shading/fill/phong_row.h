#pragma once

#include <algorithm>
#include <array>

#include "geometry/exact/scale.h"
#include "shading/fill/pixel_row.h"
#include "shading/fill/reflect.h"
#include "shading/fill/texel_row.h"

namespace xnewell {

/// Phong's illumination along a row, for any lights.
template <class Real>
class PhongRow {
 public:
  [[gnu::always_inline]] PhongRow(const PhongTriangle& t, double down)
      : t_{t}, N_{t.N, down}, V_{t.V, down}, at_{t.at, down}, q_{t.q, down} {}
  /// As in TermRow, and so is `sum`.
  [[gnu::always_inline]] void evaluate(const Real* along, int blocks, const TexelRow<Real>& texels) {
    const Lighting& lighting = *t_.lighting;
    const Material& material = *t_.material;
    const Real ambient = splat<Real>(material.ambient[t_.channel]), one = splat<Real>(1.0);
    const Vec<Real> farV = splatVec<Real>(lighting.farV);
    Vec<Real> N[kMostBlocks], V[kMostBlocks], at[kMostBlocks];
    Real share[kMostBlocks];
    for (int b = 0; b < blocks; ++b) {
      N[b] = t_.unitN ? unitOf(N_.at(along[b])) : N_.at(along[b]);
      V[b] = t_.variesV ? unitOf(V_.at(along[b])) : farV;
      if (t_.placed) at[b] = at_.at(along[b]) * (one / q_.at(along[b]));
      share[b] = texels ? texels.share(b) : one;
      sum_[b] = ambient;
    }
    for (const Lighting::Source& light : lighting.sources) {
      const double Ip = light.Ip[t_.channel];
      const Real kd = splat<Real>(Ip * material.kd[t_.channel]),
                 ks = splat<Real>(Ip * material.ks[t_.channel]);
      const Incident<Real> everywhere = incident(light, Vec<Real>{});
      for (int b = 0; b < blocks; ++b) {
        const Incident<Real> in = t_.placed ? incident(light, at[b], t_.origin) : everywhere;
        sum_[b] += kd * diffuseTerm(in, N[b], false).front * share[b];
        if (material.ks[t_.channel] != 0.0)
          sum_[b] += ks * specularTerm(in, N[b], V[b], material, lighting).front;
      }
    }
  }
  [[nodiscard, gnu::always_inline]] Real sum(int b) const { return sum_[b]; }

 private:
  const PhongTriangle& t_;
  RowOfThree<Real> N_, V_, at_;
  RowOf<Real> q_;
  Real sum_[kMostBlocks];
};

/// Phong's illumination along a row with a mistake in the equation, pixel by pixel.
template <class Real>
class MistakenRow {
 public:
  [[gnu::always_inline]] MistakenRow(const PhongTriangle& t, double down)
      : t_{t}, N_{t.N, down}, V_{t.V, down}, at_{t.at, down}, q_{t.q, down} {}
  /// As in TermRow, and so is `sum`.
  void evaluate(const Real* along, int blocks, const TexelRow<Real>& texels) {
    for (int b = 0; b < blocks; ++b) {
      const Vec<Real> N = N_.at(along[b]), V = V_.at(along[b]), at = at_.at(along[b]);
      const Real q = q_.at(along[b]), share = texels ? texels.share(b) : splat<Real>(1.0);
      for (int k = 0; k < kLanes<Real>; ++k)
        sum_[b][k] = static_cast<Number<Real>>(sumAt(lane(N, k), lane(V, k), lane(at, k), q[k], share[k]));
    }
  }
  [[nodiscard, gnu::always_inline]] Real sum(int b) const { return sum_[b]; }

 private:
  [[nodiscard]] static glm::dvec3 lane(const Vec<Real>& v, int k) { return {v.x[k], v.y[k], v.z[k]}; }
  [[nodiscard]] double sumAt(const glm::dvec3& N, const glm::dvec3& towardsEye, const glm::dvec3& overDepth,
                             double q, double share) const {
    const Lighting& lighting = *t_.lighting;
    const glm::dvec3 V = t_.variesV ? unit(towardsEye) : lighting.farV;
    const glm::dvec3 at = t_.placed ? overDepth / q : glm::dvec3{0.0};
    double sum = t_.material->ambient[t_.channel];
    for (const Lighting::Source& light : lighting.sources) {
      const Incident<double> in = incident<double>(light, {at.x, at.y, at.z}, t_.origin);
      const LightTerms terms =
          mistakenTerms(lighting, light, in, *t_.material, t_.channel, t_.unitN ? unit(N) : N, V);
      sum += terms.diffuse * share + terms.specular;
    }
    return sum;
  }

  const PhongTriangle& t_;
  RowOfThree<Real> N_, V_, at_;
  RowOf<Real> q_;
  Real sum_[kMostBlocks];
};

/// 1 / |v| from the square of v. A square that is too small for the number type is replaced by the least one.
template <class Real>
[[gnu::always_inline]] inline Real perLength(const Real& square) {
  constexpr double kLeast = sizeof(Number<Real>) == sizeof(float) ? 1e-37 : 1e-307;
  return splat<Real>(1.0) / root(larger(square, splat<Real>(kLeast)));
}

/// Whether FarLightsRow can evaluate the triangle: all lights far away, the textbook's cosine, n at least 1.
[[nodiscard]] inline bool isOfFarLights(const PhongTriangle& t) {
  return !t.placed && t.lighting->form == Form::Textbook && t.material->n > 0;
}

/// What a highlight needs of the eye: nothing, one direction, or one for each pixel.
enum class Eye { None, Far, Near };

/// Phong's illumination along a row where all lights are far away. Before N is made a unit vector, N.L is a
/// plane too, and so is L.V. So each pixel needs only the lengths of the vectors, and N.V. @see Duff 1979
template <class Real, Eye kEye>
class FarLightsRow {
 public:
  [[gnu::always_inline]] FarLightsRow(const PhongTriangle& t, double down)
      : t_{t}, down_{down}, N_{t.N, down} {
    if constexpr (kEye == Eye::Near) V_ = {t.V, down};
  }
  /// As in TermRow, and so is `sum`.
  [[gnu::always_inline]] void evaluate(const Real* along, int blocks, const TexelRow<Real>& texels) {
    const Lighting& lighting = *t_.lighting;
    const Material& material = *t_.material;
    Real perN[kMostBlocks], perV[kMostBlocks], NdotV[kMostBlocks], cosine[kMostBlocks], share[kMostBlocks];
    const Real ambient = splat<Real>(material.ambient[t_.channel]);
    const Real zero = splat<Real>(0.0), one = splat<Real>(1.0);
    const RowOf<Real> towardsFarV = rowOfDot(t_.N, lighting.farV);
    for (int b = 0; b < blocks; ++b) {
      const Vec<Real> N = N_.at(along[b]);
      perN[b] = t_.unitN ? perLength(dot(N, N)) : one;
      if constexpr (kEye == Eye::Near) {
        const Vec<Real> V = V_.at(along[b]);
        perV[b] = perLength(dot(V, V));
        NdotV[b] = dot(N, V) * perN[b] * perV[b];
      }
      if constexpr (kEye == Eye::Far) NdotV[b] = towardsFarV.at(along[b]) * perN[b];
      sum_[b] = ambient;
      share[b] = texels ? texels.share(b) : one;
    }
    for (const Lighting::Source& light : lighting.sources) {
      const double I = light.f * light.Ip[t_.channel];
      const Real kd = splat<Real>(I * material.kd[t_.channel]), ks = splat<Real>(I * material.ks[t_.channel]);
      const RowOf<Real> facing = rowOfDot(t_.N, light.L), LdotVs = rowOfDot(t_.V, light.L);
      const Real farLdotV = splat<Real>(glm::dot(light.L, lighting.farV));
      for (int b = 0; b < blocks; ++b) {
        const Real NdotL = smaller(one, facing.at(along[b]) * perN[b]);  // also where |N| is almost 0
        const Real diffuse = kd * larger(zero, NdotL);
        sum_[b] += texels ? diffuse * share[b] : diffuse;
        if constexpr (kEye != Eye::None) {
          const Real LdotV = kEye == Eye::Near ? LdotVs.at(along[b]) * perV[b] : farLdotV;
          const Real lit = clampedCosine(reflectedCosine(NdotL, NdotV[b], LdotV), material);
          cosine[b] = NdotL > zero ? lit : zero;
        }
      }
      if constexpr (kEye != Eye::None) {
        int b = 0;
        for (; b + 4 <= blocks; b += 4) addPowers<4>(&cosine[b], material.n, ks, &sum_[b]);
        for (; b < blocks; ++b) addPowers<1>(&cosine[b], material.n, ks, &sum_[b]);
      }
    }
  }
  [[nodiscard, gnu::always_inline]] Real sum(int b) const { return sum_[b]; }

 private:
  [[nodiscard, gnu::always_inline]] RowOf<Real> rowOfDot(const std::array<PixelPlane, 3>& p,
                                                         const glm::dvec3& v) const {
    const auto dotted = [&](double PixelPlane::*part) {
      return p[0].*part * v.x + p[1].*part * v.y + p[2].*part * v.z;
    };
    return {{dotted(&PixelPlane::c), dotted(&PixelPlane::gx), dotted(&PixelPlane::gy)}, down_};
  }
  /// Takes `count` blocks at once, so that there is one loop over the bits of n.
  template <int count>
  [[gnu::always_inline]] static void addPowers(const Real* cosine, int n, const Real& ks, Real* sum) {
    std::array<Real, count> x, power;
    const auto each = [&] [[gnu::always_inline]] (const auto& step) {
      for (int k = 0; k < count; ++k) step(k);
    };
    each([&](int k) { x[k] = cosine[k]; });
    for (; (n & 1) == 0; n >>= 1) each([&](int k) { x[k] *= x[k]; });
    power = x;
    for (n >>= 1; n > 0; n >>= 1) {
      each([&](int k) { x[k] *= x[k]; });
      if (n & 1) each([&](int k) { power[k] *= x[k]; });
    }
    each([&](int k) { sum[k] += ks * power[k]; });
  }

  const PhongTriangle& t_;
  double down_;
  RowOfThree<Real> N_, V_;
  Real sum_[kMostBlocks];
};

}  // namespace xnewell
