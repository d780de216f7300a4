#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "shading/fill/affine.h"
#include "shading/fill/eight.h"
#include "shading/fill/fill.h"
#include "shading/light/illumination.h"

namespace xnewell {

/// A map of 256 x 256 cells. The whole parts of two interpolated values say where to look. The map holds
/// intensities by direction, or any texture whose coordinates are affine on the screen. A value that is
/// rounded to steps of 2^-24 may be looked up beside its place if it is that near to it.
struct EnvironmentMap {
  AffineValue column, row;
  const std::uint8_t* map;  ///< 65,536 cells, row by row

  void span(std::uint8_t* cells, int i, int j, int count) const {
    const std::uint8_t* const cellAt = map;  // a copy: the compiler must assume that a store changes members
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
    return [columns = EightOfRows{column, i, j}, rows = EightOfRows{row, i, j}, cells = map](
               std::uint64_t) mutable { return lookUp(cells, places(columns.next(), rows.next())); };
  }

 private:
  static EightWords places(const Eight& u, const Eight& v) {
    return (upperHalves(v) & 0xFF00) | upperHalves(u) >> 8;
  }
};

/// The cells of `shown`, whose maps hold `mark` at some places. It puts `cell` in the place of `mark` and
/// adds their number to `count`.
template <class S>
struct Counted {
  S shown;
  std::uint8_t mark, cell;
  std::int64_t* count;

  void span(std::uint8_t* cells, int i, int j, int length) const {
    shown.span(cells, i, j, length);
    int marks = 0;
    for (int k = 0; k < length; ++k) {
      const bool marked = cells[k] == mark;
      marks += marked;
      cells[k] = marked ? cell : cells[k];
    }
    *count += marks;
  }

  [[nodiscard]] auto rowsOfEight(int i, int j) const {
    return [of = *this, rows = shown.rowsOfEight(i, j)](std::uint64_t owned) mutable {
      const std::uint64_t cells = rows(owned);
      const auto bytes = std::bit_cast<SixteenBytes>(std::array{cells, cells});
      const std::uint64_t marked = std::bit_cast<std::array<std::uint64_t, 2>>(bytes == of.mark)[0];
      *of.count += std::popcount(marked & owned) / 8;
      return (cells & ~marked) | (marked & of.cell * 0x0101010101010101u);
    };
  }
};
template <class S>
Counted(S, std::uint8_t, std::uint8_t, std::int64_t*) -> Counted<S>;  // for Clang before 17

/// The columns and rows of a map in which a mark occurs. If there is none, nothing meets the box.
struct MapBox {
  int left = 256, right = -1, top = 256, bottom = -1;  ///< all of them inside

  /// `cells` are 65,536 or none.
  MapBox(std::span<const std::uint8_t> cells, std::uint8_t mark) {
    for (int k = 0; k < static_cast<int>(cells.size()); ++k)
      if (cells[k] == mark) {
        left = std::min(left, k % 256), right = std::max(right, k % 256);
        top = std::min(top, k / 256), bottom = std::max(bottom, k / 256);
      }
  }

  /// Whether a triangle with these values at its vertices, in steps, may have a sample in the box. affine.h
  /// says how far the value of a sample can lie beyond them.
  [[nodiscard]] bool meets(const std::array<std::uint32_t, 3>& column,
                           const std::array<std::uint32_t, 3>& row) const {
    constexpr std::uint32_t kBeyond = 1U << (24 - 9);
    const auto overlap = [](const std::array<std::uint32_t, 3>& v, int first, int last) {
      const auto [least, most] = std::ranges::minmax(v);
      return static_cast<int>((least - kBeyond) >> 24) <= last &&
             static_cast<int>((most + kBeyond) >> 24) >= first;
    };
    return overlap(column, left, right) && overlap(row, top, bottom);
  }
};

/// The cells of `front` where a third value is at least 128, which stands for 0, and those of `away` where it
/// is less: there the surface faces away. It is needed only for a triangle whose vertices differ in this.
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
    // The value does not wrap between samples, so it crosses 2^31 once. A value that rises from v < 2^31
    // crosses at the first k with v + k step >= 2^31. A falling value is turned upside down.
    const std::uint32_t first = facing.at(i, j), v = faces(0) ? ~first : first;
    const std::uint32_t step = faces(0) ? 0 - facing.gx : facing.gx;
    const int turn = static_cast<int>((0x7FFF'FFFF - v) / step) + 1;
    part(0, turn);
    part(turn, count);
  }

  [[nodiscard]] auto rowsOfEight(int i, int j) const {
    return [cells = front.rowsOfEight(i, j), others = away.rowsOfEight(i, j),
            rows = EightOfRows{facing, i, j}](std::uint64_t owned) mutable {
      const std::uint64_t faces = negativeBytes(rows.next());
      return (cells(owned & faces) & faces) | (others(owned & ~faces) & ~faces);
    };
  }
};
template <class Front, class Away>
EitherSide(Front, Away, AffineValue) -> EitherSide<Front, Away>;  // for Clang before 17

/// Phong shading by a look-up. A map of 256 x 256 places holds what a surface reflects for each direction of
/// its normal. Two components of the interpolated normal say where to look. The light is infinitely far away:
/// L and fatt are those at the scene's centre. The specular term is cos^n of the angle between N and L.

enum class EnvironmentForm { Rotated, Published };
struct EnvironmentRow {
  EnvironmentForm id;
  std::string_view name, looksUp;
};
inline constexpr std::array kEnvironmentForms{
    EnvironmentRow{EnvironmentForm::Rotated, "rotated",
                   "x and y of N turned so that L is (0, 0, 1), and the sign of its z: exact"},
    EnvironmentRow{EnvironmentForm::Published, "published",
                   "Lx - Nx and Ly - Ny as seen: exact for a light on the view axis"},
};

/// kMapCentre + kMapScale c, for a component c of a unit normal in [-1, 1]: the whole part is the column or
/// the row of the map.
inline constexpr double kMapScale = 127.0, kMapCentre = 128.0;

/// The intensities that one surface reflects, in one channel. An intensity above 1 is clamped when it is
/// shown.
struct Environment {
  glm::dmat3 frame{1.0};           ///< from the world to the axes in which x and y are looked up
  bool twoMaps = false;            ///< whether normals with z < 0 have a map of their own
  std::vector<float> front, away;  ///< 65,536 each, row by row; `away` is empty unless twoMaps
};

/// With one light, a place of `rotated` whose x and y lie within the unit circle is off by at most 2^-24 +
/// n 2^-43: it is stored as a float, and near the rim z has few digits.
/// `viewFrame` is the rotation from the world to the eye's axes: x to the right, y up, z towards the viewer.
[[nodiscard]] Environment makeEnvironment(EnvironmentForm form, const Lighting& lighting,
                                          const Material& material, int channel, const glm::dmat3& viewFrame,
                                          const glm::dvec3& centre);

}  // namespace xnewell
