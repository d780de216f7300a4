#include <glm/geometric.hpp>

#include "shading/light/environment.h"
#include "shading/light/reflect.h"
#include "tests/kernels/big.h"
#include "tests/kernels/kernel.h"

namespace xnewell {

namespace {

constexpr double kU = 0x1p-53;

/// Adds a unit vector along three numbers of an input, in doubles. False if they are too short or too long
/// for the square of their length.
bool addUnit(Numbers& to, const double* v) {
  const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  if (!(square > 1e-200 && square < 1e200)) return false;
  for (int k = 0; k < 3; ++k) to.push_back(v[k] / std::sqrt(square));
  return true;
}
void addUnit(Numbers& to, Random& random) {
  Numbers v;
  do {
    v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  } while (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] < 0.01);
  addUnit(to, v.data());
}
/// A unit vector near another, or near its opposite.
void addNear(Numbers& to, const double* other, Random& random) {
  const double sign = random.sign(), off = random.power(-60, 0);
  double v[3];
  for (int k = 0; k < 3; ++k) v[k] = sign * other[k] + off * random.uniform(-1, 1);
  if (!addUnit(to, v)) addUnit(to, random);
}

std::vector<Coordinate> threeVectors() { return std::vector<Coordinate>(9, doubles(-1, 1)); }
Numbers unitVectors(const Numbers& in) {
  Numbers v;
  for (int k = 0; k < 9; k += 3)
    if (!addUnit(v, &in[k])) return {};
  return v;
}
/// The same as doubles that are floats.
Numbers singleVectors(const Numbers& in) {
  Numbers v = unitVectors(in);
  for (double& part : v) part = static_cast<float>(part);
  return v;
}
const std::vector<std::function<Numbers(Random&)>> kVectors{[](Random& random) {
  Numbers v;
  addUnit(v, random);
  random.oneIn(2) ? addUnit(v, random) : addNear(v, &v[0], random);
  random.oneIn(2) ? addUnit(v, random) : addNear(v, &v[3], random);
  return v;
}};

template <class Real>
Vec<Real> vecOf(const double* v) {
  return {static_cast<Real>(v[0]), static_cast<Real>(v[1]), static_cast<Real>(v[2])};
}
glm::dvec3 glmOf(const double* v) { return {v[0], v[1], v[2]}; }

/// R.V of the exact R = 2 N (N.L) - L.
Big exactRV(const Numbers& in) {
  const BigVec N = bigVec(&in[0]), L = bigVec(&in[3]), V = bigVec(&in[6]);
  return 2 * dot(N, L) * dot(N, V) - dot(L, V);
}
/// N.H; empty where L + V is so short that its square may underflow.
std::optional<Big> exactNH(const Numbers& in, double least) {
  const BigVec N = bigVec(&in[0]), H = bigVec(&in[3]) + bigVec(&in[6]);
  const Big length = lengthOf(H);
  if (length < least) return std::nullopt;
  return Big{dot(N, H) / length};
}

void addCosines(std::vector<Kernel>& kernels) {
  const auto rv = [](double bound) {
    return [bound](const Numbers& in, const Numbers& out) {
      double worst = 0;
      for (const double cosine : out) worst = std::max(worst, shareOf(cosine, exactRV(in), bound));
      return worst;
    };
  };
  const auto nh = [](double bound, double least) {
    return [bound, least](const Numbers& in, const Numbers& out) {
      const std::optional<Big> exact = exactNH(in, least);
      double worst = 0;
      for (const double cosine : out) worst = std::max(worst, exact ? shareOf(cosine, *exact, bound) : 0.0);
      return worst;
    };
  };
  kernels.push_back(
      {.name = "R.V",
       .claim = "2^-48",
       .header = "shading/light/reflect.h, equation.h",
       .input = threeVectors(),
       .prepare = unitVectors,
       .run =
           [](const Numbers& in) {
             const auto N = vecOf<double>(&in[0]), L = vecOf<double>(&in[3]), V = vecOf<double>(&in[6]);
             return Numbers{reflectedCosine(dot(N, L), dot(N, V), dot(L, V)),
                            specularCosine(Form::Textbook, glmOf(&in[0]), glmOf(&in[3]), glmOf(&in[6]))};
           },
       .judge = rv(0x1p-48),
       .hard = kVectors});
  kernels.push_back({.name = "R.V, single precision",
                     .claim = "2^-19",
                     .header = "shading/light/reflect.h",
                     .input = threeVectors(),
                     .prepare = singleVectors,
                     .run =
                         [](const Numbers& in) {
                           const auto N = vecOf<float>(&in[0]), L = vecOf<float>(&in[3]),
                                      V = vecOf<float>(&in[6]);
                           return Numbers{reflectedCosine(dot(N, L), dot(N, V), dot(L, V))};
                         },
                     .judge = rv(0x1p-19),
                     .hard = kVectors});
  kernels.push_back(
      {.name = "N.H",
       .claim = "2^-49 where |L + V| > 2^-500",
       .header = "shading/light/reflect.h, equation.h",
       .input = threeVectors(),
       .prepare = unitVectors,
       .run =
           [](const Numbers& in) {
             const auto N = vecOf<double>(&in[0]), L = vecOf<double>(&in[3]), V = vecOf<double>(&in[6]);
             return Numbers{dot(N, unitOf(L + V)),
                            specularCosine(Form::HalfVector, glmOf(&in[0]), glmOf(&in[3]), glmOf(&in[6]))};
           },
       .judge = nh(0x1p-49, 0x1p-500),
       .hard = kVectors});
  kernels.push_back({.name = "N.H, single precision",
                     .claim = "2^-20 where |L + V| > 2^-50",
                     .header = "shading/light/reflect.h",
                     .input = threeVectors(),
                     .prepare = singleVectors,
                     .run =
                         [](const Numbers& in) {
                           const auto N = vecOf<float>(&in[0]), L = vecOf<float>(&in[3]),
                                      V = vecOf<float>(&in[6]);
                           return Numbers{dot(N, unitOf(L + V))};
                         },
                     .judge = nh(0x1p-20, 0x1p-50),
                     .hard = kVectors});
}

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
  light.inner = in[kSpot], light.outer = in[kSpot + 1], light.falloff = static_cast<int>(in[kSpot + 2]);
  light.direction = glmOf(&in[kAxis]);
  light.position = glmOf(&in[kPosition]);
  return light;
}

