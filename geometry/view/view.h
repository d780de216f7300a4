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

/// A camera that cannot see: a zero direction, an empty window, an eye behind its own front plane.
struct ViewError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class Projection { Parallel, Perspective };

/// VRC are the viewing reference coordinates u (right), v (up), n (towards the viewer), origin at VRP;
/// the view plane is n = 0. A parallel projection's direction runs from PRP to the window's centre: off
/// the n axis it is oblique, and the shear lives here.
/// Holds (checked by the matrix functions, which throw ViewError): VPN not 0, VUP not along VPN, PRP in
/// front of the view plane (prp.z > 0), windowMin < windowMax, front > back, and for perspective
/// front < prp.z.
struct ViewSpec {
  Projection projection = Projection::Perspective;
  glm::dvec3 vrp{0}, vpn{0, 0, 1}, vup{0, 1, 0};  ///< world
  glm::dvec3 prp{0, 0, 1};                        ///< VRC
  glm::dvec2 windowMin{-1}, windowMax{1};         ///< VRC, on the view plane
  double front = 0, back = -1;                    ///< VRC n of the clipping planes F and B
  bool operator==(const ViewSpec&) const = default;
};

/// The rotation from world to VRC directions. A point is best moved by -VRP first, then rotated: far from the
/// origin that difference is exact, and the product below would cancel.
[[nodiscard]] glm::dmat3 vrcRotation(const ViewSpec& spec);

/// Rotation and translation from world to VRC.
[[nodiscard]] glm::dmat4 vrcFromWorld(const ViewSpec& spec);

/// To the canonical parallel volume: x, y in [-1, 1], z in [-1, 0], larger nearer, front plane at 0. A
/// perspective view is warped to it (homogeneous; w > 0 in front of the eye), so planes stay planes.
[[nodiscard]] glm::dmat4 canonicalFromVrc(const ViewSpec& spec);

/// To pixels: x right, y down, origin at the top left corner of the picture. z is in pixels too, measured
/// so that on the view plane a step towards the viewer counts as much as one to the right; 0 at the back
/// plane, larger nearer.
[[nodiscard]] glm::dmat4 screenFromCanonical(const ViewSpec& spec, int width, int height);

/// z of the front plane in the units of screenFromCanonical: nothing visible is larger.
[[nodiscard]] double frontDepth(const ViewSpec& spec, int width);

}  // namespace xnewell
