#include <glm/geometric.hpp>

#include "shading/fill/reflect.h"
#include "tests/kernels/big.h"
#include "tests/kernels/kernel.h"
#include "tests/kernels/unit_vectors.h"

namespace xnewell {

namespace {

/// In an input: kind of attenuation, d, unit, range, c1, c2, c3.
Light attenuated(const Numbers& in) {
  Light light{.kind = LightKind::Point, .attenuation = kAttenuations[static_cast<std::size_t>(in[0])].id};
  light.range = in[3];
  light.c = {in[4], in[5], in[6]};
  return light;
}
/// fatt at the distance d.
Big exactAttenuation(const Light& light, const Big& d, double unit) {
  const Big u = d / big(unit);
  switch (light.attenuation) {
    case Attenuation::None:
      break;
    case Attenuation::Inverse:
      return 1 / largerOf(1, u);
    case Attenuation::InverseSquare:
      return 1 / largerOf(1, u * u);
    case Attenuation::Linear:
      return largerOf(0, 1 - d / big(light.range));
    case Attenuation::Textbook:
      return 1 / largerOf(1, big(light.c[0]) + big(light.c[1]) * d + big(light.c[2]) * d * d);
  }
  return 1;
}
Numbers randomAttenuation(Random& random) {
  const double size = random.power(-30, 30);
  return {static_cast<double>(random.below(5)),
          size,
          size * random.power(-20, 2),
          size * (random.oneIn(2) ? 1 + random.power(-50, 2) : random.power(-2, 10)),
          random.oneIn(3) ? 0 : random.uniform(0, 1),
          random.oneIn(3) ? 0 : random.power(-5, 5) / size,
          random.oneIn(3) ? 0 : random.power(-5, 5) / size / size};
}

Kernel attenuationKernel() {
  const Coordinate positive = doubles(1e-300, 1e300), zeroOrMore = doubles(0, 1e300);
  return {.name = "attenuation",
          .claim = "2^-50 of it, and 2^-1022; linear: 2^-51",
          .header = "shading/light/equation.h",
          .input = {integers(0, 4), zeroOrMore, positive, positive, zeroOrMore, zeroOrMore, zeroOrMore},
          .run = [](const Numbers& in) { return Numbers{attenuation(attenuated(in), in[1], in[2])}; },
          .judge =
              [](const Numbers& in, const Numbers& out) {
                const Light light = attenuated(in);
                const Big exact = exactAttenuation(light, big(in[1]), in[2]);
                const bool linear = light.attenuation == Attenuation::Linear;
                return shareOf(out[0], exact, linear ? Big{0x1p-51} : 0x1p-50 * exact + 0x1p-1022);
              },
          .hard = {randomAttenuation}};
}

Big exactShare(const Light& light, const Big& cosine) {
  const Big inner = cos(big(light.inner) * degree()), outer = cos(big(light.outer) * degree());
  if (cosine >= inner) return 1;
  return cosine <= outer ? Big{0} : powerOf(Big{(cosine - outer) / (inner - outer)}, light.falloff);
}

/// How far a cosine must be from the exact one for this share of a spot. A share below 2^-100 counts as 0:
/// a power may underflow, or be rounded up from 0.
Big cosineMissed(const Light& light, const Big& cosine, double share) {
  const Big inner = cos(big(light.inner) * degree()), outer = cos(big(light.outer) * degree());
  if (share >= 1) return largerOf(0, (light.falloff > 0 ? inner : outer) - cosine);
  if (share < 0x1p-100) {
    const Big most =
        light.falloff > 0 && inner > outer ? Big{(inner - outer) * exp(Big{-69} / light.falloff)} : Big{0};
    return largerOf(0, cosine - outer - most);
  }
  if (light.falloff == 0) return 2;  // between 0 and 1 is impossible
  const Big between = exp(log(big(share)) / light.falloff);
  return abs(outer + (inner - outer) * between - cosine);
}

/// In an input: inner, outer, falloff, axis, L.
Light spotOf(const Numbers& in) {
  return {.kind = LightKind::Spot,
          .direction = glmOf(&in[3]),
          .inner = in[0],
          .outer = in[1],
          .falloff = static_cast<int>(in[2])};
}
Numbers preparedSpot(const Numbers& in) {
  Numbers v{std::min(in[0], in[1]), std::max(in[0], in[1]), in[2]};
  if (!addUnit(v, &in[3]) || !addUnit(v, &in[6])) return {};
  return v;
}
/// L at an angle near the cones.
Numbers randomSpot(Random& random) {
  const double inner = random.oneIn(3) ? random.uniform(0, 180) : random.uniform(0, 60);
  const double outer = std::min(180.0, inner + random.power(-40, 6));
  Numbers in{inner, outer, std::floor(random.oneIn(2) ? random.uniform(0, 8) : random.power(0, 19.9))};
  addUnit(in, random);
  const glm::dvec3 axis = glmOf(&in[3]);
  Numbers other;
  addUnit(other, random);
  const glm::dvec3 across = glm::cross(axis, glmOf(other.data()));
  const double length = glm::length(across);
  const double between = random.oneIn(3)   ? random.power(-50, 0)
                         : random.oneIn(2) ? 1 - random.power(-50, 0)
                                           : random.uniform(-0.2, 1.2);
  const double a = (outer + (inner - outer) * between) * 3.141592653589793 / 180;
  const glm::dvec3 L = length > 0 ? -(std::cos(a) * axis + std::sin(a) / length * across) : -axis;
  in.insert(in.end(), {L.x, L.y, L.z});
  return in;
}

Kernel spotKernel() {
  return {.name = "share of a spot",
          .claim = "that of a cosine within 2^-48",
          .header = "shading/light/equation.h",
          .input = {doubles(0, 180), doubles(0, 180), integers(0, 1'000'000), doubles(-1, 1), doubles(-1, 1),
                    doubles(-1, 1), doubles(-1, 1), doubles(-1, 1), doubles(-1, 1)},
          .prepare = preparedSpot,
          .run = [](const Numbers& in) { return Numbers{spotShare(spotOf(in), glmOf(&in[6]))}; },
          .judge =
              [](const Numbers& in, const Numbers& out) {
                const Big cosine = -dot(unitOf(bigVec(&in[3])), bigVec(&in[6]));
                if (!(out[0] >= 0 && out[0] <= 1)) return kWrong;
                return toDouble(cosineMissed(spotOf(in), cosine, out[0]) / 0x1p-48);
              },
          .hard = {randomSpot},
          .effort = 0.3};
}

/// A light at a place as the program meets it: resolve(), then incident(). In an input: as attenuated(), then
/// inner, outer, falloff, axis, the light's position, the place. d is not used.
constexpr std::size_t kSpot = 7, kAxis = 10, kPosition = 13, kPlace = 16;

Light lightOf(const Numbers& in) {
  Light light = attenuated(in);
  light.kind = in[1] < 1 ? LightKind::Point : LightKind::Spot;
  light.Ip = glm::dvec3{1};
  light.inner = in[kSpot], light.outer = in[kSpot + 1], light.falloff = static_cast<int>(in[kSpot + 2]);
  light.direction = glmOf(&in[kAxis]);
  light.position = glmOf(&in[kPosition]);
  return light;
}

template <class Real>
Numbers incidentOf(const Numbers& in) {
  Mesh mesh;
  mesh.points = {glmOf(&in[kPlace])};
  mesh.material = {-1};  // lights that no face reflects are left out
  const Lighting lighting = resolve(mesh, {.Ia = {}, .lights = {lightOf(in)}, .unit = in[2]}, {},
                                    Channels::Luminance, {0, 0, 5}, {0, 0, 0});
  if (lighting.sources.empty()) return {0, 0, 0, 0};
  const Incident<Real> arrives = incident(lighting.sources[0], vecOf<Real>(&in[kPlace]));
  return {arrives.L.x, arrives.L.y, arrives.L.z, arrives.f};
}

/// u is the unit of rounding: the bounds are 8 u of each part of L, 16 u of fatt (linear: 8 u), and a cosine
/// 32 u off.
double judgeIncident(const Numbers& in, const Numbers& out, double u) {
  const Light light = lightOf(in);
  const BigVec to = bigVec(&in[kPosition]) - bigVec(&in[kPlace]), L = unitOf(to);
  const Big d = lengthOf(to);
  const Big fatt = exactAttenuation(light, d, in[2]);
  if (out[3] == 0 && fatt < 4 * u) return 0;  // resolve() leaves out a light that does not reach the place
  double worst = 0;
  if (out[3] != 0) {
    worst = std::max({shareOf(out[0], L.x, 8 * u * abs(L.x) + u * u),
                      shareOf(out[1], L.y, 8 * u * abs(L.y) + u * u),
                      shareOf(out[2], L.z, 8 * u * abs(L.z) + u * u)});
  }
  const bool linear = light.attenuation == Attenuation::Linear;
  const Big bound = linear ? Big{8 * u} : 16 * u * fatt;
  if (light.kind != LightKind::Spot) return std::max(worst, shareOf(out[3], fatt, bound));
  const Big cosine = -dot(unitOf(bigVec(&in[kAxis])), L);
  if (out[3] < 0x1p-100) return worst;  // it counts as dark
  // fatt may be anywhere within its bound, so the share lies in an interval.
  const Big least = big(out[3]) / (fatt + bound), low = fatt - bound;
  const Big most = low > big(out[3]) ? Big{big(out[3]) / low} : Big{1};
  const Big exact = exactShare(light, cosine);
  if (least <= exact && exact <= most) return worst;
  const Big missed =
      smallerOf(cosineMissed(light, cosine, toDouble(least)), cosineMissed(light, cosine, toDouble(most)));
  return std::max(worst, toDouble(missed / (32 * u)));
}

Kernel incidentKernel(bool single) {
  const Coordinate size = single ? floats(-1024, 1024) : doubles(-0x1p40, 0x1p40), part = doubles(-1, 1);
  const double u = single ? 0x1p-24 : kU;
  Kernel kernel{
      .name = single ? "light that arrives, single precision" : "light that arrives",
      .claim = single ? "L 2^-21, fatt 2^-20 of it; a cosine 2^-19 off"
                      : "L 2^-50, fatt 2^-49 of it; a cosine 2^-48 off",
      .header = "shading/fill/reflect.h",
      .input = {integers(0, 4), doubles(0, 2), doubles(1e-3, 1e3), doubles(1e-3, 1e6), doubles(0, 1e3),
                doubles(0, 1e3), doubles(0, 1e3), doubles(0, 180), doubles(0, 180),
                integers(0, single ? 1024 : 1'000'000), part, part, part, size, size, size, size, size, size},
      .prepare =
          [](const Numbers& in) {
            Numbers v = in;
            if (v[kSpot] > v[kSpot + 1]) std::swap(v[kSpot], v[kSpot + 1]);
            Numbers axis;
            if (!addUnit(axis, &in[kAxis])) return Numbers{};
            std::ranges::copy(axis, v.begin() + kAxis);
            double square = 0;
            for (int k = 0; k < 3; ++k) {
              const double to = v[kPosition + k] - v[kPlace + k];
              square += to * to;
            }
            // Nearer, the square of the distance underflows in single precision.
            return square > 0x1p-100 ? v : Numbers{};
          },
      .run = single ? incidentOf<float> : incidentOf<double>,
      .judge = [u](const Numbers& in, const Numbers& out) { return judgeIncident(in, out, u); },
      .hard = {[](Random& random) {
        Numbers in = randomAttenuation(random);
        const double far = random.oneIn(4) ? random.power(0, 35) : random.power(-3, 4);
        for (int k = 2; k <= 3; ++k) in[k] = far * random.power(-3, 3);
        in[1] = random.uniform(0, 2);
        in[5] = random.power(-5, 5) / far, in[6] = random.power(-5, 5) / far / far;
        const Numbers spot = randomSpot(random);
        in.insert(in.end(), spot.begin(), spot.begin() + 6);
        Numbers place;
        for (int k = 0; k < 3; ++k) place.push_back(static_cast<float>(random.uniform(-2, 2)));
        for (int k = 0; k < 3; ++k) in.push_back(static_cast<float>(place[k] + far * spot[6 + k]));
        in.insert(in.end(), place.begin(), place.end());
        return in;
      }},
      .effort = 0.3};
  return kernel;
}

}  // namespace

void addLightKernels(std::vector<Kernel>& kernels) {
  kernels.push_back(attenuationKernel());
  kernels.push_back(spotKernel());
  kernels.push_back(incidentKernel(false));
  kernels.push_back(incidentKernel(true));
}

}  // namespace xnewell
