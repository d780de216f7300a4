#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <random>

#include "depthsort/depth_sort.h"
#include "depthsort/oracle.h"
#include "geometry/model/coplanar.h"
#include "tests/support/doubt.h"
#include "tests/support/painted.h"
#include "tests/support/random_wall.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kSize = 160;

/// A view from any side of the wall, from far away to as near as a fifth of a decal, steep or slanted.
/// Parallel and perspective views take turns.
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

/// Which face covers each sample last, for faces without depth.
std::vector<int> lastFaces(SnappedScene scene) {
  scene.planes = {};
  scene.planes.add({});
  for (SnappedFace& face : scene.faces) face.plane = 0;
  return visibleFaces(scene, kSize, kSize);
}

constexpr int kPlates = 5;  ///< number of the first plate, after the wall and its decals

/// Adds two plates that pass through the wall and its decals, near the middle of the decal that the view
/// looks at. They are rounded as the wall and the decals are.
void addCrossingPlates(Mesh& mesh, unsigned seed) {
  std::mt19937 rng{seed + 2};
  std::uniform_real_distribution<double> component{-1.0, 1.0};
  const auto corner = [&](int f, int c) { return mesh.points[mesh.face(f)[c]]; };
  const int decal = 1 + static_cast<int>(seed % 4);
  const glm::dvec3 a = glm::normalize(corner(0, 1) - corner(0, 0)),
                   N = glm::normalize(glm::cross(a, corner(0, 3) - corner(0, 0))), b = glm::cross(N, a);
  const glm::dvec3 middle = (corner(decal, 0) + corner(decal, 2)) / 2.0;
  for (int k = 0; k < 2; ++k) {
    const double angle = 3.0 * component(rng);
    const glm::dvec3 at = middle + 0.01 * (component(rng) * a + component(rng) * b);
    const glm::dvec3 along = std::cos(angle) * a + std::sin(angle) * b;
    const glm::dvec3 through = glm::normalize(N + component(rng) * glm::cross(N, along));
    addRounded(mesh,
               {at - 0.2 * along - 0.1 * through, at + 0.2 * along - 0.1 * through,
                at + 0.2 * along + 0.1 * through, at - 0.2 * along + 0.1 * through},
               kDecimals[seed % kDecimals.size()]);
  }
}

/// The number of the face of the wall or its decals that covers each sample last, as if there were no plates.
std::vector<int> lastOfWall(SnappedScene scene) {
  std::erase_if(scene.faces, [](const SnappedFace& face) { return face.number >= kPlates; });
  std::vector<int> last = lastFaces(scene);
  for (int& face : last)
    if (face != kNothing) face = scene.faces[face].number;
  return last;
}

}  // namespace

// Faces in one plane are seen in the order of the scene, in every sample of every view. If each face has its
// own plane, thousands of samples are wrong.
TEST(Decals, TheLaterIsSeen) {
  long decalSamples = 0, nearSamples = 0, lostWithout = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = normalised(wallWithDecals(seed), std::pow(10.0, static_cast<int>(seed % 13) - 6));
    ConvexParts parts = divideFaces(mesh);
    const std::vector<int> ownPlanes = parts.plane;
    uniteCoplanar(mesh, parts);
    const ViewSpec view = randomView(mesh, seed);
    const SnappedScene scene = project(mesh, parts, view, kSize, kSize, Cull::Keep);
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
    parts.plane = ownPlanes, parts.planes = {}, parts.own = {}, parts.frame.reset();
    const std::vector<int> without =
        visibleFaces(project(mesh, parts, view, kSize, kSize, Cull::Keep), kSize, kSize);
    for (std::size_t k = 0; k < seen.size(); ++k) lostWithout += without[k] != last[k];
  }
  EXPECT_GT(decalSamples, 1'000'000);
  EXPECT_GT(nearSamples, 300'000);
  EXPECT_GT(lostWithout, 100'000);
}

// The depth sort loses none of a decal's pixels to the face under it, even if both are split. Two plates pass
// through the wall and its decals, and each choice of the polygon to split is tried.
TEST(Decals, KeepTheirPixelsWhenSplit) {
  constexpr std::array kSplits{SortSettings::Split::Smaller, SortSettings::Split::First,
                               SortSettings::Split::Second};
  long plateSamples = 0, wallPieces = 0, decalPieces = 0, platePieces = 0;
  std::array<long, 2> decalSamples{};  // for parallel and for perspective views
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    const double scale = std::pow(10.0, static_cast<int>(seed % 13) - 6);
    Mesh mesh = wallWithDecals(seed);
    addCrossingPlates(mesh, seed);
    mesh = normalised(mesh, scale);
    ConvexParts parts = divideFaces(mesh);
    uniteCoplanar(mesh, parts);
    const ViewSpec view = randomView(mesh, seed);
    const SnappedScene scene = project(mesh, parts, view, kSize, kSize, Cull::Keep);
    const std::vector<int> last = lastOfWall(scene), seen = visibleFaces(scene, kSize, kSize);
    for (const bool textbook : {false, true}) {
      SortSettings settings{kSize, kSize, textbook};
      settings.crossing = kSplits[seed % kSplits.size()];
      const SortedScene sorted = depthSort(scene, settings);
      const std::vector<int> shown = painted(scene, sorted, kSize, kSize);
      int lost = 0, wrong = 0;
      for (std::size_t k = 0; k < shown.size(); ++k) {
        wrong += shown[k] != seen[k] && !mayTouch(scene, shown[k], seen[k], static_cast<int>(k), kSize);
        if (shown[k] == kNothing) continue;
        const bool plate = scene.faces[shown[k]].number >= kPlates;
        plateSamples += plate;
        if (plate) continue;
        lost += scene.faces[shown[k]].number != last[k];
        decalSamples[seed % 2] += last[k] > 0;
      }
      EXPECT_EQ(lost, 0);
      EXPECT_EQ(wrong, 0);
      for (const Fragment& fragment : sorted.fragments) {
        const int number = scene.faces[fragment.face].number;
        if (fragment.piece >= 0) ++(number == 0 ? wallPieces : number < kPlates ? decalPieces : platePieces);
      }
    }
  }
  EXPECT_GT(decalSamples[0], 1'000'000);
  EXPECT_GT(decalSamples[1], 1'000'000);
  EXPECT_GT(plateSamples, 1'000'000);
  EXPECT_GT(wallPieces, 500);
  EXPECT_GT(decalPieces, 500);
  EXPECT_GT(platePieces, 1'000);
}

}  // namespace xnewell::THIS_FILE
