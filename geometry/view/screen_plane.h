#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "geometry/exact/int128.h"
#include "geometry/view/screen_grid.h"

namespace xnewell {

/// The plane of faces over the screen, exactly: z = (A x + B y + D) / C in the units of SnappedScene.
/// Holds:  C > 0, for a snapped face has an area.
/// Bounds: |x|, |y| <= 2^29 and 0 <= z <= 2^30 make |A|, |B|, C <= 2^61 and |D| <= 2^93.
struct ScreenPlane {
  std::int64_t A = 0, B = 0, C = 1;
  Int128 D = 0;
  bool operator==(const ScreenPlane&) const = default;
};

/// Through three of the points that lie far apart: the least in x, y, z, the farthest from it on the screen,
/// and the one that spans the largest triangle with both; of equals the least again, so the points' order
/// does not matter. A face of more than three corners, or several faces in one plane, are planar only up to
/// the rounding of the snap; this plane is the one they have from here on. count >= 3, the points not all in
/// line on the screen.
[[nodiscard]] ScreenPlane planeThrough(const glm::ivec3* points, int count);

/// The sign of zP - zQ at (x, y), |x|, |y| <= 2^30 grid steps: +1 where P is nearer, 0 where they meet.
/// Exact: whole parts and remainders of the two quotients are compared, remainders crosswise in 128 bits.
[[nodiscard]] int compareDepths(const ScreenPlane& P, const ScreenPlane& Q, std::int64_t x, std::int64_t y);

/// The same at pixel (i, j)'s sample, the centre moved by (e, e^2): 0 only if the planes are the same
/// everywhere. At equal z at the centre the steeper rise to the right is nearer, then the steeper
/// rise downward.
[[nodiscard]] int nearer(const ScreenPlane& P, const ScreenPlane& Q, int i, int j);

/// z at (x, y), |x|, |y| <= 2^30 grid steps, in doubles: three roundings of 2^-53 off at most.
[[nodiscard]] double depthAt(const ScreenPlane& plane, std::int64_t x, std::int64_t y);

}  // namespace xnewell
