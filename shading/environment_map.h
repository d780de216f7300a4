#pragma once

#include <cstdint>

#include "shading/affine.h"
#include "shading/affine_lanes.h"
#include "shading/fill.h"

/// A picture of the light around, 256 x 256 cells, looked up by two interpolated values.
struct EnvironmentMap {
  AffineValue column, row;
  const std::uint8_t* map;  ///< 65,536 cells, row by row

  struct Eights {
    EightValues column, row;
    const std::uint8_t* map;
    std::uint64_t next() {
      const std::uint64_t cells = lookUp(map, (row.near >> 16 & 0xFF00) | column.near >> 24,
                                         (row.far >> 16 & 0xFF00) | column.far >> 24);
      column.nextRow();
      row.nextRow();
      return cells;
    }
  };
  [[nodiscard]] Eights eights(int i, int j) const {
    return {EightValues{column, i, j}, EightValues{row, i, j}, map};
  }

  void span(std::uint8_t* cells, int j, int from, int count) const {
    std::uint32_t u = column.at(from, j), v = row.at(from, j);
    for (int k = 0; k < count; ++k, u += column.gx, v += row.gx) cells[k] = map[(v >> 16 & 0xFF00) | u >> 24];
  }
};

/// Another shader's cells where a third value is at least 128, and one cell where it is less: the samples
/// that face away. Not needed for triangles whose three vertices agree.
template <Shader S>
struct DarkBehind {
  S front;
  AffineValue facing;
  std::uint8_t dark;

  struct Eights {
    decltype(std::declval<S>().eights(0, 0)) front;
    EightValues facing;
    std::uint64_t dark;
    std::uint64_t next() {
      const std::uint64_t faces =
          negativeBytes(reinterpret_cast<Four>(facing.near), reinterpret_cast<Four>(facing.far));
      const std::uint64_t cells = (front.next() & faces) | (dark & ~faces);
      facing.nextRow();
      return cells;
    }
  };
  [[nodiscard]] Eights eights(int i, int j) const {
    return {front.eights(i, j), EightValues{facing, i, j}, dark * 0x0101010101010101u};
  }

  void span(std::uint8_t* cells, int j, int from, int count) const {
    for (int k = 0; k < count; ++k)
      if (facing.at(from + k, j) >> 31 != 0)
        front.span(cells + k, j, from + k, 1);
      else
        cells[k] = dark;
  }
};
