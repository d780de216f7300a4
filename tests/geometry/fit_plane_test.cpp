#include "geometry/model/fit_plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "geometry/exact/unit.h"
#include "tests/support/extended.h"

namespace xnewell::THIS_FILE {

namespace {

using std::abs;  // and that of two doubles

using Real = Extended;
using Vec = glm::vec<3, Real>;

/// As if the points, which are at most 2 from the origin, had been moved there from far away: e is 2^-18.
constexpr double kSide = 1.0, kMagnitude = 0x1p32, kCoarse = 1e-3;

/// r of a point, by the words of fit_plane.h.
Real roundingOf(const Vec& N, double u) {
  const Vec n = glm::abs(N);
  return u * (n.x + n.y + n.z) + 0x1p-46 * kSide + 0x1p-50 * kMagnitude;
}

/// The least h of any plane, with r as it is for the normal N. By Helly's theorem four of the points hold the
/// best plane. With the weights l of their only affine dependency, sum l = 0 and sum l p = 0 seen along N, it
/// has h = |sum l N.p| / sum |l| r: the best of four points is the worst of all fours.
Real leastOf(const std::vector<RoundedPoint>& points, const Vec& N) {
  const Vec axis = abs(N.x) < 0.5 ? Vec{1, 0, 0} : Vec{0, 1, 0}, T = glm::normalize(glm::cross(N, axis)),
            U = glm::cross(N, T);
  Real most = 0;
  std::vector<Vec> q;
  for (const RoundedPoint& p : points)
    q.push_back({glm::dot(T, Vec{p.p}), glm::dot(U, Vec{p.p}), glm::dot(N, Vec{p.p})});
  const auto area = [&](int a, int b, int c) {
    return (q[b].x - q[a].x) * (q[c].y - q[a].y) - (q[b].y - q[a].y) * (q[c].x - q[a].x);
  };
  const int n = static_cast<int>(points.size());
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b)
      for (int c = b + 1; c < n; ++c)
        for (int d = c + 1; d < n; ++d) {
          const Real la = area(b, c, d), lb = -area(a, c, d), lc = area(a, b, d), ld = -area(a, b, c);
          const Real sum = abs(la) * roundingOf(N, points[a].u) + abs(lb) * roundingOf(N, points[b].u) +
                           abs(lc) * roundingOf(N, points[c].u) + abs(ld) * roundingOf(N, points[d].u);
          if (sum > 0)
            most = std::max(most, abs(la * q[a].z + lb * q[b].z + lc * q[c].z + ld * q[d].z) / sum);
        }
  return most;
}

}  // namespace

// The best plane is as good as fit_plane.h claims, however far it turns from the plane where the search
// starts: its h is at most 2^-9 of the least h above it. One point of every other set is exact, and its r is
// only e. Where all are rounded alike, a turn changes all r in the same way, and the h found is the least.
TEST(FitPlane, TheBestIsAsGoodAsClaimed) {
  double worst = 0;
  for (unsigned seed = 0; seed < 4'000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    std::uniform_real_distribution<double> share{0.0, 1.0};
    const bool alike = seed % 2 == 0;
    const double turn = 0x1p-10 * std::pow(10.0, 3 * share(rng) - 1.5), a = share(rng) * turn, b = turn - a;
    const glm::dvec3 start = seed % 3 == 0 ? glm::dvec3{0, 0, 1} : unit({share(rng), share(rng), 1});
    std::vector<RoundedPoint> points;
    const int count = 4 + static_cast<int>(rng() % 6);
    for (int k = 0; k < count; ++k) {
      const double x = share(rng), y = share(rng), off = 3 * kCoarse * (share(rng) - 0.5);
      points.push_back({{x, y, (a * x + b * y + off - start.x * x - start.y * y) / start.z},
                        alike || k > 0 ? kCoarse : 0.0});
    }
    const PlaneFit fit =
        fitPlane(points, {start, glm::dot(start, points[0].p)}, Rounding{kSide, kMagnitude}, FitGoal::Best);
    const double least = static_cast<double>(leastOf(points, glm::normalize(Vec{fit.plane.N})));
    const double arithmetic = 0x1p-46 / 0x1p-18;  // some roundings of places, over r
    ASSERT_LE(fit.h, least * (1 + (alike ? 1e-9 : 0x1p-9)) + arithmetic);
    if (!alike && least > 0.01) worst = std::max(worst, fit.h / least - 1);
  }
  EXPECT_GT(worst, 0x1p-13);  // the claim is needed
}

}  // namespace xnewell::THIS_FILE
