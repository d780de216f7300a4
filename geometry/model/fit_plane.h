#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

#include "geometry/exact/plane.h"

namespace xnewell {

/// How far the planes of a model may be off, because its coordinates are rounded.
/// The corners of a plane with the unit normal N, each coordinate rounded by at most u, lie within
/// r = u (|Nx| + |Ny| + |Nz|) + e of it. e = 2^-46 side + 2^-50 magnitude is for our own arithmetic and for
/// the rounding of coordinates to doubles. One plane explains a set of points if none of them is further than
/// its r from it. So the plane in which they were made explains them.
class Rounding {
 public:
  /// `side` is the longest side of the box of the points that count, `magnitude` their largest coordinate.
  Rounding(double side, double magnitude) : arithmetic_{0x1p-46 * side + 0x1p-50 * magnitude} {}

  [[nodiscard]] double arithmetic() const { return arithmetic_; }
  /// r for a vector N of any length, times that length.
  [[nodiscard]] double of(const glm::dvec3& N, double u) const {
    const glm::dvec3 n = glm::abs(N);
    return u * (n.x + n.y + n.z) + arithmetic_ * glm::length(N);
  }
  /// The largest r of any unit normal.
  [[nodiscard]] double most(double u) const { return kSqrt3 * u + arithmetic_; }

  /// How far a point may lie from the plane of a polygon's vector area through its centroid, if some plane
  /// explains the polygon and the point. `rho` is the largest r of both, `steepness` the perimeter / the
  /// area, `distance` that of the point from the centroid. The corners lie within rho of that plane, so the
  /// sine of the angle between the two is at most rho steepness: the vector area changes by no more. A chord
  /// is at most 1.04 times as long as the sine, up to 1/2; beyond that there is no bound. It holds for any
  /// point within rho of the explaining plane in the place of the centroid.
  [[nodiscard]] static double mostOff(double rho, double steepness, double distance) {
    const double sine = rho * steepness;
    return sine > 0.5 ? std::numeric_limits<double>::infinity() : 2.0 * rho + 1.04 * sine * distance;
  }

  static constexpr double kSqrt3 = 1.7320508075688772;

 private:
  double arithmetic_;
};

/// A point whose coordinates are rounded by at most u.
struct RoundedPoint {
  glm::dvec3 p;
  double u;
};

/// A plane for a set of points, and its largest distance from one of them, in units of that point's r
/// (fit_plane.h). The plane explains the points if h <= 1.
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
