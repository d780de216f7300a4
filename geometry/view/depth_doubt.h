#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "geometry/view/project.h"
#include "geometry/view/screen_plane.h"
#include "geometry/view/view.h"

namespace xnewell {

/// The largest rounding that is allowed for, in world units. A tolerance as large as the rounding of a
/// coarser file would unite planes that are apart.
inline constexpr double kMostRounding = 3e-5 / 7;

/// Computes SnappedFace::doubt: t = 4 (dz + dxy (|A| + |B|) / C). It bounds the error of the plane if a point
/// of the face is off by dxy across the screen and by dz in depth.
/// The snap moves a point by half a step. The rounding u of each coordinate moves it by at most sqrt 3 u, for
/// no point of a face moves further than the corners. Let the view plane have S steps a unit, let D = prp.z,
/// and let a point be at distance d from the eye, magnified q = D / d times, and r off the axis. Then dxy =
/// 1/2 + sqrt 3 u S q (1 + q r / D), and dz = 1/2 + sqrt 3 u S q^2, because depth is S D^2 (1/d - 1/dB). q is
/// linear in z. In a parallel view q is 1, and r / D is the slope of the projectors.
/// Faces in one plane may be further off their common plane. It goes through points far apart on the screen,
/// and those may be close together near the eye. If a corner is further off than this bound, its excess over
/// q^2 is added to dz / q^2.
class DepthDoubt {
 public:
  DepthDoubt(const ViewSpec& view, int width, int height, int zShift);

  /// The doubt of an outline in `plane` whose coordinates were rounded by u in the model. It uses the largest
  /// q r / D within the picture: an outline may reach a hundred times as far, but nothing is seen there.
  [[nodiscard]] Doubt of(const glm::ivec3* outline, int count, const ScreenPlane& plane, double u) const;

 private:
  glm::ivec2 picture_;  ///< size in grid steps
  bool perspective_;
  /// size of a grid step on the view plane; its top left corner, relative to the axis
  glm::dvec2 step_, corner_;
  double D_, magnificationPerZ_, backMagnification_;  ///< q = magnificationPerZ_ z + backMagnification_
  double slant_, steps_, zSteps_;
};

}  // namespace xnewell
