#include "geometry/model/vertex_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <random>

#include "geometry/exact/trig.h"
#include "geometry/exact/unit.h"
#include "geometry/files/bpt.h"
#include "geometry/model/solids.h"
#include "tests/support/normal_error.h"
#include "tests/support/seeds.h"

namespace xnewell {

namespace {

constexpr std::array kComputed{NormalRule::Sum, NormalRule::Distinct, NormalRule::Area, NormalRule::Angle};

Mesh meshOf(std::vector<glm::dvec3> points, const std::vector<std::vector<int>>& faces) {
  Mesh mesh;
  mesh.groupNames = {"mesh"};
  mesh.points = std::move(points);
  for (const std::vector<int>& face : faces) mesh.addFace(face, 0);
  return mesh;
}

double distance(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b); }

/// The normal of every corner.
std::vector<glm::dvec3> normals(const Mesh& mesh, NormalRule rule, double crease = 180.0,
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

/// The normal of every point, if all corners of a point have the same.
std::vector<glm::dvec3> pointNormals(const Mesh& mesh, NormalRule rule) {
  std::vector<glm::dvec3> N(mesh.points.size(), glm::dvec3{0.0});
  for (const Vertex& v : smoothVertices(mesh, rule).vertices) {
    EXPECT_EQ(N[v.point], glm::dvec3{0.0}) << "one vertex a point";
    N[v.point] = v.N;
  }
  return N;
}

/// Every face of a mesh of convex faces, cut into triangles from a random corner.
Mesh cut(const Mesh& mesh, std::mt19937& rng) {
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

glm::dvec3 randomDirection(std::mt19937& rng) {
  std::uniform_real_distribution<double> coordinate{-1.0, 1.0};
  for (;;) {
    const double x = coordinate(rng), y = coordinate(rng), z = coordinate(rng);
    const double square = x * x + y * y + z * z;
    if (0.01 < square && square < 1.0) return unit({x, y, z});
  }
}

glm::dmat3 randomRotation(std::mt19937& rng) {
  const glm::dvec3 x = randomDirection(rng), y = unit(glm::cross(x, randomDirection(rng)));
  return {x, y, glm::cross(x, y)};
}

void turn(Mesh& mesh, const glm::dmat3& rotation) {
  for (glm::dvec3& p : mesh.points) p = rotation * p;
}

/// Rounds the coordinates to `decimals` decimals, as a file holds them.
void writeAndRead(Mesh& mesh, int decimals) {
  const double ten = std::pow(10.0, decimals);
  for (glm::dvec3& p : mesh.points)
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::round(p[axis] * ten) / ten;
  mesh.rounding.assign(mesh.groupNames.size(), 0.5 / ten);
}

/// A cylinder of radius 1 and height 2 along z: `sides` rectangles and two caps. Corner i of the bottom is
/// point i.
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

// A worked example. At the origin meet a wall x = 0 and an L-shaped floor. The wall has two triangles, each
// with 45 degrees there and a double area of 9. The floor has a double area of 6, and its inner corner of 270
// degrees is there.
TEST(VertexNormals, WorkedExample) {
  const Mesh mesh = meshOf(
      {{0, 0, 0}, {0, 3, 0}, {0, 3, 3}, {0, 0, 3}, {0, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, 0, 0}},
      {{0, 1, 2}, {2, 3, 0}, {4, 5, 6, 7, 8, 0}});
  const auto expect = [&](NormalRule rule, glm::dvec3 N) {
    EXPECT_LT(distance(pointNormals(mesh, rule)[0], glm::normalize(N)), 0x1p-51) << static_cast<int>(rule);
  };
  expect(NormalRule::Sum, {2, 0, 1});
  expect(NormalRule::Distinct, {1, 0, 1});
  expect(NormalRule::Area, {18, 0, 6});
  expect(NormalRule::Angle, {90, 0, 270});
}

// The angle of a bent face is seen along its normal. Here the face is a square whose corners are alternately
// down and up.
TEST(VertexNormals, AngleOfABentFace) {
  const Mesh mesh =
      meshOf({{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}, {0, 2, 0}, {0, 0, 2}}, {{0, 1, 2, 3}, {0, 4, 5}});
  EXPECT_LT(distance(pointNormals(mesh, NormalRule::Angle)[0], unit({1, 0, 1})), 0x1p-51);
}

// The cube of 12 triangles has its diagonals as normals by the rules Distinct and Angle, however its squares
// are cut. Sum and Area favour the sides that bring two triangles to a corner, unless all three sides bring
// as many.
TEST(VertexNormals, CubeOfTwelveTriangles) {
  std::mt19937 rng{12};
  int uneven = 0;
  for (int i = 0; i < 50; ++i) {
    const Mesh mesh = cut(cube(), rng);
    ASSERT_EQ(mesh.faceCount(), 12);
    const bool even = std::ranges::all_of(std::array{0, 1, 2, 3, 4, 5, 6, 7}, [&](int p) {
      return std::ranges::count(mesh.corners, p) % 3 == 0;  // 3 or 6 triangles
    });
    uneven += !even;
    for (const NormalRule rule : kComputed) {
      const std::vector<glm::dvec3> N = pointNormals(mesh, rule);
      double worst = 0.0;
      for (int p = 0; p < 8; ++p) worst = std::max(worst, distance(N[p], mesh.points[p] / std::sqrt(3.0)));
      if (even || rule == NormalRule::Distinct || rule == NormalRule::Angle)
        EXPECT_LT(worst, 1e-15);
      else
        EXPECT_GT(worst, 0.1);
    }
  }
  EXPECT_GT(uneven, 40);
}

// Cutting flat faces into triangles changes no normal of Distinct and Angle, but some of Sum and Area. This
// holds on a turned torus and on one with the rounding of a file. The bounds: a normal, and likewise an
// angle, turns by the rounding u of the corners over the height of the triangle (at least 0.1).
TEST(VertexNormals, CuttingFlatFacesChangesSumAndAreaOnly) {
  const Seeds seeds{60};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    Mesh whole = torus(24, 12);
    turn(whole, randomRotation(rng));
    const bool fromFile = seed % 2 == 1;
    if (fromFile) writeAndRead(whole, 6);
    const double rounding = fromFile ? 0.5e-6 : 0x1p-53;
    const Mesh triangles = cut(whole, rng);
    for (const NormalRule rule : kComputed) {
      const std::vector<glm::dvec3> a = pointNormals(whole, rule), b = pointNormals(triangles, rule);
      double worst = 0.0;
      for (std::size_t p = 0; p < a.size(); ++p) worst = std::max(worst, distance(a[p], b[p]));
      if (rule == NormalRule::Distinct || rule == NormalRule::Angle)
        EXPECT_LT(worst, 100.0 * rounding) << static_cast<int>(rule);
      else
        EXPECT_GT(worst, 1e-3) << static_cast<int>(rule);
    }
  }
}

// Normals that differ are not taken for equal, however fine the facets: on a sphere of 32k faces Distinct is
// Sum. This also holds with six decimals, except for the needles around the poles. A facet at distance r from
// the axis is 0.025 r wide and turns by 0.025 r from its neighbour. Rounding turns it by about 0.5e-6 /
// (0.025 r), and the stated bound is several times that. The two meet at r = 0.1.
TEST(VertexNormals, FineFacetsStayDistinct) {
  Mesh mesh = sphere(256, 128);
  for (const bool fromFile : {false, true}) {
    if (fromFile) writeAndRead(mesh, 6);
    const std::vector<glm::dvec3> sum = pointNormals(mesh, NormalRule::Sum),
                                  distinct = pointNormals(mesh, NormalRule::Distinct);
    for (std::size_t p = 0; p < sum.size(); ++p) {
      if (fromFile && std::abs(mesh.points[p].z) > std::sqrt(1.0 - 0.1 * 0.1)) continue;
      ASSERT_LT(distance(sum[p], distinct[p]), 1e-13) << p;
    }
  }
}

// However coarse the file says that it is, normals further apart than 2^-9 are not equal: here those of that
// sphere away from the poles.
TEST(VertexNormals, CoarseFilesKeepTheirFacets) {
  Mesh mesh = sphere(256, 128);
  mesh.rounding = {0.1};
  const std::vector<glm::dvec3> sum = pointNormals(mesh, NormalRule::Sum),
                                distinct = pointNormals(mesh, NormalRule::Distinct);
  for (std::size_t p = 0; p < sum.size(); ++p)
    if (std::abs(mesh.points[p].z) < 0.99) {
      ASSERT_LT(distance(sum[p], distinct[p]), 1e-13) << p;
    }
}

// Equal normals count as one, that of their areas together. In the middle of a flat face cut into a fan it is
// the whole face's normal. It is much closer to the truth than any triangle's, which the rounding of the file
// turns.
TEST(VertexNormals, EqualNormalsMakeTheFaceWhole) {
  const Seeds seeds{50};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    Mesh fan, whole;
    fan.groupNames = whole.groupNames = {"fan"};
    std::vector<int> ring(9);
    std::iota(ring.begin(), ring.end(), 0);
    for (const int i : ring) {
      const auto [y, x] = sinCosDegrees(40.0 * i);
      fan.points.push_back({x, y, 0.0});
    }
    fan.points.push_back({0.1, 0.2, 0.0});
    turn(fan, randomRotation(rng));
    writeAndRead(fan, 5);
    whole.points = fan.points;
    whole.addFace(ring, 0);
    for (const int i : ring) fan.addFace(std::array{i, (i + 1) % 9, 9}, 0);
    const glm::dvec3 N = pointNormals(whole, NormalRule::Sum)[0];
    EXPECT_LT(distance(pointNormals(fan, NormalRule::Distinct)[9], N), 1e-15);
    EXPECT_GT(distance(pointNormals(fan, NormalRule::Sum)[9], N), 1e-9);
  }
}

// The order of the faces makes no difference, up to the rounding of a sum of a few unit vectors.
TEST(VertexNormals, FacesInAnyOrder) {
  const Seeds seeds{100};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const Mesh mesh = cut(seed % 2 ? sphere(13, 7) : torus(9, 5), rng);
    std::vector<int> order(mesh.faceCount());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::shuffle(order, rng);
    Mesh shuffled = mesh;
    shuffled.corners.clear(), shuffled.firstCorner = {0}, shuffled.group.clear(), shuffled.material.clear();
    for (const int f : order) shuffled.addFace(mesh.face(f), 0);
    for (const NormalRule rule : kComputed)
      for (const double crease : {20.0, 180.0}) {
        const std::vector<glm::dvec3> a = normals(mesh, rule, crease), b = normals(shuffled, rule, crease);
        for (int f = 0; f < mesh.faceCount(); ++f)
          for (int i = 0; i < 3; ++i)
            ASSERT_LT(distance(a[3 * order[f] + i], b[3 * f + i]), 1e-14) << static_cast<int>(rule);
      }
  }
}

