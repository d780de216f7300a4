#pragma once

#include "geometry/view/project.h"
#include "tests/kernels/big.h"
#include "tests/kernels/kernel.h"

namespace xnewell {

/// |x|, |y| and the largest z on the grid.
inline constexpr double kReach = 0x1p29, kDeep = 0x1p30;

/// Nine integers: a triangle on the grid.
using Triangle = std::array<glm::ivec3, 3>;
inline Triangle triangleAt(const double* v) {
  Triangle t;
  for (int k = 0; k < 3; ++k)
    t[k] = {static_cast<int>(v[3 * k]), static_cast<int>(v[3 * k + 1]), static_cast<int>(v[3 * k + 2])};
  return t;
}
inline std::int64_t doubleAreaOf(const Triangle& t) { return doubleArea(t.data(), 3); }

/// The plane through a triangle with an area: Cramer's rule, as the comment of ScreenPlane defines it.
inline ScreenPlane planeOf(const Triangle& t) {
  const Int128 x1 = t[1].x - t[0].x, y1 = t[1].y - t[0].y, z1 = t[1].z - t[0].z;
  const Int128 x2 = t[2].x - t[0].x, y2 = t[2].y - t[0].y, z2 = t[2].z - t[0].z;
  Int128 A = z1 * y2 - z2 * y1, B = x1 * z2 - x2 * z1, C = x1 * y2 - x2 * y1;
  if (C < 0) A = -A, B = -B, C = -C;
  ScreenPlane plane;
  plane.A = static_cast<std::int64_t>(A), plane.B = static_cast<std::int64_t>(B),
  plane.C = static_cast<std::int64_t>(C);
  plane.D = C * t[0].z - A * t[0].x - B * t[0].y;
  return plane;
}

struct ExactPlane {
  Whole A, B, C, D;
  explicit ExactPlane(const Triangle& t) {
    const ScreenPlane p = planeOf(t);
    A = p.A, B = p.B, C = p.C, D = Whole{boost::multiprecision::cpp_int{p.D}};
  }
  [[nodiscard]] Big at(const Big& x, const Big& y) const {
    return (Big{A} * x + Big{B} * y + Big{D}) / Big{C};
  }
};
/// a x + b y + c is C_P C_Q (z_P - z_Q).
struct WholeLine {
  Whole a, b, c;
};
inline WholeLine difference(const ExactPlane& P, const ExactPlane& Q) {
  return {P.A * Q.C - Q.A * P.C, P.B * Q.C - Q.B * P.C, P.D * Q.C - Q.D * P.C};
}

inline std::vector<Coordinate> triangles(int count) {
  std::vector<Coordinate> input;
  for (int k = 0; k < 3 * count; ++k) {
    input.push_back(integers(-kReach, kReach));
    input.push_back(integers(-kReach, kReach));
    input.push_back(integers(0, kDeep));
  }
  return input;
}
/// Turned so that they run counter-clockwise. Without an area there is nothing to judge.
inline Numbers turned(const Numbers& in, int count) {
  Numbers v = in;
  for (int t = 0; t < count; ++t) {
    const std::int64_t area = doubleAreaOf(triangleAt(&v[9 * t]));
    if (area == 0) return {};
    if (area < 0) std::swap_ranges(&v[9 * t + 3], &v[9 * t + 6], &v[9 * t + 6]);
  }
  return v;
}

inline double gridNumber(Random& random, double low, double high) {
  switch (random.below(4)) {
    case 0:
      return random.oneIn(2) ? low : high;
    case 1:
      return std::round(std::clamp(random.sign() * random.power(0, 29), low, high));
    case 2:  // the centre of a pixel
      return std::clamp(std::floor(random.uniform(0, 8192)) * 65536 + 32768, low, high);
    default:
      return std::round(random.uniform(low, high));
  }
}
inline void addTriangle(Numbers& in, Random& random) {
  const bool small = random.oneIn(2);
  const double size = random.power(4, 28);
  double at[3] = {gridNumber(random, -kReach, kReach), gridNumber(random, -kReach, kReach),
                  gridNumber(random, 0, kDeep)};
  for (int k = 0; k < 3; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const double low = axis == 2 ? 0 : -kReach, high = axis == 2 ? kDeep : kReach;
      in.push_back(small ? std::clamp(std::round(at[axis] + size * random.uniform(-1, 1)), low, high)
                         : gridNumber(random, low, high));
    }
}
/// Nearly in the plane of the triangle at `of`: its corners plus multiples of its edges, rounded, and raised
/// by a few steps.
inline void addNearlyCoplanar(Numbers& in, std::size_t of, Random& random) {
  const Numbers t(in.begin() + static_cast<std::ptrdiff_t>(of),
                  in.begin() + static_cast<std::ptrdiff_t>(of) + 9);
  const bool same = random.oneIn(3);
  const double raised = random.oneIn(2) ? 0 : random.sign() * std::round(random.power(0, 12));
  for (int k = 0; k < 3; ++k) {
    double p[3];
    const double a = same ? (k == 1) : random.uniform(-1, 1.5), b = same ? (k == 2) : random.uniform(-1, 1.5);
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = std::round(t[axis] + a * (t[3 + axis] - t[axis]) + b * (t[6 + axis] - t[axis]));
      const double low = axis == 2 ? 0 : -kReach, high = axis == 2 ? kDeep : kReach;
      if (axis == 2) p[axis] += random.oneIn(2) ? raised : static_cast<double>(random.integer(-1, 1));
      in.push_back(std::clamp(p[axis], low, high));
    }
  }
}

/// A triangle of whole multiples of two edges, and another of them: exactly in one plane, if nothing has to
/// be clamped to the grid. Then one corner may be raised by a step.
inline void addCoplanar(Numbers& in, Random& random) {
  const double size = random.power(1, 26);
  double at[3], edge[2][3];
  for (int axis = 0; axis < 3; ++axis) {
    at[axis] = std::round(axis == 2 ? random.uniform(0, kDeep) : random.uniform(-kReach, kReach));
    for (auto& e : edge) e[axis] = std::round(size * random.uniform(-1, 1));
  }
  for (int corner = 0; corner < 6; ++corner) {
    const double a = static_cast<double>(random.integer(-3, 3)),
                 b = static_cast<double>(random.integer(-3, 3));
    const double raised = corner == 5 && random.oneIn(2) ? random.sign() : 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double p = at[axis] + a * edge[0][axis] + b * edge[1][axis] + (axis == 2 ? raised : 0);
      in.push_back(std::clamp(p, axis == 2 ? 0 : -kReach, axis == 2 ? kDeep : kReach));
    }
  }
}

}  // namespace xnewell
