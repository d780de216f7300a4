#include "depthsort/oracle.h"

#include <algorithm>
#include <cstdint>

#include "depthsort/screen_plane.h"

namespace {

std::int64_t ceilDivide(std::int64_t n, std::int64_t positive) { return n / positive + (n % positive > 0); }

struct Columns {
  int from, to;
};

/// The samples of row j that a convex outline owns: each edge is a half plane and leaves the columns on its
/// inner side, an upright sample exactly on a left edge included and on a right edge not.
Columns columnsInside(const glm::ivec3* p, int count, int j, int width) {
  std::int64_t from = 0, to = width;
  const std::int64_t y = (std::int64_t{j} << kGridBits) + kGrid / 2;
  for (int v = 0; v < count; ++v) {
    const glm::ivec3 &a = p[v], &b = p[v + 1 == count ? 0 : v + 1];
    // Inside, A (x - ax) + B (y - ay) > 0; |A|, |B| <= 2^30 and so the sums stay below 2^62.
    const std::int64_t A = std::int64_t{b.y} - a.y, B = std::int64_t{a.x} - b.x;
    if (A == 0) {
      const std::int64_t height = B > 0 ? y - a.y : a.y - y;
      if (height < 0 || (height == 0 && B < 0)) return {0, 0};
      continue;
    }
    const std::int64_t bound = (std::int64_t{a.x} - kGrid / 2) * A - B * (y - a.y);
    if (A > 0)
      from = std::max(from, ceilDivide(bound, A * kGrid));
    else
      to = std::min(to, ceilDivide(-bound, -A * kGrid));
  }
  return {static_cast<int>(from), static_cast<int>(std::max(from, to))};
}

}  // namespace

std::vector<int> visibleFaces(const SnappedScene& scene, int width, int height) {
  std::vector<ScreenPlane> planes;
  planes.reserve(scene.faces.size());
  for (const SnappedFace& face : scene.faces) planes.push_back(planeOf(scene, face));

  std::vector<int> seen(std::size_t(width) * height, kNothing);
  for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f) {
    const SnappedFace& face = scene.faces[f];
    const glm::ivec3* const outline = &scene.vertices[face.first];
    const auto [top, bottom] =
        std::minmax_element(outline, outline + face.count, [](auto& a, auto& b) { return a.y < b.y; });
    const int end = std::min(height, (bottom->y >> kGridBits) + 1);
    for (int j = std::max(0, top->y >> kGridBits); j < end; ++j) {
      const Columns columns = columnsInside(outline, face.count, j, width);
      int* const row = seen.data() + std::ptrdiff_t(j) * width;
      for (int i = columns.from; i < columns.to; ++i)
        if (row[i] == kNothing || nearer(planes[f], planes[row[i]], i, j) >= 0) row[i] = f;
    }
  }
  return seen;
}
