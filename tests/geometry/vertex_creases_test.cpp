#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "geometry/exact/trig.h"
#include "geometry/model/solids.h"
#include "tests/support/corner_normals.h"

namespace xnewell::THIS_FILE {

// Where corners at one point have normals of their own: at creases, at materials, and at faces that have no
// normal or opposite ones. The rules themselves: vertex_normals_test.cpp.

namespace {

/// Upright, of radius 1 and height 2, `sides` rectangles and two caps. Corner i of the bottom is point i.
Mesh cylinder(int sides) {
  Mesh mesh;
  mesh.groupNames = {"cylinder"};
  std::vector<int> top, bottom;
  for (int level = 0; level < 2; ++level)
    for (int i = 0; i < sides; ++i) {
      const auto [y, x] = sinCosDegrees(360.0 * i / sides);
      mesh.points.push_back({x, y, 2.0 * level - 1.0});
    }
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    mesh.addFace(std::array{i, next, sides + next, sides + i}, 0);
    top.push_back(sides + i);
    bottom.push_back(sides - 1 - i);
  }
  mesh.addFace(top, 0);
  mesh.addFace(bottom, 0);
  return mesh;
}

}  // namespace

// Of a cube, whose faces turn by 90 degrees, a crease below 90 leaves every face its own normal and three
// vertices a point; 90 itself counts as within, and one vertex is left, also for a cube turned about.
TEST(VertexNormals, CreaseOfACube) {
  std::mt19937 rng{90};
  for (int i = 0; i < 50; ++i) {
    Mesh mesh = cut(cube(), rng);
    if (i > 0) turn(mesh, randomRotation(rng));
    for (const NormalRule rule : kComputed) {
      for (const double crease : {0.0, 60.0, 89.999}) {
        const std::vector<glm::dvec3> N = normals(mesh, rule, crease);
        for (int c = 0; c < 36; ++c) {
          const auto face = mesh.face(c / 3);
          const glm::dvec3 flat = unit(glm::cross(mesh.points[face[1]] - mesh.points[face[0]],
                                                  mesh.points[face[2]] - mesh.points[face[0]]));
          EXPECT_LT(distance(N[c], flat), 1e-15);
        }
        if (i == 0) {
          EXPECT_EQ(smoothVertices(mesh, rule, crease).vertices.size(), 24u);
        }
      }
      for (const double crease : {90.0, 180.0})
        EXPECT_EQ(smoothVertices(mesh, rule, crease).vertices.size(), 8u) << crease;
    }
  }
}

// A cylinder of 12 sides turns by 30 degrees from side to side and by 90 to its caps. A crease of 30 to 89
// makes its sides round, their normals radial, and leaves its caps flat.
TEST(VertexNormals, CreaseOfACylinder) {
  const Mesh mesh = cylinder(12);
  for (const NormalRule rule : kComputed) {
    for (const double crease : {30.0, 60.0, 89.0}) {
      const std::vector<glm::dvec3> N = normals(mesh, rule, crease);
      for (int c = 0; c < 48; ++c) {
        const glm::dvec3 p = mesh.points[mesh.corners[c]];
        EXPECT_LT(distance(N[c], {p.x, p.y, 0.0}), 1e-14) << crease;
      }
      for (int c = 48; c < 72; ++c) EXPECT_EQ(N[c], glm::dvec3(0, 0, c < 60 ? 1 : -1));
      EXPECT_EQ(smoothVertices(mesh, rule, crease).vertices.size(), 48u);
    }
    EXPECT_EQ(smoothVertices(mesh, rule, 29.999).vertices.size(), 24u + 48u);
    EXPECT_EQ(smoothVertices(mesh, rule, 180.0).vertices.size(), 24u);
  }
}

