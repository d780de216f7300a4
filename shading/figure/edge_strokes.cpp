#include "shading/figure/edge_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

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

}  // namespace xnewell
