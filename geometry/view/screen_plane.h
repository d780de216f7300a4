#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "geometry/exact/int128.h"

namespace xnewell {

/// The screen grid. x and y count in units of 1/65536 pixel.
inline constexpr int kGridBits = 16;
inline constexpr int kGrid = 1 << kGridBits;
/// The largest width and height of a picture. The guard band reaches as far from the origin, so |x|, |y| <=
/// 2^29.
inline constexpr int kMaxPicture = 8192;

/// The first row, or column, whose sample lies at or after a coordinate. An interval from `from` to `to`
/// contains the samples sampleFrom(from) to sampleFrom(to) - 1.
[[nodiscard]] constexpr int sampleFrom(int coordinate) { return (coordinate + kGrid / 2 - 1) >> kGridBits; }

/// The exact plane of faces over the screen: z = (A x + B y + D) / C in the units of SnappedScene.
/// Holds:  C > 0, because a snapped face has an area.
/// Bounds: |x|, |y| <= 2^29 and 0 <= z <= 2^30 make |A|, |B|, C <= 2^61 and |D| <= 2^93. A plane of the model
/// has
///         |A|, |B|, C <= 2^60 and, at some place in the picture, |z| <= 2^31: so it keeps to them.
struct ScreenPlane {
  std::int64_t A = 0, B = 0, C = 1;
  /// True if it comes from a plane of the model (plane_record.h), not from vertices on the grid.
  bool ofModel = false;  // before D: that saves 16 bytes of padding
  Int128 D = 0;
  bool operator==(const ScreenPlane&) const = default;
};

/// The plane through three of the points that lie far apart: the least point (in x, then y, then z), the
/// point farthest from it on the screen, and the point that spans the largest triangle with both. Of equal
/// choices it takes the least, so the order of the points does not matter. It is the record of a single
/// triangle, and of planes that are seen too nearly edge-on for a record from the model. count >= 3, and not
/// all points are in line on the screen.
[[nodiscard]] ScreenPlane planeThrough(const glm::ivec3* points, int count);

/// The sign of zP - zQ at (x, y), |x|, |y| <= 2^30 grid steps: +1 if P is nearer, 0 if the planes meet there.
/// Exact: it compares the whole parts of the two quotients, then their remainders, cross-multiplied in 128
/// bits.
[[nodiscard]] int compareDepths(const ScreenPlane& P, const ScreenPlane& Q, std::int64_t x, std::int64_t y);

/// The same at the sample of pixel (i, j), which is the centre moved by an infinitely small (e, e^2). The
/// result is 0 only if the planes are the same everywhere. If z is equal at the centre, the plane that rises
/// more steeply to the right is nearer; if those are equal too, the one that rises more steeply downward.
[[nodiscard]] int nearer(const ScreenPlane& P, const ScreenPlane& Q, int i, int j);

/// z at (x, y), |x|, |y| <= 2^30 grid steps, as a double. Its error is at most four roundings of 2^-53.
[[nodiscard]] double depthAt(const ScreenPlane& plane, std::int64_t x, std::int64_t y);

}  // namespace xnewell
