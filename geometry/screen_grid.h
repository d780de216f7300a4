#pragma once

/// The screen grid: x, y in 1/65536 pixel.
inline constexpr int kGridBits = 16;
inline constexpr int kGrid = 1 << kGridBits;
/// Pictures are at most this wide and high, and the guard band reaches as far from the origin: |x|, |y| <=
/// 2^29.
inline constexpr int kMaxPicture = 8192;
