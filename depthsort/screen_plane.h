#pragma once

#include <cstdint>
#include <vector>

#include "geometry/int128.h"
#include "geometry/project.h"

/// The plane of a face over the screen, exactly: z = (A x + B y + D) / C in the units of SnappedScene.
/// Holds:  C > 0, for a snapped face has an area.
/// Bounds: |x|, |y| <= 2^29 and 0 <= z <= 2^30 make |A|, |B|, C <= 2^61 and |D| <= 2^93.
struct ScreenPlane {
  std::int64_t A = 0, B = 0, C = 1;
  Int128 D = 0;
  bool operator==(const ScreenPlane&) const = default;
};

/// Through three vertices of the face that lie far apart: the first, the farthest from it on the screen, and
/// the one that spans the largest triangle with both. A face of more than three corners is planar only up to
/// the rounding of the snap; this plane is the one it has from here on.
[[nodiscard]] ScreenPlane planeOf(const SnappedScene& scene, const SnappedFace& face);

/// The sign of zP - zQ at pixel (i, j)'s sample, the centre moved by (e, e^2): +1 where P is nearer, -1 where
/// Q is, 0 only if the planes are the same everywhere. At equal z at the centre the steeper rise to the
/// right is nearer, then the steeper rise downward. Exact: whole parts and remainders of the
/// two quotients are compared, remainders crosswise in 128 bits.
[[nodiscard]] int nearer(const ScreenPlane& P, const ScreenPlane& Q, int i, int j);

/// z at the centre of pixel (i, j), in doubles; within 2^-50 of itself.
[[nodiscard]] double depthAt(const ScreenPlane& plane, int i, int j);

/// How far off in z the plane may be for the rounding of the snap and of the model: 4 h (1 + (|A| + |B|) /
/// C), h = 1/2 + inputSteps. Two planes nearer to each other than the sum of theirs may be one in the model.
[[nodiscard]] double doubt(const ScreenPlane& plane, double inputSteps);
