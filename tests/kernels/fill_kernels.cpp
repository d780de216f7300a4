#include "geometry/view/scanline.h"
#include "shading/fill/affine.h"
#include "tests/kernels/screen_triangle.h"
#include "tests/support/affine_over.h"

#include <utility>

namespace xnewell {

namespace {

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

/// An edge whose crossing of a row is right of a sample by 1 / (2^16 dy) of a pixel, the least that is
/// possible, or at the sample, or left of it by as much.
Numbers crossingBesideASample(Random& random) {
  const std::int64_t dy = random.integer(1 << 20, 1 << 30), top = random.integer(-(1 << 29), (1 << 29) - dy);
  const std::int64_t first = std::max<std::int64_t>(0, sampleFrom(static_cast<int>(top)));
  const std::int64_t last = std::min<std::int64_t>(kMaxPicture, sampleFrom(static_cast<int>(top + dy))) - 1;
  if (first > last) return crossingBesideASample(random);
  const std::int64_t row = random.integer(first, last), down = row * kGrid + kGrid / 2 - top;
  // Euclid's algorithm: inverse down = 1 modulo dy.
  std::int64_t a = dy, b = down % dy, before = 0, inverse = 1;
  while (b > 1) {
    const std::int64_t q = a / b;
    a = std::exchange(b, a - q * b);
    before = std::exchange(inverse, before - q * inverse);
  }
  if (b != 1) return crossingBesideASample(random);
  const std::int64_t beside = random.integer(-1, 1);
  std::int64_t dx = (beside * inverse) % dy;
  if (dx > 1 << 29) dx -= dy;
  if (dx < -(1 << 29)) dx += dy;
  const auto turns = static_cast<std::int64_t>((Int128{down} * dx - beside) / dy);
  // (xa - 1/2 pixel) + turns is whole pixels.
  const std::int64_t least = std::max<std::int64_t>(-(1 << 29), -(1 << 29) - dx),
                     most = std::min<std::int64_t>(1 << 29, (1 << 29) - dx);
  std::int64_t left = random.integer(least, most);
  left -= (((left - kGrid / 2 + turns) % kGrid) + kGrid) % kGrid;
  return {static_cast<double>(left), static_cast<double>(top), static_cast<double>(left + dx),
          static_cast<double>(top + dy), static_cast<double>(row - first)};
}

/// The first sample at an edge, in a row far below its start.
Kernel edgeKernel() {
  return {.name = "walk along an edge",
          .claim = "exact",
          .header = "geometry/view/scanline.h",
          .input = {integers(-kGridReach, kGridReach), integers(-kGridReach, kGridReach),
                    integers(-kGridReach, kGridReach), integers(-kGridReach, kGridReach),
                    integers(0, kMaxPicture - 1)},
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
                     const double top = std::round(random.uniform(-kGridReach, kGridReach - dy));
                     return Numbers{std::round(random.uniform(-kGridReach, kGridReach)), top,
                                    std::round(random.uniform(-kGridReach, kGridReach)), top + dy,
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
                   crossingBesideASample},
          .directed = 1};
}

}  // namespace

void addFillKernels(std::vector<Kernel>& kernels) {
  kernels.push_back(affineKernel());
  kernels.push_back(edgeKernel());
}

}  // namespace xnewell
