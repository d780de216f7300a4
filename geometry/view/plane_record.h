#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "geometry/model/divide.h"
#include "geometry/view/project.h"
#include "geometry/view/screen_plane.h"
#include "geometry/view/view.h"

namespace xnewell {

/// The numbers that take a plane from the world to the screen grid and back.
struct GridScale {
  GridScale(const ViewSpec& view, int width, int height, int zShift);

  /// The place on the view plane, relative to the projection reference point, of a point of the grid.
  [[nodiscard]] glm::dvec2 onViewPlane(double x, double y) const {
    return {corner.x + step.x * x, corner.y - step.y * y};
  }

  bool perspective;
  glm::dvec2 step;    ///< size of a grid step on the view plane
  double zStep;       ///< size of a z step at the view plane
  glm::dvec2 corner;  ///< the picture's top left corner, relative to the projection reference point
  double D;           ///< prp.z
  double back;        ///< n of the back plane
  glm::dvec2 lean;    ///< in a parallel view, how far a projector moves in u and v for each unit of n
};

/// Makes the plane records (screen_plane.h) of planes of the model. No vertex takes part, so neither the snap
/// nor a clip point near the eye, where rounding is magnified, can tilt a record. Let m be the normal in VRC,
/// and k = m.(q - PRP) for a point q of the plane. A ray through (X, Y) = (u, v) / D on the view plane, u and
/// v relative to PRP, meets the plane at distance d with 1 / d = (m.x X + m.y Y - m.z) / k. So z = D^2 /
/// zStep (1 / d - 1 / (D - back)). In a parallel view n = (k + D m.z - m.x u - m.y v) / m.z', where m.z' =
/// m.z + m.lean is the slope of the plane along a projector, and z = (n - back) / zStep. Both are linear in x
/// and y.
///
/// The doubles. Let N be a unit vector, s the sine of the angle between VPN and VUP, and t = 1 / s. Then m is
/// off by 2^-47 t, and k by 2^-47 t (|q| + |PRP|), both from VRP. The error of z at `near`, and of a slope,
/// is at most 2^-47 times the sum of the absolute terms, with t for |m|. The term with 1 / k counts once more
/// for the relative error of k, or in a parallel view of m.z'. Nothing is claimed where that is above a
/// quarter.
class PlaneRecords {
 public:
  PlaneRecords(const ViewSpec& view, int width, int height, int zShift);

  /// The record of a plane. `near` is a point of the grid in the picture where the plane is needed. C = 2^K,
  /// with the largest K <= 60 for which |A| and |B| are at most 2^60, so rounding them moves z by no more
  /// than 2^-32 of the slope and 2^-32 steps within the guard band. There is none for a plane that is seen so
  /// nearly edge-on that a slope reaches 2^60, or |z| at `near` 2^31.
  [[nodiscard]] std::optional<ScreenPlane> of(const ModelPlane& plane, const glm::ivec2& near) const;

  /// How much nearer a plane is than another, which has a record. 0 if the first has none.
  [[nodiscard]] Ahead ahead(const ModelPlane& plane, const ModelPlane& other, const glm::ivec2& near) const;

 private:
  /// The depth of a plane in z steps: its slopes, and what it is at `near`.
  struct Depth {
    double alpha, beta, z;
    [[nodiscard]] bool fits() const;
  };
  [[nodiscard]] Depth depthOf(const ModelPlane& plane, const glm::ivec2& near) const;

  GridScale scale_;
  glm::dmat3 rotation_;
  glm::dvec3 vrp_, prp_;
};

/// Computes PlaneTable::doubtOf(): how far the plane of a face's own corners may be off at a sample, in z
/// steps.
///
/// The snap moves a point by half a step in each coordinate. This moves a plane with the slopes alpha and
/// beta by 1/2 + (|alpha| + |beta|) / 2. Rounding in the model moves the plane by r (fit_plane.h). The terms
/// of arithmetic are left out: the snap is coarser, and coordinates far from the origin are trusted as
/// written. If the plane is k away from the eye, then at distance d it changes 1 / d by r / (|k| d). So z =
/// D^2 / zStep (1 / d - 1 / dB) changes by (z + q0) r / |k| with q0 = D^2 / (zStep dB): this is linear in z,
/// and z is linear over the screen. In a parallel view it is r / (zStep |m.z'|) everywhere, with m.z' as in
/// plane_record.h. The normal over k, or over m.z', follows from the record alone.
///
/// The record of a class of faces is another plane, up to r from each corner. Where faces touch in the model,
/// the planes of their own corners are within r of the true ones there, but the records may be 2 r off. So
/// mayTouch() (scene_planes.h) compares faces by the planes of their own corners, and no contact is deeper
/// than 1.5 times what rounding explains.
///
/// Condition: r / (|k| d) is the change to first order. A plane that moves by r changes 1 / d by up to
/// r / ((|k| - r) d). Where the eye is n roundings from the plane, |k| = n r, that is n / (n - 1) times as
/// much, and without a limit where n <= 1. So a contact there is within 1.5 times the change itself, but
/// perhaps not within 1.5 times the first-order change.
class DepthDoubt {
 public:
  DepthDoubt(const ViewSpec& view, int width, int height, int zShift);

  /// The doubt of a face in `record` whose coordinates were rounded by u in the model. It is off by at most
  /// 2^-23 of itself, because it is stored as floats, where it is below 2^127.
  [[nodiscard]] Doubt of(const ScreenPlane& record, double u) const;

 private:
  GridScale scale_;
  glm::dmat3 worldFromVrc_;
  glm::dvec2 axis_;  ///< the place of the projection reference point on the grid
  double perZ_, perBack_, q0_;
  glm::dvec2 perSlope_;
};

}  // namespace xnewell
