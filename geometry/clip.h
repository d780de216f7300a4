#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <vector>

/// Clipping in homogeneous screen coordinates (x w, y w, z w, w) before the division.
/// @see Foley & van Dam 2e §6.5.4, Sutherland & Hodgman 1974

/// A half space: inside where dot(plane, p) >= 0.
using ClipPlane = glm::dvec4;

/// Front plane, back plane and the four sides of the guard band, in the order in which they clip: the
/// front comes first, so that w > 0 for everything after it.
[[nodiscard]] std::array<ClipPlane, 6> clipPlanes(double zFront, double guard);

/// Bit k is set where p lies outside plane k.
[[nodiscard]] unsigned outcode(const std::array<ClipPlane, 6>& planes, const glm::dvec4& p);

/// Sutherland and Hodgman, plane by plane, only those in `planesMask`. A new vertex is always computed
/// from the end inside towards the end outside, so both neighbours of an edge get the same one. `polygon`
/// is replaced; empty when nothing is left.
void clip(std::vector<glm::dvec4>& polygon, const std::array<ClipPlane, 6>& planes, unsigned planesMask);
