#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <glm/geometric.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "geometry/exact/plane.h"
#include "geometry/exact/scale.h"
#include "geometry/files/bpt.h"
#include "geometry/model/bezier.h"
#include "geometry/model/edges.h"
#include "tests/support/extended.h"
#include "tests/support/sha256.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Bezier patches

using Wide = glm::vec<3, Extended>;

BezierPatch randomPatch(std::mt19937& rng) {
  std::uniform_real_distribution<double> coordinate{-4.0, 4.0};
  BezierPatch patch;
  for (glm::dvec3& p : patch.p) p = {coordinate(rng), coordinate(rng), coordinate(rng)};
  return patch;
}

/// The unit square of the plane z = 0: S(u, v) = (u, v, 0).
BezierPatch flatPatch() {
  BezierPatch patch;
  for (int i = 0; i < 16; ++i) patch.p[i] = {i / 4 / 3.0, i % 4 / 3.0, 0.0};
  return patch;
}

BezierPatch transposed(const BezierPatch& patch) {
  BezierPatch t;
  for (int i = 0; i < 16; ++i) t.p[i] = patch.p[4 * (i % 4) + i / 4];
  return t;
}

/// De Casteljau's construction with 64 bits: the value and the derivative of a cubic.
struct Cubic {
  Wide value, slope;
};
Cubic deCasteljau(std::array<Wide, 4> p, Extended t) {
  const auto mix = [t](const Wide& a, const Wide& b) { return (1 - t) * a + t * b; };
  const Wide a = mix(p[0], p[1]), b = mix(p[1], p[2]), c = mix(p[2], p[3]);
  const Wide ab = mix(a, b), bc = mix(b, c);
  return {mix(ab, bc), Extended{3} * (bc - ab)};
}

struct Oracle {
  Wide point, du, dv;
};
Oracle oracle(const BezierPatch& patch, Extended u, Extended v) {
  std::array<Wide, 4> rows, columns;
  for (int i = 0; i < 4; ++i) {
    std::array<Wide, 4> row, column;
    for (int j = 0; j < 4; ++j) {
      row[j] = patch.p[4 * i + j];
      column[j] = patch.p[4 * j + i];
    }
    rows[i] = deCasteljau(row, v).value;
    columns[i] = deCasteljau(column, u).value;
  }
  return {deCasteljau(rows, u).value, deCasteljau(rows, u).slope, deCasteljau(columns, v).slope};
}

glm::dvec3 oracleNormal(const BezierPatch& patch, Extended u, Extended v) {
  const Oracle o = oracle(patch, u, v);
  return glm::dvec3{glm::normalize(glm::cross(o.du, o.dv))};
}

double distance(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b); }

std::array<std::uint64_t, 3> bits(const glm::dvec3& p) {
  return {std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
          std::bit_cast<std::uint64_t>(p.z)};
}

// Faces run counter-clockwise seen from the side of du x dv. They are numbered row by row. Their corners are
// (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1).
TEST(Bezier, FacesAreNumberedRowByRowAndFaceDuCrossDv) {
  const Mesh mesh = tessellate(std::array{flatPatch()}, 4);
  ASSERT_EQ(mesh.faceCount(), 16);
  EXPECT_EQ(mesh.points.size(), 25u);
  for (int f = 0; f < 16; ++f) {
    ASSERT_EQ(mesh.face(f).size(), 4u);
    const double u = f / 4 / 4.0, v = f % 4 / 4.0;
    EXPECT_LT(distance(mesh.points[mesh.face(f)[0]], {u, v, 0.0}), 0x1p-50);
    EXPECT_LT(distance(mesh.points[mesh.face(f)[1]], {u + 0.25, v, 0.0}), 0x1p-50);
    EXPECT_GT(newellVector(mesh.points, mesh.face(f)).z, 0.0);
  }
  EXPECT_TRUE(mesh.rounding.empty());
  EXPECT_EQ(mesh.groupNames, std::vector<std::string>{""});
  EXPECT_EQ(normal(flatPatch(), 0.25, 0.75), glm::dvec3(0, 0, 1));
}

// Faces belong to their patch's part. Patch k owns the numbers from k * N * N on.
TEST(Bezier, PartsBecomeGroups) {
  const std::array patches{flatPatch(), flatPatch(), flatPatch()};
  const std::array parts{PatchPart{"one", 1}, PatchPart{"two", 2}};
  const Mesh mesh = tessellate(patches, 3, parts);
  EXPECT_EQ(mesh.groupNames, (std::vector<std::string>{"one", "two"}));
  for (int f = 0; f < 27; ++f) EXPECT_EQ(mesh.group[f], f < 9 ? 0 : 1);
}

