#include "shading/course/course.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "geometry/exact/int128.h"
#include "geometry/view/screen_plane.h"

namespace xnewell {

namespace {

using Point = glm::dvec2;

/// Twice the area of a triangle; positive if it runs counter-clockwise as seen on the screen.
double area(const Point& a, const Point& b, const Point& c) {
  return (c.x - a.x) * (b.y - a.y) - (b.x - a.x) * (c.y - a.y);
}

}  // namespace

Weights weightsOnScreen(const std::array<glm::ivec3, 3>& p, int i, int j) {
  // Seen from the sample, so that no digits are lost far from the origin.
  const auto fromSample = [&](const glm::ivec3& v) {
    return Point{(v.x - (i + 0.5) * kGrid) / kGrid, (v.y - (j + 0.5) * kGrid) / kGrid};
  };
  return weightsOfOrigin({fromSample(p[0]), fromSample(p[1]), fromSample(p[2])});
}

Weights weightsOfOrigin(const std::array<Point, 3>& p) {
  constexpr double kNarrow = 0x1p-12;
  const auto& [a, b, c] = p;
  const Point sample{0.0, 0.0};
  const double whole = area(a, b, c);
  const double longest =
      std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), std::abs(c.x - a.x), std::abs(c.y - a.y)});
  if (std::abs(whole) <= kNarrow * longest) return {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};
  return {area(sample, b, c) / whole, area(a, sample, c) / whole, area(a, b, sample) / whole};
}

Weights weightsInWorld(const Weights& onScreen, const std::array<double, 3>& overDepth) {
  Weights weights;
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) sum += weights[k] = onScreen[k] * overDepth[k];
  for (double& weight : weights) weight /= sum;
  return weights;
}

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

namespace {

/// a / b, rounded to the nearest whole number, of two the even one; b > 0.
Int128 nearestQuotient(Int128 a, Int128 b) {
  Int128 whole = a / b, rest = a % b;
  if (rest < 0) rest += b, --whole;
  const Int128 twice = 2 * rest;
  return whole + ((twice > b || (twice == b && whole % 2 != 0)) ? 1 : 0);
}

}  // namespace

SteppedPlane steppedOver(const std::array<glm::ivec3, 3>& p, const std::array<double, 3>& v, int bits) {
  const auto steps = [bits](double value) {
    return static_cast<std::int64_t>(std::nearbyint(std::ldexp(value, bits)));
  };
  const std::int64_t V0 = steps(v[0]), V1 = steps(v[1]) - V0, V2 = steps(v[2]) - V0;
  const std::int64_t x1 = p[1].x - p[0].x, y1 = p[1].y - p[0].y, x2 = p[2].x - p[0].x, y2 = p[2].y - p[0].y;
  // Cramer's rule: V1 = gx x1 + gy y1 and V2 = gx x2 + gy y2, with gx and gy for each step of the grid.
  Int128 area = Int128{x1} * y2 - Int128{x2} * y1;
  Int128 alongX = (Int128{V1} * y2 - Int128{V2} * y1) * kGrid;
  Int128 alongY = (Int128{V2} * x1 - Int128{V1} * x2) * kGrid;
  if (area < 0) area = -area, alongX = -alongX, alongY = -alongY;

  const Int128 steepest = area * (Int128{1} << (20 + bits));
  const auto isSteep = [&](Int128 along) { return along > steepest || -along > steepest; };
  if (isSteep(alongX) || isSteep(alongY)) return {bits, V0 + (V1 + V2) / 3, 0, 0};
  const Int128 gx = nearestQuotient(alongX, area), gy = nearestQuotient(alongY, area);
  // Back from vertex 0 to the centre of pixel (0, 0). `>>` rounds down, so this rounds to the nearest.
  const Int128 toVertex = gx * (p[0].x - kGrid / 2) + gy * (p[0].y - kGrid / 2);
  const Int128 c = V0 - ((toVertex + kGrid / 2) >> kGridBits);
  return {bits, static_cast<std::int64_t>(c), static_cast<std::int64_t>(gx), static_cast<std::int64_t>(gy)};
}

}  // namespace xnewell
