#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "geometry/exact/plane.h"
#include "geometry/model/bezier.h"
#include "geometry/model/divide.h"
#include "geometry/model/ear_clip.h"
#include "tests/support/random_wall.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Division of polygons

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

// Corners in the middle of straight sides decide no cut, and their part keeps them. Each was once the tip of
// a needle, and all pairs of needles were compared.
TEST(Divide, StraightSidesKeepTheirCorners) {
  EXPECT_EQ(partsOf(Pts{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 3, 1}, {0, 3, 0}}),
            (List{{0, 1, 2, 3, 4}, {0, 4, 5}}));
  EXPECT_EQ(partsOf(Pts{{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0.25, 1.25, 0}, {0, 2, 0}, {0, 1, 0}}),
            (List{{0, 1, 2}, {0, 2, 3, 4, 5}}));
  EXPECT_EQ(partsOf(Pts{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}).size(), 1u);  // no corner turns
}

// An arrowhead is cut through its reflex corner: from 0 to 2 if that is corner 0 or 2, otherwise from 1 to 3.
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

/// ---- Triangles by cutting ears

using Outline = std::vector<LatticePoint>;
using Triangles = std::vector<std::array<int, 3>>;

/// Twice the signed area of a closed outline.
Int128 area(const Outline& p) {
  Int128 sum = 0;
  for (std::size_t i = 2; i < p.size(); ++i) sum += turn(p[0], p[i - 1], p[i]);
  return sum;
}

/// How often the outline runs around q counter-clockwise. q must not be on an edge.
int windingNumber(const Outline& p, const LatticePoint& q) {
  int winding = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const LatticePoint &a = p[i], &b = p[(i + 1) % p.size()];
    if ((a.y <= q.y) == (b.y <= q.y)) continue;
    if (a.y <= q.y && turn(a, b, q) > 0) ++winding;
    if (b.y <= q.y && turn(a, b, q) < 0) --winding;
  }
  return winding;
}

bool onSegment(const LatticePoint& a, const LatticePoint& b, const LatticePoint& q) {
  return turn(a, b, q) == 0 && std::min(a.x, b.x) <= q.x && q.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= q.y && q.y <= std::max(a.y, b.y);
}

/// Expects n - 2 counter-clockwise triangles whose areas sum to the outline's. With this total, triangles can
/// overlap only if some area is left uncovered, so samples are checked too.
void expectTiling(const Outline& p, const Triangles& triangles, bool checkSamples) {
  ASSERT_EQ(triangles.size(), p.size() - 2);
  Int128 sum = 0;
  int backwards = 0;
  for (const auto& [a, b, c] : triangles) {
    const Int128 twice = turn(p[a], p[b], p[c]);
    backwards += twice <= 0;
    sum += twice;
  }
  EXPECT_EQ(backwards, 0);
  EXPECT_TRUE(sum == area(p));
  if (!checkSamples) return;
  // Samples lie off the lattice, because outlines are multiples of 6.
  LatticePoint low = p[0], high = p[0];
  for (const LatticePoint& q : p) {
    low = {std::min(low.x, q.x), std::min(low.y, q.y)};
    high = {std::max(high.x, q.x), std::max(high.y, q.y)};
  }
  int inside = 0;
  for (std::int64_t x = low.x + 1; x < high.x; x += 6)
    for (std::int64_t y = low.y + 2; y < high.y; y += 6) {
      const LatticePoint q{x, y};
      int holders = 0;
      bool onSide = false;
      for (const auto& t : triangles) {
        bool in = true;
        for (int i = 0; i < 3; ++i) {
          const LatticePoint &a = p[t[i]], &b = p[t[(i + 1) % 3]];
          onSide = onSide || onSegment(a, b, q);
          in = in && turn(a, b, q) > 0;
        }
        holders += in;
      }
      if (onSide) continue;
      const int expected = windingNumber(p, q);
      inside += expected;
      EXPECT_EQ(holders, expected) << x << ' ' << y;
    }
  EXPECT_GT(inside, 0);
}

/// Expects no corner of the outline in the middle of a triangle's side: neighbours would leave a gap there.
void expectNoCornerOnASide(const Outline& p, const Triangles& triangles) {
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const LatticePoint &a = p[t[i]], &b = p[t[(i + 1) % 3]];
      for (const LatticePoint& q : p) EXPECT_FALSE(onSegment(a, b, q) && q != a && q != b);
    }
}