// A patch with reversed rows or columns, and a mirrored patch, give the same points to the bit, for any
// number of divisions.
TEST(Bezier, ReversalAndReflectionChangeNoBit) {
  std::mt19937 rng{1975};
  for (int n = 1; n <= 64; ++n) {
    const BezierPatch patch = randomPatch(rng);
    BezierPatch reversed = patch, mirrored = patch;
    std::reverse(reversed.p.begin(), reversed.p.end());
    for (glm::dvec3& p : mirrored.p) p.y = -p.y;
    const Mesh a = tessellate(std::array{patch}, n), b = tessellate(std::array{reversed}, n);
    const Mesh c = tessellate(std::array{mirrored}, n);
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i) {
      EXPECT_EQ(bits(a.points[i]), bits(b.points[a.points.size() - 1 - i]));
      EXPECT_EQ(bits(a.points[i]), bits(c.points[i] * glm::dvec3{1, -1, 1}));
    }
  }
}

// Two patches with a common edge share its n + 1 vertices, in whichever of the eight ways the second patch
// runs along the edge.
TEST(Bezier, NeighboursShareTheVerticesOfTheirEdge) {
  std::mt19937 rng{1984};
  for (int n : {1, 3, 7, 10, 49}) {
    const BezierPatch left = randomPatch(rng);
    BezierPatch right = randomPatch(rng);
    for (int i = 0; i < 4; ++i) right.p[4 * i] = left.p[4 * i + 3];
    for (int way = 0; way < 8; ++way) {
      BezierPatch turned = way & 1 ? transposed(right) : right;
      if (way & 2) std::reverse(turned.p.begin(), turned.p.end());
      if (way & 4)
        for (int row = 0; row < 4; ++row)
          std::swap_ranges(&turned.p[4 * row], &turned.p[4 * row + 2],
                           std::reverse_iterator{&turned.p[4 * row + 4]});
      const Mesh mesh = tessellate(std::array{left, turned}, n);
      EXPECT_EQ(mesh.points.size(), 2u * (n + 1) * (n + 1) - (n + 1)) << n << " way " << way;
    }
  }
}

// At a pole the quads are triangles. A patch that is a curve keeps its quads, so that later faces keep their
// numbers.
TEST(Bezier, DegenerateQuadsKeepTheirNumbers) {
  BezierPatch pole = flatPatch(), curve = flatPatch();
  for (int j = 0; j < 4; ++j) pole.p[j] = {-1.0, 0.5, 0.0};
  for (int i = 0; i < 16; ++i) curve.p[i] = flatPatch().p[4 * (i / 4)];
  const Mesh mesh = tessellate(std::array{pole, curve, flatPatch()}, 5);
  ASSERT_EQ(mesh.faceCount(), 75);
  for (int f = 0; f < 75; ++f) EXPECT_EQ(mesh.face(f).size(), f < 5 ? 3u : 4u) << f;
  EXPECT_EQ(newellVector(mesh.points, mesh.face(30)), glm::dvec3{0.0});
}

// A negative zero is the same place as a positive one.
TEST(Bezier, NegativeZeroIsWelded) {
  BezierPatch negative = flatPatch();
  for (glm::dvec3& p : negative.p) p = {p.x, p.y, -0.0};
  EXPECT_EQ(tessellate(std::array{flatPatch(), negative}, 3).points.size(), 16u);
}

// Where du x dv vanishes, the normal is its limit. It agrees with the normal of 64 bits a step h towards the
// middle of the patch, up to the O(h) that the normal turns on the way.
TEST(Bezier, NormalIsTheLimitAtDegeneratePlaces) {
  constexpr double h = 1e-7;
  const auto expectLimit = [&](const BezierPatch& patch, double u, double v) {
    const Oracle o = oracle(patch, u, v);
    EXPECT_LT(static_cast<double>(glm::length(glm::cross(o.du, o.dv))), 1e-12);  // it is really degenerate
    const glm::dvec3 nearby = oracleNormal(patch, u + h * (0.5 - u), v + h * (0.5 - v));
    EXPECT_LT(distance(normal(patch, u, v), nearby), 1e-4) << u << ' ' << v;
  };
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const BezierPatch patch = randomPatch(rng);
    const double along = std::uniform_real_distribution<double>{0.1, 0.9}(rng);

    BezierPatch firstRow = patch, lastRow = patch, twoRows = patch;
    for (int j = 0; j < 4; ++j) {
      firstRow.p[j] = patch.p[0];
      lastRow.p[12 + j] = patch.p[12];
      twoRows.p[j] = twoRows.p[4 + j] = patch.p[j];  // du = 0 along the edge
    }
    for (const double v : {0.0, along, 1.0}) {
      expectLimit(firstRow, 0.0, v);
      expectLimit(transposed(firstRow), v, 0.0);
      expectLimit(lastRow, 1.0, v);
      expectLimit(transposed(lastRow), v, 1.0);
      expectLimit(twoRows, 0.0, v);
    }

    BezierPatch corner = patch, tangent = patch;
    corner.p[1] = patch.p[0];
    expectLimit(corner, 0.0, 0.0);
    tangent.p[4] = patch.p[0] + 2.0 * (patch.p[1] - patch.p[0]);  // both edges leave in one direction
    expectLimit(tangent, 0.0, 0.0);
  }
}

