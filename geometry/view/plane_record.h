#pragma once

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

}  // namespace xnewell
