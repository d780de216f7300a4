#pragma once

#include <cstdint>

#include "geometry/view/project.h"

namespace xnewell {

/// True if two faces of different planes may touch at (x, y), |x|, |y| <= 2^30 grid steps, where the records
/// put `front` before `behind`: the plane of front's own corners is not nearer than that of behind's by more
/// than the sum of their doubts. The plane of a polygon with more than three corners misses them; that of a
/// parallelogram may be 1.5 r off the true one. So it may also be nearer by 1.5 times the sum, if the records
/// are within the sum. The doubles decide right unless the two sides are within 2^-49 of the sum of the
/// depths, leads and doubts.
[[nodiscard]] bool mayTouch(const SnappedScene& scene, const SnappedFace& front, const SnappedFace& behind,
                            std::int64_t x, std::int64_t y);

}  // namespace xnewell