// A patch that is a curve or a point has no normal; the result is 0.
TEST(Bezier, NoNormalIsZero) {
  BezierPatch dot, curve, line;
  dot.p.fill({0.1, 0.2, 0.3});
  std::mt19937 rng{7};
  const BezierPatch patch = randomPatch(rng);
  for (int i = 0; i < 16; ++i) {
    curve.p[i] = patch.p[i / 4];
    line.p[i] = glm::dvec3{0.1, 0.7, 0.3} * patch.p[i].x;
  }
  for (const double u : {0.0, 0.3, 0.5, 1.0})
    for (const double v : {0.0, 0.5, 0.9, 1.0})
      for (const BezierPatch& p : {dot, curve, line}) EXPECT_EQ(normal(p, u, v), glm::dvec3{0.0});
}

// Scaling a patch by a power of two changes no bit of its normals.
TEST(Bezier, NormalDoesNotDependOnScale) {
  std::mt19937 rng{300};
  const BezierPatch patch = randomPatch(rng);
  for (const int exponent : {-1000, -400, 400, 1021}) {
    BezierPatch scaled = patch;
    for (glm::dvec3& p : scaled.p)
      for (int axis = 0; axis < 3; ++axis) p[axis] = std::ldexp(p[axis], exponent);
    EXPECT_EQ(normal(scaled, 0.25, 0.6), normal(patch, 0.25, 0.6)) << exponent;
  }
}

// There is one normal for each corner of the tessellation. It is the patch's normal at the corner's texture
// coordinates, which are its u and v. It points to the side from which the face runs counter-clockwise, and
// it is perpendicular to the edges in the surface. The patches have poles or none, and one patch is a curve
// and has no normals.
TEST(Bezier, CornerNormalsAreThoseOfThePatch) {
  int poles = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    // A gently curved patch: a facet turns by less than a right angle from its corners' normals.
    BezierPatch patch = flatPatch(), curve = flatPatch();
    std::uniform_real_distribution<double> height{-0.2, 0.2};
    for (glm::dvec3& p : patch.p) p.z = height(rng);
    BezierPatch pole = patch, other = transposed(patch);
    for (int j = 1; j < 4; ++j) pole.p[j] = other.p[4 * j] = pole.p[0];
    for (int i = 0; i < 16; ++i) curve.p[i] = flatPatch().p[4 * (i / 4)];
    const std::array patches{patch, pole, other, curve};
    const int n = 1 + static_cast<int>(seed) % 9;
    const Mesh mesh = tessellate(patches, n);
    const std::vector<glm::dvec3> normals = cornerNormals(patches, n);
    ASSERT_EQ(normals.size(), mesh.corners.size());
    ASSERT_EQ(mesh.uvOfCorner.size(), mesh.corners.size());
    for (int f = 0; f < mesh.faceCount(); ++f) {
      const BezierPatch& of = patches[f / (n * n)];
      poles += mesh.face(f).size() == 3;
      for (int c = mesh.firstCorner[f]; c < mesh.firstCorner[f + 1]; ++c) {
        const glm::dvec2 uv = mesh.uv[mesh.uvOfCorner[c]];
        ASSERT_LT(distance(mesh.points[mesh.corners[c]], point(of, uv.x, uv.y)), 1e-14);
        ASSERT_LT(distance(normals[c], normal(of, uv.x, uv.y)), 1e-11);
        const glm::dvec3 facet = newellVector(mesh.points, mesh.face(f));
        if (f < n * n) {
          ASSERT_GT(glm::dot(normals[c], facet), 0.0);
        }
        if (f >= 3 * n * n) {
          ASSERT_EQ(normals[c], glm::dvec3{0.0});
        }
      }
    }
  }
  EXPECT_GT(poles, 0);
}

