#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace xnewell {

/// N.p = d, with N a unit vector, or 0 where the polygon spans no area.
struct Plane {
  glm::dvec3 N{0.0};
  double d = 0.0;
};

/// Twice the vector area of a closed polygon by Newell's method: every vertex counts, so a slightly
/// bent polygon gets the plane that fits it and a concave or collinear corner does no harm. Points
/// towards the side from which the vertices run counter-clockwise; 0 for a polygon without area.
/// Vertices are taken relative to the first one, so that a far-away polygon loses no digits.
/// @see Sutherland, Sproull & Schumacker 1974, who credit M. Newell; Foley & van Dam 2e §11.1.3
[[nodiscard]] glm::dvec3 newellVector(std::span<const glm::dvec3> points, std::span<const int> corners);

/// The plane through the corners' mean with the normalised Newell vector as N.
[[nodiscard]] Plane newellPlane(std::span<const glm::dvec3> points, std::span<const int> corners);

/// The mean of the corners, where flat shading evaluates the illumination.
[[nodiscard]] glm::dvec3 centroid(std::span<const glm::dvec3> points, std::span<const int> corners);

}  // namespace xnewell
