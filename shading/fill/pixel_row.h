#pragma once

#include <array>

#include "shading/fill/evaluated.h"
#include "shading/light/lanes.h"

namespace xnewell {

/// What the pixels of a row have in common is made once for all of them; they are evaluated in blocks of as
/// many as there are lanes. Templates that are inlined whole, here as in the files that include this one, so
/// that each caller compiles them for its processor.

template <class Real>
using IntegersOf = Lanes<int, kLanes<Real>>;

/// The values of a plane, or of three, along a row.
template <class Real>
struct RowOf {
  Real c, gx;
  RowOf() = default;
  [[gnu::always_inline]] RowOf(const PixelPlane& plane, double down)
      : c{splat<Real>(plane.c + plane.gy * down)}, gx{splat<Real>(plane.gx)} {}
  /// At pixels `along` right of i0.
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

/// As many blocks are evaluated together, step by step, so that what a step needs stays in registers. More
/// than 16, for GCC unrolls shorter loops whole, which takes twice the code and no less time.
constexpr int kMostBlocks = 24;

}  // namespace xnewell
