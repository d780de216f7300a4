#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <array>
#include <bit>
#include <cstdint>

/// Four numbers at once, by GCC's and Clang's vector extension: any processor has them. What compilers do not
/// find by themselves is written out for SSE2, which every x86-64 processor has.
using Four [[gnu::vector_size(16)]] = int;
using FourModular [[gnu::vector_size(16)]] = std::uint32_t;  ///< modulo 2^32

/// Eight bytes, in order of memory: of each number 0xFF if it is negative, else 0.
inline std::uint64_t negativeBytes(Four left, Four right) {
#ifdef __SSE2__
  const __m128i signs =
      _mm_srai_epi16(_mm_packs_epi32(reinterpret_cast<__m128i>(left), reinterpret_cast<__m128i>(right)), 15);
  return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_packs_epi16(signs, signs)));
#else
  std::array<std::uint8_t, 8> bytes{};
  for (int i = 0; i < 4; ++i) {
    bytes[i] = left[i] < 0 ? 0xFF : 0;
    bytes[4 + i] = right[i] < 0 ? 0xFF : 0;
  }
  return std::bit_cast<std::uint64_t>(bytes);
#endif
}

/// Eight bytes, in order of memory: of each number the uppermost.
inline std::uint64_t topBytes(FourModular left, FourModular right) {
#ifdef __SSE2__
  const __m128i words =
      _mm_packs_epi32(reinterpret_cast<__m128i>(left >> 24), reinterpret_cast<__m128i>(right >> 24));
  return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_packus_epi16(words, words)));
#else
  std::array<std::uint8_t, 8> bytes{};
  for (int i = 0; i < 4; ++i) {
    bytes[i] = static_cast<std::uint8_t>(left[i] >> 24);
    bytes[4 + i] = static_cast<std::uint8_t>(right[i] >> 24);
  }
  return std::bit_cast<std::uint64_t>(bytes);
#endif
}

/// Eight words: of each number the upper half.
inline std::array<std::uint16_t, 8> upperHalves(FourModular left, FourModular right) {
#ifdef __SSE2__
  return std::bit_cast<std::array<std::uint16_t, 8>>(
      _mm_packs_epi32(_mm_srai_epi32(reinterpret_cast<__m128i>(left), 16),
                      _mm_srai_epi32(reinterpret_cast<__m128i>(right), 16)));
#else
  std::array<std::uint16_t, 8> words{};
  for (int i = 0; i < 4; ++i) {
    words[i] = static_cast<std::uint16_t>(left[i] >> 16);
    words[4 + i] = static_cast<std::uint16_t>(right[i] >> 16);
  }
  return words;
#endif
}
