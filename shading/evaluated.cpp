#include "shading/evaluated.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "shading/dispatch.h"
#include "shading/reflect.h"

namespace {

/// As AffineOver: a triangle narrower than 2^-12 pixel has the gradients of the snap.
constexpr double kSteepest = 0x1p12;

constexpr int kMostForSingle = 1024;  ///< n

template <class Real>
using IntegersOf = Lanes<int, kLanes<Real>>;

/// Values of a plane at a row's pixels, `along` of them right of i0 and `down` rows below j0.
template <class Real>
[[gnu::always_inline]] inline Real on(const PixelPlane& plane, const Real& along, double down) {
  return splat<Real>(plane.c + plane.gy * down) + splat<Real>(plane.gx) * along;
}
template <class Real>
[[gnu::always_inline]] inline Vec<Real> on(const std::array<PixelPlane, 3>& p, const Real& along,
                                           double down) {
  return {on(p[0], along, down), on(p[1], along, down), on(p[2], along, down)};
}

/// The largest whole number not above v, |v| < 2^23.
template <class Real>
[[gnu::always_inline]] inline Real wholePart(const Real& v) {
  if constexpr (std::is_floating_point_v<Real>) {
    return std::floor(v);
  } else {
    const Real cut = __builtin_convertvector(__builtin_convertvector(v, IntegersOf<Real>), Real);
    return cut > v ? cut - splat<Real>(1.0) : cut;
  }
}

/// The texels at coordinates (u, v), as shares of 1.
template <class Real>
[[gnu::always_inline]] inline Real texels(const Texture& texture, const std::uint8_t* from, const Real& u,
                                          const Real& v) {
  const auto texel = [&](double s, double t) {
    const int column = std::min(texture.width - 1, static_cast<int>(s * texture.width));
    const int row = std::min(texture.height - 1, static_cast<int>((1.0 - t) * texture.height));
    return static_cast<Number<Real>>(from[texture.index(column, row)]) / Number<Real>{255};
  };
  const Real s = u - wholePart(u), t = v - wholePart(v);
  if constexpr (std::is_floating_point_v<Real>) {
    return texel(s, t);
  } else {
    Real r;
    for (int k = 0; k < kLanes<Real>; ++k) r[k] = texel(s[k], t[k]);
    return r;
  }
}

/// The sum of all terms. `kPhong`: whether the illumination is evaluated here or its terms interpolated.
template <class Real, bool kPhong>
[[gnu::always_inline]] inline Real intensityAt(const EvaluatedTriangle& t, const Real& along, double down) {
  Real diffuse, rest;
  if constexpr (kPhong) {
    const Lighting& lighting = *t.lighting;
    const Vec<Real> N = unitOf(on(t.N, along, down));
    Vec<Real> at{}, V{};
    if (lighting.needsPlaces()) at = on(t.at, along, down);
    const bool specular = t.material->ks[t.channel] > 0.0;
    if (specular) V = towardsEye(lighting, at);
    diffuse = splat<Real>(0.0);
    rest = splat<Real>(t.material->ambient[t.channel]);
    for (const Lighting::Source& light : lighting.sources) {
      const Incident<Real> in = incident(light, at);
      const double Ip = light.Ip[t.channel];
      diffuse += splat<Real>(Ip * t.material->kd[t.channel]) * diffuseTerm(in, N, false).front;
      if (specular)
        rest +=
            splat<Real>(Ip * t.material->ks[t.channel]) * specularTerm(in, N, V, *t.material, lighting).front;
    }
  } else {
    diffuse = on(t.diffuse, along, down);
    rest = on(t.rest, along, down);
  }
  if (t.texture != nullptr) {
    const Real w = splat<Real>(1.0) / on(t.q, along, down);
    diffuse *= texels(*t.texture, t.texels, on(t.u, along, down) * w, on(t.v, along, down) * w);
  }
  return rest + diffuse;
}

template <class Real, bool kPhong>
[[gnu::always_inline]] inline void fill(const EvaluatedTriangle& t, std::uint8_t* cells, int i, int j,
                                        int count) {
  constexpr int kSideBySide = kLanes<Real>;
  Real lane;
  for (int k = 0; k < kSideBySide; ++k) lane[k] = static_cast<Number<Real>>(k);
  const Real zero = splat<Real>(0.0), one = splat<Real>(1.0);
  const double down = j - t.j0;
  IntegersOf<Real> above{};
  for (int done = 0; done < count; done += kSideBySide) {
    const Real along = splat<Real>(i + done - t.i0) + lane;
    const Real sum = intensityAt<Real, kPhong>(t, along, down);
    const Real I = smaller(one, larger(zero, sum));
    const auto within = lane < splat<Real>(count - done);
    above -= __builtin_convertvector((sum > one) & within, IntegersOf<Real>);
    std::array<std::uint8_t, kSideBySide> bytes;
    if (t.ramp.table != nullptr) {
      const auto k = __builtin_convertvector(I * splat<Real>(65536.0), IntegersOf<Real>);
      for (int l = 0; l < kSideBySide; ++l) bytes[l] = t.ramp.table[std::min(k[l], 65535)];
    } else {
      const double low = t.ramp.low;
      const Real inside = smaller(splat<Real>(t.ramp.high), larger(splat<Real>(low), I));
      const Real cell =
          splat<Real>(t.ramp.first + 0.5) + splat<Real>(t.ramp.perIntensity()) * (inside - splat<Real>(low));
      const auto k = __builtin_convertvector(cell, IntegersOf<Real>);
      for (int l = 0; l < kSideBySide; ++l) bytes[l] = static_cast<std::uint8_t>(k[l]);
    }
    std::memcpy(cells + done, bytes.data(), std::min(kSideBySide, count - done));
  }
  for (int l = 0; l < kSideBySide; ++l) *t.clamped += above[l];
}

XNEWELL_DISPATCHED
void fillSingle(const EvaluatedTriangle& t, std::uint8_t* cells, int i, int j, int count) {
  if (t.phong)
    fill<Lanes<float, 8>, true>(t, cells, i, j, count);
  else
    fill<Lanes<float, 8>, false>(t, cells, i, j, count);
}

XNEWELL_DISPATCHED
void fillDouble(const EvaluatedTriangle& t, std::uint8_t* cells, int i, int j, int count) {
  fill<Lanes<double, 4>, true>(t, cells, i, j, count);
}

}  // namespace

