#pragma once

#include <cstdint>

#include "geometry/model/mesh.h"

namespace xnewell {

// Meshes for tests, benchmarks and lessons. Each has one group and exact coordinates. The faces of closed
// solids are counter-clockwise seen from outside.

/// The cube |x|, |y|, |z| <= 1: 8 vertices, 6 squares. Each square shows the whole texture; v runs along z,
/// on the top and the bottom along y.
[[nodiscard]] Mesh cube();

/// A unit sphere about the origin with its poles on the z axis. It has `around` >= 3 meridians and `down` >=
/// 2 bands, so around * down faces; those at the poles are triangles. Texture: u runs eastward from the x
/// axis, v from the south pole to the north pole. A corner at a pole has the u of its triangle's middle.
[[nodiscard]] Mesh sphere(int around, int down);

/// A torus about the z axis with radii 1 and 0.4. It has around * across quadrilaterals, both >= 3. Texture:
/// u runs eastward from the x axis, v around the tube, upwards from its outermost circle.
[[nodiscard]] Mesh torus(int around, int across);

/// The round surfaces that sphere() and torus() approximate.
enum class RoundSolid { Sphere, Torus };
/// A vector along the outward normal of the surface, at its point that is nearest to p. It is not a unit
/// vector. It is 0 where many points are nearest: at the centre of the sphere, and on the axis and on the
/// central circle of the torus.
[[nodiscard]] glm::dvec3 outward(RoundSolid solid, const glm::dvec3& p);

}  // namespace xnewell
