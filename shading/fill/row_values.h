#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "geometry/view/scanline.h"
#include "shading/fill/affine.h"

namespace xnewell {

/// Intensities over a polygon with any number of corners, interpolated along its edges to each row, then
/// along the row (Gouraud 1971). This is not a plane: a value inside depends on the edges that its row meets,
/// so it changes when the polygon is turned on the screen. The values are those of the whole polygon, for any
/// span of it.
class RowValues {
 public:
  /// v has a value for each of the `count` vertices of a convex outline. For along() the values are in
  /// [kLeastValue, kLargestValue].
  RowValues(const glm::ivec3* outline, int count, std::vector<double> v)
      : outline_{outline}, count_{count}, v_{std::move(v)} {}

  /// The value along a row, in 8.24: c + gx i.
  [[nodiscard]] AffineValue along(int row) const {
    const Line line = lineOf(row);
    const auto steps = [](double x) {
      return static_cast<std::uint32_t>(static_cast<std::int64_t>(x * 0x1p24));
    };
    return {steps(line.c), steps(line.gx), 0};
  }
  /// The value itself at pixel (i, row).
  [[nodiscard]] double at(int i, int row) const {
    const Line line = lineOf(row);
    return line.c + line.gx * i;
  }

 private:
  struct Line {
    double c, gx;
  };
  [[nodiscard]] Line lineOf(int row) const {
    const double y = (row + 0.5) * kGrid;
    double left = 1e300, right = -1e300, atLeft = 0, atRight = 0;
    for (int k = 0; k < count_; ++k) {
      const int n = k + 1 == count_ ? 0 : k + 1;
      const glm::ivec3 &a = outline_[k], &b = outline_[n];
      if (a.y == b.y || std::min(a.y, b.y) > y || std::max(a.y, b.y) < y) continue;
      const double t = (y - a.y) / (b.y - a.y), x = a.x + t * (b.x - a.x), v = v_[k] + t * (v_[n] - v_[k]);
      if (x < left) left = x, atLeft = v;
      if (x > right) right = x, atRight = v;
    }
    const double pixels = (right - left) / kGrid;
    const double gx = pixels > 0x1p-12 ? (atRight - atLeft) / pixels : 0.0;
    return {atLeft - gx * (left - kGrid / 2) / kGrid, gx};
  }

  const glm::ivec3* outline_;
  int count_;
  std::vector<double> v_;
};

/// The cells of such a polygon, from GouraudLinear or GouraudTable.
template <class RowShader>
struct ByRows {
  RowValues values;
  RowShader shader;  ///< each row replaces its `value`
  void span(std::uint8_t* cells, int i, int j, int count) const {
    RowShader here = shader;
    here.value = values.along(j);
    here.span(cells, i, j, count);
  }
};
template <class RowShader>
ByRows(RowValues, RowShader) -> ByRows<RowShader>;  // for Clang before 17

}  // namespace xnewell
