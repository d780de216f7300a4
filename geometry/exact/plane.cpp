#include "geometry/exact/plane.h"

#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/exact/box.h"
#include "geometry/exact/scale.h"

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

namespace {

glm::dvec3 meanOf(std::span<const glm::dvec3> points, std::span<const int> corners) {
  const glm::dvec3 origin = points[corners.front()];
  glm::dvec3 sum{0.0};
  for (const int corner : corners) sum += points[corner] - origin;
  return origin + sum / static_cast<double>(corners.size());
}

}  // namespace

glm::dvec3 centroid(std::span<const glm::dvec3> points, std::span<const int> corners) {
  if (corners.size() == 3) return meanOf(points, corners);
  const glm::dvec3 N = unit(newellVector(points, corners));
  if (N == glm::dvec3{0.0}) return meanOf(points, corners);
  // The polygon is the sum of the triangles from the first corner to each side. Those that lie outside count
  // as negative. Each has its centroid at a third of a + b.
  const glm::dvec3 origin = points[corners.front()];
  const auto eachTriangle = [&](const auto& use) {
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      const glm::dvec3 a = points[corners[k]] - origin, b = points[corners[k + 1]] - origin;
      use(a, b, glm::dot(glm::cross(a, b), N));
    }
  };
  double area = 0.0;  // doubled
  Box box;            // relative to the origin
  box.add(glm::dvec3{0.0});
  eachTriangle([&](const glm::dvec3& a, const glm::dvec3& b, double doubled) {
    area += doubled;
    box.add(a), box.add(b);
  });
  if (!(area > 0.0)) return meanOf(points, corners);
  glm::dvec3 centre{0.0};
  eachTriangle([&](const glm::dvec3& a, const glm::dvec3& b, double doubled) {
    centre += (a + b) * (doubled / area / 3.0);
  });
  return origin + glm::clamp(centre, box.low, box.high);
}

Plane newellPlane(std::span<const glm::dvec3> points, std::span<const int> corners) {
  const glm::dvec3 v = newellVector(points, corners);
  const double length = std::sqrt(glm::dot(v, v));
  if (!(length > 0.0)) return {};
  const glm::dvec3 N = v / length;
  return {N, glm::dot(N, meanOf(points, corners))};
}

}  // namespace xnewell
