#include "geometry/model/edges.h"

#include <algorithm>
#include <compare>
#include <numeric>
#include <tuple>
#include <vector>

namespace xnewell {

namespace {

/// For each point, the number of its place.
std::vector<int> placesOf(const std::vector<glm::dvec3>& points) {
  std::vector<int> order(points.size()), place(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int i) { return std::tie(points[i].x, points[i].y, points[i].z); };
  std::ranges::sort(order, [&](int a, int b) { return at(a) < at(b); });
  int number = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    number += k > 0 && at(order[k - 1]) < at(order[k]);
    place[order[k]] = number;
  }
  return place;
}

struct DirectedEdge {
  int low, high;
  bool up;  ///< whether its face goes from low to high
  auto operator<=>(const DirectedEdge&) const = default;
};

}  // namespace

EdgeCounts countEdges(const Mesh& mesh) {
  const std::vector<int> place = placesOf(mesh.points);
  std::vector<DirectedEdge> edges;
  edges.reserve(mesh.corners.size());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    int from = place[mesh.face(f).back()];
    for (const int corner : mesh.face(f)) {
      const int to = place[corner];
      if (from != to) edges.push_back({std::min(from, to), std::max(from, to), from < to});
      from = to;
    }
  }
  std::ranges::sort(edges);
  EdgeCounts counts;
  for (auto first = edges.begin(), end = first; first != edges.end(); first = end) {
    end = std::find_if(first, edges.end(),
                       [&](const DirectedEdge& e) { return e.low != first->low || e.high != first->high; });
    counts.open += end - first == 1;
    counts.turned += end - first == 2 && first[0].up == first[1].up;
    counts.crowded += end - first > 2;
  }
  return counts;
}

}  // namespace xnewell
