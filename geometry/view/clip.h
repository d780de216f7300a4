#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace xnewell {

/// Clipping in homogeneous screen coordinates (x w, y w, z w, w) before the division.
/// @see Foley & van Dam 2e §6.5.4, Sutherland & Hodgman 1974

/// A half space: inside where dot(plane, p) >= 0.
using ClipPlane = glm::dvec4;

/// Front plane, back plane and the four sides of the guard band, in the order in which they clip: the
/// front comes first, so that w > 0 for everything after it.
[[nodiscard]] std::array<ClipPlane, 6> clipPlanes(double zFront, double guard);

/// Bit k is set where p lies outside plane k.
[[nodiscard]] inline unsigned outcode(const std::array<ClipPlane, 6>& planes, const glm::dvec4& p) {
  unsigned code = 0;
  for (unsigned k = 0; k < planes.size(); ++k)
    code |= static_cast<unsigned>(!(glm::dot(planes[k], p) >= 0.0)) << k;
  return code;
}

/// A vertex on its way through the clipper.
struct ClipVertex {
  glm::dvec4 p;    ///< homogeneous
  int source = 0;  ///< as SnappedScene::source
};

/// A vertex that clipping made: at a + t (b - a), 0 <= t <= 1, of two others, before the division.
struct Between {
  int a, b;  ///< sources of the two, a the one inside
  double t;
};

/// Sutherland and Hodgman, plane by plane, only those in `planesMask`. A new vertex is always computed
/// from the end inside towards the end outside, so both neighbours of an edge get the same one; it is
/// appended to `made`, and its source is the complement of its index there. `polygon` is replaced; empty when
/// nothing is left.
void clip(std::vector<ClipVertex>& polygon, const std::array<ClipPlane, 6>& planes, unsigned planesMask,
          std::vector<Between>& made);

}  // namespace xnewell