// If a mesh and its rounding are scaled by a power of two, no bit of its normals changes.
TEST(VertexNormals, SizeDoesNotMatter) {
  std::mt19937 rng{2};
  Mesh mesh = cut(torus(16, 8), rng);
  turn(mesh, randomRotation(rng));
  writeAndRead(mesh, 4);
  for (const int exponent : {-400, -60, -1, 1, 60, 400}) {
    Mesh scaled = mesh;
    for (glm::dvec3& p : scaled.points) p *= std::ldexp(1.0, exponent);
    for (double& u : scaled.rounding) u = std::ldexp(u, exponent);
    for (const NormalRule rule : kComputed)
      for (const double crease : {15.0, 180.0}) {
        const Vertices a = smoothVertices(mesh, rule, crease), b = smoothVertices(scaled, rule, crease);
        EXPECT_EQ(a.vertices, b.vertices) << exponent;
        EXPECT_EQ(a.ofCorner, b.ofCorner) << exponent;
      }
  }
}

// The faces of a cube turn by 90 degrees. With a crease below 90 every face keeps its own normal, and there
// are three vertices at each point. 90 itself counts as within, and leaves one vertex. The same holds for a
// turned cube.
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

// A cylinder of 12 sides turns by 30 degrees from side to side and by 90 to its caps. With a crease of 30 to
// 89 its sides are round, with radial normals, and its caps are flat.
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

