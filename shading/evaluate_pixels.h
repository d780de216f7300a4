#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "shading/evaluated.h"
#include "shading/reflect.h"

/// How EvaluatedTriangle is evaluated, several pixels side by side. Templates that are inlined whole, so that
/// each caller compiles them for its processor.

template <class Real>
using IntegersOf = Lanes<int, kLanes<Real>>;

/// The values of a plane, or of three, along a row. Made once for all its pixels, as everything below that
/// they have in common.
template <class Real>
struct RowOf {
  Real c, gx;
  [[gnu::always_inline]] RowOf(const PixelPlane& plane, double down)
      : c{splat<Real>(plane.c + plane.gy * down)}, gx{splat<Real>(plane.gx)} {}
  /// At pixels `along` right of i0.
  [[gnu::always_inline]] Real at(const Real& along) const { return c + gx * along; }
};
template <class Real>
struct RowOfThree {
  RowOf<Real> x, y, z;
  [[gnu::always_inline]] RowOfThree(const std::array<PixelPlane, 3>& p, double down)
      : x{p[0], down}, y{p[1], down}, z{p[2], down} {}
  [[gnu::always_inline]] Vec<Real> at(const Real& along) const {
    return {x.at(along), y.at(along), z.at(along)};
  }
};

/// The largest whole number not above v, |v| < 2^23.
template <class Real>
[[gnu::always_inline]] inline Real wholePart(const Real& v) {
  if constexpr (std::is_floating_point_v<Real>) {
    return std::floor(v);
  } else {
    Real whole;
    for (int k = 0; k < kLanes<Real>; ++k) whole[k] = std::floor(v[k]);  // an instruction, where there is one
    return whole;
  }
}

/// Where the texels at coordinates (u, v) stand in a channel of the texture: always within it, also for lanes
/// past the end of a span, where 1 / w may have crossed 0 and the coordinates are anything. (One comparison
/// of places costs a tenth of a texel less than bounds for both coordinates.)
template <class Real>
[[gnu::always_inline]] inline auto placesOf(const Texture& texture, const Real& u, const Real& v) {
  const Real s = u - wholePart(u), t = splat<Real>(1.0) - (v - wholePart(v));  // t runs down, in (0, 1]
  const Real width = splat<Real>(texture.width), height = splat<Real>(texture.height);
  const Real column = smaller(s * width, width - splat<Real>(1.0));
  const Real row = smaller(t * height, height - splat<Real>(1.0));
  if constexpr (std::is_floating_point_v<Real>) {
    return static_cast<int>(row) * texture.width + static_cast<int>(column);
  } else {
    using Places = Lanes<unsigned, kLanes<Real>>;
    const auto whole = [](const Real& x) {
      return reinterpret_cast<Places>(__builtin_convertvector(x, IntegersOf<Real>));
    };
    const Places last = Places{} + static_cast<unsigned>(texture.width * texture.height - 1);
    const Places place = whole(row) * static_cast<unsigned>(texture.width) + whole(column);
    return place < last ? place : last;
  }
}

/// As many pixels are evaluated together, step by step: what a step needs stays in registers.
constexpr int kMostBlocks = 8;

/// The illumination at `blocks` times kLanes pixels. `kPlaced`: whether a light asks where they are.
template <class Real, bool kPlaced>
[[gnu::always_inline]] inline void evaluatePhong(const EvaluatedTriangle& t, const Real* along, double down,
                                                 int blocks, Real* diffuse, Real* rest) {
  const Lighting& lighting = *t.lighting;
  const Material& material = *t.material;
  const bool shiny = material.ks[t.channel] != 0.0;
  Vec<Real> N[kMostBlocks], V[kMostBlocks];
  const RowOfThree<Real> normals{t.N, down};
  const Real ambient = splat<Real>(material.ambient[t.channel]);
  for (int b = 0; b < blocks; ++b) {
    N[b] = unitOf(normals.at(along[b]));
    diffuse[b] = splat<Real>(0.0);
    rest[b] = ambient;
  }
  const Vec<Real> farV = splatVec<Real>(lighting.farV);
  if (shiny && t.variesV) {
    const RowOfThree<Real> towardsEye{t.V, down};
    for (int b = 0; b < blocks; ++b) V[b] = unitOf(towardsEye.at(along[b]));
  }
  for (const Lighting::Source& light : lighting.sources) {
    const Real kd = splat<Real>(light.Ip[t.channel] * material.kd[t.channel]);
    const Real ks = splat<Real>(light.Ip[t.channel] * material.ks[t.channel]);
    const auto reflect = [&] [[gnu::always_inline]] (int b, const Incident<Real>& in) {
      diffuse[b] += kd * diffuseTerm(in, N[b], false).front;
      if (shiny) rest[b] += ks * specularTerm(in, N[b], t.variesV ? V[b] : farV, material, lighting).front;
    };
    if constexpr (kPlaced) {
      const RowOfThree<Real> places{t.at, down};
      const RowOf<Real> q{t.q, down};
      for (int b = 0; b < blocks; ++b)
        reflect(b, incident(light, places.at(along[b]) * (splat<Real>(1.0) / q.at(along[b]))));
    } else {
      const Incident<Real> everywhere = incident(light, Vec<Real>{});
      for (int b = 0; b < blocks; ++b) reflect(b, everywhere);
    }
  }
}

/// The texels at places, in registers all the way: bytes that were stored one by one would keep a load of
/// all of them waiting.
template <class Real>
[[gnu::always_inline]] inline Real texelsAt(const std::uint8_t* texels, const int* places) {
  if constexpr (std::is_floating_point_v<Real>) {
    return texels[places[0]];
  } else {
    IntegersOf<Real> at;
    for (int k = 0; k < kLanes<Real>; ++k) at[k] = texels[places[k]];
    return __builtin_convertvector(at, Real);
  }
}

