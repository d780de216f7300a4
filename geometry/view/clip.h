#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace xnewell {

/// Clipping in homogeneous screen coordinates (x w, y w, z w, w), before the division by w.
/// @see Foley & van Dam 2e §6.5.4, Sutherland & Hodgman 1974

/// A half space. A point p is inside if dot(plane, p) >= 0.
using ClipPlane = glm::dvec4;

/// The front plane, the back plane and the four sides of the guard band, in the order of clipping. The front
/// plane comes first, so that w > 0 for all that follow.
[[nodiscard]] std::array<ClipPlane, 6> clipPlanes(double zFront, double guard);

/// Bit k is set if p lies outside plane k.
[[nodiscard]] inline unsigned outcode(const std::array<ClipPlane, 6>& planes, const glm::dvec4& p) {
  unsigned code = 0;
  for (unsigned k = 0; k < planes.size(); ++k)
    code |= static_cast<unsigned>(!(glm::dot(planes[k], p) >= 0.0)) << k;
  return code;
}

/// A vertex inside the clipper.
struct ClipVertex {
  glm::dvec4 p;    ///< homogeneous
  int source = 0;  ///< as in SnappedScene::source
};

/// A vertex that clipping made. It lies at a + t (b - a), 0 <= t <= 1, between two others, before the
/// division by w.
struct Between {
  int a, b;  ///< sources of the two vertices; a is the one inside
  double t;
};

/// Clips a polygon by Sutherland and Hodgman's method, plane by plane, with the planes of `planesMask` only.
/// A new vertex is always computed from the inside end towards the outside end, so both faces at an edge get
/// the same vertex. Each of its coordinates is within 2^-51 (|a| + |b|) of a + t (b - a), for the ends' own
/// coordinates a and b, if these are 0 or above 2^-900. Its height over the plane is at most 2^-49 times the
/// sum of the absolute values of the terms of both ends' heights (10 roundings of them). It is appended to
/// `made`; its source is the complement of its index there. `polygon` is replaced; it is empty if nothing is
/// left.
void clip(std::vector<ClipVertex>& polygon, const std::array<ClipPlane, 6>& planes, unsigned planesMask,
          std::vector<Between>& made);

}  // namespace xnewell
