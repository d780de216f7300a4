#include <cfenv>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "depthsort/region.h"
#include "geometry/exact/int128.h"
#include "geometry/exact/plane.h"
#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"
#include "geometry/exact/two_doubles.h"
#include "geometry/model/bezier.h"
#include "geometry/model/coplanar.h"
#include "geometry/model/vertex_normals.h"
#include "geometry/view/clip.h"
#include "geometry/view/plane_record.h"
#include "geometry/view/project.h"
#include "geometry/view/scene_planes.h"
#include "geometry/view/screen_plane.h"
#include "geometry/view/view.h"
#include "shading/fill/lanes.h"
#include "tests/kernels/search.h"

namespace xnewell {

namespace {

constexpr double kMost = std::numeric_limits<double>::max();

Numbers numbersOf(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Empty if a number from the `first` on is 0 < |v| < 2^exponent.
template <int exponent, std::size_t first = 0>
Numbers notTiny(In in) {
  for (std::size_t k = first; k < in.size(); ++k)
    if (in[k] != 0 && std::abs(in[k]) < std::ldexp(1.0, exponent)) return {};
  return in;
}

/// The angle in [0, 360), then in radians.
Big radians(double degrees) { return (big(degrees) - 360 * floor(big(degrees) / 360)) * degree(); }

double judgeArcTangent(In in, In out) {
  const Big exact = in[0] == 0 && in[1] == 0 ? Big{0} : Big{atan2(big(in[0]), big(in[1])) / degree()};
  // -180 stands for 180.
  const double turn = exact > 90 && out[0] < -90 ? 360 : exact < -90 && out[0] > 90 ? -360 : 0;
  return shareOf(out[0] + turn, exact, 0x1p-45);
}

template <class Real>
double judgePower(In in, In out) {
  // lanes.h promises the same bits.
  if (out.size() > 1 && out[0] != out[1] && !(std::isnan(out[0]) && std::isnan(out[1]))) return kWrong;
  constexpr bool single = std::is_same_v<Real, float>;
  const double u = single ? kSingle : kU;
  const int n = whole(in[1]);
  const Big exact = bigPower(big(in[0]), n);
  if (abs(exact) >= double{std::numeric_limits<Real>::max()} * (1 - n * u)) return 0;
  const bool denormal = abs(exact) < double{std::numeric_limits<Real>::min()};
  return shareOf(out[0], exact, n * u * abs(exact) + (!denormal ? 0 : single ? 0x1p-140 : 0x1p-1068));
}

/// Four digits of base 2^31, the first with a sign: up to 2^124.
Inputs digits() { return integers(-0x1p31 + 1, 0x1p31 - 1) + 3 * integers(0, 0x1p31 - 1); }
Int128 int128Of(In in) {
  Int128 n = 0;
  for (const double digit : in) n = n * (Int128{1} << 31) + static_cast<std::int64_t>(digit);
  return n;
}
Big bigOf(In digits) { return Big{mp::cpp_int{int128Of(digits)}}; }

/// high + low as a share of the bound: 2^-100 of `of`.
double shareOfTwo(const double* two, const Big& exact, const Big& of) {
  return shareOf(Big{big(two[0]) + big(two[1])}, exact, 0x1p-100 * abs(of));
}

/// In an input: high x and y, and what share of 2^-52 of it is low. Prepared: x, low x, y, low y.
Numbers preparedTwo(In in) {
  Numbers v;
  for (int k = 0; k < 2; ++k) {
    if (in[k] != 0 && std::abs(in[k]) < 0x1p-190) return {};
    const double low = in[k] * 0x1p-52 * in[k + 2];
    v.push_back(in[k]), v.push_back(std::abs(low) < 0x1p-300 ? 0.0 : low);
  }
  return v;
}
Numbers runTwo(In in) {
  const TwoDoubles x{in[0], in[1]}, y{in[2], in[3]};
  Numbers out;
  for (const TwoDoubles& v : {x + y, x * y, y == 0 ? y : x / y, sqrt(abs(x))})
    out.push_back(v.high), out.push_back(v.low);
  return out;
}
double judgeTwo(In in, In out) {
  const Big x = big(in[0]) + big(in[1]), y = big(in[2]) + big(in[3]);
  const Big quotient = y == 0 ? Big{0} : Big{x / y}, root = sqrt(abs(x));
  return std::max({shareOfTwo(&out[0], x + y, abs(x) + abs(y)), shareOfTwo(&out[2], x * y, x * y),
                   shareOfTwo(&out[4], quotient, quotient), shareOfTwo(&out[6], root, root)});
}

Numbers runNewell(In in) {
  std::vector<glm::dvec3> points;
  std::vector<int> listed;
  for (std::size_t k = 0; k < in.size(); k += 3) {
    points.push_back(glmOf(&in[k]));
    listed.push_back(static_cast<int>(k / 3));
  }
  return numbersOf(newellVector(points, listed));
}
double judgeNewell(In in, In out) {
  const int n = static_cast<int>(in.size()) / 3;
  BigVec sum{0, 0, 0};
  Big extent = 0;
  for (int k = 0; k < n; ++k) {
    const BigVec a = bigVec(&in[3 * k]), from = absOf(a - bigVec(in.data()));
    sum = sum + cross(a, bigVec(&in[3 * ((k + 1) % n)]));
    extent = largerOf(extent, largerOf(from.x, largerOf(from.y, from.z)));
  }
  const Big bound = n * (n + 10) * 0x1p-52 * extent * extent;
  return shareOf(out.data(), sum, {bound, bound, bound});
}

/// The cubic Bernstein polynomials, or those of degree 2, at t.
std::array<Big, 4> bernstein(int degree, const Big& t) {
  const Big s = 1 - t;
  if (degree == 2) return {s * s, 2 * s * t, t * t, Big{0}};
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}
/// In an input: the x of 16 points, or their coordinates; then u and v.
BezierPatch patchOf(In in) {
  BezierPatch patch;
  for (std::size_t k = 0; k < 16; ++k)
    patch.p[k] = in.size() == 18 ? glm::dvec3{in[k], 0, 0} : glmOf(&in[3 * k]);
  return patch;
}
double judgeBezierPoint(In in, In out) {
  const auto u = bernstein(3, big(in[16])), v = bernstein(3, big(in[17]));
  Big sum = 0, most = 0;
  for (int k = 0; k < 16; ++k) {
    sum += u[k / 4] * v[k % 4] * big(in[k]);
    most = largerOf(most, abs(big(in[k])));
  }
  return shareOf(out[0], sum, most * 0x1p-49 + 0x1p-1070);
}
double judgeBezierNormal(In in, In out) {
  const auto at = [&](int i, int j) { return bigVec(&in[3 * (4 * i + j)]); };
  const auto u2 = bernstein(2, big(in[48])), u3 = bernstein(3, big(in[48]));
  const auto v2 = bernstein(2, big(in[49])), v3 = bernstein(3, big(in[49]));
  BigVec du{0, 0, 0}, dv{0, 0, 0};
  Big longestU = 0, longestV = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) {
      const BigVec alongU = at(i + 1, j) - at(i, j), alongV = at(j, i + 1) - at(j, i);
      du = du + alongU * (u2[i] * v3[j]);
      dv = dv + alongV * (v2[i] * u3[j]);
      longestU = largerOf(longestU, lengthOf(alongU));
      longestV = largerOf(longestV, lengthOf(alongV));
    }
  const BigVec product = cross(du, dv);
  const Big length = lengthOf(product), longest = longestU * longestV;
  if (length <= 0x1p-39 * longest) return 0.0;  // it may vanish, and a limit take its place
  return toDouble(lengthOf(bigVec(out.data()) * length - product) / (0x1p-47 * longest));
}

/// The normal at the apex of a fan of three triangles. In an input: the rule, then apex and four corners.
constexpr std::array kRules{NormalRule::Sum, NormalRule::Area, NormalRule::Angle};
Numbers runVertexNormal(In in) {
  Mesh mesh;
  for (int k = 1; k < 16; k += 3) mesh.points.push_back(glmOf(&in[k]));
  for (int k = 1; k < 4; ++k) mesh.addFace(std::array{0, k, k + 1}, 0);
  const Vertices vertices = smoothVertices(mesh, kRules[static_cast<std::size_t>(in[0])]);
  return numbersOf(vertices.vertices[vertices.ofCorner[0]].N);
}
double judgeVertexNormal(In in, In out) {
  const NormalRule rule = kRules[static_cast<std::size_t>(in[0])];
  const BigVec apex = bigVec(&in[1]);
  BigVec sum{0, 0, 0};
  Big total = 0, doubt = 0;
  for (int k = 4; k < 13; k += 3) {
    const BigVec a = bigVec(&in[k]) - apex, b = bigVec(&in[k + 3]) - apex, v = cross(a, b);
    const Big area = lengthOf(v), longest = largerOf(dot(a, a), dot(b, b));
    // Nothing is claimed for faces that are nearly lines, or so small that their area is no number.
    if (area < longest * 0x1p-30 || longest < 0x1p-900) return 0.0;
    const Big weight = rule == NormalRule::Sum    ? Big{1}
                       : rule == NormalRule::Area ? area
                                                  : Big{atan2(area, dot(a, b))};
    sum = sum + v * Big{weight / area};
    total += weight;
    doubt += weight * longest / area;
  }
  const Big length = lengthOf(sum);
  if (length <= 0x1p-30 * total) return 0.0;
  return toDouble(lengthOf(bigVec(out.data()) * length - sum) / (0x1p-47 * (total + doubt)));
}

// Views. In an input of ranges:
//   0 whether parallel, 1 width, 2 height, 3 D, 4 5 prp.x and prp.y over D, 6 7 the window's lower corner
//   over D, 8 9 its size over D, 10 distance of the front plane over D, 11 that of the back plane over that
//   of the front plane, 12 d over the front's distance, 13 14 where on the window; for some, 15 VPN, 18 VUP.
// Prepared: parallel, width, height, prp, window min, window max, front, back, then the point in VRC; then
// the rest of the input.
constexpr std::size_t kPoint = 12, kVpn = 15, kVup = 18, kRest = 21;

Inputs viewInput() {
  return integers(0, 1) + 2 * integers(1, kMaxPicture) + doubles(0x1p-40, 0x1p40) + 4 * doubles(-10, 10) +
         2 * doubles(0x1p-14, 0x1p10) + doubles(0x1p-20, 1) + 2 * doubles(1, 0x1p40) + 2 * doubles(0, 1);
}
Inputs turnedViewInput() { return viewInput() + 6 * doubles(-1, 1); }

/// The axes of a turned view, exactly. `across` is the sine of the angle of VPN and VUP.
struct Axes {
  BigVec u, v, n;
  Big across;
  explicit Axes(const double* vpn) : n{unitOf(bigVec(vpn))} {
    const BigVec right = cross(unitOf(bigVec(vpn + 3)), n);
    across = lengthOf(right), u = unitOf(right), v = cross(n, u);
  }
  /// From VRC and into it.
  [[nodiscard]] BigVec world(const BigVec& p) const { return u * p.x + v * p.y + n * p.z; }
  [[nodiscard]] BigVec vrc(const BigVec& p) const { return {dot(u, p), dot(v, p), dot(n, p)}; }
};

Numbers preparedView(In in) {
  const double D = in[3], dF = D * in[10], dB = dF * in[11], d = dF * in[12];
  const double px = D * in[4], py = D * in[5], left = D * in[6], low = D * in[7];
  const double right = left + D * in[8], high = low + D * in[9], front = D - dF, back = D - dB;
  if (!(left < right && low < high && front > back && d <= dB && (front < D || in[0] > 0))) return {};
  const double x = left + (right - left) * in[13], y = low + (high - low) * in[14];
  const double q = d / D, Z = D - d;
  // Along the projector through the place on the window.
  const double slope = in[0] > 0 ? Z / D : 0, cx = left / 2 + right / 2, cy = low / 2 + high / 2;
  const double X = in[0] > 0 ? x + slope * (px - cx) : px + (x - px) * q;
  const double Y = in[0] > 0 ? y + slope * (py - cy) : py + (y - py) * q;
  return Numbers{in[0], in[1], in[2], px, py, D, left, low, right, high, front, back, X, Y, Z} +
         slice(in, 15, in.size());
}
/// The point of the view is one of the world, VRP being 0.
Numbers preparedTurnedView(In in) {
  Numbers v = preparedView(in);
  if (v.empty()) return {};
  const Axes axes{&v[kVpn]};
  if (axes.across < 0x1p-10 || lengthOf(axes.n) == 0) return {};
  const BigVec p = axes.world(bigVec(&v[kPoint]));
  v[kPoint] = toDouble(p.x), v[kPoint + 1] = toDouble(p.y), v[kPoint + 2] = toDouble(p.z);
  return v;
}
ViewSpec viewOf(In in) {
  ViewSpec view;
  view.projection = in[0] > 0 ? Projection::Parallel : Projection::Perspective;
  view.prp = glmOf(&in[3]);
  view.windowMin = {in[6], in[7]}, view.windowMax = {in[8], in[9]};
  view.front = in[10], view.back = in[11];
  if (in.size() > kVpn) view.vpn = glmOf(&in[kVpn]), view.vup = glmOf(&in[kVup]);
  return view;
}
/// The same view, exactly.
struct BigView {
  bool parallel;
  Big width, height, D, left, low, right, high, front, back, cx, cy, perX, perY;
  BigVec prp, projector;  ///< the projector of the window's centre
  explicit BigView(In in) : parallel{in[0] > 0}, prp{bigVec(&in[3])} {
    width = big(in[1]), height = big(in[2]), D = prp.z;
    left = big(in[6]), low = big(in[7]), right = big(in[8]), high = big(in[9]);
    front = big(in[10]), back = big(in[11]);
    cx = (left + right) / 2, cy = (low + high) / 2;
    perX = width / (right - left), perY = height / (high - low);
    projector = prp - BigVec{cx, cy, 0};
  }
};

/// Where a point of VRC lies on the screen, in pixels, by the projector's meeting with the view plane; and
/// how far view.h lets it be off, in units of 2^-53. `reach` is the size of what rounds in the point.
struct OnScreen {
  BigVec at, bound;
  OnScreen(In in, const BigVec& p, const Big& reach) {
    const BigView w{in};
    const Big hx = abs(w.cx - w.prp.x) / w.D, hy = abs(w.cy - w.prp.y) / w.D;
    const Big sidesX = abs(w.left) + abs(w.right), sidesY = abs(w.low) + abs(w.high);
    if (w.parallel) {
      const BigVec moved = p - w.projector * (p.z / w.D);
      at = {(moved.x - w.left) * w.perX, (w.high - moved.y) * w.perY, (p.z - w.back) * w.perX};
      bound = {w.perX * (reach + hx * reach + abs(w.prp.x) * reach / w.D + sidesX) + w.width,
               w.perY * (reach + hy * reach + abs(w.prp.y) * reach / w.D + sidesY) + w.height,
               w.perX * (reach + abs(w.front) + abs(w.back))};
      return;
    }
    const Big d = w.D - p.z, q = w.D / d, deep = (reach + w.D) / d;
    const BigVec moved = w.prp + (p - w.prp) * q;
    at = {(moved.x - w.left) * w.perX, (w.high - moved.y) * w.perY,
          w.perX * w.D * w.D * (1 / d - 1 / (w.D - w.back))};
    bound = {w.perX * q * (reach + abs(w.prp.x) + (hx + sidesX / w.D) * (reach + w.D)) +
                 (abs(at.x) + w.width) * deep,
             w.perY * q * (reach + abs(w.prp.y) + (hy + sidesY / w.D) * (reach + w.D)) +
                 (abs(at.y) + w.height) * deep,
             w.perX * w.D * w.D / (w.D - w.front) * deep};
  }
};

Numbers runProjection(In in) {
  const ViewSpec view = viewOf(in);
  const glm::dvec4 p = screenFromCanonical(view, whole(in[1]), whole(in[2])) * canonicalFromVrc(view) *
                       glm::dvec4{glmOf(&in[kPoint]), 1.0};
  return {p.x / p.w, p.y / p.w, p.z / p.w};
}
double judgeProjection(In in, In out) {
  const BigVec p = bigVec(&in[kPoint]);
  const OnScreen exact{in, p, lengthOf(p)};
  return shareOf(out.data(), exact.at, exact.bound * Big{32 * kU});
}

Numbers runRotation(In in) {
  ViewSpec view;
  view.vpn = glmOf(&in[0]), view.vup = glmOf(&in[3]);
  const glm::dmat3 R = vrcRotation(view);
  return numbersOf(R[0]) + numbersOf(R[1]) + numbersOf(R[2]);
}
double judgeRotation(In in, In out) {
  const Axes a{in.data()};
  const Big bound = 0x1p-48 / a.across;
  const std::array columns{BigVec{a.u.x, a.v.x, a.n.x}, BigVec{a.u.y, a.v.y, a.n.y},
                           BigVec{a.u.z, a.v.z, a.n.z}};
  double worst = 0;
  for (std::size_t k = 0; k < 3; ++k)
    worst = std::max(worst, shareOf(&out[3 * k], columns[k], {bound, bound, bound}));
  return worst;
}

/// The whole way of a vertex to the grid, by snap(). In the rest of an input: VRP over D.
Numbers preparedSnap(In in) {
  Numbers v = preparedTurnedView(in);
  if (v.empty()) return v;
  for (std::size_t k = 0; k < 3; ++k) {
    v[kRest + k] *= in[3];
    v[kPoint + k] = toDouble(big(v[kPoint + k]) + big(v[kRest + k]));
  }
  return v;
}
Numbers runSnap(In in) {
  ViewSpec view = viewOf(in);
  view.vrp = glmOf(&in[kRest]);
  // A triangle of the point and two others beside it, all as deep.
  const glm::dvec3 p = glmOf(&in[kPoint]);
  const glm::dmat3 R = vrcRotation(view);
  const double d = in[0] > 0 ? 1.0 : (in[5] - (R * (p - view.vrp)).z) / in[5];
  const auto row = [&](int r) { return glm::dvec3{R[0][r], R[1][r], R[2][r]}; };
  Mesh mesh;
  mesh.points = {p, p + (in[8] - in[6]) * d * row(0), p + (in[9] - in[7]) * d * row(1)};
  mesh.addFace(std::array{0, 1, 2}, 0);
  const SnappedScene scene = snap(mesh, divideFaces(mesh), view, whole(in[1]), whole(in[2]), Cull::Keep);
  for (std::size_t k = 0; k < scene.vertices.size(); ++k)
    if (scene.source[k] == 0) {
      const glm::ivec3& at = scene.vertices[k];
      return {double(at.x), double(at.y), double(at.z), double(scene.zShift),
              std::fegetround() == FE_TONEAREST ? 0.5 : 1.0};
    }
  return {};
}
double judgeSnap(In in, In out) {
  if (out.empty()) return 0.0;  // clipped, or without area
  const Axes axes{&in[kVpn]};
  const BigVec p = bigVec(&in[kPoint]) - bigVec(&in[kRest]);
  const OnScreen exact{in, axes.vrc(p), lengthOf(p) / axes.across};
  const Big steps = kGrid, zSteps = big(std::ldexp(double{kGrid}, -whole(out[3])));
  // What is left of the error without that of the snap itself.
  const auto left = [&](double at, const Big& place, const Big& bound, const Big& step) {
    return toDouble((abs(big(at) - place * step) - big(out[4])) / (bound * 64 * kU * step));
  };
  return std::max({0.0, left(out[0], exact.at.x, exact.bound.x, steps),
                   left(out[1], exact.at.y, exact.bound.y, steps),
                   left(out[2], exact.at.z, exact.bound.z, zSteps)});
}

/// The vertex that clip() makes on an edge. In an input: the plane's number, zFront, the two ends.
Numbers runClip(In in) {
  std::vector<ClipVertex> polygon{{{in[2], in[3], in[4], in[5]}, 0}, {{in[6], in[7], in[8], in[9]}, 1}};
  std::vector<Between> made;
  clip(polygon, clipPlanes(in[1], kMaxPicture), 1u << static_cast<unsigned>(in[0]), made);
  if (made.empty()) return {};
  Numbers result{static_cast<double>(made[0].a), made[0].t};
  for (const ClipVertex& v : polygon)
    if (v.source < 0) result.insert(result.end(), {v.p.x, v.p.y, v.p.z, v.p.w});
  return result;
}
double judgeClip(In in, In out) {
  if (out.empty()) return 0.0;
  // The edge runs there and back, so it is cut twice, with the same bits.
  if (out.size() != 10 || !std::equal(&out[2], &out[6], &out[6])) return kWrong;
  if (!(out[1] >= 0 && out[1] <= 1)) return kWrong;
  const glm::dvec4 plane = clipPlanes(in[1], kMaxPicture)[static_cast<std::size_t>(in[0])];
  Big height = 0, sizes = 0;
  double worst = 0;
  const std::size_t inside = out[0] == 0 ? 2 : 6, outside = 8 - inside;
  for (int k = 0; k < 4; ++k) {
    const Big a = big(in[inside + k]), b = big(in[outside + k]), factor = big(plane[k]);
    height += factor * big(out[2 + k]);
    sizes += abs(factor) * (abs(a) + abs(b));
    const Big bound = 0x1p-51 * (abs(a) + abs(b)) + 0x1p-1070;
    worst = std::max(worst, shareOf(out[2 + k], a + (b - a) * big(out[1]), bound));
  }
  return std::max(worst, toDouble(abs(height) / (0x1p-49 * sizes + 0x1p-1070)));
}

// Triangles on the grid: nine integers each.
constexpr double kReach = 0x1p29, kDeep = 0x1p30;

Inputs triangles(int count) { return 3 * count * (2 * integers(-kReach, kReach) + integers(0, kDeep)); }
using Triangle = std::array<glm::ivec3, 3>;
Triangle triangleAt(const double* v) { return {glmOf(v), glmOf(v + 3), glmOf(v + 6)}; }

/// Turned so that they run counter-clockwise. Without an area there is nothing to judge.
template <int count>
Numbers turned(In in) {
  Numbers v = in;
  for (int t = 0; t < count; ++t) {
    const std::int64_t area = doubleArea(triangleAt(&v[9 * t]).data(), 3);
    if (area == 0) return {};
    if (area < 0) std::swap_ranges(&v[9 * t + 3], &v[9 * t + 6], &v[9 * t + 6]);
  }
  return v;
}

/// The plane through a triangle with an area: Cramer's rule, as the comment of ScreenPlane defines it.
ScreenPlane planeOf(const Triangle& t) {
  const Int128 x1 = t[1].x - t[0].x, y1 = t[1].y - t[0].y, z1 = t[1].z - t[0].z;
  const Int128 x2 = t[2].x - t[0].x, y2 = t[2].y - t[0].y, z2 = t[2].z - t[0].z;
  Int128 A = z1 * y2 - z2 * y1, B = x1 * z2 - x2 * z1, C = x1 * y2 - x2 * y1;
  if (C < 0) A = -A, B = -B, C = -C;
  ScreenPlane plane;
  plane.A = static_cast<std::int64_t>(A), plane.B = static_cast<std::int64_t>(B);
  plane.C = static_cast<std::int64_t>(C), plane.D = C * t[0].z - A * t[0].x - B * t[0].y;
  return plane;
}
struct ExactPlane {
  Whole A, B, C, D;
  explicit ExactPlane(const double* triangle) {
    const ScreenPlane p = planeOf(triangleAt(triangle));
    A = p.A, B = p.B, C = p.C, D = Whole{mp::cpp_int{p.D}};
  }
  [[nodiscard]] Big at(const Big& x, const Big& y) const {
    return (Big{A} * x + Big{B} * y + Big{D}) / Big{C};
  }
};
/// a x + b y + c is C_P C_Q (z_P - z_Q).
struct WholeLine {
  Whole a, b, c;
  WholeLine(const ExactPlane& P, const ExactPlane& Q)
      : a{P.A * Q.C - Q.A * P.C}, b{P.B * Q.C - Q.B * P.C}, c{P.D * Q.C - Q.D * P.C} {}
  [[nodiscard]] Whole at(const Whole& x, const Whole& y) const { return a * x + b * y + c; }
};

/// In an input: a triangle, a place.
double judgeDepth(In in, In out) {
  const Big exact = ExactPlane{in.data()}.at(big(in[9]), big(in[10]));
  return shareOf(out[0], exact, 4 * kU * abs(exact));
}

/// In an input: two triangles, a place. Where the order is right, the share says how much of its filter's
/// tolerance a difference takes that misleads.
Numbers runCompare(In in) {
  const ScreenPlane P = planeOf(triangleAt(in.data())), Q = planeOf(triangleAt(&in[9]));
  const auto x = static_cast<std::int64_t>(in[18]), y = static_cast<std::int64_t>(in[19]);
  return {static_cast<double>(compareDepths(P, Q, x, y)), depthAt(P, x, y), depthAt(Q, x, y)};
}
double judgeCompare(In in, In out) {
  const ExactPlane P{in.data()}, Q{&in[9]};
  const Big apart = P.at(big(in[18]), big(in[19])) - Q.at(big(in[18]), big(in[19]));
  const int sign = WholeLine{P, Q}.at(Whole{in[18]}, Whole{in[19]}).sign();
  if (out[0] != sign) return kWrong;
  const Big tolerance = 0x1p-50 * (abs(big(out[1])) + abs(big(out[2])));
  if (tolerance == 0) return 0.0;
  // A difference that misleads must stay below the tolerance. Others count a little, to lead the search.
  const Big difference = big(out[1]) - big(out[2]);
  if (difference.sign() != sign) return toDouble(abs(difference) / tolerance);
  return 0.1 * toDouble(abs(difference - apart) / tolerance);
}

/// In an input: two triangles, a pixel.
Numbers runNearer(In in) {
  const ScreenPlane P = planeOf(triangleAt(in.data())), Q = planeOf(triangleAt(&in[9]));
  return {static_cast<double>(nearer(P, Q, whole(in[18]), whole(in[19])))};
}
double judgeNearer(In in, In out) {
  const WholeLine l{ExactPlane{in.data()}, ExactPlane{&in[9]}};
  const Whole x = Whole{in[18]} * kGrid + kGrid / 2, y = Whole{in[19]} * kGrid + kGrid / 2;
  const Whole value = l.at(x, y);
  if (out[0] != (value != 0 ? value : l.a != 0 ? l.a : l.b).sign()) return kWrong;
  // How small the difference is, as a share of its terms: 0.9 at a tie.
  const Big terms = abs(Big{l.a * x}) + abs(Big{l.b * y}) + abs(Big{l.c});
  return terms == 0 ? 0.0 : 0.9 / (1 + toDouble(abs(Big{value}) / terms) * 0x1p60);
}

/// In an input: how many points, 3 or 4, then their coordinates. Of four, the plane goes through the least
/// point, the farthest from it, and what spans most with both. Int128 holds all of it.
Numbers preparedPlane(In in) {
  Numbers v = slice(in, 1, 1 + 3 * static_cast<std::size_t>(in[0]));
  const auto area = [&](std::size_t a, std::size_t b, std::size_t c) {
    const std::array<glm::ivec3, 3> p{glmOf(&v[3 * a]), glmOf(&v[3 * b]), glmOf(&v[3 * c])};
    return doubleArea(p.data(), 3);
  };
  const bool spread = area(0, 1, 2) != 0 || (in[0] > 3 && (area(0, 1, 3) != 0 || area(0, 2, 3) != 0));
  return spread ? v : Numbers{};
}
Numbers runPlane(In in) {
  std::vector<glm::ivec3> p;
  for (std::size_t k = 0; k < in.size(); k += 3) p.emplace_back(glmOf(&in[k]));
  const ScreenPlane plane = planeThrough(p.data(), static_cast<int>(p.size()));
  if (p.size() > 3) {
    const auto before = [](const glm::ivec3& a, const glm::ivec3& b) {
      return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    const auto swapMost = [&](std::size_t to, const auto& measure) {
      std::swap(p[to], *std::ranges::max_element(p, [&](const glm::ivec3& a, const glm::ivec3& b) {
                  return measure(a) != measure(b) ? measure(a) < measure(b) : before(b, a);
                }));
    };
    std::ranges::iter_swap(p.begin(), std::ranges::min_element(p, before));
    swapMost(1, [&, at = p[0]](const glm::ivec3& q) {
      const std::int64_t x = q.x - at.x, y = q.y - at.y;
      return x * x + y * y;
    });
    swapMost(2, [&, a = p[0], b = p[1]](const glm::ivec3& q) {
      const std::array on{a, b, q};
      return std::abs(doubleArea(on.data(), 3));
    });
  }
  bool right = plane.C > 0 && plane.C == std::abs(doubleArea(p.data(), 3));
  for (std::size_t k = 0; k < 3; ++k)
    right &= Int128{plane.C} * p[k].z == Int128{plane.A} * p[k].x + Int128{plane.B} * p[k].y + plane.D;
  const auto most = static_cast<double>(std::max({std::abs(plane.A), std::abs(plane.B), plane.C}));
  return {right ? std::max(most * 0x1p-61, std::abs(static_cast<double>(plane.D)) * 0x1p-93) : kWrong};
}

/// The h of a plane for a point. In an input: the normal, d beyond the point, the point, u. Prepared: a unit
/// normal, d, point, u.
Numbers preparedFit(In in) {
  const glm::dvec3 N = unit(glmOf(&in[0]));
  if (N == glm::dvec3{0.0}) return {};
  return numbersOf(N) + Numbers{glm::dot(N, glmOf(&in[4])) + in[3]} + slice(in, 4, 8);
}
Numbers runFit(In in) {
  const std::array<RoundedPoint, 1> point{{{glmOf(&in[4]), in[7]}}};
  return {fitOf({glmOf(&in[0]), in[3]}, point, Rounding{1.0, 1.0}).h};
}
double judgeFit(In in, In out) {
  const BigVec N = bigVec(&in[0]);
  const Big off = abs(dot(N, bigVec(&in[4])) - big(in[3])), e = big(0x1p-46) + big(0x1p-50);
  const Big r = big(in[7]) * sumOf(absOf(N)) + e * lengthOf(N);  // side and magnitude 1
  return shareOf(out[0], off / r, (off * 0x1p-50 + 0x1p-49) / r);
}

/// The doubt of a face whose record is the plane of a triangle on the grid. In the rest of an input: the
/// triangle, the shift of a z step, the rounding, and the z where the doubt is asked. The scene's side is 1.
constexpr std::size_t kTriangle = kRest, kShift = 30, kRounding = 31, kZ = 32;
Numbers preparedDoubt(In in) {
  const Numbers v = preparedTurnedView(in);
  return v.empty() || doubleArea(triangleAt(&v[kTriangle]).data(), 3) == 0 ? Numbers{} : v;
}
Numbers runDoubt(In in) {
  const DepthDoubt doubt{viewOf(in), whole(in[1]), whole(in[2]), whole(in[kShift])};
  return {doubt.of(planeOf(triangleAt(&in[kTriangle])), in[kRounding]).at(in[kZ])};
}
double judgeDoubt(In in, In out) {
  // The triangle's corners in VRC, as the grid has them, and so the plane of the model.
  const BigView w{in};
  const Big dBack = w.D - w.back, stepX = 1 / w.perX / kGrid, stepY = 1 / w.perY / kGrid,
            stepZ = stepX * big(std::ldexp(1.0, whole(in[kShift])));
  std::array<BigVec, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    const BigVec corner = bigVec(&in[kTriangle + 3 * k]);
    const BigVec at = BigVec{w.left + stepX * corner.x, w.high - stepY * corner.y, 0} - w.prp;
    p[k] = w.parallel ? at + w.projector * ((w.back + stepZ * corner.z) / w.D)
                      : at * (1 / (stepZ * corner.z / (w.D * w.D) + 1 / dBack) / w.D);
  }
  const BigVec m = unitOf(cross(p[1] - p[0], p[2] - p[0]));
  const Big rounding = big(in[kRounding]) * sumOf(absOf(Axes{&in[kVpn]}.world(m)));
  const ExactPlane exact{&in[kTriangle]};
  const Big grid = (1 + (abs(Big{exact.A}) + abs(Big{exact.B})) / Big{exact.C}) / 2;
  const Big away = w.parallel ? abs(dot(m, w.projector)) / w.D : abs(dot(m, p[0]));
  if (away == 0) return 0.0;
  const Big moved =
      rounding / away * (w.parallel ? Big{1 / stepZ} : Big{big(in[kZ]) + w.D * w.D / (stepZ * dBack)});
  return grid + moved > 0x1p127 ? 0.0 : shareOf(out[0], grid + moved, (grid + moved) * 0x1p-23);
}

/// Planes of the model at a place on the grid. In the rest of an input: the shift of a z step, x and y of the
/// place, and a normal for each plane, which becomes a unit vector. All planes pass through the view's point.
constexpr std::size_t kZShift = kRest, kX = 22, kY = 23, kNormal = 24;
Inputs recordInput(int planes) {
  return turnedViewInput() + integers(0, 40) + 2 * integers(-0x1p29, 0x1p29) + 3 * planes * doubles(-1, 1);
}
Numbers preparedRecord(In in) {
  Numbers v = preparedTurnedView(in);
  for (std::size_t k = kNormal; k < v.size(); k += 3) {
    const glm::dvec3 N = unit(glmOf(&v[k]));
    if (N == glm::dvec3{0.0}) return {};
    v[k] = N.x, v[k + 1] = N.y, v[k + 2] = N.z;
  }
  return v;
}
PlaneRecords recordsOf(In in) { return {viewOf(in), whole(in[1]), whole(in[2]), whole(in[kZShift])}; }
ModelPlane modelPlaneOf(In in, std::size_t k) { return {glmOf(&in[kNormal + 3 * k]), glmOf(&in[kPoint])}; }
glm::ivec2 placeOf(In in) { return {whole(in[kX]), whole(in[kY])}; }

/// A depth by the ray through the place, and its slopes: differences of the depths at two places, which are
/// linear in between. How far plane_record.h lets each be off.
struct ExactDepth {
  BigVec z, bound;  ///< the depth, then the slopes
  bool claimed = false;

