#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/exact/int128.h"

namespace xnewell {

/// A point of an integer grid, |x|, |y| <= 2^60.
struct LatticePoint {
  std::int64_t x = 0, y = 0;
  bool operator==(const LatticePoint&) const = default;
};

/// Twice the signed area of the triangle abc: > 0 for a left turn at b, 0 if the three are in line.
/// Exact: differences are at most 2^61, the result at most 2^123.
[[nodiscard]] constexpr Int128 turn(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return Int128{b.x - a.x} * (c.y - a.y) - Int128{b.y - a.y} * (c.x - a.x);
}

/// Cuts a polygon of n >= 3 corners, counter-clockwise, into n - 2 triangles of its own corners (indices
/// into `outline`). If it does not cross itself every triangle is counter-clockwise and has area, and a
/// corner in the middle of a straight side is a corner of triangles, too. The boundary may touch itself in
/// corners and run along the same edge twice (a hole joined to the outside). If it crosses itself, still
/// n - 2 triangles, but some overlap or face backwards: where no ear is left a corner is cut off as it is.
/// Near n log n: a corner is tested again only when a neighbour was cut off or the corner that stood in
/// its way is gone, and those are looked up in a tree. A polygon of n needles costs n sqrt n: a needle
/// passes that many boxes of the tree.
/// @see Meisters 1975 (two ears theorem); O'Rourke, Computational Geometry in C §1.6.5
[[nodiscard]] std::vector<std::array<int, 3>> clipEars(std::span<const LatticePoint> outline);

}  // namespace xnewell