// A point with two materials becomes two vertices, with one normal.
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

// Faces without area contribute nothing and take the normals of their points. If there are no other faces,
// the normal is 0. A face that meets a point twice counts once there, but both of its angles count. A
// repeated corner has no angle.
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

  // A floor with a hole. A slit joins the hole to the floor's corner at the origin, so there are two angles
  // of 45 degrees there.
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

// Two faces back to back have no sum. Each corner keeps its face's normal, whether they cancel exactly or
// not.
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

// Exact normals are used as they are, whatever the crease. Where there is none, Distinct applies.
TEST(VertexNormals, ExactNormalsWhereThereAre) {
  std::mt19937 rng{3};
  const Mesh mesh = cut(cube(), rng);
  std::vector<glm::dvec3> exact;
  for (std::size_t c = 0; c < mesh.corners.size(); ++c)
    exact.push_back(c % 3 ? randomDirection(rng) : glm::dvec3{0.0});
  exact[1] = {-0.0, 1.0, 0.0};
  for (const double crease : {0.0, 180.0}) {
    const std::vector<glm::dvec3> N = normals(mesh, NormalRule::Exact, crease, exact),
                                  distinct = normals(mesh, NormalRule::Distinct, crease);
    for (std::size_t c = 0; c < exact.size(); ++c) EXPECT_EQ(N[c], c % 3 ? exact[c] : distinct[c]);
    EXPECT_EQ(normals(mesh, NormalRule::Exact, crease), distinct);
  }
}

