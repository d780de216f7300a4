#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/exact/int128.h"

namespace xnewell {

/// A point on an integer grid; |x|, |y| <= 2^60.
struct LatticePoint {
  std::int64_t x = 0, y = 0;
  bool operator==(const LatticePoint&) const = default;
};

/// Twice the signed area of the triangle abc: > 0 for a left turn at b, 0 if the three points are in line.
/// Exact: differences are at most 2^61, the result at most 2^123.
[[nodiscard]] constexpr Int128 turn(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return Int128{b.x - a.x} * (c.y - a.y) - Int128{b.y - a.y} * (c.x - a.x);
}

/// Cuts a polygon into triangles by clipping ears. The polygon has n >= 3 corners, counter-clockwise. The
/// result has n - 2 triangles, whose corners are indices into `outline`.
/// If the polygon does not cross itself, every triangle is counter-clockwise and has area. A corner in the
/// middle of a straight side also becomes a corner of triangles. The boundary may touch itself in corners and
/// run along the same edge twice (to join a hole to the outside). If the polygon crosses itself, there are
/// still n - 2 triangles, but some overlap or face backwards: where no ear is left, any corner is cut off.
/// Work: near n log n. A corner is tested again only after a neighbour is cut off or after the corner that
/// lay in its triangle is gone; a tree finds such corners. A polygon of n needles costs n sqrt n, because a
/// needle passes through sqrt n boxes of the tree.
/// @see Meisters 1975 (two ears theorem); O'Rourke, Computational Geometry in C §1.6.5
[[nodiscard]] std::vector<std::array<int, 3>> clipEars(std::span<const LatticePoint> outline);

}  // namespace xnewell
