#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "geometry/view/project.h"
#include "geometry/view/screen_plane.h"
#include "geometry/view/view.h"

namespace xnewell {

/// Coarser files are taken at their word: a tolerance as large as their rounding would unite what is apart.
inline constexpr double kMostRounding = 3e-5 / 7;

/// SnappedFace::doubt: t = 4 (dz + dxy (|A| + |B|) / C), how far the plane may be off where a point of the
/// face is off by dxy across the screen and dz in depth. The snap moves it by half a step; the rounding u of
/// a coordinate by sqrt 3 u in all, for it moves no point of a face further than the corners. With S steps a
/// unit on the view plane, D = prp.z and a point at distance d from the eye, magnified q = D / d times, r off
/// the axis: dxy = 1/2 + sqrt 3 u S q (1 + q r / D) and dz = 1/2 + sqrt 3 u S q^2, for depth is S D^2 (1/d -
/// 1/dB). q is linear in z. In a parallel view it is 1, and r / D the slope of the projectors.
/// Of faces in one plane the plane may be farther off, for it goes through points far apart on the screen,
/// which may be near each other before the eye. What a corner is farther off, over q^2, is added to dz / q^2.
class DepthDoubt {
 public:
  DepthDoubt(const ViewSpec& view, int width, int height, int zShift);

  /// Of an outline in `plane` whose coordinates were rounded by u in the model. q r / D is its largest in
  /// the picture: an outline may reach a hundred times as far, and nothing is seen there.
  [[nodiscard]] Doubt of(const glm::ivec3* outline, int count, const ScreenPlane& plane, double u) const;

 private:
  glm::ivec2 picture_;  ///< its size in grid steps
  bool perspective_;
  glm::dvec2 step_, corner_;  ///< a grid step on the view plane; its top left, from the axis
  double D_, magnificationPerZ_, backMagnification_;  ///< q = magnificationPerZ_ z + backMagnification_
  double slant_, steps_, zSteps_;
};

}  // namespace xnewell
