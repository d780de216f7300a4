#include "shading/figure/runs.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "shading/figure/convex_part.h"

namespace xnewell {

LinearOver LinearOver::through(const std::array<glm::dvec2, 3>& at, const std::array<double, 3>& v) {
  const glm::dvec2 a = at[1] - at[0], b = at[2] - at[0];
  const double area = a.x * b.y - a.y * b.x, u = v[1] - v[0], w = v[2] - v[0];
  LinearOver over{(u * b.y - w * a.y) / area, (w * a.x - u * b.x) / area, 0};
  over.c = v[0] - over(at[0]);
  return over;
}

SidedPart sided(const FigurePolygon& polygon) {
  SidedPart part;
  for (std::size_t k = 0; k < polygon.corners.size(); ++k)
    part.push_back({glm::dvec2{polygon.corners[k]}, polygon.lines[k]});
  return part;
}

SidedPart clipped(const SidedPart& part, const LinearOver& value, const SideLine& line) {
  SidedPart left;
  for (std::size_t k = 0; k < part.size(); ++k) {
    const SidedCorner &u = part[k], &v = part[k + 1 == part.size() ? 0 : k + 1];
    const double hu = value(u.at), hv = value(v.at);
    if (hu >= 0) left.push_back({u.at, hu == 0 && hv < 0 ? line : u.line});
    if ((hu > 0 && hv < 0) || (hu < 0 && hv > 0))
      left.push_back({u.at + (v.at - u.at) * (hu / (hu - hv)), hu > 0 ? line : u.line});
  }
  return left;
}

void addRounded(const SidedPart& part, int face, const FigureColor& color, std::vector<FigurePolygon>& to) {
  FigurePolygon polygon;
  polygon.face = face, polygon.color = color;
  const auto rounded = [](const glm::dvec2& v) {
    return glm::ivec2{static_cast<int>(std::floor(v.x + 0.5)), static_cast<int>(std::floor(v.y + 0.5))};
  };
  for (std::size_t k = 0; k < part.size(); ++k) {
    const glm::ivec2 from = rounded(part[k].at);
    if (from == rounded(part[k + 1 == part.size() ? 0 : k + 1].at)) continue;
    polygon.corners.push_back(from);
    polygon.lines.push_back(part[k].line);
  }
  if (doubleArea(polygon.corners) > 0) to.push_back(std::move(polygon));
}

namespace {

using Color = FigureColor;

/// The colour of a face in a pixel: that of its nearest sample; if there is none near, that of the sample.
Color colorIn(const ShownSamples& samples, int face, int i, int j) {
  constexpr int kFar = 3;
  i = std::clamp(i, 0, samples.width - 1), j = std::clamp(j, 0, samples.height - 1);
  const auto at = [&](int x, int y) { return std::size_t(y) * samples.width + x; };
  if (samples.faces[at(i, j)] == face) return samples.colors[at(i, j)];
  int nearest = 2 * kFar * kFar + 1;
  Color color = samples.colors[at(i, j)];
  for (int y = std::max(0, j - kFar); y <= std::min(samples.height - 1, j + kFar); ++y)
    for (int x = std::max(0, i - kFar); x <= std::min(samples.width - 1, i + kFar); ++x) {
      const int distance = (x - i) * (x - i) + (y - j) * (y - j);
      if (samples.faces[at(x, y)] == face && distance < nearest)
        nearest = distance, color = samples.colors[at(x, y)];
    }
  return color;
}

}  // namespace

int splitIntoRuns(const FigurePolygon& polygon, int index, const ShownSamples& samples, int tolerance,
                  std::vector<FigurePolygon>& to) {
  const auto pixel = [](double steps) { return static_cast<int>(std::floor(steps / kFigureSteps)); };
  const auto [top, bottom] = std::ranges::minmax(polygon.corners, {}, &glm::ivec2::y);
  const auto lineAt = [index](bool upright, int at) {
    return SideLine{SideLine::Kind::Shade, static_cast<std::uint64_t>(index) * 2 + (upright ? 1 : 0),
                    static_cast<std::uint64_t>(at + kFigureSteps)};
  };
  int off = 0;
  SidedPart below = sided(polygon);
  for (int j = pixel(top.y); j <= pixel(bottom.y) && !below.empty(); ++j) {
    const double end = (j + 1.0) * kFigureSteps;
    SidedPart row = clipped(below, {0, -1, end}, lineAt(false, j + 1));
    below = clipped(below, {0, 1, -end}, lineAt(false, j + 1));
    if (row.size() < 3) continue;
    double left = HUGE_VAL, right = -HUGE_VAL;
    for (const SidedCorner& c : row) left = std::min(left, c.at.x), right = std::max(right, c.at.x);
    ColorBox run;
    run.add(colorIn(samples, polygon.face, pixel(left), j));
    for (int i = pixel(left) + 1; i <= pixel(right); ++i) {
      const Color color = colorIn(samples, polygon.face, i, j);
      ColorBox longer = run;
      longer.add(color);
      if (longer.radius() > tolerance) {
        const double at = static_cast<double>(i) * kFigureSteps;
        addRounded(clipped(row, {-1, 0, at}, lineAt(true, i)), polygon.face, run.middle(), to);
        row = clipped(row, {1, 0, -at}, lineAt(true, i));
        off = std::max(off, run.radius());
        longer = {};
        longer.add(color);
      }
      run = longer;
    }
    off = std::max(off, run.radius());
    addRounded(row, polygon.face, run.middle(), to);
  }
  return off;
}

}  // namespace xnewell
