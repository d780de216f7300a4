#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "shading/fill/pixel_row.h"

namespace xnewell {

/// The largest whole number not above v, |v| < 2^23.
template <class Real>
[[gnu::always_inline]] inline Real wholePart(const Real& v) {
  Real whole;
  for (int k = 0; k < kLanes<Real>; ++k)
    whole[k] = std::floor(v[k]);  // one instruction on processors that have it
  return whole;
}

/// The texels at some places. They stay in registers: if the bytes were stored one by one, a load of all of
/// them would have to wait.
template <class Real>
[[gnu::always_inline]] inline Real texelsAt(const std::uint8_t* texels, const int* places) {
  IntegersOf<Real> at;
  for (int k = 0; k < kLanes<Real>; ++k) at[k] = texels[places[k]];
  return __builtin_convertvector(at, Real);
}

/// The texels along a row, if the triangle has a texture. A place is off by at most the error of the divided
/// coordinates (pixel_row.h) and three roundings of 1, times the width or the height.
template <class Real>
class TexelRow {
 public:
  [[gnu::always_inline]] TexelRow(const EvaluatedTriangle& t, double down)
      : texels_{t.texels}, repeats_{t.repeats} {
    if (texels_ == nullptr) return;
    const int width = t.texture->width, height = t.texture->height;
    columns_ = splat<Real>(width), rows_ = splat<Real>(height);
    lastColumn_ = splat<Real>(width - 1), lastRow_ = splat<Real>(height - 1);
    stride_ = Places{} + static_cast<unsigned>(width);
    last_ = Places{} + static_cast<unsigned>(width * height - 1);
    q_ = {t.q, down};
    if (repeats_)
      u_ = {t.u, down}, v_ = {t.v, down};
    else
      u_ = {t.u * width, down}, v_ = {(t.q - t.v) * height, down};
  }
  [[gnu::always_inline]] explicit operator bool() const { return texels_ != nullptr; }
  /// Finds the places of the texels, before the first is looked up.
  [[gnu::always_inline]] void locate(const Real* along, int blocks) {
    for (int b = 0; b < blocks; ++b) {
      const Real w = splat<Real>(1.0) / q_.at(along[b]);
      const Places at = placesOf(u_.at(along[b]) * w, v_.at(along[b]) * w);
      std::memcpy(&places_[b * kLanes<Real>], &at, sizeof at);
    }
  }
  /// As a share of 1.
  [[nodiscard, gnu::always_inline]] Real share(int b) const {
    return texelsAt<Real>(texels_, &places_[b * kLanes<Real>]) * splat<Real>(1.0 / 255.0);
  }

 private:
  using Places = Lanes<unsigned, kLanes<Real>>;

  /// The places are always inside the texture, also for lanes past the end of a span, where 1 / w may have
  /// crossed 0 and the coordinates may be anything. (To compare the place costs a tenth of a texel less than
  /// to bound both coordinates.)
  [[nodiscard, gnu::always_inline]] Places placesOf(const Real& u, const Real& v) const {
    Real column = u, row = v;
    if (repeats_) {
      const Real s = u - wholePart(u), t = splat<Real>(1.0) - (v - wholePart(v));  // t runs down, in (0, 1]
      column = s * columns_, row = t * rows_;
    }
    const auto whole = [](const Real& x) {
      return reinterpret_cast<Places>(__builtin_convertvector(x, IntegersOf<Real>));
    };
    const Places place = whole(smaller(row, lastRow_)) * stride_ + whole(smaller(column, lastColumn_));
    return place < last_ ? place : last_;
  }

  const std::uint8_t* texels_;
  bool repeats_;
  Real columns_, rows_, lastColumn_, lastRow_;
  Places stride_, last_;
  RowOf<Real> u_, v_, q_;  ///< columns and rows instead of u and v if the texture does not repeat
  std::array<int, kMostBlocks * kLanes<Real>> places_;
};

}  // namespace xnewell
