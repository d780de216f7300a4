#pragma once

#include <cstdint>

#include "geometry/model/mesh.h"

namespace xnewell {

// Meshes for tests, benchmarks and lessons. One group, no rounding. Faces of closed solids are
// counter-clockwise seen from outside.

/// The cube |x|, |y|, |z| <= 1: 8 vertices, 6 squares. Each shows the whole texture, v along z; of top and
/// bottom along y.
[[nodiscard]] Mesh cube();

/// A unit sphere about the origin, poles on the z axis: `around` >= 3 meridians, `down` >= 2 bands;
/// around * down faces, triangles at the poles. Texture: u eastward from the x axis, v from pole to pole; the
/// corners at a pole have the u of their triangle's middle.
[[nodiscard]] Mesh sphere(int around, int down);

/// A torus about the z axis, radii 1 and 0.4: around * across quadrilaterals, both >= 3. Texture: u
/// eastward from the x axis, v around the tube, upwards from its outermost circle.
[[nodiscard]] Mesh torus(int around, int across);

/// `count` triangles with corners within `size` of centres scattered in the cube |x|, |y|, |z| <= 1; the
/// same for a seed on every machine.
[[nodiscard]] Mesh triangleSoup(int count, double size, std::uint64_t seed);

}  // namespace xnewell
