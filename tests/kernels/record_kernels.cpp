#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/exact/unit.h"
#include "geometry/view/plane_record.h"
#include "geometry/view/scene_planes.h"
#include "tests/kernels/big.h"
#include "tests/kernels/view_input.h"

namespace xnewell {

namespace {

/// A view, planes of the model and a place on the grid. In an input: as of viewInput(), then VPN, VUP, the
/// shift of a z step, x and y of the place, and a normal for each plane, which becomes a unit vector. VRP is
/// 0. All planes pass through the point of the view.
constexpr std::size_t kVpn = 15, kVup = 18, kShift = 21, kX = 22, kY = 23, kNormal = 24;

std::vector<Coordinate> recordInput(int planes) {
  std::vector<Coordinate> input = viewInput();
  for (int k = 0; k < 6; ++k) input.push_back(doubles(-1, 1));
  input.push_back(integers(0, 40));
  for (int k = 0; k < 2; ++k) input.push_back(integers(-0x1p29, 0x1p29));
  for (int k = 0; k < 3 * planes; ++k) input.push_back(doubles(-1, 1));
  return input;
}

Numbers preparedRecord(const Numbers& in) {
  Numbers v = preparedView({in.begin(), in.begin() + 15});
  if (v.empty()) return {};
  v.insert(v.end(), in.begin() + 15, in.end());
  const BigVec n = unitOf(bigVec(&v[kVpn])), up = unitOf(bigVec(&v[kVup])), across = cross(up, n);
  if (lengthOf(across) < 0x1p-10) return {};
  const BigVec u = unitOf(across), w = cross(n, u);
  const BigVec p = u * big(v[kPoint]) + w * big(v[kPoint + 1]) + n * big(v[kPoint + 2]);
  v[kPoint] = toDouble(p.x), v[kPoint + 1] = toDouble(p.y), v[kPoint + 2] = toDouble(p.z);
  for (std::size_t k = kNormal; k < v.size(); k += 3) {
    const glm::dvec3 N = unit({v[k], v[k + 1], v[k + 2]});
    if (N == glm::dvec3{0.0}) return {};
    v[k] = N.x, v[k + 1] = N.y, v[k + 2] = N.z;
  }
  return v;
}

PlaneRecords recordsOf(const Numbers& in) {
  ViewSpec view = viewOf(in);
  view.vpn = {in[kVpn], in[kVpn + 1], in[kVpn + 2]};
  view.vup = {in[kVup], in[kVup + 1], in[kVup + 2]};
  return {view, static_cast<int>(in[1]), static_cast<int>(in[2]), static_cast<int>(in[kShift])};
}
ModelPlane modelPlaneOf(const Numbers& in, std::size_t k) {
  const double* const N = &in[kNormal + 3 * k];
  return {{N[0], N[1], N[2]}, {in[kPoint], in[kPoint + 1], in[kPoint + 2]}};
}
glm::ivec2 placeOf(const Numbers& in) { return {static_cast<int>(in[kX]), static_cast<int>(in[kY])}; }

/// A depth by the ray through the place, and how far plane_record.h lets it be off. The slopes are
/// differences of the depths at two places, which are linear in between.
struct ExactDepth {
  Big z, alpha, beta;
  Big zBound, alphaBound, betaBound;
  bool claimed = false;
};
ExactDepth exactDepth(const Numbers& in, std::size_t plane) {
  const BigVec n = unitOf(bigVec(&in[kVpn])), across = cross(unitOf(bigVec(&in[kVup])), n),
               u = unitOf(across), v = cross(n, u);
  const BigVec N = bigVec(&in[kNormal + 3 * plane]), p = bigVec(&in[kPoint]);
  const Big D = big(in[5]), left = big(in[6]), low = big(in[7]), right = big(in[8]), high = big(in[9]),
            back = big(in[11]);
  const BigVec eye = u * big(in[3]) + v * big(in[4]) + n * D;
  const Big width = (right - left) / big(in[1]), height = (high - low) / big(in[2]);
  const Big zStep = width / kGrid * big(std::ldexp(1.0, static_cast<int>(in[kShift])));
  const BigVec projector = eye - u * ((left + right) / 2) - v * ((low + high) / 2);
  const bool parallel = in[0] > 0;
  // Where the ray through a place of the view plane meets the plane, as n; and so z.
  const auto depth = [&](const Big& x, const Big& y) {
    const BigVec place = u * (left + x * width / kGrid) + v * (high - y * height / kGrid);
    const BigVec along = parallel ? projector : eye - place;
    const Big t = dot(N, p - place) / dot(N, along);  // place + t along
    if (parallel) return (t * D - back) / zStep;
    return D * D / zStep * (1 / (D - t * D) - 1 / (D - back));
  };
  ExactDepth e;
  const BigVec m{dot(u, N), dot(v, N), dot(n, N)};
  const Big k = dot(N, p - eye), x = big(in[kX]), y = big(in[kY]);
  const Big leanX = (abs(big(in[3])) + abs(left) + abs(right)) / D,
            leanY = (abs(big(in[4])) + abs(low) + abs(high)) / D;
  // What rounds: the rotation of the normal, k, the window's size, the place.
  const Big turned = lengthOf(N) / lengthOf(across), reach = turned * (lengthOf(p) + lengthOf(eye));
  const Big window = (abs(left) + abs(right)) / (right - left) + (abs(low) + abs(high)) / (high - low);
  const Big placeX = abs(big(in[3])) + abs(left) + abs(x * width / kGrid) * (1 + window),
            placeY = abs(big(in[4])) + abs(high) + abs(y * height / kGrid) * (1 + window);
  const Big unit = big(0x1p-47);
  if (dot(N, projector) == 0 || k == 0) return e;
  if (parallel) {
    const Big slope = abs(dot(N, projector) / D), off = turned * (1 + leanX + leanY) / slope;
    if (off * unit > 0.25) return e;
    const Big sum = (reach + turned * (placeX + placeY + (leanX + leanY) * D)) / slope;
    e.zBound = (sum * (1 + off) + D + abs(back)) * (1 + window) / zStep;
    e.alphaBound = (abs(m.x) * (off + window) + turned) / slope * width / kGrid / zStep;
    e.betaBound = (abs(m.y) * (off + window) + turned) / slope * height / kGrid / zStep;
  } else {
    const Big off = reach / abs(k);
    if (off * unit > 0.25 || D - back == 0) return e;
    const Big perK = D / zStep / abs(k), sum = turned * (placeX + placeY + D);
    const Big dBack = D - back;
    e.zBound =
        (perK * sum * (1 + off) + D * D / zStep / dBack * (1 + (D + abs(back)) / dBack)) * (1 + window);
    e.alphaBound = perK * (abs(m.x) * (off + window) + turned) * width / kGrid;
    e.betaBound = perK * (abs(m.y) * (off + window) + turned) * height / kGrid;
  }
  e.zBound *= unit, e.alphaBound *= unit, e.betaBound *= unit;
  e.z = depth(x, y);
  e.alpha = depth(x + 1, y) - e.z, e.beta = depth(x, y + 1) - e.z;
  e.claimed = true;
  return e;
}

double fromInt128(Int128 v) { return static_cast<double>(v); }

Numbers hardRecord(Random& random, int planes) {
  Numbers in = randomView(random);
  const bool upright = random.oneIn(2);
  for (int k = 0; k < 6; ++k) in.push_back(upright ? (k == 2 || k == 4) : random.uniform(-1, 1));
  in.push_back(static_cast<double>(random.integer(0, 12)));
  for (int k = 0; k < 2; ++k) in.push_back(std::round(random.sign() * random.power(0, 29)));
  // Often a plane that nearly passes through the eye.
  const Numbers v = preparedView({in.begin(), in.begin() + 15});
  glm::dvec3 ray{0, 0, 1};
  if (!v.empty()) ray = glm::dvec3{v[kPoint], v[kPoint + 1], v[kPoint + 2]} - glm::dvec3{v[3], v[4], v[5]};
  for (int k = 0; k < planes; ++k) {
    glm::dvec3 N{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (random.oneIn(2) && glm::length(ray) > 0) {
      const glm::dvec3 along = glm::normalize(ray);
      N += (random.sign() * random.power(-40, 0) - glm::dot(N, along)) * along;
      N /= 2.0;
    }
    if (k > 0 && random.oneIn(2))
      for (int axis = 0; axis < 3; ++axis)
        N[axis] = in[kNormal + static_cast<std::size_t>(axis)] *
                  (1 + random.power(-50, -1) * random.uniform(-1, 1));
    for (int axis = 0; axis < 3; ++axis) in.push_back(std::clamp(N[axis], -1.0, 1.0));
  }
  return in;
}

/// A record's depth at the place, and its slopes. Rounding them to a record adds 2^-22 steps, and 2^-31 of a
/// slope.
Kernel recordKernel() {
  return {.name = "plane record",
          .claim = "2^-47 of the sums of the terms, and the rounding of a record",
          .header = "geometry/view/plane_record.h",
          .input = recordInput(1),
          .prepare = preparedRecord,
          .run =
              [](const Numbers& in) {
                const auto record = recordsOf(in).of(modelPlaneOf(in, 0), placeOf(in));
                if (!record) return Numbers{};
                const Int128 atPlace =
                    Int128{record->A} * placeOf(in).x + Int128{record->B} * placeOf(in).y + record->D;
                const double C = static_cast<double>(record->C);
                return Numbers{fromInt128(atPlace) / C, static_cast<double>(record->A) / C,
                               static_cast<double>(record->B) / C};
              },
          .judge =
              [](const Numbers& in, const Numbers& out) {
                const ExactDepth e = exactDepth(in, 0);
                if (out.empty() || !e.claimed) return 0.0;
                const Big most = largerOf(abs(e.alpha), abs(e.beta));
                const Big rounding = most * 0x1p-31 + big(0x1p-59);
                return std::max({shareOf(out[0], e.z, e.zBound + big(0x1p-22) + abs(e.z) * 0x1p-51),
                                 shareOf(out[1], e.alpha, e.alphaBound + rounding),
                                 shareOf(out[2], e.beta, e.betaBound + rounding)});
              },
          .hard = {[](Random& random) { return hardRecord(random, 1); }},
          .effort = 0.3};
}

/// How much nearer one plane is than another, at the place.
Kernel aheadKernel() {
  return {
      .name = "lead of a plane",
      .claim = "the sum of both planes' bounds, and 2^-50 of the terms",
      .header = "geometry/view/plane_record.h",
      .input = recordInput(2),
      .prepare = preparedRecord,
      .run =
          [](const Numbers& in) {
            const PlaneRecords records = recordsOf(in);
            const glm::ivec2 place = placeOf(in);
            const Ahead ahead = records.ahead(modelPlaneOf(in, 0), modelPlaneOf(in, 1), place);
            const bool both =
                records.of(modelPlaneOf(in, 0), place) && records.of(modelPlaneOf(in, 1), place);
            return both ? Numbers{ahead.at(place.x, place.y), ahead.x, ahead.y} : Numbers{};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            const ExactDepth a = exactDepth(in, 0), b = exactDepth(in, 1);
            if (out.empty() || !a.claimed || !b.claimed) return 0.0;
            const Big x = abs(big(in[kX])), y = abs(big(in[kY]));
            const Big slopes = x * (abs(a.alpha) + abs(b.alpha)) + y * (abs(a.beta) + abs(b.beta));
            const Big off = x * (a.alphaBound + b.alphaBound) + y * (a.betaBound + b.betaBound);
            const Big terms = abs(a.z) + abs(b.z) + slopes + off;
            return std::max({shareOf(out[0], a.z - b.z, a.zBound + b.zBound + terms * 0x1p-50),
                             shareOf(out[1], a.alpha - b.alpha,
                                     a.alphaBound + b.alphaBound + (abs(a.alpha) + abs(b.alpha)) * 0x1p-52),
                             shareOf(out[2], a.beta - b.beta,
                                     a.betaBound + b.betaBound + (abs(a.beta) + abs(b.beta)) * 0x1p-52)});
          },
      .hard = {[](Random& random) { return hardRecord(random, 2); }},
      .effort = 0.2};
}

/// Whether two faces may touch. In an input: whether there are leads; x and y; for each of two faces, level
/// or sloping by whole steps, the depth at the origin, the slopes, the doubts (in units of 2^-10), and the
/// lead.
Kernel touchKernel() {
  constexpr std::size_t kFace = 3, kOf = 6;
  Kernel kernel{
      .name = "whether faces touch",
      .claim = "exact beyond 2^-49 of the terms",
      .header = "geometry/view/scene_planes.h",
      .input = {integers(0, 1), integers(-0x1p30, 0x1p30), integers(-0x1p30, 0x1p30)},
      .run =
          [](const Numbers& in) {
            SnappedScene scene;
            for (int k = 0; k < 2; ++k) {
              const double* const f = &in[kFace + kOf * static_cast<std::size_t>(k)];
              ScreenPlane plane;
              plane.A = std::llround(f[1]), plane.B = std::llround(f[2]), plane.C = 1 << 20;
              plane.D = Int128{std::llround(f[0])} << 20;
              scene.planes.add(plane);
              scene.planes.setDoubt(k, {static_cast<float>(f[3]), static_cast<float>(f[4])}, 2);
              scene.faces.push_back({.part = k, .plane = k});
              if (in[0] > 0) scene.planes.setAhead(k, {.c = f[5]}, 2);
            }
            return Numbers{double(
                mayTouch(scene, scene.faces[0], scene.faces[1], std::llround(in[1]), std::llround(in[2])))};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            Big lead = 0, own = 0, doubt = 0, terms = 0;
            for (std::size_t k = 0; k < 2; ++k) {
              const double* const f = &in[kFace + kOf * k];
              const Big z =
                  big(std::round(f[0])) +
                  (big(std::round(f[1])) * big(in[1]) + big(std::round(f[2])) * big(in[2])) / (1 << 20);
              const Big slack = big(double(static_cast<float>(f[3]))),
                        byZ = big(double(static_cast<float>(f[4])));
              const Big ahead = in[0] > 0 ? big(f[5]) : Big{0};
              lead += k == 0 ? z : -z, own += k == 0 ? ahead : -ahead;
              doubt += slack + byZ * z;
              terms += abs(z) + slack + abs(byZ * z) + abs(ahead);
            }
            own += lead;
            const bool touches =
                in[0] > 0 ? own <= doubt || (lead <= doubt && 2 * own <= 3 * doubt) : lead <= doubt;
            // How far the nearest of the three comparisons is from a tie.
            const Big margin =
                smallerOf(abs(lead - doubt), in[0] > 0 ? smallerOf(abs(own - doubt), abs(own - doubt * 3 / 2))
                                                       : abs(lead - doubt));
            if (terms == 0) return 0.0;
            const double share = toDouble(margin / (terms * 0x1p-49));
            // Right ones count a little, the more the nearer to a tie, to lead the search.
            return (out[0] != 0) == touches ? 0.1 / (1 + share) : share;
          },
      .hard = {[](Random& random) {
        Numbers in{static_cast<double>(random.oneIn(2))};
        for (int k = 0; k < 2; ++k) in.push_back(std::round(random.sign() * random.power(0, 30)));
        for (int k = 0; k < 2; ++k) {
          in.push_back(std::round(random.power(0, 30)));
          for (int slope = 0; slope < 2; ++slope)
            in.push_back(std::round(random.sign() * random.power(0, 20)));
          in.push_back(random.power(-1, 10)), in.push_back(random.oneIn(2) ? 0 : random.power(-30, 0));
          in.push_back(random.oneIn(2) ? 0 : random.sign() * random.power(-10, 12));
        }
        // Often a lead that meets the doubt.
        if (random.oneIn(2)) in[kFace] = std::round(in[kFace + kOf] + in[kFace + 3] + in[kFace + kOf + 3]);
        return in;
      }}};
  for (int k = 0; k < 2; ++k) {
    kernel.input.push_back(integers(0, 0x1p30));
    kernel.input.push_back(integers(-0x1p30, 0x1p30));
    kernel.input.push_back(integers(-0x1p30, 0x1p30));
    kernel.input.push_back(floats(0, 0x1p40));
    kernel.input.push_back(floats(0, 0x1p10));
    kernel.input.push_back(doubles(-0x1p40, 0x1p40));
  }
  return kernel;
}

}  // namespace

void addRecordKernels(std::vector<Kernel>& kernels) {
  kernels.push_back(recordKernel());
  kernels.push_back(aheadKernel());
  kernels.push_back(touchKernel());
}

}  // namespace xnewell