/// A polygon around the origin with its corners sorted by direction. It is simple, because no two directions
/// are equal and no gap between them exceeds a right angle.
Outline randomStar(std::mt19937& rng, int wanted, int reach) {
  std::uniform_int_distribution<int> coordinate{-reach, reach};
  Outline p{{6 * reach, 0}, {0, 6 * reach}, {-6 * reach, 0}, {0, -6 * reach}};
  for (int i = 4; i < wanted; ++i) p.push_back({6 * coordinate(rng), 6 * coordinate(rng)});
  std::erase(p, LatticePoint{});
  const auto upper = [](const LatticePoint& q) { return q.y > 0 || (q.y == 0 && q.x > 0); };
  const LatticePoint O{};
  std::stable_sort(p.begin(), p.end(), [&](const LatticePoint& a, const LatticePoint& b) {
    return upper(a) != upper(b) ? upper(a) : turn(O, a, b) > 0;
  });
  p.erase(std::unique(p.begin(), p.end(),
                      [&](const LatticePoint& a, const LatticePoint& b) {
                        return upper(a) == upper(b) && turn(O, a, b) == 0;
                      }),
          p.end());
  return p;
}

/// A simple polygon without any order. It starts from random points and exchanges crossing edges until none
/// cross (each exchange shortens the tour, so this ends). No three points are in line.
Outline randomTangle(std::mt19937& rng, int n) {
  std::uniform_int_distribution<int> coordinate{0, 40};
  Outline p;
  while (static_cast<int>(p.size()) < n) {
    const LatticePoint q{6 * coordinate(rng), 6 * coordinate(rng)};
    bool inLine = false;
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) inLine = inLine || turn(p[i], p[j], q) == 0;
    if (!inLine && (p.empty() || q != p[0])) p.push_back(q);
  }
  const auto left = [](const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
    return turn(a, b, c) > 0;
  };
  for (bool crossed = true; crossed;) {
    crossed = false;
    for (int i = 0; i + 2 < n; ++i)
      for (int j = i + 2; j < n; ++j) {
        const LatticePoint &a = p[i], &b = p[i + 1], &c = p[j], &d = p[(j + 1) % n];
        if (a == d || left(a, b, c) == left(a, b, d) || left(c, d, a) == left(c, d, b)) continue;
        std::reverse(p.begin() + i + 1, p.begin() + j + 1);
        crossed = true;
      }
  }
  if (area(p) < 0) std::reverse(p.begin(), p.end());
  return p;
}

/// Teeth of random height over a base line. Many corners are in line, also on the base.
Outline randomHistogram(std::mt19937& rng, int columns) {
  std::uniform_int_distribution<int> height{1, 4};
  Outline p;
  for (int x = 0; x <= columns; ++x) p.push_back({6 * x, 0});
  for (int x = columns - 1; x >= 0; --x) {
    const int h = 6 * height(rng);
    p.push_back({6 * (x + 1), h});
    p.push_back({6 * x, h});
  }
  p.erase(std::unique(p.begin(), p.end()), p.end());
  return p;
}

/// n needles on a spine.
Outline comb(int n) {
  Outline p{{0, -1}, {4 * n, -1}};
  for (int i = n - 1; i >= 0; --i) {
    p.push_back({4 * i + 3, 0});
    p.push_back({4 * i + 2, 1'000'000});
    p.push_back({4 * i + 1, 0});
  }
  return p;
}

/// A band that winds `turns` times about the origin, 2 n corners.
Outline spiral(int n, int turns) {
  Outline p(2 * n);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.141592653589793 * turns * i / n, r = 1e6 + 1e6 * turns * i / n;
    const double x = std::cos(angle), y = std::sin(angle);
    p[i] = {std::lround((r + 4e5) * x), std::lround((r + 4e5) * y)};
    p[2 * n - 1 - i] = {std::lround(r * x), std::lround(r * y)};
  }
  return p;
}

