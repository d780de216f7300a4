#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <random>

#include "depthsort/oracle.h"
#include "geometry/coplanar.h"
#include "random_wall.h"

namespace {

constexpr int kSize = 160;

/// Any side of the wall, from far to as near as a fifth of a decal, steep and slanted, parallel and
/// perspective by turns.
ViewSpec randomView(const Mesh& mesh, unsigned seed) {
  std::mt19937 rng{seed + 1};
  std::uniform_real_distribution<double> component{-1.0, 1.0};
  const auto corner = [&](int f, int c) { return mesh.points[mesh.face(f)[c]]; };
  const glm::dvec3 target = (corner(1 + seed % 4, 0) + corner(1 + seed % 4, 2)) / 2.0;
  glm::dvec3 towards;
  do towards = {component(rng), component(rng), component(rng)};
  while (glm::length(towards) < 0.1);
  const bool near = seed / 2 % 2;
  const double scale = glm::length(corner(0, 1) - corner(0, 0));
  const double distance = scale * (near ? 0.02 : 1.5), window = scale * (near ? 0.02 : 0.6);
  return {seed % 2 ? Projection::Perspective : Projection::Parallel,
          target,
          towards,
          {0.3, 0.2, 0.9},
          {0, 0, distance},
          glm::dvec2{-window},
          glm::dvec2{window},
          distance * 0.999,
          -3 * scale};
}

Mesh normalised(Mesh mesh, double scale) {
  for (glm::dvec3& p : mesh.points) p *= scale;
  for (double& u : mesh.rounding) u *= scale;
  double largest = 0.0;
  for (const glm::dvec3& p : mesh.points)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (glm::dvec3& p : mesh.points)
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::ldexp(p[axis], -exponent);
  for (double& u : mesh.rounding) u = std::ldexp(u, -exponent);
  return mesh;
}

/// Which face covers each sample last, of faces that have no depth.
std::vector<int> lastFaces(SnappedScene scene) {
  scene.planes.assign(1, ScreenPlane{});
  for (SnappedFace& face : scene.faces) face.plane = 0;
  return visibleFaces(scene, kSize, kSize);
}

}  // namespace

// Faces in one plane are seen in the scene's order, in every sample of every view. With a plane of its own
// for each, samples are lost by the thousand.
TEST(Decals, TheLaterIsSeen) {
  long decalSamples = 0, nearSamples = 0, lostWithout = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = normalised(wallWithDecals(seed), std::pow(10.0, static_cast<int>(seed % 13) - 6));
    Pieces pieces = divideFaces(mesh);
    const std::vector<int> ownPlanes = pieces.plane;
    pieces.plane = coplanarClasses(mesh, pieces);
    const ViewSpec view = randomView(mesh, seed);
    const SnappedScene scene = project(mesh, pieces, view, kSize, kSize, Cull::Keep);
    const std::vector<int> seen = visibleFaces(scene, kSize, kSize), last = lastFaces(scene);
    int lost = 0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      lost += seen[k] != last[k];
      const bool decal = last[k] != kNothing && scene.faces[last[k]].number > 0;
      decalSamples += decal;
      nearSamples += decal && seed / 2 % 2;
    }
    EXPECT_EQ(lost, 0);
    EXPECT_LE(scene.planes.size(), 1u);
    pieces.plane = ownPlanes;
    const std::vector<int> without =
        visibleFaces(project(mesh, pieces, view, kSize, kSize, Cull::Keep), kSize, kSize);
    for (std::size_t k = 0; k < seen.size(); ++k) lostWithout += without[k] != last[k];
  }
  EXPECT_GT(decalSamples, 1'000'000);
  EXPECT_GT(nearSamples, 300'000);
  EXPECT_GT(lostWithout, 100'000);
}