// A second method: the rules word by word in long double, each corner by itself. The meshes are triangles
// among few points, some of them listed twice. It skips corners where an angle is near the crease, and points
// where the sum nearly vanishes.
TEST(VertexNormals, AgreeWithTheRulesWordByWord) {
  using Wide = glm::vec<3, long double>;
  const Seeds seeds{300};
  int checked = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 12; ++i) points.push_back(randomDirection(rng));
    std::vector<std::vector<int>> faces;
    for (int f = 0; f < 40; ++f) {
      std::array<int, 3> face{};
      while (face[0] == face[1] || face[1] == face[2] || face[2] == face[0])
        for (int& corner : face) corner = static_cast<int>(rng() % points.size());
      faces.push_back({face.begin(), face.end()});
      if (f % 5 == 0) faces.push_back({face[1], face[2], face[0]});
    }
    const Mesh mesh = meshOf(points, faces);
    const double crease = std::array{180.0, 120.0, 70.0}[seed % 3];
    const auto at = [&](int c) { return Wide{mesh.points[mesh.corners[c]]}; };
    std::vector<Wide> twiceArea;
    for (int f = 0; f < mesh.faceCount(); ++f)
      twiceArea.push_back(glm::cross(at(3 * f + 1) - at(3 * f), at(3 * f + 2) - at(3 * f)));
    const auto N = [&](int f) { return glm::normalize(twiceArea[f]); };
    for (const NormalRule rule : kComputed) {
      const std::vector<glm::dvec3> computed = normals(mesh, rule, crease);
      for (int c = 0; c < static_cast<int>(mesh.corners.size()); ++c) {
        Wide sum{0.0};
        std::vector<Wide> counted;
        bool clear = true;
        for (int o = 0; o < static_cast<int>(mesh.corners.size()); ++o) {
          if (mesh.corners[o] != mesh.corners[c]) continue;
          const long double cosine = glm::dot(N(c / 3), N(o / 3));
          const long double least = std::cos(crease * 3.14159265358979323846L / 180.0L);
          if (crease < 180.0 && std::abs(cosine - least) < 1e-9L) clear = false;
          if (crease < 180.0 && cosine < least) continue;
          const Wide a = at(o / 3 * 3 + (o + 1) % 3) - at(o), b = at(o / 3 * 3 + (o + 2) % 3) - at(o);
          if (rule == NormalRule::Distinct &&
              std::ranges::any_of(counted, [&](const Wide& n) { return glm::length(n - N(o / 3)) < 1e-9L; }))
            continue;
          counted.push_back(N(o / 3));
          sum += rule == NormalRule::Area ? twiceArea[o / 3]
                 : rule == NormalRule::Angle
                     ? std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * N(o / 3)
                     : N(o / 3);
        }
        if (!clear || glm::length(sum) < 0.05L) continue;
        ++checked;
        ASSERT_LT(distance(computed[c], glm::dvec3{glm::normalize(sum)}), 1e-11) << static_cast<int>(rule);
      }
    }
  }
  if (seeds.all()) {
    EXPECT_GT(checked, 100'000);
  }
}

