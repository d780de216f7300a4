#include "geometry/clip.h"

#include <glm/geometric.hpp>

std::array<ClipPlane, 6> clipPlanes(double zFront, double guard) {
  return {{{0, 0, -1, zFront},
           {0, 0, 1, 0},
           {1, 0, 0, guard},
           {-1, 0, 0, guard},
           {0, 1, 0, guard},
           {0, -1, 0, guard}}};
}

unsigned outcode(const std::array<ClipPlane, 6>& planes, const glm::dvec4& p) {
  unsigned code = 0;
  for (unsigned k = 0; k < planes.size(); ++k)
    if (!(glm::dot(planes[k], p) >= 0.0)) code |= 1u << k;
  return code;
}

void clip(std::vector<glm::dvec4>& polygon, const std::array<ClipPlane, 6>& planes, unsigned planesMask) {
  std::vector<glm::dvec4> kept;
  for (unsigned k = 0; k < planes.size() && !polygon.empty(); ++k) {
    if (!(planesMask >> k & 1u)) continue;
    kept.clear();
    glm::dvec4 a = polygon.back();
    double heightA = glm::dot(planes[k], a);
    for (const glm::dvec4& b : polygon) {
      const double heightB = glm::dot(planes[k], b);
      const bool insideA = heightA >= 0.0, insideB = heightB >= 0.0;
      if (insideA && !insideB) kept.push_back(a + (b - a) * (heightA / (heightA - heightB)));
      if (!insideA && insideB) kept.push_back(b + (a - b) * (heightB / (heightB - heightA)));
      if (insideB) kept.push_back(b);
      a = b;
      heightA = heightB;
    }
    polygon.swap(kept);
  }
}
