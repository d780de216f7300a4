#include "geometry/view/screen_plane.h"

#include <algorithm>
#include <cmath>

namespace xnewell {

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

/// The sign of m / c - n / d; c and d are positive.
int compareQuotients(Int128 m, std::int64_t c, Int128 n, std::int64_t d) {
  const Quotient p = floorDivide(m, c), q = floorDivide(n, d);
  if (p.whole != q.whole) return compare(p.whole, q.whole);
  return compare(Int128{p.rest} * d, Int128{q.rest} * c);
}

bool before(const glm::ivec3& a, const glm::ivec3& b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

Int128 numerator(const ScreenPlane& P, std::int64_t x, std::int64_t y) {
  return Int128{P.A} * x + Int128{P.B} * y + P.D;
}

}  // namespace

ScreenPlane planeThrough(const glm::ivec3* v, int count) {
  const glm::ivec3 *a = v, *b = v + 1, *c = v + 2;
  if (count > 3) {
    const auto squared = [&](const glm::ivec3& p) {
      const std::int64_t dx = p.x - a->x, dy = p.y - a->y;
      return dx * dx + dy * dy;
    };
    const auto spanned = [&](const glm::ivec3& p) {
      const std::int64_t bx = b->x - a->x, by = b->y - a->y;
      const std::int64_t px = p.x - a->x, py = p.y - a->y;
      return std::abs(bx * py - by * px);
    };
    const auto mostOf = [&](const auto& measure) {
      const glm::ivec3* most = v;
      std::int64_t is = measure(*v);
      for (const glm::ivec3* p = v + 1; p != v + count; ++p) {
        const std::int64_t mine = measure(*p);
        if (mine > is || (mine == is && before(*p, *most))) most = p, is = mine;
      }
      return most;
    };
    a = std::min_element(v, v + count, before);
    b = mostOf(squared);
    c = mostOf(spanned);
  }
  const std::int64_t x1 = b->x - a->x, y1 = b->y - a->y, z1 = b->z - a->z;
  const std::int64_t x2 = c->x - a->x, y2 = c->y - a->y, z2 = c->z - a->z;
  // Cramer's rule solves C dz = A dx + B dy for both edges.
  ScreenPlane plane;
  plane.C = x1 * y2 - x2 * y1;
  plane.A = z1 * y2 - z2 * y1;
  plane.B = x1 * z2 - x2 * z1;
  if (plane.C < 0) plane.A = -plane.A, plane.B = -plane.B, plane.C = -plane.C;
  plane.D = Int128{plane.C} * a->z - Int128{plane.A} * a->x - Int128{plane.B} * a->y;
  return plane;
}

int compareDepths(const ScreenPlane& P, const ScreenPlane& Q, std::int64_t x, std::int64_t y) {
  const Int128 p = numerator(P, x, y), q = numerator(Q, x, y);
  // The double of each quotient is off by at most four roundings of 2^-53. If the doubles differ by more than
  // all this rounding, they have the order of the exact quotients.
  const double zP = approximately(p) / static_cast<double>(P.C);
  const double zQ = approximately(q) / static_cast<double>(Q.C);
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
  return approximately(numerator(P, x, y)) / static_cast<double>(P.C);
}

}  // namespace xnewell
