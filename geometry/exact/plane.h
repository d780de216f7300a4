#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace xnewell {

/// The plane N.p = d. N is a unit vector, or 0 if the polygon has no area.
struct Plane {
  glm::dvec3 N{0.0};
  double d = 0.0;
};

/// Twice the vector area of a closed polygon, by Newell's method. It uses every vertex, so a slightly bent
/// polygon gets the plane that fits it, and concave or collinear corners do no harm. The vector points
/// to the side from which the vertices run counter-clockwise. It is 0 for a polygon without area.
/// Vertices are taken relative to the first one, so that a polygon far from the origin loses no digits. If no
/// coordinate is further than E from the first vertex's, each of the vector's is off by at most n (n + 10)
/// 2^-52 E^2 for n corners: a term is below 4 E^2 and has 20 roundings of E^2, and the sums have 2 n^2. E is
/// from 2^-400 to 2^400.
/// @see Sutherland, Sproull & Schumacker 1974, who credit M. Newell; Foley & van Dam 2e §11.1.3
[[nodiscard]] glm::dvec3 newellVector(std::span<const glm::dvec3> points, std::span<const int> corners);

/// The plane through the mean of the corners. Its N is the normalised Newell vector.
[[nodiscard]] Plane newellPlane(std::span<const glm::dvec3> points, std::span<const int> corners);

/// The centroid of the area. Flat shading evaluates the illumination there. More corners on the sides do not
/// move it, and a concave polygon may have it outside. Corners are taken relative to the first one, as above.
/// It is the mean of the corners for a triangle and for a polygon without area. A polygon that crosses itself
/// has parts that count as negative; the result stays in the box of the corners.
[[nodiscard]] glm::dvec3 centroid(std::span<const glm::dvec3> points, std::span<const int> corners);

}  // namespace xnewell
