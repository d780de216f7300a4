#include "geometry/view/clip.h"

#include <glm/geometric.hpp>

namespace xnewell {

std::array<ClipPlane, 6> clipPlanes(double zFront, double guard) {
  return {{{0, 0, -1, zFront},
           {0, 0, 1, 0},
           {1, 0, 0, guard},
           {-1, 0, 0, guard},
           {0, 1, 0, guard},
           {0, -1, 0, guard}}};
}

void clip(std::vector<ClipVertex>& polygon, const std::array<ClipPlane, 6>& planes, unsigned planesMask,
          std::vector<Between>& made) {
  std::vector<ClipVertex> kept;
  const auto cross = [&](const ClipVertex& inside, const ClipVertex& outside, double t) {
    made.push_back({inside.source, outside.source, t});
    kept.push_back({inside.p + (outside.p - inside.p) * t, ~static_cast<int>(made.size() - 1)});
  };
  for (unsigned k = 0; k < planes.size() && !polygon.empty(); ++k) {
    if (!(planesMask >> k & 1u)) continue;
    kept.clear();
    ClipVertex a = polygon.back();
    double heightA = glm::dot(planes[k], a.p);
    for (const ClipVertex& b : polygon) {
      const double heightB = glm::dot(planes[k], b.p);
      const bool insideA = heightA >= 0.0, insideB = heightB >= 0.0;
      if (insideA && !insideB) cross(a, b, heightA / (heightA - heightB));
      if (!insideA && insideB) cross(b, a, heightB / (heightB - heightA));
      if (insideB) kept.push_back(b);
      a = b;
      heightA = heightB;
    }
    polygon.swap(kept);
  }
}

}  // namespace xnewell
