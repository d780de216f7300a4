#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "geometry/exact/unit.h"
#include "geometry/model/vertex_normals.h"

namespace xnewell {

/// Meshes, turned and cut, and the normals that smoothVertices() gives to their corners.

inline constexpr std::array kComputed{NormalRule::Sum, NormalRule::Distinct, NormalRule::Area,
                                      NormalRule::Angle};

inline Mesh meshOf(std::vector<glm::dvec3> points, const std::vector<std::vector<int>>& faces) {
  Mesh mesh;
  mesh.groupNames = {"mesh"};
  mesh.points = std::move(points);
  for (const std::vector<int>& face : faces) mesh.addFace(face, 0);
  return mesh;
}

inline double distance(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b); }

/// The normal of every corner.
inline std::vector<glm::dvec3> normals(const Mesh& mesh, NormalRule rule, double crease = 180.0,
                                       std::span<const glm::dvec3> exact = {}) {
  const Vertices v = smoothVertices(mesh, rule, crease, exact);
  std::vector<glm::dvec3> N;
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    const Vertex& vertex = v.vertices[v.ofCorner[c]];
    EXPECT_EQ(vertex.point, mesh.corners[c]);
    N.push_back(vertex.N);
    for (int axis = 0; axis < 3; ++axis) EXPECT_FALSE(vertex.N[axis] == 0.0 && std::signbit(vertex.N[axis]));
  }
  return N;
}

/// With all corners of a point alike, the normal of every point.
inline std::vector<glm::dvec3> pointNormals(const Mesh& mesh, NormalRule rule) {
  std::vector<glm::dvec3> N(mesh.points.size(), glm::dvec3{0.0});
  for (const Vertex& v : smoothVertices(mesh, rule).vertices) {
    EXPECT_EQ(N[v.point], glm::dvec3{0.0}) << "one vertex a point";
    N[v.point] = v.N;
  }
  return N;
}

/// Every face of a mesh of convex faces cut into triangles, from a random corner each.
inline Mesh cut(const Mesh& mesh, std::mt19937& rng) {
  Mesh triangles;
  triangles.groupNames = mesh.groupNames;
  triangles.points = mesh.points;
  triangles.rounding = mesh.rounding;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    const std::size_t n = face.size(), first = rng() % n;
    for (std::size_t i = 2; i < n; ++i)
      triangles.addFace(std::array{face[first], face[(first + i - 1) % n], face[(first + i) % n]}, 0);
  }
  return triangles;
}

inline glm::dvec3 randomDirection(std::mt19937& rng) {
  std::uniform_real_distribution<double> coordinate{-1.0, 1.0};
  for (;;) {
    const double x = coordinate(rng), y = coordinate(rng), z = coordinate(rng);
    const double square = x * x + y * y + z * z;
    if (0.01 < square && square < 1.0) return unit({x, y, z});
  }
}

inline glm::dmat3 randomRotation(std::mt19937& rng) {
  const glm::dvec3 x = randomDirection(rng), y = unit(glm::cross(x, randomDirection(rng)));
  return {x, y, glm::cross(x, y)};
}

inline void turn(Mesh& mesh, const glm::dmat3& rotation) {
  for (glm::dvec3& p : mesh.points) p = rotation * p;
}

}  // namespace xnewell
