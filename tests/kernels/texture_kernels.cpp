#include "shading/fill/evaluate_pixels.h"
#include "tests/kernels/screen_triangle.h"

namespace xnewell {

namespace {

constexpr double kSingle = 0x1p-24;

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

}  // namespace

void addTextureKernels(std::vector<Kernel>& kernels) {
  for (const bool single : {false, true}) kernels.push_back(divisionKernel(single));
  for (const bool single : {false, true}) kernels.push_back(texelKernel(single));
}

}  // namespace xnewell
