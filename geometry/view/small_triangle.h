#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>

#include "geometry/view/screen_plane.h"

namespace xnewell {

/// Eight numbers modulo 2^32, for eight neighbouring pixels, by GCC's and Clang's vector extension; any
/// processor has them.
struct Eight {
  using Four [[gnu::vector_size(16)]] = std::uint32_t;
  Four left, right;  ///< pixels 0 to 3, 4 to 7

  void operator+=(std::uint32_t step) { left += step, right += step; }
  friend Eight operator|(const Eight& a, const Eight& b) { return {a.left | b.left, a.right | b.right}; }
};

/// first, first + step, first + 2 step, ...
[[nodiscard]] inline Eight eightFrom(std::uint32_t first, std::uint32_t step) {
  const Eight::Four left{first, first + step, first + 2 * step, first + 3 * step};
  return {left, left + 4 * step};
}

/// The columns and rows of the samples that an outline may own. They are not clipped.
struct SampleBox {
  int left, right, top, bottom;  ///< right and bottom are the first outside

  [[nodiscard]] bool meets(int width, int height) const {
    return right > 0 && left < width && bottom > 0 && top < height;
  }
};
[[nodiscard]] inline SampleBox sampleBoxOf(const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c) {
  return {sampleFrom(std::min({a.x, b.x, c.x})), sampleFrom(std::max({a.x, b.x, c.x})),
          sampleFrom(std::min({a.y, b.y, c.y})), sampleFrom(std::max({a.y, b.y, c.y}))};
}

/// Which samples a small triangle owns, by the rule of scanline.h. Its three edge functions are evaluated at
/// each sample of a block of 8 columns and 4 or 8 rows; its edges are too short to be walked. The triangle is
/// counter-clockwise on the screen, its box is small and meets a picture of at least 8 columns and 8 rows.
///
/// E(x, y) = A (x - xa) + B (y - ya), with A = yb - ya and B = xa - xb, is positive inside. A sample on the
/// edge, moved by (e, e^2), is inside if A > 0, or if A = 0 and B > 0; if it is not, E - 1 takes the place of
/// E. From centre to centre E grows by multiples of 2^16, so E >> 16, which has the sign of E, steps exactly
/// by A and B. A and B are below 2^20 and the samples are less than 2^5 pixels from a, so E >> 16 stays below
/// 2^26 and its sign is the top bit.
struct SmallTriangle {
  static constexpr int kColumns = 8, kRows = 4;
  /// True if the samples of such a box can be found so.
  [[nodiscard]] static bool fits(const SampleBox& box) {
    return box.right - box.left <= kColumns && box.bottom - box.top <= 2 * kRows;
  }
  [[nodiscard]] static bool fitsInto(int width, int height) {
    return width >= kColumns && height >= 2 * kRows;
  }
  // The block lies inside the picture. At its border it is moved inwards, and the triangle owns the same
  // samples.
  int rows, left, top;  ///< `rows` is kRows or twice that

  SmallTriangle(const glm::ivec3* p, const SampleBox& box, int width, int height)
      : rows{box.bottom - box.top <= kRows ? kRows : 2 * kRows},
        left{std::clamp(box.left, 0, width - kColumns)},
        top{std::clamp(box.top, 0, height - rows)} {
    for (int k = 0; k < 3; ++k) {
      const glm::ivec3 &a = p[k], &b = p[k == 2 ? 0 : k + 1];
      const int A = b.y - a.y, B = a.x - b.x;
      const std::int64_t E = std::int64_t{A} * (left * kGrid + kGrid / 2 - a.x) +
                             std::int64_t{B} * (top * kGrid + kGrid / 2 - a.y);
      const bool tieIsOut = (std::int64_t{A} << 32) + B <= 0;  // one test instead of three branches
      edge_[k] =
          eightFrom(static_cast<std::uint32_t>((E - tieIsOut) >> kGridBits), static_cast<std::uint32_t>(A));
      down_[k] = static_cast<std::uint32_t>(B);
    }
  }
  /// Numbers for the eight samples of the next row: the top bit is set for those that lie outside.
  [[nodiscard]] Eight nextRow() {
    const Eight outside = edge_[0] | edge_[1] | edge_[2];
    for (int k = 0; k < 3; ++k) edge_[k] += down_[k];
    return outside;
  }

 private:
  Eight edge_[3];
  std::uint32_t down_[3];
};

}  // namespace xnewell