/// ---- The teapot

class Teapot : public testing::Test {
 protected:
  std::vector<BezierPatch> patches = readBpt(XNEWELL_DATA_DIR "/teapot.bpt");
  void SetUp() override { ASSERT_EQ(patches.size(), 32u); }
};

/// The area of a tessellation, with every quad cut along its first diagonal.
double area(const Mesh& mesh) {
  double sum = 0.0;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    const glm::dvec3& a = mesh.points[face[0]];
    for (std::size_t i = 2; i < face.size(); ++i)
      sum += glm::length(glm::cross(mesh.points[face[i - 1]] - a, mesh.points[face[i]] - a)) / 2.0;
  }
  return sum;
}

// The 290 distinct control points are Newell's, by the checksum of their sorted list.
TEST_F(Teapot, ControlPointsHaveTheKnownChecksum) {
  std::set<std::string> lines;
  for (const BezierPatch& patch : patches)
    for (const glm::dvec3& p : patch.p) {
      char line[64];
      std::snprintf(line, sizeof line, "%.6f,%.6f,%.6f", p.x + 0.0, p.y + 0.0, p.z + 0.0);
      lines.insert(line);
    }
  EXPECT_EQ(lines.size(), 290u);
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  EXPECT_EQ(text.find("-0.000000"), std::string::npos);

  EXPECT_EQ(sha256(text), "89429611b6eeaf2988c815dea4494a30f9ed46a4dca77e618f5b857344add026");
}

// The areas are known from independent work. The choice of diagonal changes the coarsest by up to 0.0003, and
// a quarter of that with each doubling. The fourth decimal is rounded.
TEST_F(Teapot, AreasOfTessellations) {
  EXPECT_NEAR(area(tessellate(patches, 8, kTeapotParts)), 52.5370, 0.0003 + 0.00005);
  EXPECT_NEAR(area(tessellate(patches, 16)), 52.7959, 0.0003 / 4 + 0.00005);
  EXPECT_NEAR(area(tessellate(patches, 32)), 52.8614, 0.0003 / 16 + 0.00005);
  EXPECT_NEAR(area(tessellate(patches, 64)), 52.8778, 0.0003 / 64 + 0.00005);
}

// Neighbours share vertices. A ring of four patches has 4 n of them around, a tube of two halves has 2 n. The
// knob and the bottom start in a pole. Rim, upper body, lower body and bottom each share a circle with the
// next one, and the knob shares one with the lid. The handle's lower end touches the body in one point, (-2,
// 0, 0.9).
TEST_F(Teapot, NeighbouringPatchesAreWelded) {
  const int n = 6;
  const int openRings = 4 * (4 * n * (n + 1));  // rim, upper and lower body, lid
  const int closedRings = 2 * (4 * n * n + 1);  // knob, bottom
  const int tubes = 2 * (2 * n * (2 * n + 1));  // handle, spout
  const int shared = 4 * (4 * n) + 1;
  EXPECT_EQ(tessellate(patches, n).points.size(),
            static_cast<std::size_t>(openRings + closedRings + tubes - shared));
}

// The front of every patch is the outside. Patches that share an edge agree, also over the lip of the spout.
// Pot, lid, handle and spout have positive volumes, measured from a place at their openings.
TEST_F(Teapot, EveryPatchFacesOutward) {
  const Mesh mesh = tessellate(patches, 8, kTeapotParts);
  EXPECT_EQ(countEdges(mesh).turned, 0);
  using Names = std::set<std::string>;
  for (const auto& [names, opening] :
       {std::pair{Names{"rim", "upper body", "lower body", "bottom"}, glm::dvec3{0, 0, 2.4}},
        {Names{"lid", "knob"}, {0, 0, 2.4}},
        {Names{"handle"}, {-1.7, 0, 1.5}},
        {Names{"spout"}, {1.7, 0, 1}}}) {
    double volume = 0;
    for (int f = 0; f < mesh.faceCount(); ++f)
      if (names.contains(mesh.groupNames[mesh.group[f]]))
        volume += glm::dot(newellVector(mesh.points, mesh.face(f)), mesh.points[mesh.face(f)[0]] - opening);
    EXPECT_GT(volume, 0.1) << *names.begin();
  }
}

}  // namespace

}  // namespace xnewell::THIS_FILE
