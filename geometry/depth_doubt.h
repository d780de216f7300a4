#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "geometry/screen_plane.h"
#include "geometry/view.h"

/// Coarser files are taken at their word: a tolerance as large as their rounding would unite what is apart.
inline constexpr double kMostRounding = 3e-5 / 7;

/// SnappedFace::doubt: t = 4 (dz + dxy (|A| + |B|) / C), how far the plane may be off where a vertex is off
/// by dxy across the screen and dz in depth. The snap moves it by half a step; the rounding u of a coordinate
/// by sqrt 3 u in all. With S steps a unit on the view plane, D = prp.z and a vertex at distance d from the
/// eye, magnified q = D / d times, r off the axis: dxy = 1/2 + sqrt 3 u S q (1 + q r / D) and dz = 1/2 + sqrt
/// 3 u S q^2, for depth is S D^2 (1/d - 1/dB). In a parallel view q is 1, and r / D the slope of the
/// projectors.
class DepthDoubt {
 public:
  DepthDoubt(const ViewSpec& view, int width, int height, int zShift);

  /// Of an outline in `plane` whose coordinates were rounded by u in the model, in z steps.
  [[nodiscard]] double of(const glm::ivec3* outline, int count, const ScreenPlane& plane, double u) const;

 private:
  bool perspective_;
  glm::dvec2 step_, corner_;  ///< a grid step on the view plane; its top left, from the axis
  double D_, magnificationPerZ_, backMagnification_, slant_, steps_, zSteps_;
};
