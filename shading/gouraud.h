#pragma once

#include <cstdint>
#include <cstring>

#include "shading/affine.h"
#include "shading/eight.h"
#include "shading/fill.h"

/// Intensity interpolated over a triangle, for cells of a colour table. @see Gouraud 1971

/// The cell is the value's whole part: on a linear ramp of N cells from `first` on, interpolate
/// first + 1/2 + (N - 1) I.
struct GouraudLinear {
  AffineValue value;

  void span(std::uint8_t* cells, int i, int j, int count) const {
    const std::uint32_t gx = value.gx;
    Eight left = eightFrom(value.at(i, j), gx), right = left;
    right += 8 * gx;
    if (count <= 16) return storeSpan(cells, topBytes(left, right), count);

    const auto store = [&](std::uint8_t* to) {
      const SixteenBytes bytes = topBytes(left, right);
      std::memcpy(to, &bytes, sizeof bytes);
    };
    int k = 0;
    for (; k + 16 < count; k += 16) {
      store(cells + k);
      left += 16 * gx, right += 16 * gx;
    }
    // The last sixteen end with the span.
    const std::uint32_t back = static_cast<std::uint32_t>(count - 16 - k) * gx;
    left += back, right += back;
    store(cells + count - 16);
  }

  [[nodiscard]] auto rowsOfEight(int i, int j) const {
    return [rows = EightOfRows{value, i, j}]() mutable { return topBytes(rows.next()); };
  }
};

/// The cell is looked up by the upper 16 bits of the value: in a table that is not linear, such as one
/// corrected for the eye.
struct GouraudTable {
  AffineValue value;
  const std::uint8_t* table;  ///< 65,536 cells

  void span(std::uint8_t* cells, int i, int j, int count) const {
    const std::uint8_t* const cellAt =
        table;  // a copy: for all the compiler knows, a store may change members
    // Four sums beside each other: one would wait for itself.
    const std::uint32_t gx = value.gx;
    std::uint32_t v0 = value.at(i, j), v1 = v0 + gx, v2 = v1 + gx, v3 = v2 + gx;
    int k = 0;
    for (; k + 4 <= count; k += 4) {
      cells[k] = cellAt[v0 >> 16];
      cells[k + 1] = cellAt[v1 >> 16];
      cells[k + 2] = cellAt[v2 >> 16];
      cells[k + 3] = cellAt[v3 >> 16];
      v0 += 4 * gx, v1 += 4 * gx, v2 += 4 * gx, v3 += 4 * gx;
    }
    for (; k < count; ++k, v0 += gx) cells[k] = cellAt[v0 >> 16];
  }

  [[nodiscard]] auto rowsOfEight(int i, int j) const {
    return [rows = EightOfRows{value, i, j}, cells = table]() mutable {
      return lookUp(cells, upperHalves(rows.next()));
    };
  }
};
