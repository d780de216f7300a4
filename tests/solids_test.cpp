#include "geometry/solids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "geometry/plane.h"

namespace {

/// Every edge is run along once each way, so the surface is closed and its faces agree on a side.
void expectClosed(const Mesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) ++edges[{face[i], face[(i + 1) % face.size()]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
}

/// By the divergence theorem: positive if the faces look outward.
double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
    sum += glm::dot(newellVector(mesh.points, mesh.face(f)), centroid(mesh.points, mesh.face(f)));
  return sum / 6.0;
}

}  // namespace

// Closed, outward, of the known volume: 8; 4/3 pi and 2 pi^2 r^2 up to the inscribed polygons' deficit,
// which is below (2 pi / n)^2 / 4 a circle.
TEST(Solids, AreClosedAndFaceOutward) {
  const double pi = 3.141592653589793, deficit = (2 * pi / 60) * (2 * pi / 60) / 2;
  expectClosed(cube());
  EXPECT_EQ(volume(cube()), 8.0);
  const Mesh ball = sphere(60, 60), ring = torus(60, 60);
  EXPECT_EQ(ball.faceCount(), 3600);
  EXPECT_EQ(ring.faceCount(), 3600);
  expectClosed(ball);
  expectClosed(ring);
  expectClosed(sphere(3, 2));
  expectClosed(torus(3, 3));
  EXPECT_NEAR(volume(ball), 4 * pi / 3, 4 * pi / 3 * deficit);
  EXPECT_NEAR(volume(ring), 2 * pi * pi * 0.16, 2 * pi * pi * 0.16 * deficit);
}

// The soup is fixed by its seed: splitmix64's first number for seed 0 is 0xE220A8397B1DCDAF.
TEST(Solids, SoupIsTheSameOnEveryMachine) {
  const Mesh point = triangleSoup(1, 0.0, 0);
  EXPECT_EQ(point.points[0].x, static_cast<double>(0xE220A8397B1DCDAFu >> 11) * 0x1p-52 - 1.0);
  EXPECT_EQ(triangleSoup(100, 0.1, 7).points, triangleSoup(100, 0.1, 7).points);
  EXPECT_NE(triangleSoup(100, 0.1, 7).points, triangleSoup(100, 0.1, 8).points);
  for (const glm::dvec3& p : triangleSoup(1000, 0.1, 7).points)
    for (int axis = 0; axis < 3; ++axis) EXPECT_LE(std::abs(p[axis]), 1.1);
}
