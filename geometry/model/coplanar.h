#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "geometry/exact/plane.h"
#include "geometry/model/divide.h"
#include "geometry/model/mesh.h"

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

/// The planes of a model, as ConvexParts has them: for each part the number of its plane, 0 to n - 1 in order
/// of the first part of each plane; and of them and of the parts' own planes those that are not planes of the
/// corners of one part alone.
struct CoplanarClasses {
  std::vector<int> plane;
  NumberedPlanes planes, own;
  UnitFrame frame;
};

/// Finds the planes of a model. A decal on a wall, or a box's bottom on the floor, was coplanar when it was
/// made. The rounding of the file makes the two planes differ, and so does the rounding of the projected
/// view; which one is in front would then change from pixel to pixel. Two parts in one plane are tied, and
/// the order of the scene decides.
///
/// A class is a set of faces that one plane explains (fit_plane.h). Two faces are joined if one plane
/// explains both and they overlap in area: no edge of either separates them, seen along the axis nearest to
/// the normal of the larger. Faces that only touch, along an edge or in a corner, are not joined, however
/// their corners were rounded. Chains of such pairs form sets, and most sets are classes: the plane in which
/// faces were made explains them all, also a wall of many small tiles, each of which alone says little of the
/// wall's plane. A set that no plane explains is torn: layers that lie nearly as close as the file can tell,
/// or a bent surface made of overlapping faces. From a torn set a class is peeled off: the faces nearest to
/// the plane that has the least sum of distances, as many of them as one plane explains. What is left forms
/// sets again. A set from which nothing can be peeled is joined pair by pair, as long as one plane explains
/// each class. It does not matter which way a face looks. A face without area has a plane of its own.
///
/// The roundings are those of the faces' objects, and the side is that of the scene. (A decal's own box is
/// too small for the rounding of its plane.) Parallel layers whose distance is more than 2 (|Nx| + |Ny| +
/// |Nz|) units of the last decimal are never in one class. Nearer, one plane may explain the file. All finite
/// coordinates are allowed, up to the largest double. Faces narrower than e 2^-500 count as faces without
/// area.
///
/// Work: about n log n for n parts if few overlap in one plane; otherwise the number of pairs of different
/// faces whose boxes overlap. After 64 fits that explained nothing, a face is compared with others by the
/// plane of the larger alone.
[[nodiscard]] CoplanarClasses coplanarClasses(const Mesh& mesh, const ConvexParts& parts);

/// Sets Mesh::rounding to what of it counts, and tells in a note if that is much. Few decimals may mean two
/// things. Who writes numbers by hand means them as they are: planes that are apart by less than a unit are
/// apart. A program rounds. So a rounding of more than 3e-5 / sqrt 3 of the mesh's longest side counts only
/// if two faces show it; otherwise no more than that counts. Two faces show it if they overlap in area, and
/// one plane explains both with 9/10 of it, but none without. Layers that are meant to be apart are farther
/// from each other, or exactly parallel. If the side has fewer than 32 units of the last decimal, nearly any
/// two faces lie in one plane, and nothing is shown.
void countRounding(Mesh& mesh);

/// Sets ConvexParts::plane, planes, own and frame to the classes.
void uniteCoplanar(const Mesh& mesh, ConvexParts& parts);

/// The plane of a part. Before uniteCoplanar() it is that of its own corners.
[[nodiscard]] ModelPlane planeOf(const Mesh& mesh, const ConvexParts& parts, int part);

}  // namespace xnewell