// How close the rules come to the true normals (`tests/bench/run.sh NormalError` prints the figures). On a
// sphere's bands of quadrilaterals Sum is best, because the faces at a vertex lie almost symmetrically. Then
// comes Angle, then Area, which favours the wider band; each step is at least a factor of two. After cutting
// into triangles, Sum has ten times its error and Distinct the same. On the teapot, whose patches differ in
// size, Area is better than Sum. With twice the divisions every error is less than half.
TEST(VertexNormals, ErrorsAgainstTheTrueNormals) {
  const auto ofSphere = [](int around, NormalRule rule) {
    const Mesh mesh = sphere(around, around / 2);
    return normalError(mesh, rule, sphereNormals(mesh));
  };
  for (const int around : {24, 48}) {
    const NormalError sum = ofSphere(around, NormalRule::Sum), angle = ofSphere(around, NormalRule::Angle),
                      area = ofSphere(around, NormalRule::Area);
    EXPECT_EQ(sum.corners, 4 * around * around / 2 - 2 * around);
    EXPECT_LT(2.0 * sum.mean, angle.mean);
    EXPECT_LT(2.0 * sum.max, angle.max);
    EXPECT_LT(2.0 * angle.mean, area.mean);
    EXPECT_LT(2.0 * angle.max, area.max);

    std::mt19937 rng{1};
    const Mesh triangles = cut(sphere(around, around / 2), rng);
    const std::vector<glm::dvec3> truth = sphereNormals(triangles);
    EXPECT_GT(normalError(triangles, NormalRule::Sum, truth).mean, 10.0 * sum.mean);
    EXPECT_NEAR(normalError(triangles, NormalRule::Distinct, truth).max, sum.max, 1e-9);
  }

  const std::vector<BezierPatch> patches = readBpt(XNEWELL_DATA_DIR "/teapot.bpt");
  const auto ofTeapot = [&](int divisions, NormalRule rule) {
    const Mesh mesh = tessellate(patches, divisions);
    const std::vector<glm::dvec3> exact = cornerNormals(patches, divisions);
    const Vertices v = smoothVertices(mesh, NormalRule::Exact, 180.0, exact);
    for (std::size_t c = 0; c < exact.size(); ++c)
      EXPECT_TRUE(exact[c] == glm::dvec3{0.0} || v.vertices[v.ofCorner[c]].N == exact[c]);
    return normalError(mesh, rule, withoutCreases(mesh, exact));
  };
  for (const int divisions : {8, 16})
    EXPECT_LT(ofTeapot(divisions, NormalRule::Area).mean, ofTeapot(divisions, NormalRule::Sum).mean);
  for (const NormalRule rule : kComputed) {
    EXPECT_LT(2.0 * ofSphere(48, rule).mean, ofSphere(24, rule).mean);
    EXPECT_LT(2.0 * ofTeapot(16, rule).mean, ofTeapot(8, rule).mean);
  }
}

}  // namespace xnewell
