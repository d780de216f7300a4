#include "geometry/screen_plane.h"

#include <cmath>

namespace {

struct Quotient {
  Int128 whole;
  std::int64_t rest;  ///< 0 <= rest < divisor
};
Quotient floorDivide(Int128 n, std::int64_t divisor) {
  Int128 whole = n / divisor;
  std::int64_t rest = static_cast<std::int64_t>(n - whole * divisor);
  if (rest < 0) --whole, rest += divisor;
  return {whole, rest};
}

template <class Integer>
int compare(Integer a, Integer b) {
  return a < b ? -1 : a > b ? 1 : 0;
}

/// The sign of m / c - n / d, c and d positive.
int compareQuotients(Int128 m, std::int64_t c, Int128 n, std::int64_t d) {
  const Quotient p = floorDivide(m, c), q = floorDivide(n, d);
  if (p.whole != q.whole) return compare(p.whole, q.whole);
  return compare(Int128{p.rest} * d, Int128{q.rest} * c);
}

Int128 numerator(const ScreenPlane& P, std::int64_t x, std::int64_t y) {
  return Int128{P.A} * x + Int128{P.B} * y + P.D;
}

}  // namespace

ScreenPlane planeThrough(const glm::ivec3* v, int count) {
  int one = 1, two = 2;
  if (count > 3) {
    const auto squared = [&](int i) {
      const std::int64_t dx = v[i].x - v[0].x, dy = v[i].y - v[0].y;
      return dx * dx + dy * dy;
    };
    const auto spanned = [&](int i) {
      const std::int64_t ax = v[one].x - v[0].x, ay = v[one].y - v[0].y;
      const std::int64_t bx = v[i].x - v[0].x, by = v[i].y - v[0].y;
      return std::abs(ax * by - ay * bx);
    };
    for (int i = 2; i < count; ++i)
      if (squared(i) > squared(one)) one = i;
    two = one == 1 ? 2 : 1;
    for (int i = 1; i < count; ++i)
      if (spanned(i) > spanned(two)) two = i;
  }
  const std::int64_t x1 = v[one].x - v[0].x, y1 = v[one].y - v[0].y, z1 = v[one].z - v[0].z;
  const std::int64_t x2 = v[two].x - v[0].x, y2 = v[two].y - v[0].y, z2 = v[two].z - v[0].z;
  // C dz = A dx + B dy has the solution of Cramer's rule for both edges.
  ScreenPlane plane;
  plane.C = x1 * y2 - x2 * y1;
  plane.A = z1 * y2 - z2 * y1;
  plane.B = x1 * z2 - x2 * z1;
  if (plane.C < 0) plane.A = -plane.A, plane.B = -plane.B, plane.C = -plane.C;
  plane.D = Int128{plane.C} * v[0].z - Int128{plane.A} * v[0].x - Int128{plane.B} * v[0].y;
  return plane;
}

int compareDepths(const ScreenPlane& P, const ScreenPlane& Q, std::int64_t x, std::int64_t y) {
  const Int128 p = numerator(P, x, y), q = numerator(Q, x, y);
  // The doubles of two quotients that lie further apart than all their rounding, four steps of 2^-53
  // each, have the order of the exact ones.
  const double zP = static_cast<double>(p) / static_cast<double>(P.C);
  const double zQ = static_cast<double>(q) / static_cast<double>(Q.C);
  const double difference = zP - zQ;
  if (std::abs(difference) > 0x1p-50 * (std::abs(zP) + std::abs(zQ))) return difference > 0 ? 1 : -1;
  return compareQuotients(p, P.C, q, Q.C);
}

int nearer(const ScreenPlane& P, const ScreenPlane& Q, int i, int j) {
  const std::int64_t x = (std::int64_t{i} << kGridBits) + kGrid / 2,
                     y = (std::int64_t{j} << kGridBits) + kGrid / 2;
  if (const int sign = compareDepths(P, Q, x, y)) return sign;
  if (const int sign = compareQuotients(P.A, P.C, Q.A, Q.C)) return sign;
  return compareQuotients(P.B, P.C, Q.B, Q.C);
}

double depthAt(const ScreenPlane& P, std::int64_t x, std::int64_t y) {
  return static_cast<double>(numerator(P, x, y)) / static_cast<double>(P.C);
}
