#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "geometry/exact/plane.h"
#include "geometry/model/rounding.h"

namespace xnewell {

/// A point whose coordinates are rounded by at most u.
struct RoundedPoint {
  glm::dvec3 p;
  double u;
};

/// A plane for a set of points, and its largest distance from one of them, in units of that point's r
/// (rounding.h). The plane explains the points if h <= 1.
struct PlaneFit {
  Plane plane;
  double h = 0.0;
  [[nodiscard]] bool explains() const { return h <= 1.0; }
};

/// The distance of a plane from the points. Where d and all coordinates are at most 2, h is off by at most
/// 2^-50 of itself and 2^-49 / r.
[[nodiscard]] PlaneFit fitOf(const Plane& plane, std::span<const RoundedPoint> points,
                             const Rounding& rounding);

enum class FitGoal {
  Explain,  ///< any plane that explains the points, or the knowledge that there is none
  Best      ///< the plane with the least h
};
/// Fits a plane to points (at least one), starting from a plane near them. It solves the linear programme:
/// the least h with |N.p - d| <= h r for all points. At each step four points hold the plane, and the point
/// that is furthest off takes the place of one of them; h never falls. So if h passes 1, no plane explains
/// the points. The points are seen from `start.N`. If the plane turns from it by more than 2^-10, r and the
/// view are computed anew, a few times. So the best plane's h is at most 2^-9 of itself, and the error of
/// fitOf(), above that of any plane within 2^-10 of its direction. (If the points lie nearly in line, a plane
/// that turns further about that line may have a larger r and so a smaller h.)
/// @see Stiefel 1959 (exchange), Cheney 1966 §2.3
[[nodiscard]] PlaneFit fitPlane(std::span<const RoundedPoint> points, const Plane& start,
                                const Rounding& rounding, FitGoal goal);

}  // namespace xnewell
