#include "shading/course/interpolation.h"

#include <algorithm>
#include <cmath>

#include "geometry/view/screen_grid.h"

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

}  // namespace xnewell
