#pragma once

namespace xnewell {

/// The screen grid: x, y in 1/65536 pixel.
inline constexpr int kGridBits = 16;
inline constexpr int kGrid = 1 << kGridBits;
/// Pictures are at most this wide and high, and the guard band reaches as far from the origin: |x|, |y| <=
/// 2^29.
inline constexpr int kMaxPicture = 8192;

/// First row, or column, whose sample lies at or after a coordinate; so from an edge at `from` to one at `to`
/// own the samples sampleFrom(from)..sampleFrom(to) - 1.
[[nodiscard]] constexpr int sampleFrom(int coordinate) { return (coordinate + kGrid / 2 - 1) >> kGridBits; }

}  // namespace xnewell
