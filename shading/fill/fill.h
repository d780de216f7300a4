#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>

#include "geometry/view/project.h"
#include "geometry/view/scanline.h"
#include "shading/color/images.h"
#include "shading/fill/eight.h"

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

/// Fills a small triangle in blocks of 8 x 4 cells. The only branch is for a second block.
template <Shader S>
inline void fillSmallTriangle(IndexImage& image, const glm::ivec3* p, const SampleBox& box, const S& shader) {
  SmallTriangle triangle{p, box, image.width, image.height};
  auto nextCells = shader.rowsOfEight(triangle.left, triangle.top);
  std::uint8_t* cells = image.row(triangle.top) + triangle.left;
  for (int block = 0; block < triangle.rows; block += SmallTriangle::kRows)
    for (int j = 0; j < SmallTriangle::kRows; ++j, cells += image.width) {
      const std::uint64_t outside = negativeBytes(triangle.nextRow());
      std::uint64_t old = 0;
      std::memcpy(&old, cells, sizeof old);
      old = (old & outside) | (nextCells(~outside) & ~outside);
      std::memcpy(cells, &old, sizeof old);
    }
}

/// Fills every sample of the image that the outline owns. The outline is convex and counter-clockwise on the
/// screen.
template <Shader S>
inline void fillConvex(IndexImage& image, const glm::ivec3* p, int count, const S& shader) {
  if (count == 3 && SmallTriangle::fitsInto(image.width, image.height)) {
    const SampleBox box = sampleBoxOf(p[0], p[1], p[2]);
    if (!box.meets(image.width, image.height)) return;
    if (SmallTriangle::fits(box)) return fillSmallTriangle(image, p, box, shader);
  }
  // A copy of the shader: through a reference, every span would load its members again.
  forEachSpan(p, count, image.width, image.height, [&image, shader](int row, int from, int to) {
    shader.span(image.row(row) + from, from, row, to - from);
  });
}

/// The triangles over which the values at the corners of a face are interpolated: a plane over the screen
/// passes through three values. A polygon with more corners becomes a fan around the corner that the model
/// lists first, so the view does not choose it. Two faces agree along the edge that they share.

/// A triangle of an outline, counter-clockwise on the screen.
struct FaceTriangle {
  std::array<glm::ivec3, 3> p;
  std::array<int, 3> vertex;  ///< index into SnappedScene::vertices
};

/// Calls use(triangle) for each triangle that has an area.
template <class Use>
void forEachTriangle(const SnappedScene& scene, const SnappedFace& face, Use&& use) {
  const auto triangle = [&](int a, int b, int c) {
    const std::array vertex{face.first + a, face.first + b, face.first + c};
    return FaceTriangle{{scene.vertices[vertex[0]], scene.vertices[vertex[1]], scene.vertices[vertex[2]]},
                        vertex};
  };
  if (face.count == 3) return use(triangle(0, 1, 2));
  int apex = 0;
  const auto listed = [&](int v) { return static_cast<unsigned>(scene.source[face.first + v]); };
  for (int v = 1; v < face.count; ++v)
    if (listed(v) < listed(apex))
      apex = v;  // the source of a vertex made by clipping is negative: larger than all others
  for (int k = 1; k + 1 < face.count; ++k) {
    const FaceTriangle t = triangle(apex, (apex + k) % face.count, (apex + k + 1) % face.count);
    if (doubleArea(t.p.data(), 3) > 0) use(t);
  }
}

}  // namespace xnewell
