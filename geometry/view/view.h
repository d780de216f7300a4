#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <stdexcept>
#include <string>

namespace xnewell {

/// The textbook's viewing specification and its matrices. Transforms read right to left.
/// @see Foley & van Dam 2e §6.2 (specification), §6.5 (matrices)

/// The error of a camera that cannot see: a direction of length zero, an empty window, an eye behind its own
/// front plane.
struct ViewError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class Projection { Parallel, Perspective };
/// Which sides of the faces are drawn: both, or no backs.
enum class Cull { Keep, Back };

/// The view. VRC are the viewing reference coordinates u (right), v (up) and n (towards the viewer), with the
/// origin at VRP. The view plane is n = 0. A parallel projection's direction runs from PRP to the window's
/// centre. If it is not along the n axis, the projection is oblique, and canonicalFromVrc() shears.
/// Holds:  (checked by the matrix functions, which throw ViewError) VPN is not 0, VUP is not along VPN, PRP
///         is in front of the view plane (prp.z > 0), windowMin < windowMax, front > back, and for
///         perspective front < prp.z.
struct ViewSpec {
  Projection projection = Projection::Perspective;
  glm::dvec3 vrp{0}, vpn{0, 0, 1}, vup{0, 1, 0};  ///< world
  glm::dvec3 prp{0, 0, 1};                        ///< VRC
  glm::dvec2 windowMin{-1}, windowMax{1};         ///< VRC, on the view plane
  double front = 0, back = -1;                    ///< n of the clipping planes F and B, in VRC
  bool operator==(const ViewSpec&) const = default;
};

/// The rotation of directions from world to VRC. To transform a point, subtract VRP first, then rotate. Far
/// from the origin that difference is exact, but vrcFromWorld() would cancel digits. Each entry is off by at
/// most 2^-48 over the sine of the angle between VPN and VUP. (The cross product of two unit vectors has 16
/// roundings.)
[[nodiscard]] glm::dmat3 vrcRotation(const ViewSpec& spec);

/// The transform from world to VRC: a translation, then a rotation.
[[nodiscard]] glm::dmat4 vrcFromWorld(const ViewSpec& spec);

/// The textbook's matrices of a view, each by itself. What a projection does without is 1. With Tpar and
/// Spar, or Sper, for T and S:
///   parallel:     S T SH  R T(-VRP)
///   perspective:  M S SH T(-PRP)  R T(-VRP)
/// @see Foley & van Dam 2e §6.5.4
struct ViewMatrices {
  glm::dmat4 minusVrp{1}, R{1};  ///< T(-VRP); the rotation of the VRC axes onto x, y and z
  glm::dmat4 minusPrp{1};        ///< T(-PRP): perspective
  glm::dmat4 SH{1};              ///< the shear that brings the direction of projection onto the n axis
  glm::dmat4 T{1};               ///< parallel: the middle of the volume's front to the origin
  glm::dmat4 S{1};               ///< to the canonical volume: a box, or a pyramid with |x|, |y| <= -z <= 1
  glm::dmat4 M{1};               ///< perspective: that pyramid to the parallel volume
};
/// @throws ViewError
[[nodiscard]] ViewMatrices viewMatrices(const ViewSpec& spec);

/// The transform from VRC to the canonical parallel volume: x, y in [-1, 1], z in [-1, 0], larger is nearer,
/// front plane at 0. It warps a perspective view to this volume (homogeneous; w > 0 in front of the eye), so
/// planes stay planes.
[[nodiscard]] glm::dmat4 canonicalFromVrc(const ViewSpec& spec);

/// The error bounds of a point p that both matrices put on the screen, from about 30 roundings of the terms.
/// The picture has W pixels. The window is w wide, with its ends at left and right and its centre at c. D =
/// prp.z; d = D - p.z is the distance from the eye; q = D / d; r = |p|; dF = D - front; x is the result, in
/// pixels.
///   perspective, x:  2^-48 W/w q (r + |prp.x| + (|c - prp.x| + |left| + |right|) (r + D) / D)
///                    + 2^-48 (|x| + W) (r + D) / d
///   perspective, z:  2^-48 W/w D^2 / dF (r + D) / d
///   parallel, x:     2^-48 W/w (r + (|c - prp.x| + |prp.x|) r / D + |left| + |right|) + 2^-48 W
///   parallel, z:     2^-48 W/w (r + |front| + |back|)
/// y is as x. The snap adds half a step of the grid. For a point of the world, which vrcRotation() turns
/// first, the bounds are twice these, with r over the sine of the angle between VPN and VUP.

/// The transform to pixels: x right, y down, origin at the top left corner of the picture. z is in pixels
/// too. On the view plane, a step towards the viewer counts as much as a step to the right. z is 0 at the
/// back plane, and larger is nearer.
[[nodiscard]] glm::dmat4 screenFromCanonical(const ViewSpec& spec, int width, int height);

/// z of the front plane in the units of screenFromCanonical(). No visible z is larger.
[[nodiscard]] double frontDepth(const ViewSpec& spec, int width);

}  // namespace xnewell
