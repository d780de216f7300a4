#include "shading/fill/environment_map.h"
#include "shading/fill/evaluate_pixels.h"
#include "shading/fill/scanline.h"
#include "tests/kernels/big.h"
#include "tests/kernels/kernel.h"

namespace xnewell {

namespace {

constexpr double kU = 0x1p-53, kSingle = 0x1p-24;
constexpr double kReach = 0x1p29;

/// A triangle on the screen, then where in it: two shares of its edges. Prepared: the triangle, turned
/// counter-clockwise, then the pixel whose centre is in it.
constexpr std::size_t kPlace = 6, kPixel = 6, kOthers = 8;
std::vector<Coordinate> triangleInput() {
  std::vector<Coordinate> input(6, integers(-kReach, kReach));
  input.push_back(doubles(0, 1));
  input.push_back(doubles(0, 1));
  return input;
}
std::array<glm::ivec3, 3> triangleOf(const Numbers& in) {
  std::array<glm::ivec3, 3> p;
  for (int k = 0; k < 3; ++k) p[k] = {static_cast<int>(in[2 * k]), static_cast<int>(in[2 * k + 1]), 0};
  return p;
}
Numbers preparedTriangle(const Numbers& in) {
  Numbers v = in;
  std::array<glm::ivec3, 3> p = triangleOf(v);
  const std::int64_t area = doubleArea(p.data(), 3);
  if (area == 0) return {};
  if (area < 0) {
    std::swap(v[2], v[4]), std::swap(v[3], v[5]);
    p = triangleOf(v);
  }
  double a = in[kPlace], b = in[kPlace + 1];
  if (a + b > 1) a = 1 - a, b = 1 - b;
  const auto pixel = [&](int axis) {
    const double from = v[axis], at = from + a * (v[2 + axis] - from) + b * (v[4 + axis] - from);
    return std::clamp(std::floor(at / kGrid), 0.0, kMaxPicture - 1.0);
  };
  v[kPixel] = pixel(0), v[kPixel + 1] = pixel(1);
  for (int k = 0; k < 3; ++k) {
    const glm::ivec3 &from = p[k], &to = p[(k + 1) % 3];
    const Int128 x = Int128{static_cast<int>(v[kPixel])} * kGrid + kGrid / 2,
                 y = Int128{static_cast<int>(v[kPixel + 1])} * kGrid + kGrid / 2;
    if ((to.y - from.y) * (x - from.x) - (to.x - from.x) * (y - from.y) < 0) return {};
  }
  return v;
}
Numbers randomTriangle(Random& random) {
  Numbers in;
  const double size = random.oneIn(3) ? 0x1p29 : random.power(10, 29);
  const double x = random.uniform(0, 0x1p29), y = random.uniform(0, 0x1p29);
  for (int k = 0; k < 3; ++k) {
    in.push_back(std::clamp(std::round(x + size * random.uniform(-1, 1)), -kReach, kReach));
    in.push_back(std::clamp(std::round(y + size * random.uniform(-1, 1)), -kReach, kReach));
  }
  if (random.oneIn(3)) {  // a needle: a corner near the line through the others
    const double t = random.uniform(0, 1), off = random.power(0, 20);
    for (int axis = 0; axis < 2; ++axis)
      in[4 + axis] =
          std::clamp(std::round(in[axis] + t * (in[2 + axis] - in[axis]) + off * random.uniform(-1, 1)),
                     -kReach, kReach);
  }
  for (int k = 0; k < 2; ++k) in.push_back(random.oneIn(3) ? random.power(-40, 0) : random.uniform(0, 1));
  return in;
}
/// The exact weights of the corners at the centre of the pixel.
std::array<Big, 3> weightsAt(const Numbers& in) {
  const Big x = big(in[kPixel]) * kGrid + kGrid / 2, y = big(in[kPixel + 1]) * kGrid + kGrid / 2;
  std::array<Big, 3> w;
  Big sum = 0;
  for (int k = 0; k < 3; ++k) {
    const std::size_t a = 2 * ((k + 1) % 3), b = 2 * ((k + 2) % 3);
    w[k] = (big(in[b]) - x) * (big(in[a + 1]) - y) - (big(in[a]) - x) * (big(in[b + 1]) - y);
    sum += w[k];
  }
  for (Big& weight : w) weight /= sum;
  return w;
}
Big mean(const std::array<Big, 3>& weights, const double* v) {
  return weights[0] * big(v[0]) + weights[1] * big(v[1]) + weights[2] * big(v[2]);
}
/// (largest x - least x, largest y - least y), in pixels.
std::array<double, 2> extentOf(const Numbers& in) {
  const auto [left, right] = std::minmax({in[0], in[2], in[4]});
  const auto [top, bottom] = std::minmax({in[1], in[3], in[5]});
  return {(right - left) / kGrid, (bottom - top) / kGrid};
}

Kernel affineKernel() {
  Kernel kernel{
      .name = "affine increments",
      .claim = "(1/2 + 2^-7) (w + h) + 1 steps of 2^-24",
      .header = "shading/fill/affine.h",
      .input = triangleInput(),
      .prepare = preparedTriangle,
      .run =
          [](const Numbers& in) {
            const auto p = triangleOf(in);
            const AffineValue value = affineOver(p.data(), {in[kOthers], in[kOthers + 1], in[kOthers + 2]});
            return Numbers{
                static_cast<double>(value.at(static_cast<int>(in[kPixel]), static_cast<int>(in[kPixel + 1]))),
                double(value.gx), double(value.gy)};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            const double* const v = &in[kOthers];
            // Where it is steep, it is the mean everywhere.
            const Big x1 = big(in[2]) - big(in[0]), y1 = big(in[3]) - big(in[1]),
                      x2 = big(in[4]) - big(in[0]), y2 = big(in[5]) - big(in[1]);
            const Big d1 = big(v[1]) - big(v[0]), d2 = big(v[2]) - big(v[0]), D = x1 * y2 - x2 * y1;
            const Big steepest = largerOf(abs(d1 * y2 - d2 * y1), abs(d2 * x1 - d1 * x2)) / abs(D) * kGrid;
            if (steepest > 0x1p20 * (1 - 1e-6)) return 0.0;
            const auto [w, h] = extentOf(in);
            // Modulo 2^32 the value may be taken on either side.
            Big error = big(out[0]) - mean(weightsAt(in), v) * 0x1p24;
            if (error > 0x1p31) error -= 0x1p32;
            if (error < -0x1p31) error += 0x1p32;
            return toDouble(abs(error)) / ((0.5 + 0x1p-7) * (w + h) + 1);
          },
      .hard = {[](Random& random) {
        Numbers in = randomTriangle(random);
        const int kind = static_cast<int>(random.below(3));
        const double near = random.uniform(1, 255);
        for (int k = 0; k < 3; ++k)
          in.push_back(kind == 0   ? random.uniform(kLeastValue, kLargestValue)
                       : kind == 1 ? (random.oneIn(2) ? kLeastValue : kLargestValue)
                                   : near + random.uniform(0, 0x1p-20));
        return in;
      }}};
  for (int k = 0; k < 3; ++k) kernel.input.push_back(doubles(kLeastValue, kLargestValue));
  return kernel;
}

/// The first sample at an edge, in a row far below its start.
Kernel edgeKernel() {
  return {.name = "walk along an edge",
          .claim = "exact",
          .header = "shading/fill/scanline.h",
          .input = {integers(-kReach, kReach), integers(-kReach, kReach), integers(-kReach, kReach),
                    integers(-kReach, kReach), integers(0, kMaxPicture - 1)},
          .prepare =
              [](const Numbers& in) {
                Numbers v = in;
                if (v[1] > v[3]) std::swap(v[0], v[2]), std::swap(v[1], v[3]);
                const int first = std::max(0, sampleFrom(static_cast<int>(v[1]))),
                          end = std::min(kMaxPicture, sampleFrom(static_cast<int>(v[3])));
                if (first >= end) return Numbers{};
                v[4] = first + std::fmod(v[4], end - first);
                v.push_back(first);
                return v;
              },
          .run =
              [](const Numbers& in) {
                EdgeWalk edge{{static_cast<int>(in[0]), static_cast<int>(in[1]), 0},
                              {static_cast<int>(in[2]), static_cast<int>(in[3]), 0},
                              static_cast<int>(in[5])};
                for (int row = static_cast<int>(in[5]); row < static_cast<int>(in[4]); ++row) edge.nextRow();
                return Numbers{static_cast<double>(edge.column())};
              },
          .judge =
              [](const Numbers& in, const Numbers& out) {
                const auto integer = [](double v) { return Int128{static_cast<std::int64_t>(v)}; };
                const Int128 dx = integer(in[2]) - integer(in[0]), dy = integer(in[3]) - integer(in[1]);
                const Int128 yc = integer(in[4]) * kGrid + kGrid / 2;
                // The crossing, in grid steps from the centre of column 0, is n / dy.
                const Int128 n = (integer(in[0]) - kGrid / 2) * dy + (yc - integer(in[1])) * dx;
                const Int128 divisor = dy * kGrid;
                Int128 column = n / divisor;
                if (n - column * divisor > 0) ++column;
                if (integer(out[0]) != column) return kWrong;
                // Hard are the crossings at a sample, and those just right of one.
                const Int128 beyond = n - (column - 1) * divisor;
                const Int128 apart = std::min(beyond, divisor - beyond);
                // The rounding of the step grows from row to row.
                const double rows = (in[4] - in[5] + 1) / kMaxPicture;
                return 0.9 * rows / (1 + static_cast<double>(apart) / static_cast<double>(divisor) * 0x1p30);
              },
          .hard = {[](Random& random) {
                     const double dy = random.oneIn(2) ? 0x1p30 : std::round(random.power(8, 30));
                     const double top = std::round(random.uniform(-kReach, kReach - dy));
                     return Numbers{std::round(random.uniform(-kReach, kReach)), top,
                                    std::round(random.uniform(-kReach, kReach)), top + dy,
                                    std::floor(random.uniform(0, 8192))};
                   },
                   [](Random& random) {  // through the centres of two pixels, or one step beside one
                     const auto centre = [&] {
                       return static_cast<double>(random.integer(0, 8191)) * kGrid + kGrid / 2;
                     };
                     return Numbers{centre() + static_cast<double>(random.integer(-1, 1)), centre(),
                                    centre() + static_cast<double>(random.integer(-1, 1)), centre(),
                                    std::floor(random.uniform(0, 8192))};
                   },
                   [](Random& random) {  // the crossing is 1/dy grid steps right of a sample, dy nearly 2^30
                     const double dy = 0x1p30 - 1 - 2 * static_cast<double>(random.below(1000)),
                                  top = -0x1p29 + static_cast<double>(random.below(2000));
                     const auto row = static_cast<std::int64_t>(random.below(8192));
                     const std::int64_t down = row * kGrid + kGrid / 2 - static_cast<std::int64_t>(top),
                                        d = static_cast<std::int64_t>(dy);
                     // dx = (k d + 1) / down modulo d, by trying multiples of d.
                     std::int64_t dx = random.integer(-(1 << 28), 1 << 28);
                     for (int k = 0; k < 64; ++k) {
                       const Int128 rest = (Int128{dx} * down) % (Int128{d} * kGrid);
                       if (rest >= 0 && rest < d / 4) break;
                       ++dx;
                     }
                     const double left = static_cast<double>(random.integer(0, 4000)) * kGrid + kGrid / 2;
                     return Numbers{left, top, std::clamp(left + static_cast<double>(dx), -kReach, kReach),
                                    std::min(top + dy, kReach), static_cast<double>(row)};
                   }},
          .directed = 1};
}

/// Values of three corners over their depths, divided by 1 / w at a pixel. Prepared: the triangle and pixel,
/// three values, three of 1 / w, three values over w.
void addDepths(Kernel& kernel, double least, double most) {
  for (int k = 0; k < 3; ++k) kernel.input.push_back(doubles(least, most));
  for (int k = 0; k < 3; ++k) kernel.input.push_back(doubles(0x1p-20, 1));
  kernel.prepare = [](const Numbers& in) {
    Numbers v = preparedTriangle(in);
    if (v.empty()) return v;
    for (int k = 0; k < 3; ++k) v.push_back(v[kOthers + k] * v[kOthers + 3 + k]);
    return v;
  };
}
Numbers randomDepths(Random& random, double least, double most) {
  Numbers in = randomTriangle(random);
  for (int k = 0; k < 3; ++k) in.push_back(random.uniform(least, most));
  const double deep = random.oneIn(2) ? 1 : random.power(0, 20);
  for (int k = 0; k < 3; ++k) in.push_back(k == 0 ? 1 : 1 / random.uniform(1, 1 + deep));
  return in;
}
PixelPlane planeAt(const PixelPlanes& planes, const double* v) { return planes({v[0], v[1], v[2]}); }

/// The bound of a plane's value, as in pixel_row.h. Empty for a sliver.
std::optional<Big> offOf(const Numbers& in, const double* v, double u) {
  const Big x1 = (big(in[2]) - big(in[0])) / kGrid, y1 = (big(in[3]) - big(in[1])) / kGrid;
  const Big x2 = (big(in[4]) - big(in[0])) / kGrid, y2 = (big(in[5]) - big(in[1])) / kGrid;
  const Big area = abs(x1 * y2 - x2 * y1), areaTerms = abs(x1 * y2) + abs(x2 * y1);
  const Big longest = largerOf(largerOf(abs(x1), abs(y1)), largerOf(abs(x2), abs(y2)));
  if (area * 0x1p12 < longest * (1 + 1e-9)) return std::nullopt;
  const auto [w, h] = extentOf(in);
  const Big d1 = abs(big(v[1]) - big(v[0])), d2 = abs(big(v[2]) - big(v[0]));
  const Big gx = (d1 * abs(y2) + d2 * abs(y1)) / area, gy = (d2 * abs(x1) + d1 * abs(x2)) / area;
  const Big terms = abs(big(v[0])) + gx * (w + 1) + gy * (h + 1);
  return 8 * u * terms + 32 * kU * terms * areaTerms / area;
}

/// The values that PixelPlanes and RowOf give for Real: over w, and 1 / w.
template <class Real>
Numbers dividedValue(const Numbers& in) {
  const PixelPlanes planes{triangleOf(in)};
  const double down = in[kPixel + 1] - planes.j0();
  const Real along = splat<Real>(in[kPixel] - planes.i0());
  const RowOf<Real> a{planeAt(planes, &in[kOthers + 6]), down}, q{planeAt(planes, &in[kOthers + 3]), down};
  const Real value = a.at(along) * (splat<Real>(1.0) / q.at(along));
  return {static_cast<double>(value[0])};
}

/// The bound of the quotient, where 1 / w is known to a tenth.
std::optional<Big> quotientOff(const Numbers& in, const Big& value, const Big& q, double u) {
  const std::optional<Big> a = offOf(in, &in[kOthers + 6], u), b = offOf(in, &in[kOthers + 3], u);
  if (!a || !b || *b * 10 > q) return std::nullopt;
  return Big{(*a + abs(value) * *b) / (q - *b) + 3 * u * abs(value) + 0x1p-110};
}

Kernel divisionKernel(bool single) {
  const double u = single ? kSingle : kU;
  Kernel kernel{.name = single ? "perspective division, single precision" : "perspective division",
                .claim = "that of both planes (pixel_row.h), 3 u of it",
                .header = "shading/fill/pixel_row.h",
                .input = triangleInput(),
                .run = single ? dividedValue<Lanes<float, 8>> : dividedValue<Lanes<double, 4>>,
                .judge =
                    [u](const Numbers& in, const Numbers& out) {
                      const auto weights = weightsAt(in);
                      const Big q = mean(weights, &in[kOthers + 3]),
                                exact = mean(weights, &in[kOthers + 6]) / q;
                      const std::optional<Big> bound = quotientOff(in, exact, q, u);
                      return bound ? shareOf(out[0], exact, *bound) : 0.0;
                    },
                .hard = {[](Random& random) { return randomDepths(random, -1, 1); }}};
  addDepths(kernel, -1024, 1024);
  return kernel;
}

/// The texel that a pixel shows, in a texture of 16 x 16 whose texels all differ.
constexpr int kSide = 16;
const Texture& allDifferent() {
  static const Texture texture = [] {
    Texture t{.width = kSide, .height = kSide, .channel = {}, .gray = {}};
    for (int k = 0; k < kSide * kSide; ++k) t.gray.push_back(static_cast<std::uint8_t>(k));
    return t;
  }();
  return texture;
}
template <class Real>
Numbers texelOf(const Numbers& in) {
  // v of the texture is 1 - u, so that both are searched at once.
  const PixelPlanes planes{triangleOf(in)};
  TermsTriangle t;
  t.i0 = planes.i0(), t.j0 = planes.j0();
  t.texture = &allDifferent(), t.texels = t.texture->gray.data();
  t.q = planeAt(planes, &in[kOthers + 3]), t.u = planeAt(planes, &in[kOthers + 6]), t.v = t.u;
  t.repeats = in.back() > 0;
  const double down = in[kPixel + 1] - t.j0;
  TexelRow<Real> row{t, down};
  const Real along = splat<Real>(in[kPixel] - t.i0);
  row.locate(&along, 1);
  const double texel = std::round(255 * static_cast<double>(row.share(0)[0]));
  return {std::fmod(texel, kSide), std::floor(texel / kSide)};
}
Kernel texelKernel(bool single) {
  const double u = single ? kSingle : kU;
  Kernel kernel{
      .name = single ? "texture place, single precision" : "texture place",
      .claim = "the division's bound, and 3 roundings of the width",
      .header = "shading/fill/texel_row.h",
      .input = triangleInput(),
      .run = single ? texelOf<Lanes<float, 8>> : texelOf<Lanes<double, 4>>,
      .judge =
          [u](const Numbers& in, const Numbers& out) {
            const auto weights = weightsAt(in);
            const Big q = mean(weights, &in[kOthers + 3]), s = mean(weights, &in[kOthers + 6]) / q;
            const std::optional<Big> off = quotientOff(in, s, q, u);
            if (!off || *off * 4 > 1) return 0.0;
            const Big bound = (*off + 3 * u) * kSide;
            // How far the place lies outside the texel, around the ends if it repeats.
            const auto beyond = [&](const Big& place, double texel) {
              const Big end = in.back() > 0 ? Big{place - kSide * floor(place / kSide)}
                                            : smallerOf(largerOf(place, 0), kSide);
              const Big outside = largerOf(0, largerOf(big(texel) - end, end - big(texel) - 1));
              return in.back() > 0
                         ? smallerOf(outside, abs(kSide - 1 - abs(end - big(texel) - Big{0.5}) + Big{0.5}))
                         : outside;
            };
            return toDouble(largerOf(beyond(s * kSide, out[0]), beyond((1 - s) * kSide, out[1])) / bound);
          },
      .hard = {[](Random& random) {
                 Numbers in = randomDepths(random, 0, 1);
                 in.push_back(static_cast<double>(random.below(2)));
                 return in;
               },
               [](Random& random) {  // the same value everywhere, at or next to the end of a texel
                 Numbers in = randomDepths(random, 0, 1);
                 const double s = static_cast<double>(random.integer(0, kSide)) / kSide *
                                  (1 + random.sign() * random.power(-53, -20));
                 for (int k = 0; k < 3; ++k) in[kOthers + k] = std::clamp(s, 0.0, 1.0);
                 in.push_back(static_cast<double>(random.below(2)));
                 return in;
               }}};
  addDepths(kernel, 0, 1);
  kernel.input.push_back(integers(0, 1));
  kernel.prepare = [prepare = kernel.prepare](const Numbers& in) {
    Numbers v = in;
    const double repeats = v.back();
    v.pop_back();
    v = prepare(v);
    if (!v.empty()) v.push_back(repeats);
    return v;
  };
  return kernel;
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

void addFillKernels(std::vector<Kernel>& kernels) {
  kernels.push_back(affineKernel());
  kernels.push_back(edgeKernel());
  for (const bool single : {false, true}) kernels.push_back(divisionKernel(single));
  for (const bool single : {false, true}) kernels.push_back(texelKernel(single));
  kernels.push_back(lookUpKernel());
  kernels.push_back(phongKernel());
}

}  // namespace xnewell