  ExactDepth(In in, std::size_t plane) {
    const BigView w{in};
    const Axes axes{&in[kVpn]};
    const BigVec N = bigVec(&in[kNormal + 3 * plane]), p = bigVec(&in[kPoint]), m = axes.vrc(N);
    const BigVec eye = axes.world(w.prp), projector = axes.world(w.projector);
    const Big x = big(in[kX]), y = big(in[kY]), perX = 1 / w.perX, perY = 1 / w.perY, D = w.D;
    const Big zStep = perX / kGrid * big(std::ldexp(1.0, whole(in[kZShift])));
    // Where the ray through a place of the view plane meets the plane, as n; and so z.
    const auto depth = [&](const Big& atX, const Big& atY) {
      const BigVec place = axes.world({w.left + atX * perX / kGrid, w.high - atY * perY / kGrid, 0});
      const BigVec along = w.parallel ? projector : eye - place;
      const Big t = dot(N, p - place) / dot(N, along);  // place + t along
      if (w.parallel) return Big{(t * D - w.back) / zStep};
      return Big{D * D / zStep * (1 / (D - t * D) - 1 / (D - w.back))};
    };
    const Big k = dot(N, p - eye), slope = abs(dot(N, projector) / D), dBack = D - w.back;
    if (slope == 0 || k == 0) return;
    // What rounds: the rotation of the normal, k, the window's size, the place.
    const Big sidesX = abs(w.left) + abs(w.right), sidesY = abs(w.low) + abs(w.high);
    const Big lean = (abs(w.prp.x) + sidesX + abs(w.prp.y) + sidesY) / D;
    const Big turned = lengthOf(N) / axes.across, reach = turned * (lengthOf(p) + lengthOf(eye));
    const Big window = sidesX / (w.right - w.left) + sidesY / (w.high - w.low);
    const Big place = abs(w.prp.x) + abs(w.left) + abs(x * perX / kGrid) * (1 + window) + abs(w.prp.y) +
                      abs(w.high) + abs(y * perY / kGrid) * (1 + window);
    const Big unit = big(0x1p-47);
    const Big off = w.parallel ? Big{turned * (1 + lean) / slope} : Big{reach / abs(k)};
    if (off * unit > 0.25 || (!w.parallel && dBack == 0)) return;
    Big perSlope;
    if (w.parallel) {
      const Big sum = (reach + turned * (place + lean * D)) / slope;
      bound.x = (sum * (1 + off) + D + abs(w.back)) * (1 + window) / zStep;
      perSlope = 1 / slope / kGrid / zStep;
    } else {
      const Big perK = D / zStep / abs(k), sum = turned * (place + D);
      bound.x =
          (perK * sum * (1 + off) + D * D / zStep / dBack * (1 + (D + abs(w.back)) / dBack)) * (1 + window);
      perSlope = perK / kGrid;
    }
    bound.y = perSlope * (abs(m.x) * (off + window) + turned) * perX;
    bound.z = perSlope * (abs(m.y) * (off + window) + turned) * perY;
    bound = bound * unit;
    z.x = depth(x, y);
    z.y = depth(x + 1, y) - z.x, z.z = depth(x, y + 1) - z.x;
    claimed = true;
  }
};

Numbers runRecord(In in) {
  const glm::ivec2 place = placeOf(in);
  const auto record = recordsOf(in).of(modelPlaneOf(in, 0), place);
  if (!record) return {};
  const Int128 atPlace = Int128{record->A} * place.x + Int128{record->B} * place.y + record->D;
  const double C = static_cast<double>(record->C);
  return {static_cast<double>(atPlace) / C, static_cast<double>(record->A) / C,
          static_cast<double>(record->B) / C};
}
/// Rounding to a record adds 2^-22 steps, and 2^-31 of a slope.
double judgeRecord(In in, In out) {
  const ExactDepth e{in, 0};
  if (out.empty() || !e.claimed) return 0.0;
  const Big rounding = largerOf(abs(e.z.y), abs(e.z.z)) * 0x1p-31 + big(0x1p-59);
  return shareOf(out.data(), e.z, e.bound + BigVec{big(0x1p-22) + abs(e.z.x) * 0x1p-51, rounding, rounding});
}

/// How much nearer one plane is than another, at the place.
Numbers runAhead(In in) {
  const PlaneRecords records = recordsOf(in);
  const ModelPlane P = modelPlaneOf(in, 0), Q = modelPlaneOf(in, 1);
  const glm::ivec2 place = placeOf(in);
  const Ahead ahead = records.ahead(P, Q, place);
  if (!records.of(P, place) || !records.of(Q, place)) return {};
  return {ahead.at(place.x, place.y), ahead.x, ahead.y};
}
double judgeAhead(In in, In out) {
  const ExactDepth a{in, 0}, b{in, 1};
  if (out.empty() || !a.claimed || !b.claimed) return 0.0;
  const Big x = abs(big(in[kX])), y = abs(big(in[kY]));
  const BigVec sizes = absOf(a.z) + absOf(b.z), bound = a.bound + b.bound;
  const Big terms = sizes.x + x * (sizes.y + bound.y) + y * (sizes.z + bound.z);
  return shareOf(out.data(), a.z - b.z,
                 bound + BigVec{terms * 0x1p-50, sizes.y * 0x1p-52, sizes.z * 0x1p-52});
}

/// Whether two faces may touch. In an input: whether there are leads; x and y; for each of two faces, the
/// depth at the origin, the slopes in 2^-20, the two doubts, and the lead.
constexpr std::size_t kFace = 3, kOf = 6;
Inputs touchInput() {
  return integers(0, 1) + 2 * integers(-0x1p30, 0x1p30) +
         2 * (integers(0, 0x1p30) + 2 * integers(-0x1p30, 0x1p30) + floats(0, 0x1p40) + floats(0, 0x1p10) +
              doubles(-0x1p40, 0x1p40));
}
Numbers runTouch(In in) {
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
  return {double(mayTouch(scene, scene.faces[0], scene.faces[1], std::llround(in[1]), std::llround(in[2])))};
}
double judgeTouch(In in, In out) {
  Big lead = 0, own = 0, doubt = 0, terms = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const double* const f = &in[kFace + kOf * k];
    const Big z = big(f[0]) + (big(f[1]) * big(in[1]) + big(f[2]) * big(in[2])) / (1 << 20);
    const Big slack = big(f[3]), byZ = big(f[4]), ahead = in[0] > 0 ? big(f[5]) : Big{0};
    lead += k == 0 ? z : -z, own += k == 0 ? ahead : -ahead;
    doubt += slack + byZ * z;
    terms += abs(z) + slack + abs(byZ * z) + abs(ahead);
  }
  if (terms == 0) return 0.0;
  own += lead;
  const bool leads = in[0] > 0;
  const bool touches = leads ? own <= doubt || (lead <= doubt && 2 * own <= 3 * doubt) : lead <= doubt;
  // How far the nearest of the three comparisons is from a tie.
  Big margin = abs(lead - doubt);
  if (leads) margin = smallerOf(margin, smallerOf(abs(own - doubt), abs(own - doubt * 3 / 2)));
  const double share = toDouble(margin / (terms * 0x1p-49));
  // Right ones count a little, the more the nearer to a tie, to lead the search.
  return (out[0] != 0) == touches ? 0.1 / (1 + share) : share;
}

/// a, b, c of a cut line. The larger of |a|, |b| is scaled to 1, so the exact line is scaled by its own.
Numbers runCutLine(In in) {
  SnappedScene scene;
  for (const std::size_t k : {0u, 9u}) scene.planes.add(planeOf(triangleAt(&in[k])));
  const Line line = Regions{scene}.cut(0, 1);
  return {line.a, line.b, line.c};
}
double judgeCutLine(In in, In out) {
  const WholeLine l{ExactPlane{in.data()}, ExactPlane{&in[9]}};
  const Big most = largerOf(abs(Big{l.a}), abs(Big{l.b}));
  if (most == 0) {  // parallel: c has the sign everywhere
    const int sign = (out[2] > 0) - (out[2] < 0);
    return out[0] == 0 && out[1] == 0 && sign == l.c.sign() ? 0.0 : kWrong;
  }
  const BigVec exact = BigVec{Big{l.a}, Big{l.b}, Big{l.c}} * (1 / most);
  return shareOf(out.data(), exact, absOf(exact) * Big{6 * kU});
}

}  // namespace

