#pragma once

#include <cstdint>

#include "geometry/view/project.h"

namespace xnewell {

/// True if two faces of different planes may touch at (x, y), |x|, |y| <= 2^30 grid steps, where the records
/// put `front` before `behind`: the plane of front's own corners is not nearer than that of behind's by more
/// than the sum of their doubts.
[[nodiscard]] bool mayTouch(const SnappedScene& scene, const SnappedFace& front, const SnappedFace& behind,
                            std::int64_t x, std::int64_t y);

}  // namespace xnewell
