#include "depthsort/oracle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/view/screen_plane.h"

namespace xnewell {

namespace {

std::int64_t ceilDivide(std::int64_t n, std::int64_t positive) { return n / positive + (n % positive > 0); }

struct Columns {
  int from, to;
};

/// The samples of row j that a convex outline owns. Each edge is a half plane and keeps the columns on its
/// inner side. A sample exactly on a left edge is inside, on a right edge outside.
Columns columnsInside(const glm::ivec3* p, int count, int j, int width) {
  std::int64_t from = 0, to = width;
  const std::int64_t y = (std::int64_t{j} << kGridBits) + kGrid / 2;
  for (int v = 0; v < count; ++v) {
    const glm::ivec3 &a = p[v], &b = p[v + 1 == count ? 0 : v + 1];
    // Inside, A (x - ax) + B (y - ay) > 0. |A|, |B| <= 2^30, so the sums stay below 2^62.
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

VisibleFaces::VisibleFaces(const SnappedScene& scene) : scene_{scene} {
  for (const SnappedFace& face : scene.faces) estimates_.emplace_back(scene, face, scene.planes[face.plane]);
}

std::vector<int> VisibleFaces::rows(int first, int end, int width) {
  const auto planeOf = [&](int f) -> const ScreenPlane& { return scene_.planes[scene_.faces[f].plane]; };
  std::vector<int> seen(std::size_t(width) * (end - first), kNothing);
  nearest_.resize(seen.size());
  for (int f = 0; f < static_cast<int>(scene_.faces.size()); ++f) {
    const SnappedFace& face = scene_.faces[f];
    const glm::ivec3* const outline = &scene_.vertices[face.first];
    const auto [top, bottom] =
        std::minmax_element(outline, outline + face.count, [](auto& a, auto& b) { return a.y < b.y; });
    const int until = std::min(end, (bottom->y >> kGridBits) + 1);
    for (int j = std::max(first, top->y >> kGridBits); j < until; ++j) {
      const Columns columns = columnsInside(outline, face.count, j, width);
      for (int i = columns.from; i < columns.to; ++i) {
        const std::size_t sample = std::size_t(j - first) * width + i;
        const int best = seen[sample];
        const double z = estimates_[f].at(i, j);
        if (best != kNothing) {
          const double ahead = z - nearest_[sample], doubt = estimates_[f].error() + estimates_[best].error();
          if (ahead < -doubt || (ahead <= doubt && nearer(planeOf(f), planeOf(best), i, j) < 0)) continue;
        }
        seen[sample] = f;
        nearest_[sample] = z;
      }
    }
  }
  return seen;
}

std::vector<int> visibleFaces(const SnappedScene& scene, int width, int height) {
  return VisibleFaces{scene}.rows(0, height, width);
}

}  // namespace xnewell