std::vector<Kernel> geometryKernels() {
  const Inputs ends = 2 * integers(-0x1p30, 0x1p30),
               points = 2 * integers(-kReach, kReach) + integers(0, kDeep);
  return {
      {"sine", "trig.h: 2^-51", doubles(-0x1p52, 0x1p52), nullptr,
       [](In in) { return Numbers{sinCosDegrees(in[0]).sin}; },
       [](In in, In out) { return shareOf(out[0], sin(radians(in[0])), 0x1p-51); }},
      {"cosine", "trig.h: 2^-51", doubles(-0x1p52, 0x1p52), nullptr,
       [](In in) { return Numbers{sinCosDegrees(in[0]).cos}; },
       [](In in, In out) { return shareOf(out[0], cos(radians(in[0])), 0x1p-51); }},
      {"tangent", "trig.h: 2^-48 of it, 2^-1000 to 80 degrees", doubles(-80, 80), notTiny<-1000>,
       [](In in) { return Numbers{tanDegrees(in[0])}; },
       [](In in, In out) {
         const Big exact = tan(big(in[0]) * degree());
         return shareOf(out[0], exact, 0x1p-48 * abs(exact));
       }},
      {"arc tangent", "trig.h: 2^-45 degrees", 2 * doubles(-0x1p1000, 0x1p1000), notTiny<-1000>,
       [](In in) { return Numbers{degreesOf(in[0], in[1])}; }, judgeArcTangent},
      {"power", "power.h: n 2^-53 of it; 2^-1068 more below 2^-1022",
       doubles(-kMost, kMost) + integers(0, 1'000'000), nullptr,
       [](In in) {
         return Numbers{power(in[0], whole(in[1])), powerOf(in[0], whole(in[1]))};
       },
       judgePower<double>},
      {"power, single precision", "lanes.h: n 2^-24 of it, n <= 1,024; 2^-140 more below 2^-126",
       floats(0, 1) + integers(0, 1024), nullptr,
       [](In in) { return Numbers{powerOf(static_cast<float>(in[0]), whole(in[1]))}; }, judgePower<float>},
      {"unit vector", "unit.h: 2^-51 of each coordinate, and 2^-1073", 3 * doubles(-kMost, kMost), nullptr,
       [](In in) { return numbersOf(unit(glmOf(&in[0]))); },
       [](In in, In out) {
         const BigVec exact = unitOf(bigVec(&in[0]));
         const Big least = 0x1p-1073;
         return shareOf(&out[0], exact, absOf(exact) * 0x1p-51 + BigVec{least, least, least});
       }},
      {"128 bits to double", "int128.h: 2^-52 of it", digits(), nullptr,
       [](In in) { return Numbers{approximately(int128Of(in))}; },
       [](In in, In out) { return shareOf(out[0], bigOf(in), 0x1p-52 * abs(bigOf(in))); }},
      {"128 bits to two doubles", "two_doubles.h: 2^-100 of it", digits(), nullptr,
       [](In in) {
         const TwoDoubles n = twoDoubles(int128Of(in));
         return Numbers{n.high, n.low};
       },
       [](In in, In out) { return shareOfTwo(&out[0], bigOf(in), bigOf(in)); }, 1},
      {"sum, product, quotient and root of two doubles each",
       "two_doubles.h: 2^-100 of |x| + |y|, of the others themselves; 2^-76 in other modes",
       2 * doubles(-0x1p400, 0x1p400) + 2 * doubles(-1, 1), preparedTwo, runTwo, judgeTwo, 0x1p24},
      {"plane: Newell's vector of 3", "plane.h: n (n + 10) 2^-52 E^2, E from the first corner",
       9 * doubles(-0x1p400, 0x1p400), notTiny<-400>, runNewell, judgeNewell},
      {"plane: Newell's vector of 4", "plane.h: n (n + 10) 2^-52 E^2, E from the first corner",
       12 * doubles(-0x1p400, 0x1p400), notTiny<-400>, runNewell, judgeNewell},
      {"Bezier point", "bezier.h: 2^-49 of the largest coordinate, and 2^-1070",
       16 * doubles(-0x1p1000, 0x1p1000) + 2 * doubles(0, 1), nullptr,
       [](In in) { return Numbers{point(patchOf(in), in[16], in[17]).x}; }, judgeBezierPoint},
      {"Bezier normal", "bezier.h: 2^-47 E / |du x dv / 9|, E the product of the longest edges",
       48 * doubles(-0x1p500, 0x1p500) + 2 * doubles(0, 1), nullptr,
       [](In in) { return numbersOf(normal(patchOf(in), in[48], in[49])); }, judgeBezierNormal, 2, 0.5},
      {"vertex normal of a fan", "vertex_normals.h: 2^-47 (W + sum of w e) / |sum of w N|",
       integers(0, 2) + 15 * doubles(-0x1p100, 0x1p100), nullptr, runVertexNormal, judgeVertexNormal, 2, 0.5},
      {"rotation of the view", "view.h: 2^-48 / sin of the angle of VPN and VUP",
       6 * doubles(-0x1p1000, 0x1p1000),
       // Not where they are parallel: there is a ViewError.
       [](In in) { return Axes{&in[0]}.across > 0x1p-40 ? in : Numbers{}; }, runRotation, judgeRotation, 2,
       0.5},
      {"projection and warp", "view.h: 2^-48 of the sums of the terms", viewInput(), preparedView,
       runProjection, judgeProjection},
      {"clipping", "clip.h: 2^-49 (A + B) off the plane, 2^-51 (|a| + |b|) off the edge",
       integers(0, 5) + doubles(0, 0x1p40) + 8 * doubles(-0x1p100, 0x1p100), notTiny<-900, 2>, runClip,
       judgeClip},
      {"snap of a vertex", "view.h, plane_record.h: beyond half a step, 2^-47 of the sums of the terms",
       turnedViewInput() + 3 * doubles(-0x1p20, 0x1p20), preparedSnap, runSnap, judgeSnap, 2, 0.3},
      {"depth of a plane", "screen_plane.h: 4 2^-53 of it", triangles(1) + ends, turned<1>,
       [](In in) {
         return Numbers{depthAt(planeOf(triangleAt(&in[0])), std::llround(in[9]), std::llround(in[10]))};
       },
       judgeDepth},
      {"order of two depths", "screen_plane.h: exact; its filter: 2^-50 (|zP| + |zQ|)", triangles(2) + ends,
       turned<2>, runCompare, judgeCompare},
      {"nearer plane at a sample", "screen_plane.h: exact", triangles(2) + 2 * integers(0, 8191), turned<2>,
       runNearer, judgeNearer, 1},
      {"plane through points", "screen_plane.h: exact; |A|, |B|, C <= 2^61, |D| <= 2^93",
       integers(3, 4) + 4 * points, preparedPlane, runPlane, [](In, In out) { return out[0]; }, 1},
      {"plane fit: h of a plane", "fit_plane.h: 2^-50 of it, and 2^-49 / r",
       4 * doubles(-1, 1) + 3 * doubles(0, 1) + doubles(0, 1e-4), preparedFit, runFit, judgeFit},
      {"depth doubt", "plane_record.h: 2^-23 of it, up to 2^127",
       turnedViewInput() + triangles(1) + integers(0, 40) + doubles(0, 1e-4) + integers(0, kDeep),
       preparedDoubt, runDoubt, judgeDoubt, 2, 0.3},
      {"plane record", "plane_record.h: 2^-47 of the sums of the terms, and the rounding of a record",
       recordInput(1), preparedRecord, runRecord, judgeRecord, 2, 0.3},
      {"lead of a plane", "plane_record.h: the sum of both planes' bounds, and 2^-50 of the terms",
       recordInput(2), preparedRecord, runAhead, judgeAhead, 2, 0.2},
      {"whether faces touch", "scene_planes.h: exact beyond 2^-49 of the terms", touchInput(), nullptr,
       runTouch, judgeTouch},
      {"meeting line of two planes", "region.h: 6 2^-53 of each coefficient", triangles(2), turned<2>,
       runCutLine, judgeCutLine},
  };
}

}  // namespace xnewell
