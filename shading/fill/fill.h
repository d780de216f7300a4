#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <cstring>

#include "shading/color/index_image.h"
#include "shading/fill/eight.h"
#include "shading/fill/scanline.h"

namespace xnewell {

/// Fills convex outlines by the sample rule of scanline.h, with the cells that a shader gives to the samples.

/// A shader gives cells to a fill: FlatCell below, and those of gouraud.h and environment_map.h.
template <class S>
concept Shader = requires(const S& shader, std::uint8_t* cells, int i, int j, int count) {
  /// Stores the cells of pixels (i, j) to (i + count - 1, j), count >= 1. The outline owns all their samples.
  shader.span(cells, i, j, count);
  /// For triangles of a few pixels. It returns a function. Each call of that function gives eight cells, as
  /// eight bytes in the order of memory: first those of the eight pixels from (i, j) on, then those of the
  /// row below, and so on. Its argument has 0xFF in the bytes of the samples that the outline owns, 0 in the
  /// others.
  { shader.rowsOfEight(i, j)(std::uint64_t{}) } -> std::same_as<std::uint64_t>;
};

/// cells[0..count-1] = cell, count >= 1. Most spans are short, and memset would cost a call.
inline void fillSpan(std::uint8_t* cells, int count, std::uint8_t cell) {
  const std::uint64_t eight = cell * 0x0101010101010101u;
  const auto store = [&]<class Word>(int at, Word word) { std::memcpy(cells + at, &word, sizeof word); };
  if (count > 32) {
    std::memset(cells, cell, static_cast<std::size_t>(count));
  } else if (count >= 16) {
    store(0, eight), store(8, eight);
    store(count - 16, eight), store(count - 8, eight);
  } else if (count >= 8) {
    store(0, eight), store(count - 8, eight);
  } else if (count >= 4) {
    const auto four = static_cast<std::uint32_t>(eight);
    store(0, four), store(count - 4, four);
  } else {
    cells[0] = cells[count / 2] = cells[count - 1] = cell;
  }
}

/// cells[0..count-1] = bytes[0..count-1], 1 <= count <= 16, by stores that overlap.
inline void storeSpan(std::uint8_t* cells, SixteenBytes bytes, int count) {
  const auto copy = [&]<class Word>(int at, Word word) {
    std::memcpy(&word, reinterpret_cast<const std::uint8_t*>(&bytes) + at, sizeof word);
    std::memcpy(cells + at, &word, sizeof word);
  };
  if (count >= 8) {
    copy(0, std::uint64_t{}), copy(count - 8, std::uint64_t{});
  } else if (count >= 4) {
    copy(0, std::uint32_t{}), copy(count - 4, std::uint32_t{});
  } else {
    cells[0] = bytes[0], cells[count / 2] = bytes[count / 2], cells[count - 1] = bytes[count - 1];
  }
}

/// One cell for all samples.
struct FlatCell {
  std::uint8_t cell;

  void span(std::uint8_t* cells, int, int, int count) const { fillSpan(cells, count, cell); }
  [[nodiscard]] auto rowsOfEight(int, int) const {
    return [eight = cell * 0x0101010101010101u](std::uint64_t) { return eight; };
  }
};

/// The columns and rows of the samples that a small triangle may own. They are not clipped.
struct SampleBox {
  int left, right, top, bottom;  ///< right and bottom are the first outside
};

/// Evaluates three edge functions at each sample, in blocks of 8 x 4 cells. The only branch is for a second
/// block. It is for triangles whose box has at most 8 columns and 8 rows; their edges are too short to be
/// walked. The box meets the image, which has at least 8 columns and 8 rows.
///
/// E(x, y) = A (x - xa) + B (y - ya), with A = yb - ya and B = xa - xb, is positive inside. A sample on the
/// edge, moved by (e, e^2), is inside if A > 0, or if A = 0 and B > 0; if it is not, E - 1 takes the place of
/// E. From centre to centre E grows by multiples of 2^16, so E >> 16, which has the sign of E, steps exactly
/// by A and B. A and B are below 2^20 and the samples are less than 2^5 pixels from a, so E >> 16 stays below
/// 2^26 and its sign is the top bit.
template <Shader S>
inline void fillSmallTriangle(IndexImage& image, const glm::ivec3* p, const SampleBox& box, const S& shader) {
  constexpr int kColumns = 8, kRows = 4;
  // Blocks lie inside the image. At its border they are moved inwards, and the triangle owns the same
  // samples.
  const int rows = box.bottom - box.top <= kRows ? kRows : 2 * kRows;
  const int left = std::clamp(box.left, 0, image.width - kColumns);
  const int top = std::clamp(box.top, 0, image.height - rows);
  Eight edge[3];
  std::uint32_t down[3];
  for (int k = 0; k < 3; ++k) {
    const glm::ivec3 &a = p[k], &b = p[k == 2 ? 0 : k + 1];
    const int A = b.y - a.y, B = a.x - b.x;
    const std::int64_t E = std::int64_t{A} * (left * kGrid + kGrid / 2 - a.x) +
                           std::int64_t{B} * (top * kGrid + kGrid / 2 - a.y);
    const bool tieIsOut = (std::int64_t{A} << 32) + B <= 0;  // one test instead of three branches
    edge[k] =
        eightFrom(static_cast<std::uint32_t>((E - tieIsOut) >> kGridBits), static_cast<std::uint32_t>(A));
    down[k] = static_cast<std::uint32_t>(B);
  }
  auto nextCells = shader.rowsOfEight(left, top);
  std::uint8_t* cells = image.row(top) + left;
  for (int block = 0; block < rows; block += kRows)
    for (int j = 0; j < kRows; ++j, cells += image.width) {
      const std::uint64_t outside = negativeBytes(edge[0] | edge[1] | edge[2]);
      std::uint64_t old = 0;
      std::memcpy(&old, cells, sizeof old);
      old = (old & outside) | (nextCells(~outside) & ~outside);
      std::memcpy(cells, &old, sizeof old);
      for (int k = 0; k < 3; ++k) edge[k] += down[k];
    }
}

/// Fills every sample of the image that the outline owns. The outline is convex and counter-clockwise on the
/// screen.
template <Shader S>
inline void fillConvex(IndexImage& image, const glm::ivec3* p, int count, const S& shader) {
  if (count == 3 && image.width >= 8 && image.height >= 8) {
    const SampleBox box{
        sampleFrom(std::min({p[0].x, p[1].x, p[2].x})), sampleFrom(std::max({p[0].x, p[1].x, p[2].x})),
        sampleFrom(std::min({p[0].y, p[1].y, p[2].y})), sampleFrom(std::max({p[0].y, p[1].y, p[2].y}))};
    if (box.right <= 0 || box.left >= image.width || box.bottom <= 0 || box.top >= image.height) return;
    if (box.right - box.left <= 8 && box.bottom - box.top <= 8)
      return fillSmallTriangle(image, p, box, shader);
  }
  // A copy of the shader: through a reference, every span would load its members again.
  forEachSpan(p, count, image.width, image.height, [&image, shader](int row, int from, int to) {
    shader.span(image.row(row) + from, from, row, to - from);
  });
}

}  // namespace xnewell
