#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

#include "geometry/view/screen_plane.h"

namespace xnewell {

/// Values that are interpolated over a face: intensities, or coordinates in a map. Gouraud 1971 steps them
/// along the edges, then along each row; over a triangle that gives a plane.

/// A plane over the picture, in 8.24 fixed point: c + gx i + gy j modulo 2^32 at the centre of pixel (i, j).
/// This is the definition of the interpolated value of a face. The steps are exact. So a pixel has one value,
/// wherever a span starts and however the face is split.
struct AffineValue {
  std::uint32_t c = 0, gx = 0, gy = 0;
  [[nodiscard]] constexpr std::uint32_t at(int i, int j) const {
    return c + gx * static_cast<std::uint32_t>(i) + gy * static_cast<std::uint32_t>(j);
  }
  bool operator==(const AffineValue&) const = default;
};

/// The least and the largest value of a vertex. Values in between stay in [0, 256) at every sample of the
/// triangle, because the plane is off by less than 2^-9.
inline constexpr double kLeastValue = 1.0 / 256, kLargestValue = 255.99;

/// The nearest integer, and of two the even one, for |x| < 2^51: the last bit of x + 3 2^51 is worth 1.
[[nodiscard]] inline std::int64_t nearestInteger(double x) {
  constexpr double kLastBitIsOne = 0x1.8p52;
  return std::bit_cast<std::int64_t>(x + kLastBitIsOne) - std::bit_cast<std::int64_t>(kLastBitIsOne);
}

/// A value in [kLeastValue, kLargestValue], in steps of 2^-24.
[[nodiscard]] inline std::uint32_t valueSteps(double v) {
  assert(kLeastValue <= v && v <= kLargestValue);
  return static_cast<std::uint32_t>(nearestInteger(v * 0x1p24));
}

/// Makes planes through values at the vertices of one triangle.
/// Space: vertices on the 1/65536 pixel grid, |x|, |y| <= 2^29; values in steps of 2^-24.
///
/// The values V are rounded to steps, which leaves an error of at most 1/2 step anywhere in the triangle. The
/// gradient is N / D per grid step, with N = V1 y2 - V2 y1 and D = x1 y2 - x2 y1 in differences from vertex
/// 0. |N| < 2^63 and |D| <= 2^61 are exact. Four roundings (of N, D, 1 / D and the product) leave a relative
/// error of 2^-51. Below `kSteepest` = 2^44 steps per pixel that is 2^-7 step, and 1/2 + 2^-7 step after the
/// gradient is rounded to whole steps. The plane keeps the lower 32 bits of them. The value at vertex 0 adds
/// another 1/2 step. A sample of the triangle is at most the width w and the height h away from vertex 0, so
/// it is off the exact plane by at most
///   (1/2 + 2^-7) (w + h) + 1 steps:  2^-10.9 over 8,192 x 8,192 pixels, 2^-9.9 over the whole grid.
///
/// Where the values grow by more than kSteepest, 2^20 per pixel, they pass through their range of 256 within
/// 2^-12 pixel, or 16 grid steps. Such a triangle is a sliver, in which the snap decides the gradient. It has
/// the mean everywhere.
class AffineOver {
 public:
  static constexpr double kSteepest = 0x1p44;

  [[gnu::always_inline]] explicit AffineOver(const glm::ivec3* p)
      : x0_{p[0].x - kGrid / 2},
        y0_{p[0].y - kGrid / 2},
        x1_{p[1].x - p[0].x},
        y1_{p[1].y - p[0].y},
        x2_{p[2].x - p[0].x},
        y2_{p[2].y - p[0].y},
        gridOverD_{kGrid / static_cast<double>(x1_ * y2_ - x2_ * y1_)} {}

  /// The plane through v[k] at vertex k, all in [kLeastValue, kLargestValue].
  [[nodiscard]] AffineValue operator()(const std::array<double, 3>& v) const {
    const std::array steps{valueSteps(v[0]), valueSteps(v[1]), valueSteps(v[2])};
    return (*this)(steps.data());
  }
  /// The same for three values in steps.
  [[nodiscard, gnu::always_inline]] AffineValue operator()(const std::uint32_t* steps) const {
    const std::int64_t V0 = steps[0];
    const std::int64_t V1 = steps[1] - V0, V2 = steps[2] - V0;
    const double alongX = static_cast<double>(V1 * y2_ - V2 * y1_) * gridOverD_;
    const double alongY = static_cast<double>(V2 * x1_ - V1 * x2_) * gridOverD_;
    const bool steep =
        !(std::abs(alongX) <= kSteepest && std::abs(alongY) <= kSteepest);  // true for no area, too
    if (steep) return {static_cast<std::uint32_t>(V0 + (V1 + V2) / 3), 0, 0};
    // Modulo 2^64 is enough: only bits 16 to 47 are kept.
    const auto gx = static_cast<std::uint64_t>(nearestInteger(alongX));
    const auto gy = static_cast<std::uint64_t>(nearestInteger(alongY));
    const std::uint64_t toVertex =
        gx * static_cast<std::uint64_t>(x0_) + gy * static_cast<std::uint64_t>(y0_);
    const std::uint64_t c = static_cast<std::uint64_t>(V0) - ((toVertex + kGrid / 2) >> kGridBits);
    return {static_cast<std::uint32_t>(c), static_cast<std::uint32_t>(gx), static_cast<std::uint32_t>(gy)};
  }

 private:
  std::int64_t x0_, y0_;  ///< vertex 0, relative to the centre of pixel (0, 0)
  std::int64_t x1_, y1_, x2_, y2_;
  double gridOverD_;
};

}  // namespace xnewell
