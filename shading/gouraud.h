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
    std::uint64_t next() {
      const std::uint64_t cells = topBytes(value.near, value.far);
      value.nextRow();
      return cells;
    }
  };
  [[nodiscard]] Eights eights(int i, int j) const { return {EightValues{value, i, j}}; }

  void span(std::uint8_t* cells, int row, int from, int count) const {
    std::uint32_t v = value.at(from, row);
    for (int k = 0; k < count; ++k, v += value.gx) cells[k] = static_cast<std::uint8_t>(v >> 24);
  }
};

/// The cell is looked up by the value's upper 16 bits: any table of intensities.
struct GouraudTable {
  AffineValue value;
  const std::uint8_t* table;  ///< 65,536 cells

  struct Eights {
    EightValues value;
    const std::uint8_t* table;
    std::uint64_t next() {
      const std::uint64_t cells = lookUp(table, value.near >> 16, value.far >> 16);
      value.nextRow();
      return cells;
    }
  };
  [[nodiscard]] Eights eights(int i, int j) const { return {EightValues{value, i, j}, table}; }

  void span(std::uint8_t* cells, int row, int from, int count) const {
    std::uint32_t v = value.at(from, row);
    for (int k = 0; k < count; ++k, v += value.gx) cells[k] = table[v >> 16];
  }
};
