#include "shading/figure/edge_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "shading/figure/figure.h"

namespace xnewell {

void addLine(const HidingFaces& faces, const glm::dvec3& a, const glm::dvec3& b, FigureStroke& seen,
             FigureStroke& unseen) {
  const auto at = [&](double t) {
    const glm::dvec3 p = (a + t * (b - a)) * (static_cast<double>(kFigureSteps) / kGrid);
    return glm::ivec2{static_cast<int>(std::floor(p.x + 0.5)), static_cast<int>(std::floor(p.y + 0.5))};
  };
  const auto add = [&](FigureStroke& to, const HidingFaces::Interval& part) {
    const glm::ivec2 from = at(part[0]), until = at(part[1]);
    if (from != until) to.lines.push_back({from, until});
  };
  const std::vector<HidingFaces::Interval> hidden = faces.hidden(a, b);
  for (const HidingFaces::Interval& part : HidingFaces::shown(hidden)) add(seen, part);
  for (const HidingFaces::Interval& part : hidden) add(unseen, part);
}

std::vector<FigureStroke> edgeStrokes(const SnappedScene& scene, const HidingFaces& faces, ModelEdges edges) {
  if (edges == ModelEdges::None) return {};
  struct Edge {
    glm::dvec3 a, b;
    std::vector<int> numbers;  ///< of the model's faces beside it
  };
  const auto packed = [](const glm::ivec3& v) { return std::array{v.x, v.y, v.z}; };
  std::map<std::array<std::array<int, 3>, 2>, Edge> found;
  for (const SnappedFace& face : scene.faces)
    for (int k = face.first, last = face.first + face.count; k < last; ++k) {
      const int next = k + 1 == last ? face.first : k + 1;
      if (scene.source[k] < 0 && scene.source[next] < 0) continue;  // the clip made it
      const auto [low, high] = std::minmax({packed(scene.vertices[k]), packed(scene.vertices[next])});
      Edge& edge = found[{low, high}];
      edge.a = {low[0], low[1], low[2]}, edge.b = {high[0], high[1], high[2]};
      edge.numbers.push_back(face.number);
    }
  FigureStroke seen, unseen;
  seen.width = kFigureSteps * 3 / 4;
  unseen.width = kFigureSteps / 2, unseen.dashed = true;
  for (auto& [ends, edge] : found) {
    std::ranges::sort(edge.numbers);
    if (std::ranges::adjacent_find(edge.numbers) != edge.numbers.end()) continue;  // a face is divided there
    addLine(faces, edge.a, edge.b, seen, unseen);
  }
  if (edges != ModelEdges::All) unseen.lines.clear();
  std::vector<FigureStroke> strokes;
  for (FigureStroke* stroke : {&unseen, &seen})
    if (!stroke->lines.empty()) strokes.push_back(std::move(*stroke));
  return strokes;
}

HidingFaces::HidingFaces(const SnappedScene& scene, int width, int height) : scene_{scene} {
  const double w = double{kGrid} * width, h = double{kGrid} * height;
  side_ = std::max(double{kGrid}, std::sqrt(w * h / (1.0 + static_cast<double>(scene.faces.size()))));
  columns_ = static_cast<int>(w / side_) + 1, rows_ = static_cast<int>(h / side_) + 1;
  faces_.resize(std::size_t(columns_) * rows_);
  for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f) {
    const SnappedFace& face = scene.faces[f];
    // Newell's normal: x, y, z are twice the areas of the projections.
    glm::dvec3 N{0.0}, mean{0.0};
    glm::dvec2 low{HUGE_VAL}, high{-HUGE_VAL};
    for (int k = 0; k < face.count; ++k) {
      const glm::dvec3 u{scene.vertices[face.first + k]},
          v{scene.vertices[face.first + (k + 1 == face.count ? 0 : k + 1)]};
      N += glm::dvec3{(u.y - v.y) * (u.z + v.z), (u.z - v.z) * (u.x + v.x), (u.x - v.x) * (u.y + v.y)};
      mean += u / static_cast<double>(face.count);
      low = {std::min(low.x, u.x), std::min(low.y, u.y)},
      high = {std::max(high.x, u.x), std::max(high.y, u.y)};
    }
    Depth depth{-N.x / N.z, -N.y / N.z, 0, 0};
    depth.c = mean.z - depth.x * mean.x - depth.y * mean.y;
    // Each corner is rounded by half a step along each axis, and a face of more corners is not quite plane.
    depth.doubt = 2 * (1 + std::abs(depth.x) + std::abs(depth.y));
    for (int k = 0; k < face.count; ++k) {
      const glm::dvec3 v{scene.vertices[face.first + k]};
      depth.doubt = std::max(depth.doubt, 2 * std::abs(depth.x * v.x + depth.y * v.y + depth.c - v.z));
    }
    depths_.push_back(depth);
    for (int j = cellOf(low.y, rows_); j <= cellOf(high.y, rows_); ++j)
      for (int i = cellOf(low.x, columns_); i <= cellOf(high.x, columns_); ++i)
        faces_[std::size_t(j) * columns_ + i].push_back(f);
  }
}

