#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <random>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"
#include "geometry/model/solids.h"
#include "geometry/model/vertex_normals.h"
#include "tests/support/extended.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Normals at vertices

/// Meshes, turned and cut, and the normals that smoothVertices() gives to their corners.

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

/// With all corners of a point alike, the normal of every point.
std::vector<glm::dvec3> pointNormals(const Mesh& mesh, NormalRule rule) {
  std::vector<glm::dvec3> N(mesh.points.size(), glm::dvec3{0.0});
  for (const Vertex& v : smoothVertices(mesh, rule).vertices) {
    EXPECT_EQ(N[v.point], glm::dvec3{0.0}) << "one vertex a point";
    N[v.point] = v.N;
  }
  return N;
}

/// Every face of a mesh of convex faces cut into triangles, from a random corner each.
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

/// As a file holds it: coordinates of `decimals` decimals.
void writeAndRead(Mesh& mesh, int decimals) {
  const double ten = std::pow(10.0, decimals);
  for (glm::dvec3& p : mesh.points)
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::round(p[axis] * ten) / ten;
  mesh.rounding.assign(mesh.groupNames.size(), 0.5 / ten);
}

// A worked example: at the origin meet a wall x = 0 of two triangles, each with 45 degrees there and twice
// the area 9, and an L-shaped floor, twice the area 6, with its inner corner of 270 degrees there.
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

// The angle of a bent face is the one seen along its normal: here of a square, whose corners are alternately
// down and up.
TEST(VertexNormals, AngleOfABentFace) {
  const Mesh mesh =
      meshOf({{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}, {0, 2, 0}, {0, 0, 2}}, {{0, 1, 2, 3}, {0, 4, 5}});
  EXPECT_LT(distance(pointNormals(mesh, NormalRule::Angle)[0], unit({1, 0, 1})), 0x1p-51);
}

// Cutting flat faces into triangles changes no normal of the rules Distinct and Angle, and some of Sum and
// Area; so on a torus turned about, and on one with the rounding of a file. The bounds: a normal is turned by
// the rounding u of the corners over the height of the triangle (0.1 at least), and the angles likewise.
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
// Sum. So with six decimals, but for the needles about the poles: a facet r from the axis is 0.025 r wide,
// turns by 0.025 r from its neighbour and by about 0.5e-6 / (0.025 r) by the rounding, and the stated bound
// is some times that: the two meet at r = 0.1. However coarse a file says that it is, normals further apart
// than 2^-9 are not equal: those away from the poles.
TEST(VertexNormals, FineFacetsStayDistinct) {
  for (const auto& [decimals, rounding, r] :
       {std::tuple{17, 0.0, 0.0}, {6, 0.5e-6, 0.1}, {17, 0.1, std::sqrt(1.0 - 0.99 * 0.99)}}) {
    Mesh mesh = sphere(256, 128);
    if (decimals < 17) writeAndRead(mesh, decimals);
    mesh.rounding = {rounding};
    const std::vector<glm::dvec3> sum = pointNormals(mesh, NormalRule::Sum),
                                  distinct = pointNormals(mesh, NormalRule::Distinct);
    for (std::size_t p = 0; p < sum.size(); ++p)
      if (std::abs(mesh.points[p].z) <= std::sqrt(1.0 - r * r)) {
        ASSERT_LT(distance(sum[p], distinct[p]), 1e-13) << p;
      }
  }
}

// Equal normals count as that of their areas together: in the middle of a flat face cut into a fan it is the
// whole face's, closer by far than any triangle's, which the rounding of the file turns.
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

// The order of the faces does not matter but for the rounding of a sum of a few unit vectors.
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

// Scaled by a power of two, and its rounding with it, a mesh has the same normals to the bit.
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

// Exact normals, and those of a file, are taken as they are, whatever the crease; where there is none,
// Distinct.
TEST(VertexNormals, ExactNormalsWhereThereAre) {
  std::mt19937 rng{3};
  const Mesh mesh = cut(cube(), rng);
  std::vector<glm::dvec3> exact;
  for (std::size_t c = 0; c < mesh.corners.size(); ++c)
    exact.push_back(c % 3 ? randomDirection(rng) : glm::dvec3{0.0});
  exact[1] = {-0.0, 1.0, 0.0};
  for (const double crease : {0.0, 180.0}) {
    const std::vector<glm::dvec3> N = normals(mesh, crease == 0.0 ? NormalRule::File : NormalRule::Exact,
                                              crease, exact),
                                  distinct = normals(mesh, NormalRule::Distinct, crease);
    for (std::size_t c = 0; c < exact.size(); ++c) EXPECT_EQ(N[c], c % 3 ? exact[c] : distinct[c]);
    EXPECT_EQ(normals(mesh, NormalRule::Exact, crease), distinct);
  }
}

// A second method: the rules word by word with 64 bits, every corner by itself, on triangles among few
// points, some of them twice. The error is no larger than vertex_normals.h claims. Corners where an angle is
// near the crease are left out, and points where the sum nearly vanishes.
TEST(VertexNormals, AgreeWithTheRulesWordByWord) {
  using Wide = glm::vec<3, Extended>;
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
        Extended weights = 0, doubts = 0;
        std::vector<Wide> counted;
        bool clear = true;
        for (int o = 0; o < static_cast<int>(mesh.corners.size()); ++o) {
          if (mesh.corners[o] != mesh.corners[c]) continue;
          const auto cosine = static_cast<double>(glm::dot(N(c / 3), N(o / 3)));
          const double least = std::cos(crease * std::numbers::pi / 180);
          if (crease < 180.0 && std::abs(cosine - least) < 1e-9) clear = false;
          if (crease < 180.0 && cosine < least) continue;
          const Wide a = at(o / 3 * 3 + (o + 1) % 3) - at(o), b = at(o / 3 * 3 + (o + 2) % 3) - at(o);
          if (rule == NormalRule::Distinct &&
              std::ranges::any_of(counted, [&](const Wide& n) { return glm::length(n - N(o / 3)) < 1e-9; }))
            continue;
          counted.push_back(N(o / 3));
          const Extended area = glm::length(twiceArea[o / 3]),
                         longest = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(a - b, a - b)});
          const Extended weight =
              rule == NormalRule::Area ? area
              : rule == NormalRule::Angle
                  ? Extended{std::atan2(static_cast<double>(area), static_cast<double>(glm::dot(a, b)))}
                  : Extended{1.0};
          sum += weight * N(o / 3);
          weights += weight, doubts += weight * longest / area;
        }
        const Extended length = glm::length(sum);
        if (!clear || length < 0x1p-30 * weights) continue;
        ++checked;
        // The angles and the result are rounded to doubles here, too.
        const Extended bound = (0x1p-47 * (weights + doubts) + 0x1p-51 * weights) / length;
        ASSERT_LE(distance(computed[c], glm::dvec3{sum / length}), static_cast<double>(bound))
            << static_cast<int>(rule);
      }
    }
  }
  if (seeds.all()) {
    EXPECT_GT(checked, 100'000);
  }
}

/// ---- Creases

// Where corners at one point have normals of their own: at creases, at materials, and at faces that have no
// normal or opposite ones. The rules themselves stand above.

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

}  // namespace

}  // namespace xnewell::THIS_FILE
