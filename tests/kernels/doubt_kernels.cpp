#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/exact/unit.h"
#include "geometry/model/fit_plane.h"
#include "geometry/view/plane_record.h"
#include "tests/kernels/big.h"
#include "tests/kernels/grid_triangles.h"
#include "tests/kernels/view_input.h"

namespace xnewell {

namespace {

/// A whole number in parts of 32 bits, the lowest first.
void addParts(Numbers& out, Int128 n, int parts) {
  for (int k = 0; k < parts; ++k, n >>= 32)
    out.push_back(k + 1 < parts ? static_cast<double>(static_cast<std::uint32_t>(n))
                                : static_cast<double>(n));
}
Whole fromParts(const double* part, int parts) {
  Whole n = 0;
  for (int k = parts; k-- > 0;) n = n * Whole{0x1p32} + Whole{part[k]};
  return n;
}

struct WholePoint {
  Whole x, y, z;
};

/// In an input: how many points, 3 or 4, then their coordinates.
Kernel planeThroughKernel() {
  const auto before = [](const WholePoint& a, const WholePoint& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  };
  const auto area = [](const WholePoint& a, const WholePoint& b, const WholePoint& c) {
    return Whole{(b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)};
  };
  const auto pointsOf = [](const Numbers& in) {
    std::vector<WholePoint> p;
    for (std::size_t k = 1; k < 1 + 3 * static_cast<std::size_t>(in[0]); k += 3)
      p.push_back({Whole{in[k]}, Whole{in[k + 1]}, Whole{in[k + 2]}});
    return p;
  };
  Kernel kernel{
      .name = "plane through points",
      .claim = "exact; |A|, |B|, C <= 2^61, |D| <= 2^93",
      .header = "geometry/view/screen_plane.h",
      .input = {integers(3, 4)},
      .prepare =
          [=](const Numbers& in) {
            const std::vector<WholePoint> p = pointsOf(in);
            bool spread = false;
            for (std::size_t k = 2; k < p.size(); ++k)
              spread |= area(p[0], p[k - 1], p[k]) != 0 || area(p[0], p[1], p[k]) != 0;
            return spread && (p.size() == 4 || area(p[0], p[1], p[2]) != 0) ? in : Numbers{};
          },
      .run =
          [](const Numbers& in) {
            std::vector<glm::ivec3> points;
            for (std::size_t k = 1; k < 1 + 3 * static_cast<std::size_t>(in[0]); k += 3)
              points.emplace_back(static_cast<int>(in[k]), static_cast<int>(in[k + 1]),
                                  static_cast<int>(in[k + 2]));
            const ScreenPlane plane = planeThrough(points.data(), static_cast<int>(points.size()));
            Numbers out;
            for (const std::int64_t n : {plane.A, plane.B, plane.C}) addParts(out, n, 2);
            addParts(out, plane.D, 4);
            return out;
          },
      .judge =
          [=](const Numbers& in, const Numbers& out) {
            const std::vector<WholePoint> p = pointsOf(in);
            std::array<WholePoint, 3> on{p[0], p[1], p[2]};
            if (p.size() > 3) {  // the least point, the farthest from it, and what spans most with both
              on[0] = *std::ranges::min_element(p, before);
              const auto most = [&](const auto& measure) {
                return *std::ranges::max_element(p, [&](const WholePoint& a, const WholePoint& b) {
                  const Whole ma = measure(a), mb = measure(b);
                  return ma != mb ? ma < mb : before(b, a);
                });
              };
              on[1] = most([&](const WholePoint& q) {
                return Whole{(q.x - on[0].x) * (q.x - on[0].x) + (q.y - on[0].y) * (q.y - on[0].y)};
              });
              on[2] = most([&](const WholePoint& q) { return Whole{abs(area(on[0], on[1], q))}; });
            }
            const Whole A = fromParts(&out[0], 2), B = fromParts(&out[2], 2), C = fromParts(&out[4], 2),
                        D = fromParts(&out[6], 4);
            if (C <= 0 || C != abs(area(on[0], on[1], on[2]))) return kWrong;
            for (const WholePoint& q : on)
              if (C * q.z != A * q.x + B * q.y + D) return kWrong;
            const Whole most = std::max({Whole{abs(A)}, Whole{abs(B)}, C});
            return std::max(toDouble(Big{most} * 0x1p-61), toDouble(Big{Whole{abs(D)}} * 0x1p-93));
          },
      .hard = {[](Random& random) {
        Numbers in{random.oneIn(2) ? 3.0 : 4.0};
        addTriangle(in, random);
        const std::size_t copied = 1 + 3 * random.below(3);  // often one of the corners, or beside it
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double low = axis == 2 ? 0 : -kReach, high = axis == 2 ? kDeep : kReach;
          in.push_back(random.oneIn(2) ? in[copied + axis] : gridNumber(random, low, high));
        }
        return in;
      }},
      .directed = 1};
  for (int k = 0; k < 12; ++k)
    kernel.input.push_back(k % 3 == 2 ? integers(0, kDeep) : integers(-kReach, kReach));
  return kernel;
}

/// |N.p - d| and r of a point.
struct OffPlane {
  Big off, r;
};
OffPlane offPlane(const BigVec& N, const Big& d, const BigVec& p, const Big& u) {
  const Big e = big(0x1p-46) + big(0x1p-50);  // side and magnitude 1
  return {abs(dot(N, p) - d), u * (abs(N.x) + abs(N.y) + abs(N.z)) + e * lengthOf(N)};
}

/// The h of a plane for a point. In an input: the normal, d beyond the point, the point, u. Prepared: a unit
/// normal, d, point, u.
Kernel fitOfKernel() {
  return {.name = "plane fit: h of a plane",
          .claim = "2^-50 of it, and 2^-49 / r",
          .header = "geometry/model/fit_plane.h",
          .input = {doubles(-1, 1), doubles(-1, 1), doubles(-1, 1), doubles(-1, 1), doubles(0, 1),
                    doubles(0, 1), doubles(0, 1), doubles(0, 1e-4)},
          .prepare =
              [](const Numbers& in) {
                const glm::dvec3 N = unit({in[0], in[1], in[2]}), p{in[4], in[5], in[6]};
                if (N == glm::dvec3{0.0}) return Numbers{};
                return Numbers{N.x, N.y, N.z, glm::dot(N, p) + in[3], p.x, p.y, p.z, in[7]};
              },
          .run =
              [](const Numbers& in) {
                const std::array<RoundedPoint, 1> point{{{{in[4], in[5], in[6]}, in[7]}}};
                return Numbers{fitOf({{in[0], in[1], in[2]}, in[3]}, point, Rounding{1.0, 1.0}).h};
              },
          .judge =
              [](const Numbers& in, const Numbers& out) {
                const OffPlane exact = offPlane(bigVec(in.data()), big(in[3]), bigVec(&in[4]), big(in[7]));
                return shareOf(out[0], exact.off / exact.r, (exact.off * 0x1p-50 + 0x1p-49) / exact.r);
              },
          .hard = {[](Random& random) {
            Numbers in;
            for (int k = 0; k < 3; ++k) in.push_back(random.uniform(-1, 1));
            in.push_back(random.oneIn(2) ? 0 : random.sign() * random.power(-50, 0));
            for (int k = 0; k < 3; ++k)
              in.push_back(random.oneIn(2) ? 1 - random.power(-53, 0) : random.uniform(0, 1));
            in.push_back(random.oneIn(2) ? 0 : random.power(-40, -14));
            return in;
          }}};
}

/// The least h of four points. In an input: three points, then the shares of two edges and the height in r of
/// the fourth, then u. Prepared: the points, u, and the plane of the first three.
Kernel fitPlaneKernel() {
  const auto worstOf = [](const Numbers& in, const BigVec& N, const Big& d) {
    Big worst = 0;
    for (std::size_t k = 0; k < 12; k += 3) {
      const OffPlane p = offPlane(N, d, bigVec(&in[k]), big(in[12]));
      worst = largerOf(worst, p.off / p.r);
    }
    return worst;
  };
  Kernel kernel{.name = "plane fit: the least h",
                .claim = "2^-9 of the least within 2^-10 of its direction, and 2^-49 / r, up to h = 4",
                .header = "geometry/model/fit_plane.h",
                .input = std::vector<Coordinate>(9, doubles(0, 1)),
                .prepare =
                    [](const Numbers& in) {
                      const glm::dvec3 a{in[0], in[1], in[2]}, b{in[3], in[4], in[5]}, c{in[6], in[7], in[8]};
                      const glm::dvec3 N = unit(glm::cross(b - a, c - a));
                      if (!(glm::length(glm::cross(b - a, c - a)) > 0x1p-8)) return Numbers{};
                      const double r = in[12] * (std::abs(N.x) + std::abs(N.y) + std::abs(N.z)) + 0x1p-46;
                      const glm::dvec3 p = a + in[9] * (b - a) + in[10] * (c - a) + in[11] * r * N;
                      Numbers v(in.begin(), in.begin() + 9);
                      for (int axis = 0; axis < 3; ++axis) v.push_back(p[axis]);
                      if (std::ranges::any_of(v, [](double x) { return !(x >= 0 && x <= 1); }))
                        return Numbers{};
                      v.insert(v.end(), {in[12], N.x, N.y, N.z, glm::dot(N, a)});
                      return v;
                    },
                .run =
                    [](const Numbers& in) {
                      std::array<RoundedPoint, 4> points;
                      for (std::size_t k = 0; k < 4; ++k)
                        points[k] = {{in[3 * k], in[3 * k + 1], in[3 * k + 2]}, in[12]};
                      const PlaneFit fit = fitPlane(points, {{in[13], in[14], in[15]}, in[16]},
                                                    Rounding{1.0, 1.0}, FitGoal::Best);
                      return Numbers{fit.plane.N.x, fit.plane.N.y, fit.plane.N.z, fit.plane.d};
                    },
                .judge =
                    [=](const Numbers& in, const Numbers& out) {
                      const Big h = worstOf(in, bigVec(out.data()), big(out[3]));
                      // Of all planes z = a x + b y + c over the found one, the best leaves the residuals s w
                      // h at the corners, s the signs of the weights with which the corners' places add up to
                      // 0. From it on again.
                      Big least = h;
                      const BigVec found = unitOf(bigVec(out.data()));
                      BigVec N = found;
                      for (int step = 0; step < 6; ++step) {
                        const BigVec axis = abs(N.x) <= abs(N.y) && abs(N.x) <= abs(N.z) ? BigVec{1, 0, 0}
                                            : abs(N.y) <= abs(N.z)                       ? BigVec{0, 1, 0}
                                                                                         : BigVec{0, 0, 1};
                        const BigVec T = unitOf(cross(N, axis)), U = cross(N, T), origin = bigVec(in.data());
                        std::array<BigVec, 4> q;
                        for (std::size_t k = 0; k < 4; ++k) {
                          const BigVec p = bigVec(&in[3 * k]) - origin;
                          q[k] = {dot(T, p), dot(U, p), dot(N, p)};
                        }
                        std::array<Big, 4> weight;
                        std::size_t widest = 0;
                        Big sum = 0, total = 0;
                        for (std::size_t k = 0; k < 4; ++k) {
                          const BigVec &a = q[(k + 1) % 4], &b = q[(k + 2) % 4], &c = q[(k + 3) % 4];
                          weight[k] =
                              ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) * (k % 2 ? -1 : 1);
                          sum += weight[k] * q[k].z, total += abs(weight[k]);
                          if (abs(weight[k]) > abs(weight[widest])) widest = k;
                        }
                        const Big all = sum / total;  // = s w h
                        std::array<BigVec, 3> on;
                        for (std::size_t k = 0; k < 3; ++k) {
                          const std::size_t of = (widest + 1 + k) % 4;
                          on[k] = q[of];
                          on[k].z -= weight[of] > 0 ? all : weight[of] < 0 ? -all : Big{0};
                        }
                        const BigVec M = unitOf(cross(on[1] - on[0], on[2] - on[0]));
                        const BigVec next = T * M.x + U * M.y + N * M.z;
                        if (lengthOf(next - found) <= 0x1p-10 || lengthOf(next + found) <= 0x1p-10)
                          least = smallerOf(least, worstOf(in, next, dot(M, on[0]) + dot(next, origin)));
                        N = next;
                      }
                      if (least > 4) return 0.0;
                      const Big r = offPlane(N, Big{0}, BigVec{0, 0, 0}, big(in[12])).r;
                      return toDouble((h - least) / (least * 0x1p-9 + 0x1p-49 / r));
                    },
                .hard = {[](Random& random) {
                  Numbers in;
                  const bool thin = random.oneIn(3);
                  const double size = random.power(-3, 0), off = thin ? random.power(-6, 0) : 1;
                  for (int k = 0; k < 9; ++k) in.push_back(0.5 + 0.5 * size * random.uniform(-1, 1));
                  for (std::size_t axis = 6; axis < 9; ++axis)
                    in[axis] = in[axis - 3] + off * (in[axis] - in[axis - 3]);
                  for (int k = 0; k < 2; ++k) in.push_back(random.uniform(-1, 2));
                  in.push_back(random.uniform(-8, 8));
                  in.push_back(random.oneIn(3) ? 0 : random.power(-40, -16));
                  return in;
                }},
                .effort = 0.2};
  kernel.input.push_back(doubles(-1, 2));
  kernel.input.push_back(doubles(-1, 2));
  kernel.input.push_back(doubles(-8, 8));
  kernel.input.push_back(doubles(0, 1.7e-5));
  return kernel;
}

