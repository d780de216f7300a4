#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "geometry/exact/trig.h"
#include "geometry/model/mesh.h"
#include "geometry/model/vertex_normals.h"

namespace xnewell {

/// The errors in degrees of a rule's normals against the normals of the surface that the faces approximate.
struct NormalError {
  double mean = 0.0, max = 0.0;
  int corners = 0;
};

/// The errors over all corners of a mesh where the true normal is known, that is, not 0.
[[nodiscard]] inline NormalError normalError(const Mesh& mesh, NormalRule rule,
                                             std::span<const glm::dvec3> truth) {
  const Vertices v = smoothVertices(mesh, rule);
  NormalError error;
  for (std::size_t c = 0; c < truth.size(); ++c) {
    if (truth[c] == glm::dvec3{0.0}) continue;
    const glm::dvec3 N = v.vertices[v.ofCorner[c]].N;
    const double degrees = degreesOf(glm::length(glm::cross(N, truth[c])), glm::dot(N, truth[c]));
    error.mean += degrees;
    error.max = std::max(error.max, degrees);
    ++error.corners;
  }
  error.mean /= error.corners;
  return error;
}

/// The normals of a unit sphere about the origin, at the corners of a mesh that approximates it.
[[nodiscard]] inline std::vector<glm::dvec3> sphereNormals(const Mesh& mesh) {
  std::vector<glm::dvec3> normals;
  for (const int corner : mesh.corners) normals.push_back(glm::normalize(mesh.points[corner]));
  return normals;
}

/// `truth` without the corners of points where it differs by more than a degree: where patches meet in a
/// crease, no rule that smooths everything can be right.
[[nodiscard]] inline std::vector<glm::dvec3> withoutCreases(const Mesh& mesh, std::vector<glm::dvec3> truth) {
  std::vector<glm::dvec3> first(mesh.points.size(), glm::dvec3{0.0});
  std::vector<char> creased(mesh.points.size(), 0);
  for (std::size_t c = 0; c < truth.size(); ++c) {
    if (truth[c] == glm::dvec3{0.0}) continue;
    glm::dvec3& N = first[mesh.corners[c]];
    if (N == glm::dvec3{0.0}) N = truth[c];
    if (glm::dot(N, truth[c]) < sinCosDegrees(1.0).cos) creased[mesh.corners[c]] = 1;
  }
  for (std::size_t c = 0; c < truth.size(); ++c)
    if (creased[mesh.corners[c]]) truth[c] = glm::dvec3{0.0};
  return truth;
}

}  // namespace xnewell
