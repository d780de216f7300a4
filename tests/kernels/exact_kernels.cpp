#include "geometry/exact/int128.h"
#include "geometry/exact/plane.h"
#include "geometry/exact/power.h"
#include "geometry/exact/two_doubles.h"
#include "geometry/exact/unit.h"
#include "shading/fill/lanes.h"
#include "tests/kernels/big.h"
#include "tests/kernels/kernel.h"

namespace xnewell {

namespace {

constexpr double kMost = std::numeric_limits<double>::max();

Numbers numbersOf(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Four digits of base 2^31, the first with a sign: up to 2^124.
Int128 int128Of(const Numbers& in) {
  Int128 n = 0;
  for (const double digit : in) n = n * (Int128{1} << 31) + static_cast<std::int64_t>(digit);
  return n;
}

/// An integer whose halves of 64 bits are likely to round: a few bits at both ends of each.
Numbers roundedHalves(Random& random) {
  Int128 n = 0;
  for (int k = 0; k < 4; ++k) n += Int128{static_cast<std::int64_t>(random.below(16))} << random.below(118);
  if (random.oneIn(2)) n += (Int128{1} << random.below(120)) - 1;
  Numbers digits(4);
  for (int k = 3; k >= 0; --k, n >>= 31)
    digits[k] = static_cast<double>(static_cast<std::int64_t>(n & 0x7FFF'FFFF));
  digits[0] *= random.sign();
  return digits;
}

template <class Real>
double judgePower(const Numbers& in, const Numbers& out, double least, double denormal, double u) {
  const int n = static_cast<int>(in[1]);
  const Big exact = powerOf(big(in[0]), n);
  if (abs(exact) >= static_cast<double>(std::numeric_limits<Real>::max()) * (1 - n * u)) return 0;
  return shareOf(out[0], exact, n * u * abs(exact) + (abs(exact) < least ? Big{denormal} : Big{0}));
}

Kernel powerKernel() {
  return {.name = "power",
          .claim = "n 2^-53 of it; 2^-1068 more below 2^-1022",
          .header = "geometry/exact/power.h",
          .input = {doubles(-kMost, kMost), integers(0, 1'000'000)},
          .run =
              [](const Numbers& in) {
                const int n = static_cast<int>(in[1]);
                return Numbers{power(in[0], n), powerOf(in[0], n)};
              },
          .judge =
              [](const Numbers& in, const Numbers& out) {
                // lanes.h promises the same bits.
                if (encoded(out[0]) != encoded(out[1]) && !(std::isnan(out[0]) && std::isnan(out[1])))
                  return kWrong;
                return judgePower<double>(in, out, 0x1p-1022, 0x1p-1068, 0x1p-53);
              },
          .hard = {[](Random& random) {  // near 1, so that a large n neither overflows nor underflows
                     const double n = std::floor(random.power(0, 19.93));
                     return Numbers{1.0 + random.sign() * random.power(-53, 0) / n * 100, n};
                   },
                   [](Random& random) {  // powers of two, whose roundings all come from squarings
                     const double n = std::ldexp(1.0, static_cast<int>(random.below(20)));
                     return Numbers{1.0 + random.sign() * random.uniform(0, 2) / n, n};
                   },
                   [](Random& random) {  // a cosine
                     return Numbers{random.uniform(0, 1), std::floor(random.power(0, 12))};
                   }}};
}

Kernel singlePowerKernel() {
  return {.name = "power, single precision",
          .claim = "n 2^-24 of it, n <= 1,024; 2^-140 more below 2^-126",
          .header = "shading/fill/lanes.h",
          .input = {floats(0, 1), integers(0, 1024)},
          .run =
              [](const Numbers& in) {
                return Numbers{powerOf(static_cast<float>(in[0]), static_cast<int>(in[1]))};
              },
          .judge = [](const Numbers& in,
                      const Numbers& out) { return judgePower<float>(in, out, 0x1p-126, 0x1p-140, 0x1p-24); },
          .hard = {[](Random& random) {
            const double n = std::floor(random.power(0, 10));
            return Numbers{1.0 - random.power(-24, 4) / n, n};
          }}};
}

Kernel unitKernel() {
  return {
      .name = "unit vector",
      .claim = "2^-51 of each coordinate, and 2^-1073",
      .header = "geometry/exact/unit.h",
      .input = {doubles(-kMost, kMost), doubles(-kMost, kMost), doubles(-kMost, kMost)},
      .run =
          [](const Numbers& in) {
            return numbersOf(unit({in[0], in[1], in[2]}));
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            const BigVec exact = unitOf(bigVec(in.data()));
            const std::array parts{exact.x, exact.y, exact.z};
            double worst = 0;
            for (int k = 0; k < 3; ++k)
              worst = std::max(worst, shareOf(out[k], parts[k], 0x1p-51 * abs(parts[k]) + 0x1p-1073));
            return worst;
          },
      .hard =
          {[](Random& random) {  // of like size
             const double size = random.power(-1070, 1022);
             return Numbers{size * random.uniform(-1, 1), size * random.uniform(-1, 1),
                            size * random.uniform(-1, 1)};
           },
           [](Random& random) {  // where the two ways of unit() meet, or a square is denormal or overflows
             const double limit = random.oneIn(2) ? random.power(-540, -440) : random.power(440, 520);
             const double size = limit * random.uniform(0.5, 2);
             return Numbers{size * random.uniform(-1, 1), size * random.power(-60, 0),
                            size * random.power(-600, 0)};
           }}};
}

Kernel approximatelyKernel() {
  return {.name = "128 bits to double",
          .claim = "2^-52 of it",
          .header = "geometry/exact/int128.h",
          .input = {integers(-0x1p31 + 1, 0x1p31 - 1), integers(0, 0x1p31 - 1), integers(0, 0x1p31 - 1),
                    integers(0, 0x1p31 - 1)},
          .run = [](const Numbers& in) { return Numbers{approximately(int128Of(in))}; },
          .judge =
              [](const Numbers& in, const Numbers& out) {
                const Big exact{boost::multiprecision::cpp_int{int128Of(in)}};
                return shareOf(out[0], exact, 0x1p-52 * abs(exact));
              },
          .hard = {roundedHalves}};
}

/// How far high + low is from the exact number, as a share of the bound.
double shareOfTwo(const double* two, const Big& exact, const Big& bound) {
  const Big error = abs(big(two[0]) + big(two[1]) - exact);
  return error == 0 ? 0.0 : bound > 0 ? toDouble(error / bound) : kWrong;
}

Kernel twoDoublesOfKernel() {
  return {.name = "128 bits to two doubles",
          .claim = "2^-100 of it",
          .header = "geometry/exact/two_doubles.h",
          .input = {integers(-0x1p31 + 1, 0x1p31 - 1), integers(0, 0x1p31 - 1), integers(0, 0x1p31 - 1),
                    integers(0, 0x1p31 - 1)},
          .run =
              [](const Numbers& in) {
                const TwoDoubles n = twoDoubles(int128Of(in));
                return Numbers{n.high, n.low};
              },
          .judge =
              [](const Numbers& in, const Numbers& out) {
                const Big exact{boost::multiprecision::cpp_int{int128Of(in)}};
                return shareOfTwo(out.data(), exact, 0x1p-100 * abs(exact));
              },
          .hard = {roundedHalves},
          .directed = 1};
}

/// In an input: high x and y, and what share of 2^-52 of it is low.
Kernel twoDoublesKernel() {
  return {.name = "sum, product, quotient and root of two doubles each",
          .claim = "2^-100 of |x| + |y|, of the others themselves; 2^-76 in other modes",
          .header = "geometry/exact/two_doubles.h",
          .input = {doubles(-0x1p400, 0x1p400), doubles(-0x1p400, 0x1p400), doubles(-1, 1), doubles(-1, 1)},
          .prepare =
              [](const Numbers& in) {
                for (int k = 0; k < 2; ++k)
                  if (in[k] != 0 && std::abs(in[k]) < 0x1p-190) return Numbers{};
                const auto low = [&](int k) {
                  const double l = in[k] * 0x1p-52 * in[k + 2];
                  return std::abs(l) < 0x1p-300 ? 0.0 : l;
                };
                return Numbers{in[0], low(0), in[1], low(1)};
              },
          .run =
              [](const Numbers& in) {
                const TwoDoubles x{in[0], in[1]}, y{in[2], in[3]},
                    sum = x + y, product = x * y, quotient = y == 0 ? y : x / y, root = sqrt(abs(x));
                return Numbers{sum.high,      sum.low,      product.high, product.low,
                               quotient.high, quotient.low, root.high,    root.low};
              },
          .judge =
              [](const Numbers& in, const Numbers& out) {
                const Big x = big(in[0]) + big(in[1]), y = big(in[2]) + big(in[3]);
                const Big quotient = y == 0 ? Big{0} : Big{x / y}, root = sqrt(abs(x));
                return std::max({shareOfTwo(&out[0], x + y, 0x1p-100 * (abs(x) + abs(y))),
                                 shareOfTwo(&out[2], x * y, 0x1p-100 * abs(x * y)),
                                 shareOfTwo(&out[4], quotient, 0x1p-100 * abs(quotient)),
                                 shareOfTwo(&out[6], root, 0x1p-100 * root)});
              },
          .hard = {[](Random& random) {  // nearly opposite
                     const double x = random.sign() * random.power(-100, 100);
                     return Numbers{x, -x * (1.0 + random.sign() * random.power(-53, 0)),
                                    random.uniform(-1, 1), random.uniform(-1, 1)};
                   },
                   [](Random& random) {  // of like size
                     return Numbers{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 1),
                                    random.uniform(-1, 1)};
                   }},
          .directed = 0x1p24};
}

/// Newell's vector of `corners` points.
Kernel newellKernel(int corners) {
  Kernel kernel{
      .name = "plane: Newell's vector of " + std::to_string(corners),
      .claim = "n (n + 10) 2^-52 E^2, E from the first corner",
      .header = "geometry/exact/plane.h",
      .run =
          [](const Numbers& in) {
            std::vector<glm::dvec3> points;
            std::vector<int> listed;
            for (std::size_t k = 0; k < in.size(); k += 3) {
              points.emplace_back(in[k], in[k + 1], in[k + 2]);
              listed.push_back(static_cast<int>(k / 3));
            }
            return numbersOf(newellVector(points, listed));
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            const int n = static_cast<int>(in.size()) / 3;
            BigVec sum{0, 0, 0};
            Big extent = 0;
            const BigVec first = bigVec(in.data());
            for (int k = 0; k < n; ++k) {
              const BigVec a = bigVec(&in[3 * k]), b = bigVec(&in[3 * ((k + 1) % n)]), from = a - first;
              sum = sum + cross(a, b);
              extent = largerOf(extent, largerOf(abs(from.x), largerOf(abs(from.y), abs(from.z))));
            }
            const Big bound = n * (n + 10) * 0x1p-52 * extent * extent;
            return std::max({shareOf(out[0], sum.x, bound), shareOf(out[1], sum.y, bound),
                             shareOf(out[2], sum.z, bound)});
          },
      .hard = {[corners](Random& random) {  // near-degenerate: a point and multiples of an edge
                 Numbers in;
                 const double far = random.sign() * random.power(-20, 20), size = random.power(-20, 0);
                 double edge[3], at[3];
                 for (int axis = 0; axis < 3; ++axis)
                   at[axis] = far * random.uniform(-1, 1), edge[axis] = far * size * random.uniform(-1, 1);
                 for (int k = 0; k < corners; ++k) {
                   const double t = random.uniform(-1, 1), off = random.oneIn(2) ? 0 : random.power(-60, 0);
                   for (int axis = 0; axis < 3; ++axis)
                     in.push_back(at[axis] + t * edge[axis] + off * far * size * random.uniform(-1, 1));
                 }
                 return in;
               },
               [corners](Random& random) {  // large and like in all coordinates: nothing cancels
                 Numbers in;
                 for (int k = 0; k < 3 * corners; ++k) in.push_back(random.sign() * random.uniform(0.9, 1));
                 return in;
               }}};
  for (int k = 0; k < 3 * corners; ++k) kernel.input.push_back(doubles(-0x1p400, 0x1p400));
  kernel.prepare = [](const Numbers& in) {
    for (const double v : in)
      if (v != 0 && std::abs(v) < 0x1p-400) return Numbers{};
    return in;
  };
  return kernel;
}

}  // namespace

void addExactKernels(std::vector<Kernel>& kernels) {
  kernels.push_back(powerKernel());
  kernels.push_back(singlePowerKernel());
  kernels.push_back(unitKernel());
  kernels.push_back(approximatelyKernel());
  kernels.push_back(twoDoublesOfKernel());
  kernels.push_back(twoDoublesKernel());
  kernels.push_back(newellKernel(3));
  kernels.push_back(newellKernel(4));
}

}  // namespace xnewell
