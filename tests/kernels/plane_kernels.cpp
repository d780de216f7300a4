#include "geometry/view/screen_plane.h"
#include "tests/kernels/grid_triangles.h"

namespace xnewell {

namespace {

Kernel depthKernel() {
  Kernel kernel{.name = "depth of a plane",
                .claim = "4 2^-53 of it",
                .header = "geometry/view/screen_plane.h",
                .input = triangles(1),
                .prepare = [](const Numbers& in) { return turned(in, 1); },
                .run =
                    [](const Numbers& in) {
                      return Numbers{depthAt(planeOf(triangleAt(in.data())), static_cast<std::int64_t>(in[9]),
                                             static_cast<std::int64_t>(in[10]))};
                    },
                .judge =
                    [](const Numbers& in, const Numbers& out) {
                      const Big exact = ExactPlane{triangleAt(in.data())}.at(big(in[9]), big(in[10]));
                      return shareOf(out[0], exact, 4 * kU * abs(exact));
                    },
                .hard = {[](Random& random) {
                  Numbers in;
                  addTriangle(in, random);
                  for (int k = 0; k < 2; ++k) in.push_back(gridNumber(random, -2 * kReach, 2 * kReach));
                  return in;
                }}};
  kernel.input.push_back(integers(-0x1p30, 0x1p30));
  kernel.input.push_back(integers(-0x1p30, 0x1p30));
  return kernel;
}

/// Where it is right, the share says how much of its filter's tolerance a difference takes that misleads.
Kernel compareKernel() {
  Kernel kernel{
      .name = "order of two depths",
      .claim = "exact; its filter: 2^-50 (|zP| + |zQ|)",
      .header = "geometry/view/screen_plane.h",
      .input = triangles(2),
      .prepare = [](const Numbers& in) { return turned(in, 2); },
      .run =
          [](const Numbers& in) {
            const ScreenPlane P = planeOf(triangleAt(in.data())), Q = planeOf(triangleAt(&in[9]));
            const auto x = static_cast<std::int64_t>(in[18]), y = static_cast<std::int64_t>(in[19]);
            return Numbers{static_cast<double>(compareDepths(P, Q, x, y)), depthAt(P, x, y),
                           depthAt(Q, x, y)};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            const ExactPlane P{triangleAt(in.data())}, Q{triangleAt(&in[9])};
            const Big zP = P.at(big(in[18]), big(in[19])), zQ = Q.at(big(in[18]), big(in[19])),
                      apart = zP - zQ;
            const WholeLine l = difference(P, Q);
            const Whole exact = l.a * Whole{in[18]} + l.b * Whole{in[19]} + l.c;
            if (out[0] != exact.sign()) return kWrong;
            const Big tolerance = 0x1p-50 * (abs(big(out[1])) + abs(big(out[2])));
            if (tolerance == 0) return 0.0;
            // A difference that misleads must stay below the tolerance. Others count a little, to lead the
            // search.
            const Big difference = big(out[1]) - big(out[2]);
            if (difference.sign() != exact.sign()) return toDouble(abs(difference) / tolerance);
            return 0.1 * toDouble(abs(difference - apart) / tolerance);
          },
      .hard = {[](Random& random) {
        Numbers in;
        if (random.oneIn(2)) {
          addCoplanar(in, random);
        } else {
          addTriangle(in, random);
          random.oneIn(3) ? addTriangle(in, random) : addNearlyCoplanar(in, 0, random);
        }
        // At a corner, or anywhere.
        const std::size_t corner = 3 * random.below(6);
        for (std::size_t k = 0; k < 2; ++k)
          in.push_back(random.oneIn(2) ? in[corner + k] : gridNumber(random, -2 * kReach, 2 * kReach));
        return in;
      }}};
  kernel.input.push_back(integers(-0x1p30, 0x1p30));
  kernel.input.push_back(integers(-0x1p30, 0x1p30));
  return kernel;
}

Kernel nearerKernel() {
  Kernel kernel{
      .name = "nearer plane at a sample",
      .claim = "exact",
      .header = "geometry/view/screen_plane.h",
      .input = triangles(2),
      .prepare = [](const Numbers& in) { return turned(in, 2); },
      .run =
          [](const Numbers& in) {
            return Numbers{
                static_cast<double>(nearer(planeOf(triangleAt(in.data())), planeOf(triangleAt(&in[9])),
                                           static_cast<int>(in[18]), static_cast<int>(in[19])))};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            const WholeLine l = difference(ExactPlane{triangleAt(in.data())}, ExactPlane{triangleAt(&in[9])});
            const Whole x = Whole{in[18]} * kGrid + kGrid / 2, y = Whole{in[19]} * kGrid + kGrid / 2;
            const Whole value = l.a * x + l.b * y + l.c;
            const Whole& part = value != 0 ? value : l.a != 0 ? l.a : l.b;
            if (out[0] != part.sign()) return kWrong;
            // How small the difference is, as a share of its terms: 0.9 at a tie.
            const Big terms = abs(Big{l.a * x}) + abs(Big{l.b * y}) + abs(Big{l.c});
            return terms == 0 ? 0.0 : 0.9 / (1 + toDouble(abs(Big{value}) / terms) * 0x1p60);
          },
      .hard = {[](Random& random) {
        Numbers in;
        addTriangle(in, random);
        // A corner of both, at the centre of a pixel.
        const double i = static_cast<double>(random.integer(0, 8191)),
                     j = static_cast<double>(random.integer(0, 8191));
        in[0] = i * kGrid + kGrid / 2, in[1] = j * kGrid + kGrid / 2;
        addNearlyCoplanar(in, 0, random);
        if (random.oneIn(2)) std::copy(in.begin(), in.begin() + 3, in.begin() + 9);
        in.push_back(i), in.push_back(j);
        return in;
      }},
      .directed = 1};
  kernel.input.push_back(integers(0, 8191));
  kernel.input.push_back(integers(0, 8191));
  return kernel;
}

}  // namespace

void addPlaneKernels(std::vector<Kernel>& kernels) {
  kernels.push_back(depthKernel());
  kernels.push_back(compareKernel());
  kernels.push_back(nearerKernel());
}

}  // namespace xnewell
