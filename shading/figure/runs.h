#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "shading/figure/shades.h"

namespace xnewell {

/// What shades.h makes polygons with: convex parts whose sides know their lines.

/// A corner of a part, and the line of the side from it to the next one.
struct SidedCorner {
  glm::dvec2 at;
  SideLine line;
};
using SidedPart = std::vector<SidedCorner>;

/// A value over the page: x (at.x) + y (at.y) + c.
struct LinearOver {
  double x = 0, y = 0, c = 0;
  [[nodiscard]] double operator()(const glm::dvec2& at) const { return x * at.x + y * at.y + c; }
  [[nodiscard]] LinearOver negative() const { return {-x, -y, -c}; }
  /// Positive to the left of the way from a to b, as seen.
  [[nodiscard]] static LinearOver besides(const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 on = b - a;
    return {on.y, -on.x, on.x * a.y - on.y * a.x};
  }
  /// With the values v at three places that are on no common line.
  [[nodiscard]] static LinearOver through(const std::array<glm::dvec2, 3>& at,
                                          const std::array<double, 3>& v);
};

[[nodiscard]] SidedPart sided(const FigurePolygon& polygon);
/// The part where a value is not negative. The side that this makes lies on `line`.
[[nodiscard]] SidedPart clipped(const SidedPart& part, const LinearOver& value, const SideLine& line);
/// Adds a part as a polygon with rounded corners, if it keeps an area.
void addRounded(const SidedPart& part, int face, const FigureColor& color, std::vector<FigurePolygon>& to);

/// The least box around some colours.
struct ColorBox {
  FigureColor low{255, 255, 255}, high{0, 0, 0};
  void add(const FigureColor& color) {
    for (int c = 0; c < 3; ++c) low[c] = std::min(low[c], color[c]), high[c] = std::max(high[c], color[c]);
  }
  [[nodiscard]] FigureColor middle() const {
    FigureColor middle;
    for (int c = 0; c < 3; ++c) middle[c] = static_cast<std::uint8_t>((low[c] + high[c]) / 2);
    return middle;
  }
  /// How far the middle is from the others.
  [[nodiscard]] int radius() const {
    int most = 0;
    for (int c = 0; c < 3; ++c) most = std::max(most, (high[c] - low[c] + 1) / 2);
    return most;
  }
};

/// Cuts a polygon, the index-th, into runs of pixels of one colour; see shadePartsOf().
/// @return  how far a run's colour is at most from that of a sample
int splitIntoRuns(const FigurePolygon& polygon, int index, const ShownSamples& samples, int tolerance,
                  std::vector<FigurePolygon>& to);

}  // namespace xnewell
