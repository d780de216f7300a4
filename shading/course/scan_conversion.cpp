#include "shading/course/scan_conversion.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

#include "geometry/view/screen_grid.h"

namespace xnewell {

namespace {

constexpr double kPixel = kGrid;

/// y, or x, of the samples of a row, or a column, on the grid.
std::int64_t centreOf(int pixel) { return std::int64_t{pixel} * kGrid + kGrid / 2; }

/// The smallest whole number that is at least a / b, b > 0.
std::int64_t quotientUp(std::int64_t a, std::int64_t b) { return a / b + (a % b > 0); }

}  // namespace

double ScanEdge::step() const {
  return static_cast<double>(bottom.x - top.x) / static_cast<double>(bottom.y - top.y);
}

double ScanEdge::x(int row) const {
  return (top.x + step() * static_cast<double>(centreOf(row) - top.y)) / kPixel;
}

int ScanEdge::firstColumn(int row) const {
  // Sample i lies at x or to the right of it if (i + 1/2) pixels >= top.x + (y - top.y) dx / dy.
  const std::int64_t dx = bottom.x - top.x, dy = bottom.y - top.y;
  const std::int64_t right = (top.x - kGrid / 2) * dy + (centreOf(row) - top.y) * dx;
  return static_cast<int>(quotientUp(right, dy * kGrid));
}

std::vector<ScanEdge> edgesOf(std::span<const glm::ivec3> outline) {
  std::vector<ScanEdge> edges;
  const int count = static_cast<int>(outline.size());
  for (int k = 0; k < count; ++k) {
    ScanEdge edge{.from = k, .to = (k + 1) % count};
    const glm::ivec2 a{outline[edge.from]}, b{outline[edge.to]};
    edge.left = a.y < b.y;  // counter-clockwise: down on the left side, up on the right side
    std::tie(edge.top, edge.bottom) = edge.left ? std::pair{a, b} : std::pair{b, a};
    edge.firstRow = sampleFrom(edge.top.y), edge.endRow = sampleFrom(edge.bottom.y);
    if (edge.firstRow < edge.endRow) edges.push_back(edge);
  }
  std::ranges::sort(edges, {}, [](const ScanEdge& e) { return std::pair{e.firstRow, !e.left}; });
  return edges;
}

std::vector<ScanSpan> spansOf(std::span<const ScanEdge> edges) {
  std::vector<ScanSpan> spans;
  if (edges.empty()) return spans;
  const int end = std::ranges::max(edges, {}, &ScanEdge::endRow).endRow;
  for (int row = edges.front().firstRow; row < end; ++row) {
    ScanSpan span{.row = row};
    for (int k = 0; k < static_cast<int>(edges.size()); ++k)
      if (edges[k].firstRow <= row && row < edges[k].endRow) (edges[k].left ? span.left : span.right) = k;
    span.from = edges[span.left].firstColumn(row);
    span.to = edges[span.right].firstColumn(row);
    spans.push_back(span);
  }
  return spans;
}

}  // namespace xnewell
