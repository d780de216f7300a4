#pragma once

#include <array>

#include "shading/fill/evaluated.h"
#include "shading/light/lanes.h"

namespace xnewell {

/// The values that the pixels of a row have in common are made once. The pixels are evaluated in blocks, one
/// pixel in each lane. Here, and in the files that include this one, all templates are inlined, so that each
/// caller compiles them for its processor.

template <class Real>
using IntegersOf = Lanes<int, kLanes<Real>>;

/// The values along a row, of one plane or of three.
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
