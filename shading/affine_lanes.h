#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "shading/affine.h"
#include "shading/four.h"

/// A value at eight pixels of a row, row after row.
struct EightValues {
  FourModular near, far;  ///< columns 0 to 3, 4 to 7
  std::uint32_t gy;

  EightValues(const AffineValue& value, int i, int j) : gy{value.gy} {
    const std::uint32_t first = value.at(i, j), gx = value.gx;
    near = FourModular{first, first + gx, first + 2 * gx, first + 3 * gx};
    far = near + 4 * gx;
  }
  void nextRow() { near += gy, far += gy; }
};

/// Eight bytes of a table, in order of memory.
inline std::uint64_t lookUp(const std::uint8_t* table, FourModular near, FourModular far) {
  std::array<std::uint8_t, 8> bytes;
  for (int k = 0; k < 4; ++k) {
    bytes[k] = table[near[k]];
    bytes[4 + k] = table[far[k]];
  }
  return std::bit_cast<std::uint64_t>(bytes);
}