// One point in two materials is two vertices, with one normal.
TEST(VertexNormals, MaterialsAreVerticesOfTheirOwn) {
  Mesh mesh = cube();
  mesh.materials = {{"a", glm::dvec3{1.0}}, {"b", glm::dvec3{1.0}}};
  mesh.material = {0, 1, 0, 1, 0, 1};
  const Vertices v = smoothVertices(mesh, NormalRule::Sum);
  EXPECT_EQ(v.vertices.size(), 8u + 6u) << "two opposite corners have one material only";
  const std::vector<glm::dvec3> N = normals(mesh, NormalRule::Sum);
  for (int c = 0; c < 24; ++c) {
    EXPECT_EQ(v.vertices[v.ofCorner[c]].material, mesh.material[c / 4]);
    EXPECT_LT(distance(N[c], mesh.points[mesh.corners[c]] / std::sqrt(3.0)), 1e-15);
  }
}

// Faces without area contribute nothing and take the normals of their points; where there are no others the
// normal is 0. A face that comes by a point twice counts once, its angles both; a repeated corner has no
// angle.
TEST(VertexNormals, DegenerateFaces) {
  const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0},  {0, 0, 1},
                                       {2, 0, 0}, {5, 5, 5}, {0, -1, 0}, {-1, 0, 0}};
  const Mesh lean = meshOf(points, {{0, 1, 2}, {0, 2, 3}});
  const Mesh fat = meshOf(points, {{0, 1, 2}, {0, 1, 4}, {0, 2, 3}, {0, 0, 2}, {5, 5, 5}});
  for (const NormalRule rule : kComputed)
    for (const double crease : {0.0, 180.0}) {
      const std::vector<glm::dvec3> a = normals(lean, rule, crease), b = normals(fat, rule, crease);
      EXPECT_TRUE(std::equal(a.begin(), a.begin() + 3, b.begin()));
      EXPECT_TRUE(std::equal(a.begin() + 3, a.end(), b.begin() + 6));
      EXPECT_LT(distance(b[3], unit({1, 0, 1})), 1e-15) << "of both faces at the point, whatever the crease";
      EXPECT_EQ(b[5], glm::dvec3{0.0});
      EXPECT_EQ(b[12], glm::dvec3{0.0});
    }

  // A floor with a hole, which a slit joins to its corner at the origin: two angles of 45 degrees there.
  const Mesh slit =
      meshOf({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {1, 2, 0}, {2, 1, 0}, {0, 0, 4}},
             {{0, 1, 2, 3, 0, 4, 5, 6, 4}, {0, 3, 7}});
  for (const NormalRule rule : {NormalRule::Sum, NormalRule::Distinct, NormalRule::Angle})
    EXPECT_LT(distance(pointNormals(slit, rule)[0], unit({1, 0, 1})), 1e-15);
  EXPECT_LT(distance(pointNormals(slit, NormalRule::Area)[0], unit({16, 0, 31})), 1e-15);
  const Mesh repeated = meshOf(points, {{0, 0, 1, 2, 2, 0}, {0, 2, 3}});
  for (const NormalRule rule : kComputed)
    EXPECT_LT(distance(pointNormals(repeated, rule)[0], pointNormals(lean, rule)[0]), 1e-15);
}

// Two faces back to back have no sum: each corner keeps its face's normal, exact cancellation or not.
TEST(VertexNormals, OppositeFacesKeepTheirOwn) {
  std::mt19937 rng{180};
  for (int i = 0; i < 200; ++i) {
    Mesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {0.3, 0.7, 0}}, {{0, 1, 2}, {1, 0, 2}});
    const glm::dmat3 rotation = randomRotation(rng);
    turn(mesh, rotation);
    for (const NormalRule rule : kComputed) {
      const std::vector<glm::dvec3> N = normals(mesh, rule);
      for (int c = 0; c < 6; ++c) EXPECT_LT(distance(N[c], c < 3 ? rotation[2] : -rotation[2]), 1e-15);
    }
  }
}

}  // namespace xnewell::THIS_FILE
