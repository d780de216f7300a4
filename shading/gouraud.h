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
    return [rows = EightOfRows{value, i, j}](std::uint64_t) mutable { return topBytes(rows.next()); };
  }
};

/// The cell is looked up by the upper 16 bits of the value: in a table that is not linear, such as one
/// corrected for the eye.
struct GouraudTable {
  AffineValue value;
  const std::uint8_t* table;  ///< 65,536 cells; values below 255.992 never ask for the last one

  void span(std::uint8_t* cells, int i, int j, int count) const {
    const std::uint8_t* const cellAt =
        table;  // a copy: for all the compiler knows, a store may change members
    // In the upper half of 64 bits, from where one shift makes the place; four sums beside each other, for
    // one would wait for itself.
    const std::uint64_t g = std::uint64_t{value.gx} << 32;
    std::uint64_t v = std::uint64_t{value.at(i, j)} << 32;
    if (count < 8) {
      for (int k = 0; k < count; ++k, v += g) cells[k] = cellAt[v >> 48];
      return;
    }
    std::uint64_t v1 = v + g, v2 = v1 + g, v3 = v2 + g;
    const auto eight = [&](std::uint8_t* to) {
      const std::uint64_t w = v + 4 * g, w1 = v1 + 4 * g, w2 = v2 + 4 * g, w3 = v3 + 4 * g;
      const std::uint64_t bytes =
          gathered({cellAt + (v >> 48), cellAt + (v1 >> 48), cellAt + (v2 >> 48), cellAt + (v3 >> 48),
                    cellAt + (w >> 48), cellAt + (w1 >> 48), cellAt + (w2 >> 48), cellAt + (w3 >> 48)});
      std::memcpy(to, &bytes, sizeof bytes);
    };
    const auto step = [&](std::uint64_t by) { v += by, v1 += by, v2 += by, v3 += by; };
    int k = 0;
    for (; k + 8 < count; k += 8, step(8 * g)) eight(cells + k);
    // The last eight end with the span.
    step(g * static_cast<std::uint64_t>(count - 8 - k));
    eight(cells + count - 8);
  }

  [[nodiscard]] auto rowsOfEight(int i, int j) const {
    return [rows = EightOfRows{value, i, j}, cells = table](std::uint64_t) mutable {
      return lookUp(cells, upperHalves(rows.next()));
    };
  }
};
