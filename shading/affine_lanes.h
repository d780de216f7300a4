#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "shading/affine.h"
#include "shading/four.h"

/// A value at eight pixels of a row, row after row or along the row.
struct EightValues {
  FourModular near, far;  ///< columns 0 to 3, 4 to 7

  EightValues(const AffineValue& value, int i, int j) {
    const std::uint32_t first = value.at(i, j), gx = value.gx;
    near = FourModular{first, first + gx, first + 2 * gx, first + 3 * gx};
    far = near + 4 * gx;
  }
  void operator+=(std::uint32_t step) { near += step, far += step; }
};

/// Sixteen bytes, of each value the uppermost.
inline void storeTopBytes(std::uint8_t* to, const EightValues& left, const EightValues& right) {
#ifdef __SSE2__
  const auto words = [](const EightValues& v) {
    return _mm_packs_epi32(reinterpret_cast<__m128i>(v.near >> 24), reinterpret_cast<__m128i>(v.far >> 24));
  };
  const __m128i bytes = _mm_packus_epi16(words(left), words(right));
  std::memcpy(to, &bytes, sizeof bytes);
#else
  const std::array<std::uint64_t, 2> bytes{topBytes(left.near, left.far), topBytes(right.near, right.far)};
  std::memcpy(to, &bytes, sizeof bytes);
#endif
}

/// Eight bytes of a table, in order of memory.
inline std::uint64_t lookUp(const std::uint8_t* table, FourModular near, FourModular far) {
  std::array<std::uint8_t, 8> bytes;
  for (int k = 0; k < 4; ++k) {
    bytes[k] = table[near[k]];
    bytes[4 + k] = table[far[k]];
  }
  return std::bit_cast<std::uint64_t>(bytes);
}

/// cells[0..count-1] = bytes[0..count-1], 1 <= count <= 16, without a loop: stores overlap.
inline void storeUpTo16(std::uint8_t* cells, const std::array<std::uint8_t, 16>& bytes, int count) {
  const auto copy = [&]<class Word>(int at, Word word) {
    std::memcpy(&word, bytes.data() + at, sizeof word);
    std::memcpy(cells + at, &word, sizeof word);
  };
  if (count >= 8) {
    copy(0, std::uint64_t{}), copy(count - 8, std::uint64_t{});
  } else if (count >= 4) {
    copy(0, std::uint32_t{}), copy(count - 4, std::uint32_t{});
  } else {
    cells[0] = bytes[0], cells[count / 2] = bytes[count / 2], cells[count - 1] = bytes[count - 1];
  }
}