PixelPlanes::PixelPlanes(const std::array<glm::ivec3, 3>& p)
    : i0_{sampleFrom(std::min({p[0].x, p[1].x, p[2].x}))},
      j0_{sampleFrom(std::min({p[0].y, p[1].y, p[2].y}))} {
  const auto pixels = [](std::int64_t steps) { return static_cast<double>(steps) / kGrid; };
  const auto centre = [](int i) { return std::int64_t{i} * kGrid + kGrid / 2; };
  x0_ = pixels(p[0].x - centre(i0_)), y0_ = pixels(p[0].y - centre(j0_));
  x1_ = pixels(std::int64_t{p[1].x} - p[0].x), y1_ = pixels(std::int64_t{p[1].y} - p[0].y);
  x2_ = pixels(std::int64_t{p[2].x} - p[0].x), y2_ = pixels(std::int64_t{p[2].y} - p[0].y);
  const double area = x1_ * y2_ - x2_ * y1_;
  const double longest = std::max({std::abs(x1_), std::abs(y1_), std::abs(x2_), std::abs(y2_)});
  perArea_ = std::abs(area) * kSteepest > longest ? 1.0 / area : 0.0;
}

PixelPlane PixelPlanes::operator()(const std::array<double, 3>& v) const {
  if (perArea_ == 0.0) return {(v[0] + v[1] + v[2]) / 3.0, 0.0, 0.0};
  const double d1 = v[1] - v[0], d2 = v[2] - v[0];
  const double gx = (d1 * y2_ - d2 * y1_) * perArea_, gy = (d2 * x1_ - d1 * x2_) * perArea_;
  return {v[0] - gx * x0_ - gy * y0_, gx, gy};
}

void EvaluatedTriangle::span(std::uint8_t* cells, int i, int j, int count) const {
  if (phong && material->n > kMostForSingle)
    fillDouble(*this, cells, i, j, count);
  else
    fillSingle(*this, cells, i, j, count);
}

double EvaluatedTriangle::intensity(int i, int j) const {
  const double along = i - i0, down = j - j0;
  return phong ? intensityAt<double, true>(*this, along, down)
               : intensityAt<double, false>(*this, along, down);
}
