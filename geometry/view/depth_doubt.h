#pragma once

#include <glm/mat3x3.hpp>

#include "geometry/view/plane_record.h"
#include "geometry/view/project.h"

namespace xnewell {

/// Computes PlaneTable::doubtOf(): how far the plane of a face's own corners may be off at a sample, in z
/// steps.
///
/// The snap moves a point by half a step in each coordinate. This moves a plane with the slopes alpha and
/// beta by 1/2 + (|alpha| + |beta|) / 2. Rounding in the model moves the plane by r (rounding.h). The terms
/// of arithmetic are left out: the snap is coarser, and coordinates far from the origin are trusted as
/// written. If the plane is k away from the eye, then at distance d it changes 1 / d by r / (|k| d). So z =
/// D^2 / zStep (1 / d - 1 / dB) changes by (z + q0) r / |k| with q0 = D^2 / (zStep dB): this is linear in z,
/// and z is linear over the screen. In a parallel view it is r / (zStep |m.z'|) everywhere, with m.z' as in
/// plane_record.h. The normal over k, or over m.z', follows from the record alone.
///
/// The record of a class of faces is another plane, up to r from each corner. Where faces touch in the model,
/// the planes of their own corners are within r of the true ones there, but the records may be 2 r off. So
/// mayTouch() (touch.h) compares faces by the planes of their own corners, and no contact is deeper than 1.5
/// times what rounding explains.
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
