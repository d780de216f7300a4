#pragma once

#include <cstdint>
#include <cstring>

#include "shading/fill/affine.h"
#include "shading/fill/eight.h"
#include "shading/fill/fill.h"

namespace xnewell {

/// Intensities interpolated over a triangle, as cells of a colour table. @see Gouraud 1971

/// The cell is the value's whole part. The value is that of ramp.h, without a table: first + 1/2 + (N - 1) I
/// on a ramp of N cells from `first` on.
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
    // The last sixteen cells end with the span.
    const std::uint32_t back = static_cast<std::uint32_t>(count - 16 - k) * gx;
    left += back, right += back;
    store(cells + count - 16);
  }

  [[nodiscard]] auto rowsOfEight(int i, int j) const {
    return [rows = EightOfRows{value, i, j}](std::uint64_t) mutable { return topBytes(rows.next()); };
  }
};

/// The upper 16 bits of the value are an index into a table of cells, for a ramp that is not linear: one that
/// is corrected for the eye.
struct GouraudTable {
  AffineValue value;
  const std::uint8_t* table;  ///< 65,536 cells; values are below 255.992, so the last one is never read

  void span(std::uint8_t* cells, int i, int j, int count) const {
    const std::uint8_t* const cellAt =
        table;  // a copy: the compiler must assume that a store changes members
    // The value is in the upper half of 64 bits, so one shift gives the index. Each sum waits for at most
    // three others.
    const std::uint64_t g = std::uint64_t{value.gx} << 32;
    std::uint64_t v = std::uint64_t{value.at(i, j)} << 32;
    if (count < 8) {
      for (int k = 0; k < count; ++k, v += g) cells[k] = cellAt[v >> 48];
      return;
    }
    const auto eight = [&](std::uint8_t* to) {
      const std::uint64_t w = v + 4 * g;
      const auto at = [&](std::uint64_t from, std::uint64_t k) { return cellAt + ((from + k * g) >> 48); };
      const std::uint64_t bytes =
          gathered({at(v, 0), at(v, 1), at(v, 2), at(v, 3), at(w, 0), at(w, 1), at(w, 2), at(w, 3)});
      std::memcpy(to, &bytes, sizeof bytes);
    };
    int k = 0;
    for (; k + 8 < count; k += 8, v += 8 * g) eight(cells + k);
    // The last eight cells end with the span.
    v += g * static_cast<std::uint64_t>(count - 8 - k);
    eight(cells + count - 8);
  }

  [[nodiscard]] auto rowsOfEight(int i, int j) const {
    return [rows = EightOfRows{value, i, j}, cells = table](std::uint64_t) mutable {
      return lookUp(cells, upperHalves(rows.next()));
    };
  }
};

}  // namespace xnewell
