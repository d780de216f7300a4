#include "depthsort/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/exact_region.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

ExactLine exactly(const SnappedScene& scene, const Line& line) {
  return line.kind == Line::Kind::Edge ? exactEdge(scene.vertices[line.p], scene.vertices[line.q])
                                       : exactDifference(scene.planes[line.p], scene.planes[line.q]);
}
ExactPoint meeting(const ExactLine& l, const ExactLine& m) {
  const Rational w = l.a * m.b - m.a * l.b;
  return {(l.b * m.c - m.b * l.c) / w, (m.a * l.c - l.a * m.c) / w};
}
int signOf(const Rational& r) { return r.sign(); }

/// True if the doubles decide in sign(), which tries them first.
bool doublesDecide(const Line& line, const Corner& at) {
  const double value = line.a * at.x + line.b * at.y + line.c;
  return std::abs(value) > 0x1p-49 * (std::abs(at.x) + std::abs(at.y) + std::abs(line.c)) + 2.0 * at.radius;
}

struct Asked {
  int doubles = 0, integers = 0, zeros = 0, corners = 0;
};

/// A line of the scene: an edge, or the line where two different planes meet.
Line randomLine(const Regions& regions, const SnappedScene& scene, std::mt19937& rng) {
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution{0, static_cast<int>(n) - 1}(rng);
  };
  if (scene.planes.size() == 1 || below(3) == 0) {
    const SnappedFace& face = scene.faces[below(scene.faces.size())];
    const int k = below(face.count);
    return regions.edge(face.first + k, face.first + (k + 1) % face.count);
  }
  const int p = below(scene.planes.size());
  return regions.cut(p, (p + 1 + below(scene.planes.size() - 1)) % static_cast<int>(scene.planes.size()));
}

