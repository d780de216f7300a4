#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "geometry/model/fit_plane.h"
#include "geometry/model/sheets.h"

namespace xnewell::THIS_FILE {

namespace {

void add(Mesh& mesh, const std::vector<glm::dvec3>& corners) {
  std::vector<int> face(corners.size());
  std::iota(face.begin(), face.end(), static_cast<int>(mesh.points.size()));
  mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
  mesh.addFace(face, 0);
}

/// A wavy sheet of n x n faces, about 1 long, with decals on every eighth of them, and one long face that
/// makes the scene 1 / share as large.
Mesh sheetBesideFarCorner(int n, double share, unsigned seed) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  Mesh mesh;
  mesh.groupNames = {""};
  const auto at = [&](double i, double j) {
    return glm::dvec3{i / n, j / n, 0.1 * std::sin(7.0 * i / n) + 0.2 * std::cos(5.0 * j / n)};
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const glm::dvec3 a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1);
      add(mesh, {a, b, c});
      if (unit(rng) > 0.125) continue;
      const auto inside = [&](double s, double t) { return a + s * (b - a) + t * (c - b); };
      add(mesh, {a, b, c});
      add(mesh, {inside(0.5, 0.1), inside(0.9, 0.1), inside(0.9, 0.4)});
    }
  const double far = (seed % 2 == 0 ? 1.0 : -1.0) / share;
  add(mesh, {{0.3, 0.3, 0.0}, {0.6, far, 0.0}, {0.6, 0.4, 0.01}});
  add(mesh, {{0.2, 0.2, 0.1}, {0.7, 0.2, 0.15}, {0.7, 0.8, 0.1}});
  return mesh;
}

using Pairs = std::set<std::pair<int, int>>;

Pairs nearPairs(const Sheets& sheets, std::size_t& visits) {
  Pairs visited;
  sheets.forAllNear([&](const SheetPart& P, const SheetPart& Q) {
    ++visits;
    visited.insert(std::minmax(P.part, Q.part));
  });
  return visited;
}

/// True if two parts overlap in area and one plane explains both, without a search for near ones.
bool inOnePlane(const Sheets& model, int i, int j) {
  const ModelSheet P = model.sheet(i), Q = model.sheet(j);
  const ModelSheet& larger = P.area > Q.area ? P : Q;
  if (model.parted({i, P}, {j, Q}, larger.plane.N)) return false;
  std::vector<RoundedPoint> both;
  for (const int sheet : {i, j})
    for (const int c : model.corners(sheet)) both.push_back({model.box.points[c], model.roundingOf(sheet)});
  return fitPlane(both, larger.plane, model.rounding, FitGoal::Explain).explains();
}

}  // namespace

