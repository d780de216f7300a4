#pragma once

namespace xnewell {

/// The screen grid. x and y count in units of 1/65536 pixel.
inline constexpr int kGridBits = 16;
inline constexpr int kGrid = 1 << kGridBits;
/// The largest width and height of a picture. The guard band reaches as far from the origin, so |x|, |y| <=
/// 2^29.
inline constexpr int kMaxPicture = 8192;

/// The first row, or column, whose sample lies at or after a coordinate. An interval from `from` to `to`
/// contains the samples sampleFrom(from) to sampleFrom(to) - 1.
[[nodiscard]] constexpr int sampleFrom(int coordinate) { return (coordinate + kGrid / 2 - 1) >> kGridBits; }

}  // namespace xnewell