/// A star with n tips and inner corners at a random radius. `crowd` squeezes half of them into a millionth of
/// the turn.
Outline star(int n, bool crowd) {
  std::mt19937 rng{1};
  std::uniform_real_distribution<double> radius{0.2, 0.9};
  Outline p;
  for (int i = 0; i < n; ++i) {
    double turnPart = static_cast<double>(i) / n;
    if (crowd) turnPart = turnPart < 0.5 ? turnPart * 1e-6 : turnPart * 2 - 1;
    if (crowd && i >= n / 2) turnPart = 1e-6 + turnPart * (1 - 1e-6);
    const double angle = 2 * 3.141592653589793 * turnPart, r = 0x1p48 * (i % 2 ? radius(rng) : 1.0);
    p.push_back({std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))});
  }
  return p;
}

// The triangles tile a simple polygon: the number of triangles that hold a sample is the winding number. So
// for stars, for outlines without any order, and where many corners are in line; each of these is used.
TEST(ClipEars, TilesRandomOutlines) {
  for (unsigned seed = 0; seed < 1'200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const int n = static_cast<int>(seed), kind = n % 4;
    const Outline p = kind == 0   ? randomStar(rng, 4 + n / 4 % 40, 3 + n / 4 % 9)
                      : kind == 1 ? randomHistogram(rng, 2 + n / 4 % 12)
                                  : randomTangle(rng, 4 + n / 2 % 30);
    const Triangles triangles = clipEars(p);
    expectTiling(p, triangles, kind < 2 || n % 20 == 2);
    if (kind < 2) expectNoCornerOnASide(p, triangles);
  }
}

// A triangle with k corners on each side has no reflex corner, but it must not be cut along a side.
TEST(ClipEars, TriangleWithCornersOnItsSides) {
  for (int k = 1; k < 12; ++k) {
    Outline p;
    for (int i = 0; i < k; ++i) p.push_back({6 * i, 0});
    for (int i = 0; i < k; ++i) p.push_back({6 * k, 6 * i});
    for (int i = k; i > 0; --i) p.push_back({6 * i, 6 * i});
    const Triangles triangles = clipEars(p);
    expectTiling(p, triangles, k > 1);
    expectNoCornerOnASide(p, triangles);
  }
}

// A hole that is joined to the outside by an edge, run along twice, is left out.
TEST(ClipEars, LeavesOutAHoleJoinedByABridge) {
  const Outline p{{0, 0},   {60, 0},  {60, 60}, {0, 60},  {0, 0},
                  {18, 18}, {18, 42}, {42, 36}, {36, 18}, {18, 18}};
  const Outline hole{{18, 18}, {36, 18}, {42, 36}, {18, 42}};
  EXPECT_TRUE(area(p) == 2 * 60 * 60 - area(hole));
  expectTiling(p, clipEars(p), true);
}

// At the largest coordinates the cuts are the same as at a small scale.
TEST(ClipEars, IsExactAtTheLimits) {
  const std::int64_t k = std::int64_t{1} << 58;
  std::mt19937 rng{58};
  for (int round = 0; round < 50; ++round) {
    const Outline p = randomHistogram(rng, 5);  // at most 30 steps wide
    Outline huge;
    for (const LatticePoint& q : p) huge.push_back({q.x / 6 * (k / 8), q.y / 6 * (k / 8)});
    EXPECT_EQ(clipEars(p), clipEars(huge));
  }
}

// For every outline the function ends with n - 2 triangles of three different corners each.
TEST(ClipEars, EndsOnOutlinesThatCrossThemselves) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    std::mt19937 rng{seed};
    std::uniform_int_distribution<int> coordinate{0, seed % 3 ? 4 : 1000};
    Outline p(3 + seed % 30);
    for (LatticePoint& q : p) q = {coordinate(rng), seed % 5 ? coordinate(rng) : 0};
    const Triangles triangles = clipEars(p);
    ASSERT_EQ(triangles.size(), p.size() - 2);
    std::vector<int> uses(p.size(), 0);
    for (const auto& [a, b, c] : triangles) {
      EXPECT_TRUE(a != b && b != c && c != a);
      for (const int corner : {a, b, c}) ++uses[corner];
    }
    EXPECT_EQ(std::count(uses.begin(), uses.end(), 0), 0);
  }
}

// Large outlines of the shapes that make naive clipping quadratic. The tiling is right, and the test ends
// within its time limit.
TEST(ClipEars, LargeCombSpiralAndStars) {
  for (const Outline& p :
       {comb(33'333), spiral(50'000, 10), spiral(50'000, 500), star(100'000, false), star(100'000, true)})
    expectTiling(p, clipEars(p), false);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
