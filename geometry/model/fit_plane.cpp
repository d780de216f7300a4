#include "geometry/model/fit_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace xnewell {

namespace {

constexpr int kMostSteps = 100, kMostTurns = 4;
/// Relative to h: the step that ends the search for the best plane.
constexpr double kNearly = 1e-6;

using Column = std::array<double, 4>;

/// Solves a 4 x 4 system whose columns are given: sum x_k columns[k] = b. Or, transposed: columns[k].x =
/// b[k].
std::optional<Column> solve(const std::array<Column, 4>& columns, Column b, bool transposed) {
  std::array<Column, 4> m;  // rows
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) m[i][j] = transposed ? columns[i][j] : columns[j][i];
  for (int k = 0; k < 4; ++k) {
    int pivot = k;
    for (int i = k + 1; i < 4; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    if (!(std::abs(m[pivot][k]) > 1e-13)) return {};
    std::swap(m[k], m[pivot]), std::swap(b[k], b[pivot]);
    for (int i = k + 1; i < 4; ++i) {
      const double factor = m[i][k] / m[k][k];
      for (int j = k; j < 4; ++j) m[i][j] -= factor * m[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (int k = 3; k >= 0; --k) {
    for (int j = k + 1; j < 4; ++j) b[k] -= m[k][j] * b[j];
    b[k] /= m[k][k];
  }
  return b;
}

/// A point as the programme sees it: z over the plane of x and y, and the weight of its error.
struct Height {
  double x, y, z, w;
};

/// The plane z = a x + b y + c with the least h, |z - a x - b y - c| <= h w at all points.
struct Exchange {
  std::span<const Height> points;
  double a = 0, b = 0, c = 0;
  double least = 0;  ///< no plane has a smaller h

  void run(FitGoal goal) {
    // One point holds the plane from above and from below, two more only from above. So h = 0, and the
    // weights of the two are 0.
    const std::optional<std::array<int, 3>> start = farApart();
    if (!start) return;
    std::array<int, 4> held{(*start)[0], (*start)[0], (*start)[1], (*start)[2]};
    std::array<double, 4> sign{1, -1, 1, 1};
    std::array<Column, 4> columns;
    const auto column = [&](int i, double s) -> Column {
      return {s * points[i].x, s * points[i].y, s, points[i].w};
    };
    for (int step = 0; step < kMostSteps; ++step) {
      Column heights;
      for (int k = 0; k < 4; ++k)
        columns[k] = column(held[k], sign[k]), heights[k] = sign[k] * points[held[k]].z;
      const auto plane = solve(columns, heights, true);
      auto weight = solve(columns, {0, 0, 0, 1}, false);
      if (!plane || !weight) return;
      a = (*plane)[0], b = (*plane)[1], c = (*plane)[2];
      least = std::max(least, (*plane)[3]);
      const auto [furthest, off] = furthestOff();
      const double h = std::abs(off) / points[furthest].w;
      if (h <= least * (1 + kNearly) || (goal == FitGoal::Explain && (h <= 1 || least > 1 + kNearly))) return;

      const double s = off < 0 ? -1 : 1;
      auto d = solve(columns, column(furthest, s), false);
      if (!d) return;
      // A point of weight 0 can hold the plane from the other side as well.
      if (step == 0)
        for (const int k : {2, 3})
          if ((*d)[k] > 0) {
            const double share = (*d)[k] * points[held[k]].w / points[held[0]].w;
            (*d)[0] += share, (*d)[1] += share;
            (*d)[k] = -(*d)[k];
            sign[k] = -sign[k];
          }
      int leaves = -1;
      for (int k = 0; k < 4; ++k) {
        if (!((*d)[k] > 1e-12)) continue;
        const double ratio = std::max(0.0, (*weight)[k]) / (*d)[k];
        if (leaves < 0 || ratio < std::max(0.0, (*weight)[leaves]) / (*d)[leaves]) leaves = k;
      }
      if (leaves < 0) return;
      held[leaves] = furthest, sign[leaves] = s;
    }
  }

 private:
  /// Three points that span a large triangle; none if all are in line.
  [[nodiscard]] std::optional<std::array<int, 3>> farApart() const {
    const auto most = [&](const auto& measure) {
      int best = 0;
      double is = -1.0;
      for (int i = 0; i < static_cast<int>(points.size()); ++i)
        if (const double mine = measure(points[i]); mine > is) best = i, is = mine;
      return std::pair{best, is};
    };
    const Height& first = points[0];
    const int second =
        most([&](const Height& p) { return std::abs(p.x - first.x) + std::abs(p.y - first.y); }).first;
    const double ex = points[second].x - first.x, ey = points[second].y - first.y;
    const auto [third, area] =
        most([&](const Height& p) { return std::abs(ex * (p.y - first.y) - ey * (p.x - first.x)); });
    if (!(area > 1e-10)) return {};
    return std::array{0, second, third};
  }
  [[nodiscard]] std::pair<int, double> furthestOff() const {
    int furthest = 0;
    double off = 0.0, most = -1.0;
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
      const Height& p = points[i];
      const double z = p.z - (a * p.x + b * p.y + c);
      if (std::abs(z) > most * p.w) furthest = i, off = z, most = std::abs(z) / p.w;
    }
    return {furthest, off};
  }
};

/// Two unit vectors at right angles to N and to each other.
std::pair<glm::dvec3, glm::dvec3> tangents(const glm::dvec3& N) {
  const glm::dvec3 n = glm::abs(N);
  const glm::dvec3 axis = n.x <= n.y && n.x <= n.z ? glm::dvec3{1, 0, 0}
                          : n.y <= n.z             ? glm::dvec3{0, 1, 0}
                                                   : glm::dvec3{0, 0, 1};
  const glm::dvec3 first = glm::normalize(glm::cross(N, axis));
  return {first, glm::cross(N, first)};
}

}  // namespace

PlaneFit fitOf(const Plane& plane, std::span<const RoundedPoint> points, const Rounding& rounding) {
  PlaneFit fit{plane};
  for (const RoundedPoint& q : points)
    fit.h = std::max(fit.h, std::abs(glm::dot(plane.N, q.p) - plane.d) / rounding.of(plane.N, q.u));
  return fit;
}

PlaneFit fitPlane(std::span<const RoundedPoint> points, const Plane& start, const Rounding& rounding,
                  FitGoal goal) {
  PlaneFit best = fitOf(start, points, rounding);
  if (goal == FitGoal::Explain && best.explains()) return best;
  std::vector<Height> heights(points.size());
  glm::dvec3 N = start.N;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const auto [T, U] = tangents(N);
    const glm::dvec3 origin = points[0].p;
    double reach = 0.0;
    for (const RoundedPoint& q : points) reach = std::max(reach, glm::length(q.p - origin));
    if (reach == 0.0) return best;
    const double w = rounding.most(points[0].u);  // the unit of z
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::dvec3 q = points[i].p - origin;
      heights[i] = {glm::dot(T, q) / reach, glm::dot(U, q) / reach, glm::dot(N, q) / w,
                    rounding.of(N, points[i].u) / w};
    }
    Exchange exchange{heights};
    exchange.run(goal);
    const double a = exchange.a * w / reach, b = exchange.b * w / reach;
    N = glm::normalize(N - a * T - b * U);
    const double length = std::sqrt(1.0 + a * a + b * b);
    const PlaneFit fit = fitOf({N, glm::dot(N, origin) + exchange.c * w / length}, points, rounding);
    if (fit.h < best.h) best = fit;
    if (goal == FitGoal::Explain && best.explains()) break;
    if (std::abs(a) + std::abs(b) < 0x1p-10) break;
  }
  return best;
}

}  // namespace xnewell
