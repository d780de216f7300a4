#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/model/mesh.h"

namespace xnewell {

/// A judge of pictures in which surfaces nearly touch. It knows the numbers of the file and of the camera,
/// and the rule below. It computes with 64 bits (Extended), sample by sample, and shares nothing else with
/// the program but the struct that holds a mesh: no plane, class, tolerance, projection, clipping or sample
/// table.
///
/// The rule. A number of the file may be off by u, half a unit of its last decimal, and by the rounding of
/// doubles: a plane with the unit normal N may be off by
/// r = u (|Nx| + |Ny| + |Nz|) + 2^-46 side + 2^-50 magnitude. The screen grid moves a point by half a step in
/// x, y and z, and a step is 1/65536 pixel (in z times the least power of two for which 2^30 steps reach the
/// nearest point). These two explain a difference of depths at a sample.
/// 1. No face may be nearer than the one shown by more than 1.5 times what both their roundings explain
///    there. A plane h away from the eye that moves by r changes 1 / d by up to r / (h - r) of it.
/// 2. Of the faces that were made in one plane, the latest that covers the sample must be shown, unless a
///    face of another plane is.
/// 3. A face is shown only where it covers the sample, and nothing is shown only where no face does.
/// Outlines may be off by the grid. For 2, where two faces of one plane were only made to touch, rounding may
/// let them overlap: the later one must cover the sample by 3 sqrt 3 u.

/// The camera's numbers, in the units of the file.
struct JudgedCamera {
  glm::dvec3 eye{0}, lookAt{0}, up{0, 1, 0};
  double fov = 0;                ///< vertical, in degrees; for a perspective view
  double height = 0;             ///< of the picture; for a parallel view, else 0
  double length = 0, angle = 0;  ///< of an oblique view: of a unit along n, and its angle in degrees
};

struct Judgement {
  long samples = 0;   ///< that show a face
  long farther = 0;   ///< against 1
  long lost = 0;      ///< against 2
  long outline = 0;   ///< against 3
  long doubtful = 0;  ///< another face lies within what rounding explains of the one that is shown
  /// the most by which a face is nearer than the one shown, in what their roundings explain there
  double worst = 0;
  [[nodiscard]] long wrong() const { return farther + lost + outline; }
};

/// Judges a picture. `shown` holds for each sample, row by row from the top, the number of its face plus 1,
/// or 0. Faces are convex, and planar up to rounding. `madeIn` holds for each face the number of the plane in
/// which it was made, -1 if it shares it with no other. u is the rounding of all coordinates.
[[nodiscard]] Judgement judged(const Mesh& mesh, const std::vector<int>& madeIn, double u,
                               const JudgedCamera& camera, int width, int height,
                               const std::vector<std::uint32_t>& shown);

}  // namespace xnewell
