#pragma once

#include <array>
#include <bit>
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
    const std::uint32_t du = 8 * column.gx, dv = 8 * row.gx;
    Eight u = eightFrom(column.at(i, j), column.gx), v = eightFrom(row.at(i, j), row.gx);
    int k = 0;
    for (; k + 8 <= count; k += 8, u += du, v += dv) {
      const auto at = std::bit_cast<std::array<std::uint16_t, 8>>(places(u, v));
      for (int n = 0; n < 8; ++n) cells[k + n] = cellAt[at[n]];
    }
    if (k == count) return;
    const auto at = std::bit_cast<std::array<std::uint16_t, 8>>(places(u, v));
    for (int n = 0; k < count; ++k, ++n) cells[k] = cellAt[at[n]];
  }

  [[nodiscard]] auto rowsOfEight(int i, int j) const {
    return [columns = EightOfRows{column, i, j}, rows = EightOfRows{row, i, j}, cells = map]() mutable {
      return lookUp(cells, places(columns.next(), rows.next()));
    };
  }

 private:
  static EightWords places(const Eight& u, const Eight& v) {
    return (upperHalves(v) & 0xFF00) | upperHalves(u) >> 8;
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
