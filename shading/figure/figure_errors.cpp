#include "shading/figure/figure_errors.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "shading/color/color_difference.h"
#include "shading/figure/side_table.h"

namespace xnewell {

namespace {

/// A place where an outline passes a row of samples.
struct Passage {
  int row, column;  ///< of the first sample that does not lie to its left
  int turn;         ///< 1 if the outline goes down, -1 if it goes up
  auto operator<=>(const Passage&) const = default;
};

constexpr int kHalfStep = kFigureSteps / 2;  ///< where the sample lies in its pixel

/// The first sample at or after a coordinate.
int sampleFrom(double at) { return static_cast<int>(std::ceil((at - kHalfStep) / kFigureSteps)); }

void addPassages(const FigureLoop& loop, const VectorFigure& figure, std::vector<Passage>& passages) {
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const glm::ivec2 &a = loop[k], &b = loop[k + 1 == loop.size() ? 0 : k + 1];
    const auto [high, low] = std::minmax(a.y, b.y);
    const int end = std::min(figure.height, sampleFrom(low));
    for (int row = std::max(0, sampleFrom(high)); row < end; ++row) {
      const double down = double{kFigureSteps} * row + kHalfStep - a.y;
      passages.push_back({row, sampleFrom(a.x + down * (b.x - a.x) / (b.y - a.y)), a.y < b.y ? 1 : -1});
    }
  }
}

void paint(const FigureTriangle& triangle, const VectorFigure& figure, std::vector<FigureColor>& colors) {
  std::array<glm::dvec2, 3> at;
  for (int k = 0; k < 3; ++k) at[k] = triangle.corners[k];
  std::array<LinearOver, 3> weights;
  for (int k = 0; k < 3; ++k)
    weights[k] = LinearOver::through(at, {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0});
  const auto [left, right] = std::ranges::minmax(at, {}, &glm::dvec2::x);
  const auto [top, bottom] = std::ranges::minmax(at, {}, &glm::dvec2::y);
  for (int j = std::max(0, sampleFrom(top.y)); j < std::min(figure.height, sampleFrom(bottom.y)); ++j)
    for (int i = std::max(0, sampleFrom(left.x)); i < std::min(figure.width, sampleFrom(right.x)); ++i) {
      const glm::dvec2 sample = glm::dvec2{i, j} * double{kFigureSteps} + double{kHalfStep};
      std::array<double, 3> w;
      for (int k = 0; k < 3; ++k) w[k] = weights[k](sample);
      if (*std::ranges::min_element(w) < 0) continue;
      for (int c = 0; c < 3; ++c) {
        double level = 0.5;
        for (int k = 0; k < 3; ++k) level += w[k] * triangle.colors[k][c];
        colors[std::size_t(j) * figure.width + i][c] = static_cast<std::uint8_t>(level);
      }
    }
}

int farthestChannel(const FigureColor& p, const FigureColor& q) {
  int most = 0;
  for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(p[c] - q[c]));
  return most;
}

}  // namespace

std::vector<FigureColor> colorsAtSamples(const VectorFigure& figure, FigureColor ground) {
  std::vector<FigureColor> colors(std::size_t(figure.width) * figure.height, ground);
  std::vector<Passage> passages;
  for (const FigurePath& path : figure.paths) {
    for (const FigureTriangle& triangle : path.triangles) paint(triangle, figure, colors);
    passages.clear();
    for (const FigureLoop& loop : path.loops) addPassages(loop, figure, passages);
    std::ranges::sort(passages);
    int winding = 0;  // it ends each row with 0
    for (std::size_t k = 0; k + 1 < passages.size(); ++k) {
      winding += passages[k].turn;
      if (winding == 0) continue;
      const auto row = colors.begin() + std::ptrdiff_t{passages[k].row} * figure.width;
      const int from = std::clamp(passages[k].column, 0, figure.width),
                to = std::clamp(passages[k + 1].column, 0, figure.width);
      std::fill(row + from, row + to, path.color);
    }
  }
  return colors;
}

FigureErrors errorsOf(const VectorFigure& figure, const Comparison& comparison, const Palette& palette) {
  const Picture& picture = comparison.picture();
  const FigureColor ground = figureColorOf(palette[picture.ground()]);
  const std::vector<FigureColor> colors = colorsAtSamples(figure, ground);
  std::vector<float> ofFigure(colors.size(), std::numeric_limits<float>::quiet_NaN());
  FigureErrors errors;
  for (std::size_t k = 0; k < colors.size(); ++k) {
    const FigureColor shown = figureColorOf(palette[picture.image().pixels[k]]);
    if (!comparison.shows(k) && colors[k] == ground) continue;
    const int off = farthestChannel(colors[k], shown);
    errors.differ += off > figure.statistics.off;
    errors.largest = std::max(errors.largest, off);
    ofFigure[k] = static_cast<float>(ciede2000(
        labFromSrgb(colors[k].data()),
        labFromSrgb(comparison.trueFace(k) < 0 ? palette[picture.ground()] : comparison.dueColor(k))));
  }
  errors.figure = spreadOf(ofFigure);
  errors.picture = spreadOf(comparison.colorErrors());
  errors.samples = errors.figure.count;
  return errors;
}

}  // namespace xnewell
