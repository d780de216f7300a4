#include "geometry/model/edges.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace xnewell {

namespace {

/// For each point, the first point at its place. A table with open addressing finds it: half of its slots or
/// more are empty.
std::vector<int> placesOf(const std::vector<glm::dvec3>& points) {
  const std::size_t mask = std::bit_ceil(2 * points.size() + 1) - 1;
  std::vector<int> slots(mask + 1, -1), place(points.size());
  for (int i = 0; i < std::ssize(points); ++i) {
    const glm::dvec3 p = points[i] + 0.0;  // -0 is at the place of 0
    std::uint64_t hash = 0;
    for (const double v : {p.x, p.y, p.z}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(v)) * 0x9E3779B97F4A7C15u;  // 2^64 over the golden ratio
      hash ^= hash >> 32;
    }
    // The middle bits depend on all.
    std::size_t slot = static_cast<std::size_t>(hash * 0x9E3779B97F4A7C15u >> 32) & mask;
    while (slots[slot] >= 0 && points[slots[slot]] != p) slot = (slot + 1) & mask;
    if (slots[slot] < 0) slots[slot] = i;
    place[i] = slots[slot];
  }
  return place;
}

/// Calls found(low, high, up) for each edge with a length; `up` says whether its face goes from low to high.
template <class Found>
void forEachEdge(const Mesh& mesh, const std::vector<int>& place, const Found& found) {
  for (int f = 0; f < mesh.faceCount(); ++f) {
    int from = place[mesh.face(f).back()];
    for (const int corner : mesh.face(f)) {
      const int to = place[corner];
      if (from != to) found(std::min(from, to), std::max(from, to), from < to);
      from = to;
    }
  }
}

}  // namespace

EdgeCounts countEdges(const Mesh& mesh) {
  const std::vector<int> place = placesOf(mesh.points);
  // Edges of one lower end are neighbours here: twice the upper end, and 1 more if the face goes upwards.
  std::vector<std::size_t> next(mesh.points.size() + 1);
  forEachEdge(mesh, place, [&](int low, int, bool) { ++next[low + 1]; });
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<std::uint32_t> ends(next.back());
  forEachEdge(mesh, place, [&](int low, int high, bool up) {
    ends[next[low]++] = 2 * static_cast<std::uint32_t>(high) + (up ? 1 : 0);
  });
  EdgeCounts counts;
  auto begin = ends.begin();
  for (std::size_t low = 0; low < mesh.points.size(); ++low) {
    const auto end = ends.begin() + static_cast<std::ptrdiff_t>(next[low]);
    std::sort(begin, end);
    while (begin != end) {
      const auto first = begin;
      begin = std::find_if(first, end, [&](std::uint32_t e) { return e / 2 != *first / 2; });
      counts.open += begin - first == 1;
      counts.turned += begin - first == 2 && first[0] == first[1];
      counts.crowded += begin - first > 2;
    }
  }
  return counts;
}

}  // namespace xnewell
