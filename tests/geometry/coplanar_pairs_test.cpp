#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "geometry/exact/plane.h"
#include "geometry/model/coplanar.h"
#include "tests/support/random_wall.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

using Pts = std::vector<glm::dvec3>;

/// The classes as coplanar.h defines them, from all pairs of parts. It is for scenes where one plane explains
/// those parts and only those that were made in one plane, `madeIn` by face (-1 for none).
std::vector<int> classesOfAllPairs(const Mesh& mesh, const ConvexParts& parts,
                                   const std::vector<int>& madeIn) {
  const double u = mesh.rounding.empty() ? 0.0 : mesh.rounding[0];
  std::vector<int> classes = parts.plane;
  const auto parted = [&](int i, int j, const glm::dvec3& axis) {
    const auto P = parts.part(i);
    const double turns = glm::dot(newellVector(mesh.points, P), axis) > 0.0 ? 1.0 : -1.0;
    for (std::size_t k = 0; k < P.size(); ++k) {
      const glm::dvec3 a = mesh.points[P[k]], b = mesh.points[P[(k + 1) % P.size()]];
      const glm::dvec3 along = b - a - axis * glm::dot(axis, b - a);
      const double length = glm::length(along);
      const glm::dvec3 inwards = turns * glm::cross(axis, along) / length;
      if (std::ranges::all_of(parts.part(j), [&](int c) {
            const double beyond = std::abs(glm::dot(along, 2.0 * mesh.points[c] - a - b)) / (length * length);
            return glm::dot(inwards, mesh.points[c] - a) <=
                   (std::sqrt(2.0) * u + 1e-14) * (1.0 + std::clamp(beyond, 1.0, 3.0));
          }))
        return true;
    }
    return false;
  };
  for (int i = 0; i < parts.count(); ++i)
    for (int j = 0; j < i; ++j) {
      const int plane = madeIn[parts.face[i]];
      if (classes[i] == classes[j] || plane < 0 || plane != madeIn[parts.face[j]]) continue;
      const glm::dvec3 N = glm::abs(newellPlane(mesh.points, mesh.face(parts.face[j])).N);
      const glm::dvec3 axis = N.z >= N.x && N.z >= N.y ? glm::dvec3{0, 0, 1}
                              : N.y >= N.x             ? glm::dvec3{0, 1, 0}
                                                       : glm::dvec3{1, 0, 0};
      if (!parted(i, j, axis) && !parted(j, i, axis))
        std::replace(classes.begin(), classes.end(), int{classes[j]}, int{classes[i]});
    }
  std::vector<int> seen;  // numbered in order of the first part of each
  for (int& c : classes) {
    if (std::find(seen.begin(), seen.end(), c) == seen.end()) seen.push_back(c);
    c = static_cast<int>(std::find(seen.begin(), seen.end(), c) - seen.begin());
  }
  return classes;
}

/// A comb of 60 long teeth: one concave face, and the boxes of most of its parts overlap. Decals lie in its
/// plane, on a tooth, in a gap, over several teeth or behind its back. Triangles pass through it.
Mesh combWithDecals(unsigned seed) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  const Frame frame = randomFrame(rng);
  const int decimals = kDecimals[seed % kDecimals.size()];
  constexpr int kTeeth = 60;
  Mesh mesh;
  mesh.groupNames = {""};
  Pts comb{frame.at(0, 0), frame.at(1, 0)};
  for (int tooth = kTeeth - 1; tooth >= 0; --tooth) {
    comb.push_back(frame.at((tooth + 0.5) / kTeeth, 1.0));
    comb.push_back(frame.at((tooth + 0.0) / kTeeth, 0.1));
  }
  addRounded(mesh, comb, decimals);
  for (int k = 0; k < 120; ++k) {
    const glm::dvec3 off = k % 4 == 0 ? 0.01 * frame.N : glm::dvec3{0.0};
    const double size = k % 8 == 1 ? 0.1 : 0.002;
    const glm::dvec3 corner = frame.at(unit(rng), unit(rng)) + off, a = size * frame.a, b = size * frame.b;
    addRounded(mesh, {corner, corner + a, corner + a + b, corner + b}, decimals);
  }
  for (int k = 0; k < 60; ++k) {
    const auto point = [&] { return frame.at(unit(rng), unit(rng)) + (unit(rng) - 0.5) * frame.N; };
    addRounded(mesh, {point(), point(), point()}, decimals);
  }
  return mesh;
}

}  // namespace

// For a comb, decals in its plane and triangles across it, the classes are those that a comparison of all
// pairs of parts gives. The comb's parts are always in one class.
TEST(Coplanar, CombsAsAllPairsGiveThem) {
  const Seeds seeds{30};
  int onComb = 0, inGaps = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = combWithDecals(seed);
    const ConvexParts parts = divideFaces(mesh);
    const std::vector<int> classes = coplanarClasses(mesh, parts).plane;
    std::vector<int> madeIn(mesh.faceCount(), -1);
    madeIn[0] = 0;
    for (int k = 0; k < 120; ++k) madeIn[k + 1] = k % 4 == 0 ? 1 : 0;
    ASSERT_EQ(classes, classesOfAllPairs(mesh, parts, madeIn));
    const auto combParts = std::count(parts.face.begin(), parts.face.end(), 0);
    ASSERT_GT(combParts, 100);
    EXPECT_EQ(std::count(classes.begin(), classes.begin() + combParts, 0), combParts);
    for (int k = 0; k < 120; ++k) {
      const int decal = static_cast<int>(combParts) + k;
      onComb += classes[decal] == 0;
      inGaps += k % 4 != 0 && classes[decal] != 0;
    }
  }
  if (!seeds.all()) return;
  EXPECT_GT(onComb, 500);
  EXPECT_GT(inGaps, 500);
}

}  // namespace xnewell::THIS_FILE
