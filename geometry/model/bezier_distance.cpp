#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/model/bezier.h"

namespace xnewell {

namespace {

/// The cubic Bernstein polynomials at t, and their derivatives.
struct Weights {
  std::array<double, 4> value, slope;
};
Weights weights(double t) {
  const double s = 1.0 - t;
  return {{s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t},
          {-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t}};
}

/// The way from a point of the surface to p, and the surface's derivatives there.
struct Way {
  glm::dvec3 to{0}, alongU{0}, alongV{0};
  [[nodiscard]] double square() const { return glm::dot(to, to); }
};
Way wayFrom(const BezierPatch& patch, glm::dvec2 uv, const glm::dvec3& p) {
  const Weights u = weights(uv.x), v = weights(uv.y);
  Way way;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const glm::dvec3& control = patch.p[4 * i + j];
      way.to += u.value[i] * v.value[j] * (p - control);  // the weights sum to 1
      way.alongU += u.slope[i] * v.value[j] * control;
      way.alongV += u.value[i] * v.slope[j] * control;
    }
  return way;
}

}  // namespace

double distanceFrom(const BezierPatch& patch, const glm::dvec3& p, glm::dvec2 uv) {
  constexpr int kSteps = 20, kHalvings = 10;
  Way way = wayFrom(patch, uv, p);
  for (int step = 0; step < kSteps; ++step) {
    const double uu = glm::dot(way.alongU, way.alongU), vv = glm::dot(way.alongV, way.alongV);
    const double uvs = glm::dot(way.alongU, way.alongV);
    const double damping = 0x1p-40 * (uu + vv);  // where a derivative vanishes
    const double a = uu + damping, b = vv + damping, determinant = a * b - uvs * uvs;
    if (!(determinant > 0.0)) break;
    const double byU = glm::dot(way.alongU, way.to), byV = glm::dot(way.alongV, way.to);
    glm::dvec2 move{(b * byU - uvs * byV) / determinant, (a * byV - uvs * byU) / determinant};
    bool nearer = false;
    for (int half = 0; half < kHalvings && !nearer; ++half, move *= 0.5) {
      const glm::dvec2 next = glm::clamp(uv + move, 0.0, 1.0);
      const Way there = wayFrom(patch, next, p);
      if (!(there.square() < way.square())) continue;
      nearer = true;
      uv = next, way = there;
    }
    if (!nearer || std::max(std::abs(move.x), std::abs(move.y)) < 0x1p-40) break;
  }
  return std::sqrt(way.square());
}

}  // namespace xnewell
