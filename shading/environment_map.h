#pragma once

#include <cstdint>

#include "shading/affine.h"
#include "shading/eight.h"
#include "shading/fill.h"

/// A map of 256 x 256 cells, looked up by the whole parts of two interpolated values: of intensities by
/// direction, or any texture whose coordinates are affine on the screen.
struct EnvironmentMap {
  AffineValue column, row;
  const std::uint8_t* map;  ///< 65,536 cells, row by row

  void span(std::uint8_t* cells, int i, int j, int count) const {
    const std::uint8_t* const cellAt = map;  // a copy: for all the compiler knows, a store may change members
    const auto place = [](std::uint32_t u, std::uint32_t v) { return (v >> 16 & 0xFF00) | u >> 24; };
    // Two sums of each value beside each other: one would wait for itself.
    const std::uint32_t du = column.gx, dv = row.gx;
    std::uint32_t u0 = column.at(i, j), v0 = row.at(i, j), u1 = u0 + du, v1 = v0 + dv;
    int k = 0;
    for (; k + 2 <= count; k += 2) {
      cells[k] = cellAt[place(u0, v0)];
      cells[k + 1] = cellAt[place(u1, v1)];
      u0 += 2 * du, v0 += 2 * dv, u1 += 2 * du, v1 += 2 * dv;
    }
    if (k < count) cells[k] = cellAt[place(u0, v0)];
  }

  [[nodiscard]] auto rowsOfEight(int i, int j) const {
    return [columns = EightOfRows{column, i, j}, rows = EightOfRows{row, i, j}, cells = map]() mutable {
      const EightWords u = upperHalves(columns.next()), v = upperHalves(rows.next());
      return lookUp(cells, (v & 0xFF00) | u >> 8);
    };
  }
};

/// Cells of `front` where a third value is at least 128, which stands for 0, and of `away` where it is less:
/// those samples face away. Only needed where the vertices of a triangle do not agree.
template <Shader Front, Shader Away>
struct EitherSide {
  Front front;
  Away away;
  AffineValue facing;

  void span(std::uint8_t* cells, int i, int j, int count) const {
    const auto faces = [&](int k) { return facing.at(i + k, j) >> 31 != 0; };
    const auto part = [&](int from, int to) {
      if (faces(from))
        front.span(cells + from, i + from, j, to - from);
      else
        away.span(cells + from, i + from, j, to - from);
    };
    if (faces(0) == faces(count - 1)) return part(0, count);
    // Between samples the value does not wrap, so it crosses 2^31 once: of a value that rises from v < 2^31,
    // at the first k with v + k step >= 2^31. One that falls does so upside down.
    const std::uint32_t first = facing.at(i, j), v = faces(0) ? ~first : first;
    const std::uint32_t step = faces(0) ? 0 - facing.gx : facing.gx;
    const int turn = static_cast<int>((0x7FFF'FFFF - v) / step) + 1;
    part(0, turn);
    part(turn, count);
  }

  [[nodiscard]] auto rowsOfEight(int i, int j) const {
    return [cells = front.rowsOfEight(i, j), others = away.rowsOfEight(i, j),
            rows = EightOfRows{facing, i, j}]() mutable {
      const std::uint64_t faces = negativeBytes(rows.next());
      return (cells() & faces) | (others() & ~faces);
    };
  }
};
