#include <glm/geometric.hpp>

#include "shading/fill/environment.h"
#include "shading/fill/environment_map.h"
#include "shading/fill/evaluate_pixels.h"
#include "shading/fill/reflect.h"
#include "tests/kernels/big.h"
#include "tests/kernels/unit_vectors.h"

namespace xnewell {

namespace {

constexpr double kSingle = 0x1p-24;

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
       .header = "shading/fill/reflect.h, equation.h",
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
                     .header = "shading/fill/reflect.h",
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
       .header = "shading/fill/reflect.h, equation.h",
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
                     .header = "shading/fill/reflect.h",
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

/// The rotated environment map of one light at one place of the map.
Kernel environmentKernel() {
  constexpr std::size_t kL = 5;
  return {
      .name = "environment map, rotated",
      .claim = "2^-24 + n 2^-43, where |x, y| <= 1",
      .header = "shading/fill/environment.h",
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
            mesh.material = {-1};  // lights that no face reflects are left out
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

/// The column of an environment map for a component of a normal.
Kernel lookUpKernel() {
  return {
      .name = "environment look-up",
      .claim = "2^-24 of a column",
      .header = "shading/fill/environment_map.h",
      .input = {doubles(-1, 1)},
      .run =
          [](const Numbers& in) {
            static const std::vector<std::uint8_t> columns = [] {
              std::vector<std::uint8_t> cells(65'536);
              for (std::size_t k = 0; k < cells.size(); ++k) cells[k] = static_cast<std::uint8_t>(k % 256);
              return cells;
            }();
            const AffineValue column{valueSteps(128.0 + 127.0 * in[0]), 0, 0};
            const EnvironmentMap map{column, {128u << 24, 0, 0}, columns.data()};
            std::array<std::uint8_t, 9> cells{};
            map.span(cells.data(), 0, 0, 9);
            return Numbers{static_cast<double>(cells[0]), static_cast<double>(cells[8])};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            if (out[0] != out[1]) return kWrong;
            const Big place = 128 + 127 * big(in[0]);
            return toDouble(largerOf(0, largerOf(big(out[0]) - place, place - big(out[0]) - 1)) / 0x1p-24);
          },
      .hard = {[](Random& random) {
        return Numbers{(static_cast<double>(random.integer(1, 255)) - 128) / 127 +
                       random.sign() * random.power(-40, -28)};
      }}};
}

/// Phong's sum at a pixel with far lights, where N, L and V are the same at all pixels: the shortest way
/// through FarLightsRow. In an input: n, N, L, V.
Kernel phongKernel() {
  Kernel kernel{
      .name = "Phong's sum, single precision",
      .claim = "(8 + 32 n) 2^-24, and 2^-40, n <= 1,024",
      .header = "shading/fill/evaluated.h",
      .input = std::vector<Coordinate>(10, doubles(-1, 1)),
      .prepare =
          [](const Numbers& in) {
            Numbers v{in[0]};
            for (int k = 1; k < 10; k += 3) {
              const double length = std::sqrt(in[k] * in[k] + in[k + 1] * in[k + 1] + in[k + 2] * in[k + 2]);
              if (!(length > 1e-10)) return Numbers{};
              for (int axis = 0; axis < 3; ++axis) v.push_back(in[k + axis] / length);
            }
            return v;
          },
      .run =
          [](const Numbers& in) {
            using Real = Lanes<float, 8>;
            Mesh mesh;
            mesh.points = {{0, 0, 0}};
            mesh.material = {-1};  // lights that no face reflects are left out
            const Illumination user{.Ia = 0.25,
                                    .Ip = 0.75,
                                    .ka = 0.5,
                                    .kd = 0.5,
                                    .ks = 0.5,
                                    .n = static_cast<int>(in[0]),
                                    .light = {in[4], in[5], in[6]},
                                    .constantV = true};
            const Lighting lighting =
                resolve(mesh, {}, user, Channels::Luminance, {in[7], in[8], in[9]}, {0, 0, 0});
            PhongTriangle t;
            t.lighting = &lighting, t.material = &lighting.materials[0];
            for (int axis = 0; axis < 3; ++axis) t.N[axis] = {in[1 + axis], 0, 0};
            const TexelRow<Real> texels{t, 0};
            double sum = 0;
            withRow<Real>(t, 0, [&](auto row) {
              const Real along{};
              row.evaluate(&along, 1, texels);
              sum = row.sum(0)[0];
            });
            return Numbers{sum};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            const BigVec N = unitOf(bigVec(&in[1])), L = unitOf(bigVec(&in[4])), V = unitOf(bigVec(&in[7]));
            const int n = static_cast<int>(in[0]);
            const Big NdotL = dot(N, L), RdotV = 2 * NdotL * dot(N, V) - dot(L, V);
            // The highlight begins at once where N.L = 0.
            if (abs(NdotL) < 0x1p-20) return 0.0;
            Big exact = 0.125;
            if (NdotL > 0) exact += 0.375 * NdotL + 0.375 * powerOf(largerOf(0, RdotV), n);
            return shareOf(out[0], exact, Big{(8 + 32 * n) * kSingle + 0x1p-40});
          },
      .hard = {[](Random& random) {
        Numbers in{std::floor(random.power(0, 10))};
        for (int k = 0; k < 6; ++k) in.push_back(random.uniform(-1, 1));
        // Near the mirror's direction.
        const double along = 2 * (in[1] * in[4] + in[2] * in[5] + in[3] * in[6]) /
                             (in[1] * in[1] + in[2] * in[2] + in[3] * in[3] + 1e-9);
        const double off = random.power(-20, 0);
        for (int k = 0; k < 3; ++k) in.push_back(along * in[1 + k] - in[4 + k] + off * random.uniform(-1, 1));
        const double most = std::max({1.0, std::abs(in[7]), std::abs(in[8]), std::abs(in[9])});
        for (int k = 7; k < 10; ++k) in[k] /= most;
        return in;
      }}};
  kernel.input[0] = integers(1, 1024);
  return kernel;
}

}  // namespace

void addSpecularKernels(std::vector<Kernel>& kernels) {
  addCosines(kernels);
  kernels.push_back(phongKernel());
  kernels.push_back(environmentKernel());
  kernels.push_back(lookUpKernel());
}

}  // namespace xnewell
