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
    std::uint32_t columnStep, rowStep;
    const std::uint8_t* map;
    std::uint64_t next() {
      const std::uint64_t cells = lookUp(map, (row.near >> 16 & 0xFF00) | column.near >> 24,
                                         (row.far >> 16 & 0xFF00) | column.far >> 24);
      column += columnStep, row += rowStep;
      return cells;
    }
  };
  [[nodiscard]] Eights eights(int i, int j) const {
    return {EightValues{column, i, j}, EightValues{row, i, j}, column.gy, row.gy, map};
  }

  [[nodiscard]] static std::uint32_t indexOf(std::uint32_t u, std::uint32_t v) {
    return (v >> 16 & 0xFF00) | u >> 24;
  }
  void span(std::uint8_t* cells, int j, int from, int count) const {
    const std::uint8_t* const cellOf = map;
    std::uint32_t u0 = column.at(from, j), u1 = u0 + column.gx, v0 = row.at(from, j), v1 = v0 + row.gx;
    const std::uint32_t uStep = 2 * column.gx, vStep = 2 * row.gx;
    int k = 0;
    for (; k + 2 <= count; k += 2, u0 += uStep, u1 += uStep, v0 += vStep, v1 += vStep) {
      cells[k] = cellOf[indexOf(u0, v0)];
      cells[k + 1] = cellOf[indexOf(u1, v1)];
    }
    if (k < count) cells[k] = cellOf[indexOf(u0, v0)];
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
    std::uint32_t step;
    std::uint64_t dark;
    std::uint64_t next() {
      const std::uint64_t faces =
          negativeBytes(reinterpret_cast<Four>(facing.near), reinterpret_cast<Four>(facing.far));
      const std::uint64_t cells = (front.next() & faces) | (dark & ~faces);
      facing += step;
      return cells;
    }
  };
  [[nodiscard]] Eights eights(int i, int j) const {
    return {front.eights(i, j), EightValues{facing, i, j}, facing.gy, dark * 0x0101010101010101u};
  }

  void span(std::uint8_t* cells, int j, int from, int count) const {
    const std::uint32_t first = facing.at(from, j), last = facing.at(from + count - 1, j);
    const bool starts = first >> 31 != 0, ends = last >> 31 != 0;
    int turn = count;
    if (starts != ends) {
      // Of a value that rises from below 2^31; one that falls does so upside down.
      const std::uint32_t v = starts ? ~first : first, step = starts ? 0 - facing.gx : facing.gx;
      turn = static_cast<int>((0x7FFF'FFFF - v) / step) + 1;
    }
    const auto part = [&](bool faces, int k, int n) {
      if (faces)
        front.span(cells + k, j, from + k, n);
      else
        fillSpan(cells + k, n, dark);
    };
    part(starts, 0, turn);
    if (turn < count) part(ends, turn, count - turn);
  }
};
