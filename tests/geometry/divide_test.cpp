#include "geometry/model/divide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "geometry/exact/plane.h"
#include "geometry/model/bezier.h"
#include "tests/support/random_wall.h"

namespace xnewell::THIS_FILE {

namespace {

using Pts = std::vector<glm::dvec3>;

Mesh oneFace(const Pts& points, double rounding = 0.0) {
  Mesh mesh;
  mesh.points = points;
  mesh.groupNames = {"face"};
  mesh.rounding = {rounding};
  std::vector<int> corners;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) corners.push_back(i);
  mesh.addFace(corners, 0);
  return mesh;
}

std::vector<std::vector<int>> partsOf(const Mesh& mesh) {
  const ConvexParts parts = divideFaces(mesh);
  EXPECT_EQ(parts.firstCorner.size(), parts.face.size() + 1);
  std::vector<std::vector<int>> list;
  for (int k = 0; k < parts.count(); ++k) list.emplace_back(parts.part(k).begin(), parts.part(k).end());
  return list;
}

std::vector<std::vector<int>> partsOf(const Pts& points, double rounding = 0.0) {
  return partsOf(oneFace(points, rounding));
}

using List = std::vector<std::vector<int>>;

/// A circle of n corners in the plane spanned by a and b, counter-clockwise about a x b.
Pts circle(int n, const glm::dvec3& a, const glm::dvec3& b) {
  Pts p;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.141592653589793 * i / n;
    p.push_back(std::cos(angle) * a + std::sin(angle) * b);
  }
  return p;
}

}  // namespace

