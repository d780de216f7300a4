#pragma once

#include <cstdint>
#include <cstring>

#include "shading/fill/affine.h"
#include "shading/fill/cells_by_key.h"
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

/// The value's steps are the keys of the cells, for a table that is not even: one that is corrected for the
/// eye.
struct GouraudTable {
  AffineValue value;
  const CellsByKey* cellsOf;

  void span(std::uint8_t* cells, int i, int j, int count) const {
    const CellsByKey::Entries words{*cellsOf};
    const std::uint32_t gx = value.gx, first = value.at(i, j);
    const auto from = [&](std::uint32_t v) {
      Eight keys = eightFrom(0, gx);  // the same for each span
      keys += v;
      return keys;
    };
    const auto eight = [&](std::uint32_t v, const Eight& keys) {
      const EightWords here = words(v, gx, keys);
      return packed(here, here);
    };
    if (count < 8) {
      storeSpan(cells, eight(first, from(first)), count);
    } else {
      const auto store = [&](std::uint8_t* to, SixteenBytes bytes) {
        std::memcpy(to, &bytes, sizeof bytes / 2);
      };
      std::uint32_t v = first;
      Eight keys = from(v);
      for (int k = 0; k + 8 < count; k += 8, v += 8 * gx, keys += 8 * gx) store(cells + k, eight(v, keys));
      // The last eight cells end with the span.
      const std::uint32_t last = first + static_cast<std::uint32_t>(count - 8) * gx;
      store(cells + count - 8, eight(last, from(last)));
    }
    cellsOf->search(cells, count, first, gx);
  }

  [[nodiscard]] auto rowsOfEight(int i, int j) const {
    return [rows = EightOfRows{value, i, j}, words = CellsByKey::Entries{*cellsOf}, v = value.at(i, j),
            gx = value.gx, by = cellsOf](std::uint64_t) mutable {
      const EightWords here = words(v, gx, rows.next());
      auto cells = std::bit_cast<std::array<std::uint8_t, 16>>(packed(here, here));
      by->search(cells.data(), 8, v, gx);
      v += rows.gy;
      return std::bit_cast<std::array<std::uint64_t, 2>>(cells)[0];
    };
  }
};

}  // namespace xnewell