/// The diffuse terms times their texels, as shares of 1. Places first, then all look-ups, then all products.
template <class Real>
[[gnu::always_inline]] inline void multiplyByTexels(const EvaluatedTriangle& t, const Real* along,
                                                    double down, int blocks, Real* diffuse) {
  constexpr int kSideBySide = kLanes<Real>;
  std::array<int, kMostBlocks * kSideBySide> places;
  const RowOf<Real> u{t.u, down}, v{t.v, down}, q{t.q, down};
  for (int b = 0; b < blocks; ++b) {
    const Real w = splat<Real>(1.0) / q.at(along[b]);
    const auto at = placesOf(*t.texture, u.at(along[b]) * w, v.at(along[b]) * w);
    std::memcpy(&places[b * kSideBySide], &at, sizeof at);
  }
  for (int b = 0; b < blocks; ++b)
    diffuse[b] *= texelsAt<Real>(t.texels, &places[b * kSideBySide]) * splat<Real>(1.0 / 255.0);
}

/// The sum of all terms there. `kPhong`: whether the illumination is evaluated or its terms interpolated.
template <class Real, bool kPhong>
[[gnu::always_inline]] inline void evaluatePixels(const EvaluatedTriangle& t, const Real* along, double down,
                                                  int blocks, Real* sum) {
  Real diffuse[kMostBlocks], rest[kMostBlocks];
  if constexpr (kPhong) {
    if (t.placed)
      evaluatePhong<Real, true>(t, along, down, blocks, diffuse, rest);
    else
      evaluatePhong<Real, false>(t, along, down, blocks, diffuse, rest);
  } else {
    const RowOf<Real> diffuseTerms{t.diffuse, down}, otherTerms{t.rest, down};
    for (int b = 0; b < blocks; ++b) {
      diffuse[b] = diffuseTerms.at(along[b]);
      rest[b] = otherTerms.at(along[b]);
    }
  }
  if (t.texture != nullptr) multiplyByTexels(t, along, down, blocks, diffuse);
  for (int b = 0; b < blocks; ++b) sum[b] = rest[b] + diffuse[b];
}

/// The ramp's cells, a byte a lane; of its lowest where the sum is not a number, past the end of a span.
template <class Real>
[[gnu::always_inline]] inline void storeCells(const Ramp& ramp, const Real* sum, int blocks,
                                              std::uint8_t* bytes) {
  constexpr int kSideBySide = kLanes<Real>;
  std::array<int, kMostBlocks * kSideBySide> whole;
  const auto store = [&](int b, const Real& value) {
    const auto cut = __builtin_convertvector(value, IntegersOf<Real>);
    std::memcpy(&whole[b * kSideBySide], &cut, sizeof cut);
  };
  const int count = blocks * kSideBySide;
  if (ramp.table != nullptr) {
    const Real zero = splat<Real>(0.0), one = splat<Real>(1.0);
    for (int b = 0; b < blocks; ++b) store(b, smaller(larger(sum[b], zero), one) * splat<Real>(65535.0));
    for (int k = 0; k < count; ++k) bytes[k] = ramp.table[whole[k]];
    return;
  }
  const Real low = splat<Real>(ramp.low), high = splat<Real>(ramp.high);
  const Real perIntensity = splat<Real>(ramp.perIntensity()), first = splat<Real>(ramp.first + 0.5);
  for (int b = 0; b < blocks; ++b)
    store(b, first + perIntensity * (smaller(larger(sum[b], low), high) - low));
  for (int k = 0; k < count; ++k) bytes[k] = static_cast<std::uint8_t>(whole[k]);
}

template <class Real, bool kPhong>
[[gnu::always_inline]] inline void fillPixels(const EvaluatedTriangle& t, std::uint8_t* cells, int i, int j,
                                              int count) {
  constexpr int kSideBySide = kLanes<Real>;
  constexpr int kMost = kMostBlocks * kSideBySide;
  Real lane;
  for (int k = 0; k < kSideBySide; ++k) lane[k] = static_cast<Number<Real>>(k);
  IntegersOf<Real> above{};
  const auto fill = [&] [[gnu::always_inline]] (int from, int pixels, int blocks) {
    Real along[kMostBlocks], sum[kMostBlocks];
    const Real first = splat<Real>(i + from - t.i0) + lane;
    for (int b = 0; b < blocks; ++b) along[b] = first + splat<Real>(b * kSideBySide);
    evaluatePixels<Real, kPhong>(t, along, j - t.j0, blocks, sum);
    for (int b = 0; b < blocks; ++b) {
      auto clamped = sum[b] > splat<Real>(1.0);
      if (pixels < blocks * kSideBySide) clamped &= lane < splat<Real>(pixels - b * kSideBySide);
      above -= __builtin_convertvector(clamped, IntegersOf<Real>);
    }
    std::array<std::uint8_t, kMost> bytes;
    storeCells(t.ramp, sum, blocks, bytes.data());
    std::memcpy(cells + from, bytes.data(), static_cast<std::size_t>(pixels));
  };
  // Of whole blocks by themselves: how many steps there are is known when they are compiled.
  int done = 0;
  for (; count - done >= kMost; done += kMost) fill(done, kMost, kMostBlocks);
  if (done < count) fill(done, count - done, (count - done + kSideBySide - 1) / kSideBySide);
  for (int l = 0; l < kSideBySide; ++l) *t.clamped += above[l];
}