// Triangles and planar convex polygons are not divided. They keep the corners on their straight sides.
TEST(Divide, ConvexPlanarFacesStayWhole) {
  EXPECT_EQ(partsOf(Pts{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (List{{0, 1, 2}}));
  EXPECT_EQ(partsOf(Pts{{0, 0, 5}, {1, 0, 5}, {2, 0, 5}, {2, 2, 5}, {1, 2, 5}, {0, 2, 5}}),
            (List{{0, 1, 2, 3, 4, 5}}));
  // Seen from either side, along each axis, and on a slope.
  for (const glm::dvec3& a : {glm::dvec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6, 0, 0.8}})
    for (const glm::dvec3& b : {glm::dvec3{0, 1, 0}, {0, -0.6, 0.8}, {1, 0, 0}, {-0.8, 0, 0.6}})
      if (glm::length(glm::cross(a, b)) > 0.1) {
        EXPECT_EQ(partsOf(circle(7, a, b)).size(), 1u);
      }
}

// Successive corners with the same index or the same place are listed once. A face that collapses keeps a
// part.
TEST(Divide, CoincidentCornersCollapse) {
  EXPECT_EQ(partsOf(Pts{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-0.0, 0, 0}}),
            (List{{0, 2, 3, 4}}));
  EXPECT_EQ(partsOf(Pts{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {2, 2, 2}}), (List{{0, 1, 2, 3}}));
  EXPECT_EQ(partsOf(Pts{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), (List{{0, 1, 2}}));
}

// Where an outline runs out and back it has no area, wherever it begins: not outside, not inside, not with a
// bend, and not where it comes back only half the way.
TEST(Divide, SpikesHaveNoArea) {
  const Pts tips{{1.8, 0.4, 0}, {0.1, -0.3, 0}, {0.3, 0.1, 0.8}};
  const auto spiked = [&](const Pts& base, const Pts& spike) {
    for (std::size_t begin = 0; begin < base.size() + spike.size(); ++begin) {
      Pts p = base;
      p.insert(p.end(), spike.begin(), spike.end());
      std::ranges::rotate(p, p.begin() + static_cast<std::ptrdiff_t>(begin));
      glm::dvec3 sum{0};
      double area = 0;  // doubled
      for (const auto& part : partsOf(p)) {
        const glm::dvec3 mine = newellVector(p, part);
        sum += mine, area += glm::length(mine);
      }
      EXPECT_NEAR(area, glm::length(sum), 1e-12) << begin;
      EXPECT_EQ(partsOf(p).size(), partsOf(base).size()) << begin;
    }
  };
  const Pts triangle{{-1, -1, 0}, {1, 1, 0}, {0, 1, 0}},
      ell{{0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 0, 0}};
  for (const Pts& base : {triangle, ell}) {
    for (const glm::dvec3& tip : tips) spiked(base, {tip, base.back()});
    spiked(base, {tips[0], tips[1], tips[2], tips[1], tips[0], base.back()});
  }
  spiked({{-1, -1, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}}, {{-3, 1, 0}, {-2, 1, 0}});
}

// A bent quadrilateral is cut from corner 0 to corner 2, whichever way it is bent or seen.
TEST(Divide, BentQuadIsCutFromItsFirstCorner) {
  for (const double bend : {0.1, -0.1, 1e-9}) {
    EXPECT_EQ(partsOf(Pts{{0, 0, 0}, {1, 0, 0}, {1, 1, bend}, {0, 1, 0}}), (List{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(partsOf(Pts{{0, 1, 0}, {1, 1, bend}, {1, 0, 0}, {0, 0, 0}}), (List{{0, 1, 2}, {0, 2, 3}}));
  }
}

// An arrowhead is cut through its reflex corner: from 0 to 2 if that is corner 0 or 2, otherwise from 1 to 3.
// Corners in the middle of straight sides decide no cut, and their part keeps them. Each was once the tip of
// a needle, and all pairs of needles were compared.
TEST(Divide, StraightSidesKeepTheirCorners) {
  EXPECT_EQ(partsOf(Pts{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 3, 1}, {0, 3, 0}}),
            (List{{0, 1, 2, 3, 4}, {0, 4, 5}}));
  EXPECT_EQ(partsOf(Pts{{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0.25, 1.25, 0}, {0, 2, 0}, {0, 1, 0}}),
            (List{{0, 1, 2}, {0, 2, 3, 4, 5}}));
  EXPECT_EQ(partsOf(Pts{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}).size(), 1u);  // no corner turns
}

TEST(Divide, ArrowheadIsCutThroughItsNotch) {
  const Pts arrow{{0, 0, 0}, {3, -2, 0}, {1, 0, 0}, {3, 2, 0}};  // the notch is corner 2
  const Pts line{{0, 0, 0}, {1, 0, 0.1}, {2, 0, 0}, {1, 1, 0}};  // seen from above, corner 1 is on a side
  for (int shift = 0; shift < 4; ++shift)
    for (const bool backwards : {false, true}) {
      Pts p = arrow;
      std::rotate(p.begin(), p.begin() + shift, p.end());
      if (backwards) std::reverse(p.begin(), p.end());
      const int notch = static_cast<int>(std::find(p.begin(), p.end(), arrow[2]) - p.begin());
      EXPECT_EQ(partsOf(p), notch % 2 ? (List{{1, 2, 3}, {1, 3, 0}}) : (List{{0, 1, 2}, {0, 2, 3}}));
    }
  EXPECT_EQ(partsOf(line), (List{{1, 2, 3}, {1, 3, 0}}));
}

// ConvexParts turn as their face does: on a lattice their areas sum to the face's exactly, in each of the
// planes and from both sides.
TEST(Divide, PartsOfConcaveFacesSumToTheFace) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    std::uniform_int_distribution<int> height{1, 9};
    Pts p;  // a skyline: a base and towers
    const int towers = 2 + static_cast<int>(seed % 8);
    p.push_back({0, 0, 0});
    p.push_back({towers, 0, 0});
    for (int x = towers; x > 0; --x) {
      const double h = height(rng);
      p.push_back({x, h, 0});
      p.push_back({x - 1, h, 0});
    }
    for (glm::dvec3& q : p) {  // exchange the axes, and look from behind
      for (unsigned i = 0; i < seed % 3; ++i) q = {q.z, q.x, q.y};
      if (seed % 2) q = {q.y, q.x, q.z};
    }
    const Mesh mesh = oneFace(p);
    const ConvexParts parts = divideFaces(mesh);
    const glm::dvec3 whole = newellVector(mesh.points, mesh.face(0));
    glm::dvec3 sum{0.0};
    for (int k = 0; k < parts.count(); ++k) {
      const glm::dvec3 part = newellVector(mesh.points, parts.part(k));
      EXPECT_GT(glm::dot(part, whole), 0.0);
      sum += part;
    }
    EXPECT_EQ(sum, whole);
  }
}

// The rounding of a file does not bend a face. A face counts as planar if each corner is within half the last
// decimal of one plane. Exact data must be planar to 2^-46.
TEST(Divide, RoundedFacesArePlanar) {
  // Raising corner 2 by 4 h moves the corners h off the Newell plane.
  const auto cuts = [](double h, double rounding) {
    return partsOf(Pts{{0, 0, 0}, {1, 0, 0}, {1, 1, 4 * h}, {0, 1, 0}}, rounding).size() > 1;
  };
  EXPECT_FALSE(cuts(0.99e-6, 1e-6));
  EXPECT_TRUE(cuts(1.01e-6, 1e-6));
  EXPECT_FALSE(cuts(0.99e-3, 1e-3));
  EXPECT_TRUE(cuts(1.01e-3, 1e-3));
  EXPECT_FALSE(cuts(0x1p-46, 0.0));
  EXPECT_TRUE(cuts(0x1p-45, 0.0));
}

// Nor does it bend a small flag with a long spike, although the plane of the face's vector area, which is
// that of the flag, may miss the tip by many roundings: another plane explains all corners. A corner of the
// flag that is moved by more than that bends the face.
TEST(Divide, RoundedFlagsArePlanar) {
  constexpr double kU = 0.5e-6;
  int tilted = 0;
  for (unsigned seed = 0; seed < 2'000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const Frame frame = randomFrame(rng);
    const double size = std::pow(10.0, -1 - std::uniform_real_distribution<double>{0.0, 1.0}(rng)),
                 half = size / 2, width = 20 * kU;
    Mesh mesh;
    mesh.groupNames = {""};
    addRounded(mesh,
               {frame.at(0, 0), frame.at(size, 0), frame.at(size, half - width), frame.at(1, half),
                frame.at(size, half + width), frame.at(size, size), frame.at(0, size)},
               6);
    const auto planes = [&] { return 1 + divideFaces(mesh).plane.back(); };
    EXPECT_EQ(planes(), 1);
    const Plane plane = newellPlane(mesh.points, mesh.face(0));
    const glm::dvec3 n = glm::abs(plane.N);
    const double r = kU * (n.x + n.y + n.z);
    tilted += std::abs(glm::dot(plane.N, mesh.points[3]) - plane.d) > 10 * r;
    mesh.points[0] += 20 * std::sqrt(3.0) * kU * frame.N;  // the flag's corners share it, a quarter each
    EXPECT_GT(planes(), 1);
  }
  EXPECT_GT(tilted, 500);
}

// Pentagons far from the origin are planar although their corners are rounded to double.
TEST(Divide, FarFacesArePlanarUpToTheRoundingOfDoubles) {
  std::mt19937 rng{53};
  std::uniform_real_distribution<double> component{-1.0, 1.0};
  const auto direction = [&] {
    return glm::normalize(glm::dvec3{component(rng), component(rng), component(rng)});
  };
  for (int round = 0; round < 2000; ++round) {
    const glm::dvec3 a = direction(), b = glm::normalize(glm::cross(a, direction()));
    const glm::dvec3 centre = std::ldexp(1.0, round % 30) * direction();
    Pts p = circle(5, a, b);
    for (glm::dvec3& q : p) q += centre;
    EXPECT_EQ(partsOf(p).size(), 1u) << round;
  }
}

// Scale makes no difference, from the smallest to the largest doubles.
TEST(Divide, DoesNotDependOnScale) {
  const Pts notched{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {5, 8, 0}, {5, 2, 0}, {3, 2, 0}, {3, 8, 0}, {0, 8, 0}};
  const Pts bent{{-8, 0, 0}, {8, 0, 0}, {8, 8, 1}, {-8, 8, 0}};
  const Pts flat{{-8, -8, -8}, {8, -8, -8}, {8, 8, 8}, {-8, 8, 8}};
  for (const int exponent : {-1074, -600, 0, 500, 1020})
    for (const Pts& p : {notched, bent, flat}) {
      Pts scaled = p;
      for (glm::dvec3& q : scaled)
        for (int axis = 0; axis < 3; ++axis) q[axis] = std::ldexp(q[axis], exponent);
      EXPECT_EQ(partsOf(scaled), partsOf(p)) << exponent;
    }
  EXPECT_EQ(partsOf(flat).size(), 1u);
}

// Faces without area, and faces that cross themselves, give some parts, each made of the face's own corners.
TEST(Divide, DegenerateFacesEnd) {
  EXPECT_EQ(partsOf(Pts{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).size(), 1u);  // in line
  EXPECT_EQ(partsOf(Pts{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 1u);  // a bow tie
  EXPECT_EQ(partsOf(Pts{{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 1, 0}}).size(), 2u);  // an uneven one
  const Pts star = circle(5, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(partsOf(Pts{star[0], star[2], star[4], star[1], star[3]}).size(), 3u);  // a pentagram
  std::mt19937 rng{4};
  std::uniform_real_distribution<double> coordinate{-1.0, 1.0};
  for (int round = 0; round < 2000; ++round) {
    Pts p(3 + round % 10);
    for (glm::dvec3& q : p)
      for (int axis = 0; axis < 3; ++axis)
        q[axis] = std::ldexp(coordinate(rng), round % 7 ? 0 : round % 2000 - 1000);
    for (const auto& part : partsOf(p)) {
      EXPECT_GE(part.size(), 3u);
      for (const int corner : part) EXPECT_LT(corner, static_cast<int>(p.size()));
    }
  }
}

// ConvexParts come in face order with the face's number, and every face has one.
TEST(Divide, KeepsFaceNumbers) {
  BezierPatch patch;
  for (int i = 0; i < 16; ++i) patch.p[i] = {i / 4, i % 4, i % 5 == 0 ? 1.0 : 0.0};
  for (int j = 0; j < 4; ++j) patch.p[j] = {0, 0, 0};
  const Mesh mesh = tessellate(std::array{patch}, 6);
  const ConvexParts parts = divideFaces(mesh);
  EXPECT_TRUE(std::is_sorted(parts.face.begin(), parts.face.end()));
  for (int f = 0; f < mesh.faceCount(); ++f)
    EXPECT_TRUE(std::binary_search(parts.face.begin(), parts.face.end(), f));
  for (int k = 0; k < parts.count(); ++k)
    for (const int corner : parts.part(k)) {
      const auto face = mesh.face(parts.face[k]);
      EXPECT_NE(std::find(face.begin(), face.end(), corner), face.end());
    }
}

// A regular polygon of a million corners stays whole. With one corner pushed in, it is cut into a million - 2
// triangles.
TEST(Divide, MillionCorners) {
  Pts p = circle(1'000'000, {1, 0, 0}, {0, 0.6, 0.8});
  EXPECT_EQ(divideFaces(oneFace(p)).count(), 1);
  p[777'777] *= 0.5;
  EXPECT_EQ(divideFaces(oneFace(p)).count(), 999'998);
}

}  // namespace xnewell::THIS_FILE