/// Triangles whose first edges and planes pass a common point V at 2^-22 step or less, or go through it. A
/// line through V + u and V - k u + d, with d at most a step, passes V at a distance of d / (k + 1). The
/// first face is large and surrounds V.
SnappedScene nearlyConcurrent(unsigned seed) {
  std::mt19937 rng{seed};
  const auto uniform = [&](int low, int high) { return std::uniform_int_distribution{low, high}(rng); };
  SnappedScene scene;
  const glm::ivec3 V{uniform(0, 1 << 27), uniform(0, 1 << 27), 1 << 29};
  addFace(scene, {V + glm::ivec3{-(1 << 28), -(1 << 28), 7}, V + glm::ivec3{0, 1 << 28, 0},
                  V + glm::ivec3{1 << 28, -(1 << 27), -9}});
  while (scene.faces.size() < 6) {
    const glm::ivec3 u{uniform(-15, 15), uniform(-15, 15), uniform(-15, 15)};
    const glm::ivec3 d{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    const glm::ivec3 w{uniform(-1 << 20, 1 << 20), uniform(-1 << 20, 1 << 20), uniform(-1 << 20, 1 << 20)};
    addFace(scene, {V + u, V - u * uniform(1 << 22, 1 << 24) + d, V + w});
  }
  return scene;
}

/// Clips a region by lines of the scene, both quickly and exactly, and compares the signs of every line at
/// every corner.
void expectExact(const SnappedScene& scene, unsigned seed, Asked& asked) {
  std::mt19937 rng{seed};
  const Regions regions{scene};
  Region region;
  regions.outline(scene.faces[0], region);
  ExactRegion exact;
  for (const Side& side : region) exact.push_back({Rational{side.corner.x}, Rational{side.corner.y}});
  for (int cuts = 0; cuts < 5 && !region.empty(); ++cuts) {
    const Line line = randomLine(regions, scene, rng);
    const ExactLine exactLine = exactly(scene, line);
    const bool nowhere = exactLine.a == 0 && exactLine.b == 0 && exactLine.c == 0;
    ASSERT_EQ(nowhere, line.kind == Line::Kind::Cut && regions.samePlane(line.p, line.q));
    if (nowhere) continue;
    // Up to a common scale, the coefficients are as accurate as their bound says.
    const double a = exactLine.a.convert_to<double>(), b = exactLine.b.convert_to<double>();
    const double scale = std::max(std::abs(a), std::abs(b));
    if (scale > 0.0) {
      const double c = Rational{exactLine.c / Rational{scale}}.convert_to<double>();
      ASSERT_NEAR(line.a, a / scale, 0x1p-50);
      ASSERT_NEAR(line.b, b / scale, 0x1p-50);
      ASSERT_NEAR(line.c, c, 0x1p-50 * std::abs(c));
    }
    Signs signs;
    for (std::size_t k = 0; k < region.size(); ++k) {
      const Side &side = region[k], &next = region[k + 1 == region.size() ? 0 : k + 1];
      const ExactPoint corner = side.corner.exact()
                                    ? ExactPoint{Rational{side.corner.x}, Rational{side.corner.y}}
                                    : meeting(exactly(scene, side.line), exactly(scene, next.line));
      ASSERT_LE(abs(Rational{corner.x - Rational{side.corner.x}}), Rational{side.corner.radius});
      ASSERT_LE(abs(Rational{corner.y - Rational{side.corner.y}}), Rational{side.corner.radius});
      const int sign = signOf(valueAt(exactLine, corner));
      ASSERT_EQ(regions.sign(line, side.line, next.line, side.corner), sign);
      ++(doublesDecide(line, side.corner) ? asked.doubles : asked.integers);
      asked.zeros += sign == 0;
      ++asked.corners;
      signs.add(sign);
    }
    ASSERT_EQ(regions.signs(line, region).positive, signs.positive);
    ASSERT_EQ(regions.signs(line, region).negative, signs.negative);
    regions.clip(region, line);
    exact = clipped(exact, exactLine);
    ASSERT_EQ(region.empty(), exact.empty());
    // The corners are the same, except for those in the middle of a side.
    for (std::size_t k = 0; k < region.size(); ++k) {
      const Side &side = region[k], &next = region[k + 1 == region.size() ? 0 : k + 1];
      const ExactPoint corner = side.corner.exact()
                                    ? ExactPoint{Rational{side.corner.x}, Rational{side.corner.y}}
                                    : meeting(exactly(scene, side.line), exactly(scene, next.line));
      ASSERT_TRUE(std::ranges::any_of(
          exact, [&](const ExactPoint& p) { return p.x == corner.x && p.y == corner.y; }));
    }
    for (const ExactPoint& p : exact)
      ASSERT_TRUE(std::ranges::any_of(
          region, [&](const Side& side) { return valueAt(exactly(scene, side.line), p) == 0; }));
  }
}

}  // namespace

// The coefficients, corners, signs and clips agree with rational arithmetic, in scenes of every kind.
TEST(Region, IsExact) {
  const Seeds seeds{1600};
  Asked asked;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    expectExact(randomScene(seed, 6, 16), seed, asked);
    if (HasFatalFailure()) return;
  }
  if (!seeds.all()) return;
  EXPECT_GT(asked.doubles, 10'000);
  EXPECT_GT(asked.zeros, 1'000);
}

// The same where lines pass a point so closely that doubles cannot decide. The integers find both signs, and
// 0 where three lines go through one point.
TEST(Region, IsExactWhereDoublesAreNot) {
  const Seeds seeds{1500};
  Asked asked;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    expectExact(nearlyConcurrent(seed), seed, asked);
    if (HasFatalFailure()) return;
  }
  if (!seeds.all()) return;
  EXPECT_GT(asked.doubles, 10'000);
  EXPECT_GT(asked.integers - asked.zeros, 500);
  EXPECT_GT(asked.zeros, 1'000);
}

// A negative constant of a cut line far below 2^64 is as exact as any other. Here it is -3. As a double it
// was once 0, so that two planes 3 steps apart were taken for one.
TEST(Region, SmallNegativeConstantOfACut) {
  SnappedScene scene;
  for (const int z : {5, 8}) addFace(scene, {{0, 0, z}, {0, 1, z}, {1, 0, z}});
  const Regions regions{scene};
  EXPECT_EQ(regions.cut(0, 1).c, -3.0);
  EXPECT_EQ(regions.cut(1, 0).c, 3.0);
  EXPECT_FALSE(regions.samePlane(0, 1));
}

}  // namespace xnewell::THIS_FILE
