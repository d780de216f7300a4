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

/// The depths of one face's plane, estimated in doubles. The estimate is good enough to separate the faces at
/// most samples.
class DepthEstimate {
 public:
  DepthEstimate(const SnappedScene& scene, const SnappedFace& face, const ScreenPlane& plane)
      : anchor_{scene.vertices[face.first]},
        z_{depthAt(plane, anchor_.x, anchor_.y)},
        dzdx_{static_cast<double>(plane.A) / static_cast<double>(plane.C)},
        dzdy_{static_cast<double>(plane.B) / static_cast<double>(plane.C)} {
    double reach = 0.0;
    for (int v = face.first; v < face.first + face.count; ++v) {
      const glm::dvec2 d = glm::dvec2{scene.vertices[v]} - glm::dvec2{anchor_};
      reach = std::max(reach, std::abs(dzdx_ * d.x) + std::abs(dzdy_ * d.y));
    }
    // Samples lie in the hull of the vertices, so each term is at most `reach`. A slope has at most three
    // roundings of 2^-53 and z has four; each product and each sum adds one. So no term has more than six
    // roundings, and 2^-50 allows eight, of reach + |z|.
    error_ = 0x1p-50 * (reach + std::abs(z_));
  }
  /// The depth at the centre of pixel (i, j). Its error is at most error().
  [[nodiscard]] double at(int i, int j) const {
    return dzdx_ * (kGrid * (i + 0.5) - anchor_.x) + (dzdy_ * (kGrid * (j + 0.5) - anchor_.y) + z_);
  }
  [[nodiscard]] double error() const { return error_; }

 private:
  glm::ivec3 anchor_;
  double z_, dzdx_, dzdy_, error_ = 0;
};

}  // namespace

std::vector<int> visibleFaces(const SnappedScene& scene, int width, int height) {
  std::vector<DepthEstimate> estimates;
  for (const SnappedFace& face : scene.faces) estimates.emplace_back(scene, face, scene.planes[face.plane]);
  const auto planeOf = [&](int face) -> const ScreenPlane& { return scene.planes[scene.faces[face].plane]; };

  std::vector<int> seen(std::size_t(width) * height, kNothing);
  std::vector<double> nearest(seen.size());  // estimated depth of the face that is seen
  for (int f = 0; f < static_cast<int>(scene.faces.size()); ++f) {
    const SnappedFace& face = scene.faces[f];
    const glm::ivec3* const outline = &scene.vertices[face.first];
    const auto [top, bottom] =
        std::minmax_element(outline, outline + face.count, [](auto& a, auto& b) { return a.y < b.y; });
    const int end = std::min(height, (bottom->y >> kGridBits) + 1);
    for (int j = std::max(0, top->y >> kGridBits); j < end; ++j) {
      const Columns columns = columnsInside(outline, face.count, j, width);
      for (int i = columns.from; i < columns.to; ++i) {
        const std::size_t sample = std::size_t(j) * width + i;
        const int best = seen[sample];
        const double z = estimates[f].at(i, j);
        if (best != kNothing) {
          const double ahead = z - nearest[sample], doubt = estimates[f].error() + estimates[best].error();
          if (ahead < -doubt || (ahead <= doubt && nearer(planeOf(f), planeOf(best), i, j) < 0)) continue;
        }
        seen[sample] = f;
        nearest[sample] = z;
      }
    }
  }
  return seen;
}

}  // namespace xnewell
