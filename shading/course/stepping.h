#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace xnewell {

/// Values that are stepped over a triangle by additions, as the textbook teaches it: one increment from
/// pixel to pixel, another from row to row. They are whole numbers of steps of 2^-bits, so additions are
/// exact, and all error is in the rounding of the increments. It is written to be read. The filler has 24
/// bits (shading/fill/affine.h); tests hold it against this file, bit by bit.
/// @see Foley & van Dam 2e §3.6, §16.2.4 (Gouraud 1971)
struct SteppedPlane {
  int bits = 24;  ///< after the binary point
  /// At the centre of pixel (0, 0), and the two increments.
  std::int64_t c = 0, perColumn = 0, perRow = 0;

  /// The value at the centre of pixel (i, j), in steps.
  [[nodiscard]] std::int64_t at(int i, int j) const { return c + perColumn * i + perRow * j; }
  /// Steps as a number.
  [[nodiscard]] double number(std::int64_t steps) const {
    return static_cast<double>(steps) / static_cast<double>(std::int64_t{1} << bits);
  }
  bool operator==(const SteppedPlane&) const = default;
};

/// The plane through v[k] at vertex k. The filler steps places on a ramp of cells, 11.5 + 239 I (ramp.h).
/// Vertices are on the grid of 1/65536 pixel, |x|, |y| <= 2^29, and the triangle has an area; |v[k]| < 256; 0
/// <= bits <= 24. The values are rounded to steps, and the increments to steps a pixel, each to the nearest,
/// of two the even one. Where the values grow by more than 2^20 a pixel, the triangle is a sliver, and has
/// the mean everywhere.
[[nodiscard]] SteppedPlane steppedOver(const std::array<glm::ivec3, 3>& p, const std::array<double, 3>& v,
                                       int bits);

}  // namespace xnewell