template <class Real>
Numbers incidentOf(const Numbers& in) {
  Mesh mesh;
  mesh.points = {glmOf(&in[kPlace])};
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
  // fatt may be at either end of its bound.
  const auto missed = [&](const Big& f) {
    if (f <= 0) return Big{out[3] == 0 ? 0 : 4};
    const double share = std::min(1.0, toDouble(big(out[3]) / f));
    return cosineMissed(light, cosine, share);
  };
  const Big least = smallerOf(missed(fatt), smallerOf(missed(fatt + bound), missed(fatt - bound)));
  return std::max(worst, toDouble(least / (32 * u)));
}

Kernel incidentKernel(bool single) {
  const Coordinate size = single ? floats(-1024, 1024) : doubles(-0x1p40, 0x1p40), part = doubles(-1, 1);
  const double u = single ? 0x1p-24 : kU;
  Kernel kernel{
      .name = single ? "light that arrives, single precision" : "light that arrives",
      .claim = single ? "L 2^-21, fatt 2^-20 of it; a cosine 2^-19 off"
                      : "L 2^-50, fatt 2^-49 of it; a cosine 2^-48 off",
      .header = "shading/light/reflect.h",
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

/// The rotated environment map of one light at one place of the map.
Kernel environmentKernel() {
  constexpr std::size_t kL = 5;
  return {
      .name = "environment map, rotated",
      .claim = "2^-24 + n 2^-43, where |x, y| <= 1",
      .header = "shading/light/environment.h",
      .input = {integers(0, 255), integers(0, 255), integers(0, 1), integers(0, 1'000'000), doubles(0, 1),
                doubles(-1, 1), doubles(-1, 1), doubles(-1, 1)},
      .prepare =
          [](const Numbers& in) {
            Numbers v(in.begin(), in.begin() + kL);
            const double x = in[0] - 127.5, y = in[1] - 127.5;
            return x * x + y * y <= 127 * 127 && addUnit(v, &in[kL]) ? v : Numbers{};
          },
      .run =
          [](const Numbers& in) {
            Mesh mesh;
            mesh.points = {{0, 0, 0}};
            const Illumination user{.Ia = 0,
                                    .Ip = 1,
                                    .kd = in[4],
                                    .ks = 1 - in[4],
                                    .n = static_cast<int>(in[3]),
                                    .light = glmOf(&in[kL])};
            const Lighting lighting = resolve(mesh, {}, user, Channels::Luminance, {0, 0, 5}, {0, 0, 0});
            const Environment map = makeEnvironment(EnvironmentForm::Rotated, lighting, lighting.materials[0],
                                                    0, glm::dmat3{1.0}, {0, 0, 0});
            return Numbers{(in[2] > 0 ? map.front : map.away)[static_cast<std::size_t>(256 * in[1] + in[0])]};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            const Big x = (big(in[0]) - 127.5) / 127, y = (big(in[1]) - 127.5) / 127;
            const int n = static_cast<int>(in[3]);
            const Big kd = big(in[4]), ks = big(1 - in[4]);
            Big exact = 0;
            if (in[2] > 0) {
              const Big z = sqrt(1 - x * x - y * y);
              if (z > 0) exact = kd * z + ks * powerOf(z, n);
            }
            return shareOf(out[0], exact, Big{0x1p-24 + n * 0x1p-43});
          },
      .hard = {[](Random& random) {
        Numbers in{std::floor(random.uniform(0, 256)), std::floor(random.uniform(0, 256)), 1,
                   std::floor(random.power(0, 19.9)), random.uniform(0, 1)};
        const double a = random.uniform(0, 6.3);
        if (random.oneIn(2)) {  // at the rim
          in[0] = std::round(127.5 + 126.5 * std::cos(a));
          in[1] = std::round(127.5 + 126.5 * std::sin(a));
        }
        addUnit(in, random);
        return in;
      }},
      .effort = 0.01};
}

}  // namespace

void addLightKernels(std::vector<Kernel>& kernels) {
  kernels.push_back(attenuationKernel());
  kernels.push_back(spotKernel());
  kernels.push_back(incidentKernel(false));
  kernels.push_back(incidentKernel(true));
  addCosines(kernels);
  kernels.push_back(environmentKernel());
}

}  // namespace xnewell
