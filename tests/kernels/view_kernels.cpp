#include <cfenv>
#include <glm/vec4.hpp>

#include "geometry/view/clip.h"
#include "geometry/view/project.h"
#include "geometry/view/view.h"
#include "tests/kernels/big.h"
#include "tests/kernels/view_input.h"

namespace xnewell {

namespace {

/// Where a point lies on the screen, in pixels, by the projector's meeting with the view plane; and how far
/// view.h lets it be off, in units of 2^-53. `shift` is how far the point itself may be off.
struct Exact {
  BigVec at, bound;
};
Exact exactly(const Numbers& in, const BigVec& p, const Big& reach) {
  const Big width = big(in[1]), height = big(in[2]), D = big(in[5]);
  const BigVec prp{big(in[3]), big(in[4]), D};
  const Big left = big(in[6]), low = big(in[7]), right = big(in[8]), high = big(in[9]);
  const Big sx = right - left, sy = high - low, cx = (left + right) / 2, cy = (low + high) / 2;
  const Big perX = width / sx, perY = height / sy;
  const Big hx = abs(cx - prp.x) / D, hy = abs(cy - prp.y) / D;
  const Big front = big(in[10]), back = big(in[11]);
  Exact e;
  if (in[0] > 0) {
    const Big t = p.z / D;
    e.at = {(p.x - t * (prp.x - cx) - left) * perX, (high - p.y + t * (prp.y - cy)) * perY,
            (p.z - back) * perX};
    e.bound = {perX * (reach + hx * reach + abs(prp.x) * reach / D + abs(left) + abs(right)) + width,
               perY * (reach + hy * reach + abs(prp.y) * reach / D + abs(low) + abs(high)) + height,
               perX * (reach + abs(front) + abs(back))};
    return e;
  }
  const Big d = D - p.z, q = D / d, dF = D - front, dB = D - back;
  e.at = {(prp.x + (p.x - prp.x) * q - left) * perX, (high - prp.y - (p.y - prp.y) * q) * perY,
          perX * D * D * (1 / d - 1 / dB)};
  const Big deep = (reach + D) / d;
  e.bound = {perX * q * (reach + abs(prp.x) + (hx + (abs(left) + abs(right)) / D) * (reach + D)) +
                 (abs(e.at.x) + width) * deep,
             perY * q * (reach + abs(prp.y) + (hy + (abs(low) + abs(high)) / D) * (reach + D)) +
                 (abs(e.at.y) + height) * deep,
             perX * D * D / dF * deep};
  return e;
}

double worstOf(const Numbers& out, const BigVec& exact, const BigVec& bound) {
  return std::max({shareOf(out[0], exact.x, bound.x), shareOf(out[1], exact.y, bound.y),
                   shareOf(out[2], exact.z, bound.z)});
}

Kernel projectionKernel() {
  return {
      .name = "projection and warp",
      .claim = "2^-48 of the sums of the terms",
      .header = "geometry/view/view.h",
      .input = viewInput(),
      .prepare = preparedView,
      .run =
          [](const Numbers& in) {
            const ViewSpec view = viewOf(in);
            const glm::dmat4 screenFromVrc =
                screenFromCanonical(view, static_cast<int>(in[1]), static_cast<int>(in[2])) *
                canonicalFromVrc(view);
            const glm::dvec4 p = screenFromVrc * glm::dvec4{in[kPoint], in[kPoint + 1], in[kPoint + 2], 1.0};
            return Numbers{p.x / p.w, p.y / p.w, p.z / p.w};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            const BigVec p = bigVec(&in[kPoint]);
            const Exact e = exactly(in, p, lengthOf(p));
            return worstOf(out, e.at, e.bound * Big{32 * kU});
          },
      .hard = {randomView}};
}

/// vpn, vup: six numbers.
Kernel rotationKernel() {
  return {.name = "rotation of the view",
          .claim = "2^-48 / sin of the angle of VPN and VUP",
          .header = "geometry/view/view.h",
          .input = std::vector<Coordinate>(6, doubles(-0x1p1000, 0x1p1000)),
          .prepare =
              [](const Numbers& in) {
                // Not where they are parallel: there is a ViewError.
                const BigVec n = unitOf(bigVec(&in[0])), up = unitOf(bigVec(&in[3]));
                return lengthOf(cross(n, up)) > 0x1p-40 ? in : Numbers{};
              },
          .run =
              [](const Numbers& in) {
                ViewSpec view;
                view.vpn = {in[0], in[1], in[2]}, view.vup = {in[3], in[4], in[5]};
                const glm::dmat3 R = vrcRotation(view);
                Numbers entries;
                for (int column = 0; column < 3; ++column)
                  for (int row = 0; row < 3; ++row) entries.push_back(R[column][row]);
                return entries;
              },
          .judge =
              [](const Numbers& in, const Numbers& out) {
                const BigVec n = unitOf(bigVec(&in[0])), up = unitOf(bigVec(&in[3]));
                const BigVec across = cross(up, n), u = unitOf(across), v = cross(n, u);
                const Big bound = 0x1p-48 / lengthOf(across);
                const std::array columns{BigVec{u.x, v.x, n.x}, BigVec{u.y, v.y, n.y}, BigVec{u.z, v.z, n.z}};
                double worst = 0;
                for (int k = 0; k < 3; ++k)
                  worst = std::max(worst, worstOf({out[3 * k], out[3 * k + 1], out[3 * k + 2]}, columns[k],
                                                  {bound, bound, bound}));
                return worst;
              },
          .hard = {[](Random& random) {
            Numbers in;
            const double size = random.power(-900, 900), off = random.power(-38, 0);
            for (int k = 0; k < 3; ++k) in.push_back(size * random.uniform(-1, 1));
            for (int k = 0; k < 3; ++k) in.push_back(in[k] + off * size * random.uniform(-1, 1));
            return in;
          }},
          .effort = 0.5};
}

/// The whole way of a vertex to the grid, by snap(). In an input: as of projectionKernel(), then VRP, VPN and
/// VUP.
Kernel snapKernel() {
  constexpr std::size_t kVrp = kPoint + 3, kVpn = kVrp + 3, kVup = kVpn + 3;
  const auto world = [](const Numbers& in) {
    // To nearest: the world point whose VRC coordinates are about those of the input.
    ViewSpec view = viewOf(in);
    view.vrp = {in[kVrp], in[kVrp + 1], in[kVrp + 2]};
    view.vpn = {in[kVpn], in[kVpn + 1], in[kVpn + 2]};
    view.vup = {in[kVup], in[kVup + 1], in[kVup + 2]};
    return view;
  };
  Kernel kernel{
      .name = "snap of a vertex",
      .claim = "beyond half a step: 2^-47 of the sums of the terms",
      .header = "geometry/view/view.h, plane_record.h",
      .input = viewInput(),
      .prepare =
          [world](const Numbers& in) {
            Numbers v = preparedView({in.begin(), in.begin() + 15});
            if (v.empty()) return Numbers{};
            for (int k = 15; k < 24; ++k) v.push_back(k < 18 ? in[k] * in[3] : in[k]);
            const BigVec n = unitOf(bigVec(&v[kVpn])), up = unitOf(bigVec(&v[kVup])), u = cross(up, n);
            if (lengthOf(u) < 0x1p-10 || lengthOf(bigVec(&v[kVpn])) == 0) return Numbers{};
            const BigVec x = unitOf(u), y = cross(n, x);
            const BigVec p =
                x * big(v[kPoint]) + y * big(v[kPoint + 1]) + n * big(v[kPoint + 2]) + bigVec(&v[kVrp]);
            v[kPoint] = toDouble(p.x), v[kPoint + 1] = toDouble(p.y), v[kPoint + 2] = toDouble(p.z);
            return v;
          },
      .run =
          [world](const Numbers& in) {
            const ViewSpec view = world(in);
            // A triangle of the point and two others beside it, all as deep.
            const glm::dvec3 p{in[kPoint], in[kPoint + 1], in[kPoint + 2]};
            const glm::dmat3 R = vrcRotation(view);
            const double d = in[0] > 0 ? 1.0 : (in[5] - (R * (p - view.vrp)).z) / in[5];
            const auto row = [&](int r) { return glm::dvec3{R[0][r], R[1][r], R[2][r]}; };
            const double side = (in[8] - in[6]) * d;
            Mesh mesh;
            mesh.points = {p, p + side * row(0), p + (in[9] - in[7]) * d * row(1)};
            mesh.addFace(std::array{0, 1, 2}, 0);
            const ConvexParts parts = divideFaces(mesh);
            const SnappedScene scene =
                snap(mesh, parts, view, static_cast<int>(in[1]), static_cast<int>(in[2]), Cull::Keep);
            for (std::size_t k = 0; k < scene.vertices.size(); ++k)
              if (scene.source[k] == 0)
                return Numbers{double(scene.vertices[k].x), double(scene.vertices[k].y),
                               double(scene.vertices[k].z), double(scene.zShift),
                               std::fegetround() == FE_TONEAREST ? 0.5 : 1.0};
            return Numbers{};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            if (out.empty()) return 0.0;  // clipped, or without area
            const BigVec n = unitOf(bigVec(&in[kVpn])), up = unitOf(bigVec(&in[kVup])), across = cross(up, n);
            const BigVec u = unitOf(across), v = cross(n, u), p = bigVec(&in[kPoint]) - bigVec(&in[kVrp]);
            const Big reach = lengthOf(p) / lengthOf(across);
            const Exact e = exactly(in, {dot(u, p), dot(v, p), dot(n, p)}, reach);
            const Big steps = kGrid, zSteps = big(std::ldexp(double{kGrid}, -static_cast<int>(out[3])));
            const Big off = 64 * kU;
            const std::array exact{e.at.x * steps, e.at.y * steps, e.at.z * zSteps};
            const std::array bound{e.bound.x * off * steps, e.bound.y * off * steps,
                                   e.bound.z * off * zSteps};
            double worst = 0;  // what is left of the error without that of the snap itself
            for (int k = 0; k < 3; ++k)
              worst = std::max(worst, toDouble((abs(big(out[k]) - exact[k]) - big(out[4])) / bound[k]));
            return worst;
          },
      .hard = {[](Random& random) {
        Numbers in = randomView(random);
        const double far = random.oneIn(2) ? 0 : random.power(-10, 10);
        for (int k = 0; k < 3; ++k) in.push_back(far * random.uniform(-1, 1));
        for (int k = 0; k < 6; ++k) in.push_back(random.uniform(-1, 1));
        return in;
      }},
      .effort = 0.3};
  for (int k = 0; k < 3; ++k) kernel.input.push_back(doubles(-0x1p20, 0x1p20));
  for (int k = 0; k < 6; ++k) kernel.input.push_back(doubles(-1, 1));
  return kernel;
}

/// The vertex that clip() makes on an edge. In an input: the plane's number, zFront, the two ends.
Kernel clipKernel() {
  Kernel kernel{
      .name = "clipping",
      .claim = "2^-49 (A + B) off the plane, 2^-51 (|a| + |b|) off the edge",
      .header = "geometry/view/clip.h",
      .input = {integers(0, 5), doubles(0, 0x1p40)},
      .prepare =
          [](const Numbers& in) {
            for (std::size_t n = 2; n < in.size(); ++n)
              if (in[n] != 0 && std::abs(in[n]) < 0x1p-900) return Numbers{};
            return in;
          },
      .run =
          [](const Numbers& in) {
            const glm::dvec4 a{in[2], in[3], in[4], in[5]}, b{in[6], in[7], in[8], in[9]};
            std::vector<ClipVertex> polygon{{a, 0}, {b, 1}};
            std::vector<Between> made;
            clip(polygon, clipPlanes(in[1], kMaxPicture), 1u << static_cast<unsigned>(in[0]), made);
            if (made.empty()) return Numbers{};
            Numbers result{static_cast<double>(made[0].a), made[0].t};
            for (const ClipVertex& v : polygon)
              if (v.source < 0) result.insert(result.end(), {v.p.x, v.p.y, v.p.z, v.p.w});
            return result;
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            if (out.empty()) return 0.0;
            // The edge runs there and back, so it is cut twice, with the same bits.
            if (out.size() != 10 || !std::equal(&out[2], &out[6], &out[6])) return kWrong;
            if (!(out[1] >= 0 && out[1] <= 1)) return kWrong;
            const glm::dvec4 plane = clipPlanes(in[1], kMaxPicture)[static_cast<std::size_t>(in[0])];
            Big height = 0, sizes = 0;
            double worst = 0;
            const double* const inside = out[0] == 0 ? &in[2] : &in[6];
            const double* const outside = out[0] == 0 ? &in[6] : &in[2];
            for (int k = 0; k < 4; ++k) {
              const Big a = big(inside[k]), b = big(outside[k]), factor = big(plane[k]);
              height += factor * big(out[2 + k]);
              sizes += abs(factor) * (abs(a) + abs(b));
              worst = std::max(worst, shareOf(out[2 + k], a + (b - a) * big(out[1]),
                                              0x1p-51 * (abs(a) + abs(b)) + 0x1p-1070));
            }
            return std::max(worst, toDouble(abs(height) / (0x1p-49 * sizes + 0x1p-1070)));
          },
      .hard = {[](Random& random) {
                 Numbers in{static_cast<double>(random.below(6)), random.power(-10, 30)};
                 const double size = random.power(-30, 30);
                 for (int k = 0; k < 8; ++k) in.push_back(size * random.uniform(-1, 1));
                 return in;
               },
               [](Random& random) {  // both ends near the plane
                 Numbers in{static_cast<double>(random.below(6)), random.power(-10, 30)};
                 const glm::dvec4 plane = clipPlanes(in[1], kMaxPicture)[static_cast<std::size_t>(in[0])];
                 for (int end = 0; end < 2; ++end) {
                   double p[4], w = random.uniform(0.1, 2);
                   for (double& part : p) part = w * random.uniform(-1e4, 1e4);
                   const int axis = static_cast<int>(in[0]) < 2 ? 2 : static_cast<int>(in[0]) < 4 ? 0 : 1;
                   p[axis] = -plane.w * w / plane[axis] * (1 + random.sign() * random.power(-53, 0));
                   in.insert(in.end(), {p[0], p[1], p[2], w});
                 }
                 return in;
               }}};
  for (int k = 0; k < 8; ++k) kernel.input.push_back(doubles(-0x1p100, 0x1p100));
  return kernel;
}

}  // namespace

void addViewKernels(std::vector<Kernel>& kernels) {
  kernels.push_back(rotationKernel());
  kernels.push_back(projectionKernel());
  kernels.push_back(clipKernel());
  kernels.push_back(snapKernel());
}

}  // namespace xnewell