// A scene may be so large that a detailed object is a speck in it, down to the size of rounding. No pair of
// faces that lies in one plane is missed.
TEST(FarCorner, NoPairIsMissed) {
  std::size_t joined = 0, apart = 0;
  unsigned seed = 0;
  for (const double share : {1e-3, 1e-6, 1e-8, 1e-10, 1e-11, 3e-12, 1e-12, 3e-13, 1e-13, 1e-14, 1e-30}) {
    SCOPED_TRACE(share);
    for (const double u : {0.0, 1e-4, 1.0}) {
      SCOPED_TRACE(u);
      Mesh mesh = sheetBesideFarCorner(34, share, seed++);
      if (u > 0.0) mesh.rounding = {u};
      const ConvexParts parts = divideFaces(mesh);
      ASSERT_EQ(parts.count(), mesh.faceCount());
      const Sheets sheets{mesh, parts};
      std::size_t visits = 0;
      const Pairs visited = nearPairs(sheets, visits);
      for (int i = 0; i < parts.count(); ++i)
        for (int j = i + 1; j < parts.count(); ++j) {
          if (!inOnePlane(sheets, i, j)) continue;
          ++joined;
          ASSERT_TRUE(visited.contains({i, j})) << i << ' ' << j;
        }
      apart += static_cast<std::size_t>(parts.count()) * parts.count() / 2 - visited.size();
    }
  }
  EXPECT_GT(joined, 1'000u);
  EXPECT_GT(apart, 10'000'000u);
}

// Whether a model is searched cell by cell or as a whole, the same pairs lie in one plane.
TEST(FarCorner, CellsMissNoPair) {
  std::size_t joined = 0;
  for (const double share : {1.0, 0.3, 1e-2, 1e-7, 1e-14}) {
    SCOPED_TRACE(share);
    Mesh mesh = sheetBesideFarCorner(75, share, 7);
    mesh.rounding = {1e-5};
    const ConvexParts parts = divideFaces(mesh);
    ASSERT_GT(static_cast<std::size_t>(parts.count()), kManyBoxes);
    const Sheets sheets{mesh, parts};
    Pairs byCells, asAWhole;
    const auto addTo = [&](Pairs& pairs) {
      return [&](const SheetPart& P, const SheetPart& Q) {
        if (!sheets.tooFar(P, Q)) pairs.insert(std::minmax(P.part, Q.part));
      };
    };
    sheets.forAllNear(addTo(byCells));
    std::vector<int> all(parts.count());
    std::iota(all.begin(), all.end(), 0);
    sheets.forNear(all, addTo(asAWhole));
    std::erase_if(byCells, [&](const auto& pair) { return !inOnePlane(sheets, pair.first, pair.second); });
    std::erase_if(asAWhole, [&](const auto& pair) { return !inOnePlane(sheets, pair.first, pair.second); });
    EXPECT_EQ(byCells, asAWhole);
    joined += byCells.size();
  }
  EXPECT_GT(joined, 5'000u);
}

// Specks that are smaller than the rounding still lie in the plane of the floor under them. A needle has no
// room for them, however long it is.
TEST(FarCorner, SpecksLieOnTheFloor) {
  std::size_t joined = 0;
  for (const double share : {1e-3, 1e-13, 1e-14, 1e-16, 1e-30, 1e-200}) {
    SCOPED_TRACE(share);
    Mesh mesh = sheetBesideFarCorner(20, share, 4);
    const double far = 1.0 / share;
    add(mesh, {{-far, -far, 0.0}, {far, -far, 0.0}, {0.0, far, 0.0}});
    add(mesh, {{-far, 0.0, 0.1}, {far, 0.0, 0.1}, {0.0, 0.6, 0.1}});
    const ConvexParts parts = divideFaces(mesh);
    const Sheets sheets{mesh, parts};
    std::size_t visits = 0;
    const Pairs visited = nearPairs(sheets, visits);
    for (int i = 0; i < parts.count(); ++i)
      for (int j = i + 1; j < parts.count(); ++j) {
        const bool covers = sheets.sheet(i).area > 0.0 && sheets.sheet(j).area > 0.0;
        if (!covers || !inOnePlane(sheets, i, j)) continue;
        ++joined;
        ASSERT_TRUE(visited.contains({i, j})) << i << ' ' << j;
      }
  }
  EXPECT_GT(joined, 1'000u);
}

// One far corner of a patch makes needles of that patch's faces, and specks of all others. Each speck lies
// within the rounding of each needle's end.
TEST(FarCorner, SpecksAreNotComparedWithNeedles) {
  Mesh mesh = sheetBesideFarCorner(60, 1e-20, 6);
  for (int i = 0; i < 2'000; ++i)
    add(mesh, {{0.5, 0.001 * i, 0.0}, {0.5, 0.001 * i + 0.1, 0.0}, {0.5, 0.001 * i, 1e20 + 1e16 * i}});
  const ConvexParts parts = divideFaces(mesh);
  std::size_t withSpecks = 0;
  const int firstNeedle = parts.count() - 2'000;
  Sheets{mesh, parts}.forAllNear([&](const SheetPart& P, const SheetPart& Q) {
    withSpecks += std::min(P.part, Q.part) < firstNeedle - 2 && std::max(P.part, Q.part) >= firstNeedle;
  });
  EXPECT_EQ(withSpecks, 0u);
}

// The work grows with the number of faces, however large the scene is beside them. Faces that are not dust
// are at least about delta long here, and a place reaches two roundings further on each side. So about 10 x
// 10 faces are near, with their decals, and each pair may be visited twice.
TEST(FarCorner, FewPairsAreCompared) {
  for (double share = 1.0; share > 1e-20; share /= 7.0) {
    SCOPED_TRACE(share);
    const Mesh mesh = sheetBesideFarCorner(150, share, 5);
    const ConvexParts parts = divideFaces(mesh);
    std::size_t visits = 0;
    Sheets{mesh, parts}.forAllNear([&](const SheetPart&, const SheetPart&) { ++visits; });
    EXPECT_LT(visits, 300u * static_cast<std::size_t>(parts.count()));
  }
}

}  // namespace xnewell::THIS_FILE
