#pragma once

#include <cstdint>

#include "shading/affine.h"
#include "shading/affine_lanes.h"

/// Intensity interpolated over a triangle. @see Gouraud 1971; Foley & van Dam 2e §16.2.4

/// The cell is the value's whole part: on a linear ramp of N cells from `first` on, the caller interpolates
/// first + 1/2 + (N - 1) I.
struct GouraudLinear {
  AffineValue value;

  struct Eights {
    EightValues value;
    std::uint32_t gy;
    std::uint64_t next() {
      const std::uint64_t cells = topBytes(value.near, value.far);
      value += gy;
      return cells;
    }
  };
  [[nodiscard]] Eights eights(int i, int j) const { return {EightValues{value, i, j}, value.gy}; }

  void span(std::uint8_t* cells, int row, int from, int count) const {
    const std::uint32_t gx = value.gx;
    EightValues left{value, from, row}, right = left;
    right += 8 * gx;
    if (count < 16) {
      std::array<std::uint8_t, 16> some;
      storeTopBytes(some.data(), left, right);
      return storeUpTo16(cells, some, count);
    }
    int k = 0;
    for (; k + 16 < count; k += 16) {
      storeTopBytes(cells + k, left, right);
      left += 16 * gx, right += 16 * gx;
    }
    // The last sixteen end with the span.
    const std::uint32_t back = static_cast<std::uint32_t>(count - 16 - k) * gx;
    left += back, right += back;
    storeTopBytes(cells + count - 16, left, right);
  }
};

/// The cell is looked up by the value's upper 16 bits: any table of intensities.
struct GouraudTable {
  AffineValue value;
  const std::uint8_t* table;  ///< 65,536 cells

  struct Eights {
    EightValues value;
    std::uint32_t gy;
    const std::uint8_t* table;
    std::uint64_t next() {
      const std::uint64_t cells = lookUp(table, value.near >> 16, value.far >> 16);
      value += gy;
      return cells;
    }
  };
  [[nodiscard]] Eights eights(int i, int j) const { return {EightValues{value, i, j}, value.gy, table}; }

  void span(std::uint8_t* cells, int row, int from, int count) const {
    // Four sums at once: each waits for the one before it.
    const std::uint8_t* const cellOf = table;  // a copy: for all the compiler knows, stores change members
    const std::uint32_t step = 4 * value.gx;
    std::uint32_t v0 = value.at(from, row), v1 = v0 + value.gx, v2 = v1 + value.gx, v3 = v2 + value.gx;
    int k = 0;
    for (; k + 4 <= count; k += 4, v0 += step, v1 += step, v2 += step, v3 += step) {
      cells[k] = cellOf[v0 >> 16];
      cells[k + 1] = cellOf[v1 >> 16];
      cells[k + 2] = cellOf[v2 >> 16];
      cells[k + 3] = cellOf[v3 >> 16];
    }
    if (k < count) cells[k] = cellOf[v0 >> 16];
    if (k + 1 < count) cells[k + 1] = cellOf[v1 >> 16];
    if (k + 2 < count) cells[k + 2] = cellOf[v2 >> 16];
  }
};
