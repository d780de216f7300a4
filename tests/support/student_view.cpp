#include "tests/support/student.h"

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace student {

namespace {

constexpr double kPi = 3.14159265358979323846;

using Quad = glm::dvec4;
using Matrix = glm::dmat4;  // by columns

Matrix translation(const Triple& by) {
  Matrix t{1};
  for (int k = 0; k < 3; ++k) t[3][k] = by[k];
  return t;
}
Matrix axes(const Triple& u, const Triple& v, const Triple& n) {
  Matrix r{1};
  for (int k = 0; k < 3; ++k) r[k][0] = u[k], r[k][1] = v[k], r[k][2] = n[k];
  return r;
}
/// About x (0), y (1) or z (2).
Matrix rotation(int axis, double angle) {
  Matrix r{1};
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  r[a][a] = r[b][b] = std::cos(angle);
  r[b][a] = -std::sin(angle), r[a][b] = std::sin(angle);
  return r;
}
Triple negative(const Triple& a) { return {-a[0], -a[1], -a[2]}; }
double length(const Triple& a) { return std::hypot(a[0], a[1], a[2]); }
Triple unit(const Triple& a) { return {a[0] / length(a), a[1] / length(a), a[2] / length(a)}; }
Triple times3(const Matrix& a, const Triple& p) {
  const Quad q = a * Quad{p[0], p[1], p[2], 0};
  return {q[0], q[1], q[2]};
}

struct Viewing {
  Viewing(const World& w, const Program& p) : world{w}, program{p} {
    Triple eye = w.eye, at = w.at;
    if (has("eye-and-look-at-exchanged")) std::swap(eye, at);
    Triple n = unit({eye[0] - at[0], eye[1] - at[1], eye[2] - at[2]});
    if (has("VPN-reversed")) n = negative(n);
    Triple up = w.up;
    if (has("other-VUP"))  // in the plane of VUP and n
      for (int k = 0; k < 3; ++k) up[k] = 3 * up[k] + 0.4 * n[k];
    Triple u = unit(crossOf(up, n)), v = crossOf(n, u);
    if (has("v-is-VUP")) v = unit(w.up);
    if (has("u-left-handed")) u = negative(u);
    R = axes(u, v, n);
    if (has("R-transposed")) R = transpose(R);
    const double ay = std::asin(R[2][0]), ax = std::atan2(-R[2][1], R[2][2]),
                 az = std::atan2(-R[1][0], R[0][0]);
    const auto turn = [](double x, double y, double z) {
      return rotation(0, x) * rotation(1, y) * rotation(2, z);
    };
    if (has("by-angles")) R = turn(ax, ay, az);
    if (has("R-angles-negated")) R = turn(-ax, -ay, -az);
    if (has("R-in-degrees")) R = turn(ax * 180 / kPi, ay * 180 / kPi, az * 180 / kPi);
    if (has("R-wrong-axis")) R = rotation(0, ay) * rotation(1, ax) * rotation(2, az);
    Matrix view = R * translation(negative(eye));
    if (has("view-T-after-R")) view = translation(negative(eye)) * R;
    if (has("view-transposed")) view = transpose(view);
    const double aspect = double(p.width) / p.height;
    double tangent = std::tan(w.fov / 2 * kPi / 180), wide = aspect;
    if (has("fov-in-degrees")) tangent = std::tan(w.fov / 2);
    if (has("fov-not-halved")) tangent = std::tan(w.fov * kPi / 180);
    if (has("aspect-inverted")) wide = 1 / aspect;
    if (has("aspect-forgotten")) wide = 1;
    double high = tangent;
    if (has("fov-horizontal")) high = tangent / aspect;
    // The window's centre is w.shift half heights from the line to the look-at point.
    const double half = std::tan(w.fov / 2 * kPi / 180);
    if (!has("shear-forgotten") && !has("window-centre-forgotten")) {
      const double sign = has("shear-negated") ? -1 : 1;
      SH[2][0] = sign * w.shift[0] * half, SH[2][1] = sign * w.shift[1] * half;
    }
    const double B = w.back;
    S[0][0] = 1 / (high * wide * B), S[1][1] = 1 / (high * B), S[2][2] = 1 / B;
    if (has("flip-y") || has("turned-180")) S[1][1] *= -1;
    if (has("flip-x") || has("turned-180")) S[0][0] *= -1;
    if (has("opengl")) S[0][0] *= B, S[1][1] *= B;  // w is the distance itself
    const double least = w.front / B;
    Matrix M{1};
    M[2][2] = 1 / (1 - least), M[3][2] = least / (1 - least), M[2][3] = -1, M[3][3] = 0;
    all = M * S * SH * view;
    if (has("view-S-first")) all = M * SH * view * S;
    if (has("rows-for-columns")) all = transpose(all);
  }
  [[nodiscard]] bool has(const char* key) const { return program.mistake == key || program.variant == key; }

  const World& world;
  const Program& program;
  Matrix R{1}, SH{1}, S{1}, all{1};
};

}  // namespace

Triple normalInView(const World& world, const Program& program, const Triple& N) {
  const Viewing view{world, program};
  const Matrix back = transpose(view.R), linear = view.S * view.SH;
  if (program.mistake == "N-not-turned") return times3(back, N);
  if (program.mistake == "N-by-M") return unit(times3(back, times3(linear, times3(view.R, N))));
  if (program.mistake != "N-scaled") return N;
  // The inverse of the transpose, of a matrix whose last row is (0, 0, s).
  const Triple m = times3(view.R, N);
  const double x = m[0] / linear[0][0], y = m[1] / linear[1][1];
  return times3(back, {x, y, (m[2] - x * linear[2][0] - y * linear[2][1]) / linear[2][2]});
}

Triple lightInView(const World& world, const Program& program, const Triple& light, const Triple& P) {
  Triple L = times3(transpose(Viewing{world, program}.R), light);
  if (world.lamp)
    for (int k = 0; k < 3; ++k) L[k] -= P[k] - world.eye[k];
  return L;
}

Result drawByMatrices(const World& world, const Program& program,
                      const std::function<int(int face)>& cellOf) {
  const Viewing view{world, program};
  const int W = program.width, H = program.height;
  Result r{W, H, {}, {}, {}};
  r.cell.assign(std::size_t(W) * H, 0);
  std::vector<double> nearest(r.cell.size(), -1e300);
  const bool clips = !view.has("divided-before-clipping"), divides = !view.has("w-not-divided");
  for (std::size_t f = 0; f < world.faces.size(); ++f) {
    std::vector<Quad> corners, kept;
    for (const int k : world.faces[f]) {
      const Triple& p = world.points[k];
      corners.push_back(view.all * Quad{p[0], p[1], p[2], 1});
    }
    const double near = world.front / world.back;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Quad &a = corners[k], &b = corners[(k + 1) % corners.size()];
      const bool in = !clips || !divides || a[3] >= near, out = !clips || !divides || b[3] >= near;
      if (in) kept.push_back(a);
      if (in == out) continue;
      Quad c{};
      for (int m = 0; m < 4; ++m) c[m] = a[m] + (near - a[3]) / (b[3] - a[3]) * (b[m] - a[m]);
      kept.push_back(c);
    }
    if (view.has("near-plane-negated")) kept.clear();
    std::vector<Triple> at;
    const double w = view.has("viewport-one-short") ? W - 1 : W,
                 h = view.has("viewport-one-short") ? H - 1 : H;
    for (const Quad& q : kept) {
      const double d = divides ? q[3] : 1;
      at.push_back({(q[0] / d + 1) / 2 * w, (1 - q[1] / d) / 2 * h, q[2] / d});
    }
    const double centre = view.has("viewport-half-pixel") ? 0 : 0.5;
    const int cell = kept.empty() ? 0 : cellOf(static_cast<int>(f));
    for (std::size_t k = 1; k + 1 < at.size(); ++k) {
      const Triple &a = at[0], &b = at[k], &c = at[k + 1];
      const double area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
      if (area == 0) continue;
      const double low = std::min({a[1], b[1], c[1]}), high = std::max({a[1], b[1], c[1]});
      for (int j = int(std::clamp(low - 1, 0.0, double(H))); j < H && j <= high; ++j)
        for (int i = 0; i < W; ++i) {
          const double x = i + centre, y = j + centre;
          const double p = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area;
          const double q = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area;
          if (p < 0 || q < 0 || p + q > 1) continue;
          const double z = view.has("z-not-kept") ? 0 : a[2] + p * (b[2] - a[2]) + q * (c[2] - a[2]);
          if (z < nearest[std::size_t(j) * W + i]) continue;
          nearest[std::size_t(j) * W + i] = z, r.cell[std::size_t(j) * W + i] = cell;
        }
    }
  }
  return r;
}

}  // namespace student
