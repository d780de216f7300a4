#include "geometry/exact/plane.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace xnewell {

glm::dvec3 newellVector(std::span<const glm::dvec3> points, std::span<const int> corners) {
  const glm::dvec3 origin = points[corners.front()];
  glm::dvec3 sum{0.0};
  glm::dvec3 a = points[corners.back()] - origin;
  for (const int corner : corners) {
    const glm::dvec3 b = points[corner] - origin;
    sum.x += (a.y - b.y) * (a.z + b.z);
    sum.y += (a.z - b.z) * (a.x + b.x);
    sum.z += (a.x - b.x) * (a.y + b.y);
    a = b;
  }
  return sum;
}

glm::dvec3 centroid(std::span<const glm::dvec3> points, std::span<const int> corners) {
  const glm::dvec3 origin = points[corners.front()];
  glm::dvec3 sum{0.0};
  for (const int corner : corners) sum += points[corner] - origin;
  return origin + sum / static_cast<double>(corners.size());
}

Plane newellPlane(std::span<const glm::dvec3> points, std::span<const int> corners) {
  const glm::dvec3 v = newellVector(points, corners);
  const double length = std::sqrt(glm::dot(v, v));
  if (!(length > 0.0)) return {};
  const glm::dvec3 N = v / length;
  return {N, glm::dot(N, centroid(points, corners))};
}

}  // namespace xnewell
