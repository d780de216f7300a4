#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "geometry/view/small_triangle.h"
#include "shading/fill/affine.h"

namespace xnewell {

// Instructions that compilers do not find by themselves are written out for SSE2, which every x86-64
// processor has.

using EightWords [[gnu::vector_size(16)]] = std::uint16_t;
using SixteenBytes [[gnu::vector_size(16)]] = std::uint8_t;

/// The upper half of each number.
[[nodiscard]] inline EightWords upperHalves(const Eight& eight) {
#ifdef __SSE2__
  const auto half = [](Eight::Four four) { return _mm_srai_epi32(reinterpret_cast<__m128i>(four), 16); };
  return reinterpret_cast<EightWords>(_mm_packs_epi32(half(eight.left), half(eight.right)));
#else
  EightWords words{};
  for (int k = 0; k < 4; ++k) {
    words[k] = static_cast<std::uint16_t>(eight.left[k] >> 16);
    words[4 + k] = static_cast<std::uint16_t>(eight.right[k] >> 16);
  }
  return words;
#endif
}

/// Each number, or 32,767 if it is larger. The numbers are below 2^31.
[[nodiscard]] inline EightWords packed(const Eight& eight) {
#ifdef __SSE2__
  return reinterpret_cast<EightWords>(
      _mm_packs_epi32(reinterpret_cast<__m128i>(eight.left), reinterpret_cast<__m128i>(eight.right)));
#else
  EightWords words{};
  for (int k = 0; k < 4; ++k) {
    words[k] = static_cast<std::uint16_t>(std::min(eight.left[k], 32767U));
    words[4 + k] = static_cast<std::uint16_t>(std::min(eight.right[k], 32767U));
  }
  return words;
#endif
}

/// Each number, or 255 if it is larger. The numbers are below 2^15.
[[nodiscard]] inline SixteenBytes packed(EightWords left, EightWords right) {
#ifdef __SSE2__
  return reinterpret_cast<SixteenBytes>(
      _mm_packus_epi16(reinterpret_cast<__m128i>(left), reinterpret_cast<__m128i>(right)));
#else
  SixteenBytes bytes{};
  for (int k = 0; k < 8; ++k) {
    bytes[k] = static_cast<std::uint8_t>(std::min<int>(left[k], 255));
    bytes[8 + k] = static_cast<std::uint8_t>(std::min<int>(right[k], 255));
  }
  return bytes;
#endif
}

/// The uppermost byte of each number.
[[nodiscard]] inline SixteenBytes topBytes(const Eight& left, const Eight& right) {
  const auto words = [](const Eight& eight) { return packed({eight.left >> 24, eight.right >> 24}); };
  return packed(words(left), words(right));
}

/// The same for eight numbers. From here on, eight bytes in the order of memory are one number.
[[nodiscard]] inline std::uint64_t topBytes(const Eight& eight) {
  return std::bit_cast<std::array<std::uint64_t, 2>>(topBytes(eight, eight))[0];
}

/// 0xFF for each number whose top bit is set, so that it is negative if signed; 0 for the others.
[[nodiscard]] inline std::uint64_t negativeBytes(const Eight& eight) {
#ifdef __SSE2__
  const __m128i signs = _mm_srai_epi16(
      _mm_packs_epi32(reinterpret_cast<__m128i>(eight.left), reinterpret_cast<__m128i>(eight.right)), 15);
  return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_packs_epi16(signs, signs)));
#else
  return (topBytes(eight) >> 7 & 0x0101010101010101u) * 0xFF;
#endif
}

/// The bytes of a table at eight indices.
[[nodiscard]] inline std::uint64_t lookUp(const std::uint8_t* table, EightWords at) {
  const auto words = std::bit_cast<std::array<std::uint16_t, 8>>(at);
  std::array<std::uint8_t, 8> bytes{};
  for (int k = 0; k < 8; ++k) bytes[k] = table[words[k]];
  return std::bit_cast<std::uint64_t>(bytes);
}

/// A value at eight pixels of a row, then at those of the row below, and so on.
struct EightOfRows {
  Eight row;
  std::uint32_t gy;

  EightOfRows(const AffineValue& value, int i, int j)
      : row{eightFrom(value.at(i, j), value.gx)}, gy{value.gy} {}
  Eight next() {
    const Eight eight = row;
    row += gy;
    return eight;
  }
};

}  // namespace xnewell