/// The doubt of a face whose record is the plane of a triangle on the grid. In an input: as of viewInput(),
/// then VPN, VUP, the triangle, the shift of a z step, the rounding, and the z where the doubt is asked.
/// The side of the scene is 1.
Kernel doubtKernel() {
  constexpr std::size_t kVpn = 15, kVup = 18, kTriangle = 21, kShift = 30, kRounding = 31, kZ = 32;
  Kernel kernel{
      .name = "depth doubt",
      .claim = "2^-23 of it, up to 2^127",
      .header = "geometry/view/plane_record.h",
      .input = viewInput(),
      .prepare =
          [](const Numbers& in) {
            Numbers v = preparedView({in.begin(), in.begin() + 15});
            if (v.empty()) return Numbers{};
            v.insert(v.end(), in.begin() + 15, in.end());
            const BigVec n = unitOf(bigVec(&v[kVpn])), up = unitOf(bigVec(&v[kVup]));
            if (lengthOf(cross(up, n)) < 0x1p-10 || lengthOf(bigVec(&v[kVpn])) == 0) return Numbers{};
            const std::int64_t area = doubleAreaOf(triangleAt(&v[kTriangle]));
            return area == 0 ? Numbers{} : v;
          },
      .run =
          [](const Numbers& in) {
            ViewSpec view = viewOf(in);
            view.vpn = {in[kVpn], in[kVpn + 1], in[kVpn + 2]};
            view.vup = {in[kVup], in[kVup + 1], in[kVup + 2]};
            const DepthDoubt doubt{view, static_cast<int>(in[1]), static_cast<int>(in[2]),
                                   static_cast<int>(in[kShift])};
            return Numbers{doubt.of(planeOf(triangleAt(&in[kTriangle])), in[kRounding]).at(in[kZ])};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            // The triangle's corners in VRC, as the grid has them, and so the plane of the model.
            const Big D = big(in[5]), left = big(in[6]), low = big(in[7]), right = big(in[8]),
                      high = big(in[9]), dBack = D - big(in[11]);
            const Big stepX = (right - left) / big(in[1]) / kGrid, stepY = (high - low) / big(in[2]) / kGrid,
                      stepZ = stepX * big(std::ldexp(1.0, static_cast<int>(in[kShift])));
            const BigVec prp{big(in[3]), big(in[4]), D};
            const BigVec along = prp - BigVec{(left + right) / 2, (low + high) / 2, 0};  // the projectors
            std::array<BigVec, 3> p;
            for (std::size_t k = 0; k < 3; ++k) {
              const double* const corner = &in[kTriangle + 3 * k];
              const BigVec at{left + stepX * big(corner[0]), high - stepY * big(corner[1]), 0};
              if (in[0] > 0) {
                const Big n = big(in[11]) + stepZ * big(corner[2]);
                p[k] = at + along * (n / D) - prp;
              } else {
                const Big distance = 1 / (stepZ * big(corner[2]) / (D * D) + 1 / dBack);
                p[k] = (at - prp) * (distance / D);
              }
            }
            const BigVec m = unitOf(cross(p[1] - p[0], p[2] - p[0]));
            const BigVec n = unitOf(bigVec(&in[kVpn])), u = unitOf(cross(unitOf(bigVec(&in[kVup])), n)),
                         v = cross(n, u);
            const BigVec N = u * m.x + v * m.y + n * m.z;
            const Big rounding = big(in[kRounding]) * (abs(N.x) + abs(N.y) + abs(N.z));
            const ExactPlane exact{triangleAt(&in[kTriangle])};
            const Big grid = (1 + (abs(Big{exact.A}) + abs(Big{exact.B})) / Big{exact.C}) / 2;
            const Big away = in[0] > 0 ? abs(dot(m, along)) / D : abs(dot(m, p[0]));
            const Big moved = in[0] > 0 ? rounding / away / stepZ
                                        : rounding / away * (big(in[kZ]) + D * D / (stepZ * dBack));
            if (away == 0 || grid + moved > 0x1p127) return 0.0;
            return shareOf(out[0], grid + moved, (grid + moved) * 0x1p-23);
          },
      .hard = {[](Random& random) {
        Numbers in = randomView(random);
        for (int k = 0; k < 3; ++k) in.push_back(random.uniform(-1, 1));
        for (int k = 0; k < 3; ++k) in.push_back(random.uniform(-1, 1));
        addTriangle(in, random);
        in.push_back(static_cast<double>(random.integer(0, 12)));
        in.push_back(random.oneIn(4) ? 0 : random.power(-40, -14));
        in.push_back(random.oneIn(3) ? 0 : std::round(random.power(0, 30)));
        return in;
      }},
      .effort = 0.3};
  for (int k = 0; k < 6; ++k) kernel.input.push_back(doubles(-1, 1));
  const std::vector<Coordinate> triangle = triangles(1);
  kernel.input.insert(kernel.input.end(), triangle.begin(), triangle.end());
  kernel.input.push_back(integers(0, 40));
  kernel.input.push_back(doubles(0, 1e-4));
  kernel.input.push_back(integers(0, kDeep));
  return kernel;
}

}  // namespace

void addDoubtKernels(std::vector<Kernel>& kernels) {
  kernels.push_back(planeThroughKernel());
  kernels.push_back(fitOfKernel());
  kernels.push_back(fitPlaneKernel());
  kernels.push_back(doubtKernel());
}

}  // namespace xnewell