int HidingFaces::cellOf(double at, int cells) const {
  return static_cast<int>(std::clamp(std::floor(at / side_), 0.0, cells - 1.0));
}

HidingFaces::Interval HidingFaces::hiddenBy(int f, const glm::dvec3& a, const glm::dvec3& b) const {
  constexpr double kTouches = 2;  // steps of the grid: what is nearer to a side only touches it
  Interval in{0, 1};
  const auto keepPositive = [&](double atA, double atB) {
    if (atA <= 0 && atB <= 0) in[1] = -1;
    if (atA > 0 && atB > 0) return;
    const double at = atA / (atA - atB);
    if (atA > 0)
      in[1] = std::min(in[1], at);
    else
      in[0] = std::max(in[0], at);
  };
  const Depth& d = depths_[f];
  const auto ahead = [&](const glm::dvec3& p) { return d.x * p.x + d.y * p.y + d.c - p.z - d.doubt; };
  keepPositive(ahead(a), ahead(b));
  const SnappedFace& face = scene_.faces[f];
  for (int k = 0; k < face.count && in[0] < in[1]; ++k) {
    const glm::dvec3 u{scene_.vertices[face.first + k]},
        v{scene_.vertices[face.first + (k + 1 == face.count ? 0 : k + 1)]};
    const glm::dvec2 on{v.x - u.x, v.y - u.y};
    const double slack = kTouches * std::sqrt(on.x * on.x + on.y * on.y);
    const auto within = [&](const glm::dvec3& p) { return on.y * (p.x - u.x) - on.x * (p.y - u.y) - slack; };
    keepPositive(within(a), within(b));
  }
  return in;
}

std::vector<HidingFaces::Interval> HidingFaces::hidden(const glm::dvec3& a, const glm::dvec3& b) const {
  std::vector<int> near;
  for (int j = cellOf(std::min(a.y, b.y), rows_); j <= cellOf(std::max(a.y, b.y), rows_); ++j)
    for (int i = cellOf(std::min(a.x, b.x), columns_); i <= cellOf(std::max(a.x, b.x), columns_); ++i) {
      const std::vector<int>& cell = faces_[std::size_t(j) * columns_ + i];
      near.insert(near.end(), cell.begin(), cell.end());
    }
  std::ranges::sort(near);
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::vector<Interval> parts;
  for (const int face : near)
    if (const Interval in = hiddenBy(face, a, b); in[0] < in[1]) parts.push_back(in);
  std::ranges::sort(parts);
  // Neighbours hide up to their common side, but for the steps that count as touching it. A figure has no
  // finer steps than this.
  const double gap = static_cast<double>(kGrid) / kFigureSteps /
                     (1 + std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)));
  std::vector<Interval> apart;
  for (const Interval& part : parts)
    if (!apart.empty() && part[0] <= apart.back()[1] + gap)
      apart.back()[1] = std::max(apart.back()[1], part[1]);
    else
      apart.push_back(part);
  return apart;
}

bool HidingFaces::hides(const glm::dvec3& place) const {
  const std::size_t cell = std::size_t(cellOf(place.y, rows_)) * columns_ + cellOf(place.x, columns_);
  return std::ranges::any_of(faces_[cell], [&](int face) {
    const Interval in = hiddenBy(face, place, place);
    return in[0] < in[1];
  });
}

std::vector<HidingFaces::Interval> HidingFaces::shown(const std::vector<Interval>& hidden) {
  std::vector<Interval> left;
  double from = 0;
  for (const Interval& part : hidden) {
    if (part[0] > from) left.push_back({from, part[0]});
    from = part[1];
  }
  if (from < 1) left.push_back({from, 1});
  return left;
}

}  // namespace xnewell
