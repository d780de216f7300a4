#pragma once

#include <array>

#include "shading/fill/evaluated.h"
#include "shading/fill/lanes.h"

namespace xnewell {

/// The values that the pixels of a row have in common are made once. The pixels are evaluated in blocks, one
/// pixel in each lane. Here, and in the files that include this one, all templates are inlined, so that each
/// caller compiles them for its processor.

template <class Real>
using IntegersOf = Lanes<int, kLanes<Real>>;

/// The values along a row, of one plane or of three.
///
/// Error bounds: let u be the unit of rounding of Real, 2^-53 or 2^-24. Over a box of w x h pixels, let T =
/// |v0| + gx (w + 1) + gy (h + 1), where v0 is the value of the first vertex, and gx and gy are the gradients
/// with absolute values in place of their terms. Let a be the absolute values of the terms of the triangle's
/// area, over the area. Then a value is off by at most t = 8 u T + 32 2^-53 a T. Divided by a plane of 1 / w,
/// q, that is off by at most s q, s < 1/10, it is off by at most (t / q + s |value|) / (1 - s) + 3 u |value|.
template <class Real>
struct RowOf {
  Real c, gx;
  RowOf() = default;
  [[gnu::always_inline]] RowOf(const PixelPlane& plane, double down)
      : c{splat<Real>(plane.c + plane.gy * down)}, gx{splat<Real>(plane.gx)} {}
  /// At the pixels that are `along` to the right of i0.
  [[gnu::always_inline]] Real at(const Real& along) const { return c + gx * along; }
};
template <class Real>
struct RowOfThree {
  RowOf<Real> x, y, z;
  RowOfThree() = default;
  [[gnu::always_inline]] RowOfThree(const std::array<PixelPlane, 3>& p, double down)
      : x{p[0], down}, y{p[1], down}, z{p[2], down} {}
  [[gnu::always_inline]] Vec<Real> at(const Real& along) const {
    return {x.at(along), y.at(along), z.at(along)};
  }
};

/// 0, 1, 2, ...
template <class Real>
[[gnu::always_inline]] inline Real lanesFrom0() {
  Real lane;
  for (int k = 0; k < kLanes<Real>; ++k) lane[k] = static_cast<Number<Real>>(k);
  return lane;
}

/// This many blocks are evaluated together, one step after the other, so that the numbers of a step stay in
/// registers. It is more than 16, because GCC unrolls shorter loops completely: twice the code, in the same
/// time.
constexpr int kMostBlocks = 24;

}  // namespace xnewell
