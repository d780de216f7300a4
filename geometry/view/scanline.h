#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>

#include "geometry/view/project.h"

namespace xnewell {

/// Finds the samples of convex polygons on the screen grid by one rule. The sample of a pixel is its centre
/// moved by (e, e^2), where e > 0 is infinitely small. So no sample lies on an edge, and faces that share an
/// edge own each sample exactly once: samples on left and top edges are inside, those on right and bottom
/// edges outside.

/// Where an edge crosses the rows that it spans: exactly, with one addition and one shift for each row.
///
/// The edge from a down to b crosses the samples of row j at X. The first sample at X or to the right of it
/// is i = ceil(M / dy), with M = ceil(((xa - 1/2 px) dy + (yc - ya) dx) / 2^16), in grid steps. M grows by
/// exactly dx for each row. M / dy is an integer, or at least 1/dy >= 2^-30 above one. So floor(x) is that
/// ceiling as long as M / dy + 1 - 2^-30 <= x < M / dy + 1. `x_` holds x with 47 fraction bits. It starts
/// 2^-32 below the upper end and strays from there by less than 2^-33: |M| <= 2^45, dx and dy are exact as
/// doubles. So the two roundings of a product with 1/dy leave x at the first row, |x| <= 2^15, within 2^-37,
/// and the growth over all rows, which is dx in pixels, within 2^-38. The step is cut off at 2^-47, which
/// adds 2^-34 in 8192 rows.
class EdgeWalk {
 public:
  static constexpr int kFraction = 47;

  EdgeWalk() = default;
  /// The edge from a down to b (a.y < b.y), at the row `firstRow`, which it spans.
  EdgeWalk(const glm::ivec3& a, const glm::ivec3& b, int firstRow) {
    constexpr double kOne = 0x1p47;
    const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
    const std::int64_t yc = (std::int64_t{firstRow} << kGridBits) + kGrid / 2;
    const std::int64_t M = -((-((a.x - kGrid / 2) * dy + (yc - a.y) * dx)) >> kGridBits);
    const double perRow = kOne / static_cast<double>(dy);
    x_ = static_cast<std::int64_t>(static_cast<double>(M) * perRow) +
         ((std::int64_t{1} << kFraction) - 1 - (std::int64_t{1} << 15));
    // An edge less than a pixel high spans at most one row: it never steps.
    if (dy >= kGrid) step_ = static_cast<std::int64_t>(static_cast<double>(dx) * perRow);
  }
  /// The first sample of the current row at the edge or to the right of it.
  [[nodiscard]] int column() const { return static_cast<int>(x_ >> kFraction); }
  void nextRow() { x_ += step_; }

 private:
  std::int64_t x_ = 0, step_ = 0;
};

/// Calls span(row, from, to) for every row of [firstRow, endRow) in which the outline owns samples of [0,
/// width): those from `from` to `to` - 1, from < to. The outline is convex and counter-clockwise on the
/// screen (y down); firstRow >= 0.
template <class Span>
void forEachSpan(const glm::ivec3* p, int count, int firstRow, int width, int endRow, Span&& span) {
  int top = 0, bottom = 0;
  for (int i = 1; i < count; ++i) {
    if (p[i].y < p[top].y) top = i;
    if (p[i].y > p[bottom].y) bottom = i;
  }
  int row = std::max(firstRow, sampleFrom(p[top].y));
  const int end = std::min(endRow, sampleFrom(p[bottom].y));
  if (row >= end) return;

  // In a counter-clockwise outline the left chain runs forward from the top vertex, the right one backward.
  struct Chain {
    int vertex, direction, end;  // `end`: the first row below the current edge
    EdgeWalk edge;
  };
  Chain left{top, 1, row, {}}, right{top, -1, row, {}};
  const auto advance = [&](Chain& chain) {
    while (chain.end <= row) {
      const int from = chain.vertex;
      chain.vertex = from + chain.direction;
      if (chain.vertex == count) chain.vertex = 0;
      if (chain.vertex < 0) chain.vertex = count - 1;
      chain.end = sampleFrom(p[chain.vertex].y);
      if (chain.end > row) chain.edge = EdgeWalk{p[from], p[chain.vertex], row};
    }
  };
  while (row < end) {
    advance(left);
    advance(right);
    const int until = std::min({end, left.end, right.end});
    for (; row < until; ++row) {
      const int from = std::max(0, left.edge.column()), to = std::min(width, right.edge.column());
      if (from < to) span(row, from, to);
      left.edge.nextRow();
      right.edge.nextRow();
    }
  }
}

/// The same for all rows of a picture.
template <class Span>
void forEachSpan(const glm::ivec3* p, int count, int width, int height, Span&& span) {
  forEachSpan(p, count, 0, width, height, span);
}

}  // namespace xnewell
