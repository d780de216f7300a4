#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "depthsort/box_grid.h"
#include "depthsort/fragment_spans.h"
#include "depthsort/oracle.h"
#include "depthsort/region.h"
#include "tests/support/exact_region.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Regions

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
  const auto exactCorner = [&](std::size_t k) {
    const Side &side = region[k], &next = region[k + 1 == region.size() ? 0 : k + 1];
    return side.corner.exact() ? ExactPoint{Rational{side.corner.x}, Rational{side.corner.y}}
                               : meeting(exactly(scene, side.line), exactly(scene, next.line));
  };
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
      const ExactPoint corner = exactCorner(k);
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
      const ExactPoint corner = exactCorner(k);
      ASSERT_TRUE(std::ranges::any_of(
          exact, [&](const ExactPoint& p) { return p.x == corner.x && p.y == corner.y; }));
    }
    for (const ExactPoint& p : exact)
      ASSERT_TRUE(std::ranges::any_of(
          region, [&](const Side& side) { return valueAt(exactly(scene, side.line), p) == 0; }));
  }
}

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

/// ---- Samples of fragments

/// The sign by the definition of the sample rule, in rational arithmetic.
int exactSignAtSample(const ExactLine& line, int i, int j) {
  const Rational value = valueAt(line, {Rational{2 * i + 1, 2} * kGrid, Rational{2 * j + 1, 2} * kGrid});
  return (value != 0 ? value : line.a != 0 ? line.a : line.b).sign();
}

// The sides of samples, and their owners, agree with rational arithmetic. The regions are parts of faces
// clipped by the planes of others, many of them thin, in pictures that do not show them whole.
TEST(Samples, AreOwnedByTheRule) {
  const Seeds seeds{1600};
  int owning = 0, empty = 0, ties = 0, asked = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const int width = 1 + static_cast<int>(rng() % 12), height = 1 + static_cast<int>(rng() % 12);
    const SnappedScene scene = randomScene(seed, 5, 12);
    const Regions regions{scene};
    Region region;
    regions.outline(scene.faces[0], region);
    ExactRegion exact = exactOutline(scene, scene.faces[0]);
    for (std::size_t f = 0; f < scene.faces.size() && !region.empty(); ++f) {
      const int over = scene.faces[0].plane, under = scene.faces[f].plane;
      if (!regions.samePlane(over, under)) {
        const Line cut = regions.cut(over, under);
        const ExactLine exactCut = exactDifference(scene.planes[over], scene.planes[under]);
        for (int k = 0; k < 4; ++k) {
          const int i = static_cast<int>(rng() % 12), j = static_cast<int>(rng() % 12);
          ASSERT_EQ(signAtSample(scene, cut, i, j), exactSignAtSample(exactCut, i, j));
          ties += valueAt(exactCut, {Rational{2 * i + 1, 2} * kGrid, Rational{2 * j + 1, 2} * kGrid}) == 0;
          ++asked;
        }
        const bool flip = rng() % 2;
        regions.clip(region, flip ? Regions::flipped(cut) : cut);
        exact = clipped(exact, flip ? exactDifference(scene.planes[under], scene.planes[over]) : exactCut);
      }
      if (region.empty()) break;
      const bool owns = exactlyOwnsSample(exact, width, height);
      ASSERT_EQ(ownsSample(scene, region, width, height), owns);
      ++(owns ? owning : empty);
    }
  }
  if (!seeds.all()) return;
  EXPECT_GT(owning, 1'500);
  EXPECT_GT(empty, 500);
  EXPECT_GT(asked, 8'000);
  EXPECT_GT(ties, 20);
}

// A face that is left out owns no sample. Every face that owns no sample, and whose box has at most four
// samples, is left out.
TEST(Samples, MayOwnIsFalseOnlyWhereNoneIsOwned) {
  const Seeds seeds{3200};
  int may = 0, none = 0, needless = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const int width = 1 + static_cast<int>(seed % 10), height = 1 + static_cast<int>(seed % 9);
    for (const SnappedScene& scene : {randomScene(seed, 3, 10), randomScene(SceneKind::Tiny, seed, 3, 10)})
      for (const SnappedFace& face : scene.faces) {
        const glm::ivec3* const v = &scene.vertices[face.first];
        const auto [x0, x1] =
            std::minmax_element(v, v + face.count, [](auto& a, auto& b) { return a.x < b.x; });
        const auto [y0, y1] =
            std::minmax_element(v, v + face.count, [](auto& a, auto& b) { return a.y < b.y; });
        const bool owns = exactlyOwnsSample(exactOutline(scene, face), width, height);
        const bool mayOwn = mayOwnSample(scene, face, {x0->x, y0->y, x1->x, y1->y}, width, height);
        ASSERT_TRUE(mayOwn || !owns);
        if (x1->x - x0->x < 2 * kGrid && y1->y - y0->y < 2 * kGrid) {
          ASSERT_EQ(mayOwn, owns);
        }
        ++(mayOwn ? may : none);
        needless += mayOwn && !owns;
      }
  }
  if (!seeds.all()) return;
  EXPECT_GT(may, 5'000);
  EXPECT_GT(none, 2'000);
  EXPECT_GT(needless, 0);
}

// A region is thick if 2 area / diameter is more than 64 steps.
TEST(Samples, WideIsThickerThanTheBound) {
  const auto rectangle = [](int wide, int high) {
    SnappedScene scene;
    addFace(scene, {{0, 0, 0}, {0, high, 0}, {wide, high, 0}, {wide, 0, 0}});
    Region region;
    Regions{scene}.outline(scene.faces[0], region);
    return region;
  };
  EXPECT_FALSE(isWide(rectangle(1 << 20, 31)));
  EXPECT_FALSE(isWide(rectangle(31, 1 << 20)));
  EXPECT_TRUE(isWide(rectangle(1 << 20, 33)));
  EXPECT_TRUE(isWide(rectangle(33, 1 << 20)));
}

// A walk along a cut leaves the columns of a row that are on its side, in rational arithmetic too.
TEST(FragmentSpans, CutWalkLeavesWhatIsOnItsSide) {
  const Seeds seeds{800};
  int some = 0, allOrNone = 0, level = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomScene(seed, 4, 40);
    for (int p = 0; p < static_cast<int>(scene.planes.size()); ++p)
      for (int q = 0; q < static_cast<int>(scene.planes.size()); ++q) {
        const ExactLine difference = exactDifference(scene.planes[p], scene.planes[q]);
        if (difference.a == 0 && difference.b == 0) continue;
        const CutWalk walk{scene, {p, q}};
        for (int row = 0; row < 40; row += 7) {
          const Columns all{row / 3, 40 - row / 2};
          Columns kept = all;
          walk.clip(row, kept);
          for (int i = all.from; i < all.to; ++i)
            ASSERT_EQ(kept.from <= i && i<kept.to, exactSignAtSample(difference, i, row)> 0)
                << "row " << row << ", column " << i;
          const int count = std::max(0, kept.to - kept.from);
          ++(count > 0 && count < all.to - all.from ? some : allOrNone);
          level += difference.a == 0;
        }
      }
  }
  if (!seeds.all()) return;
  EXPECT_GT(some, 2'000);
  EXPECT_GT(allOrNone, 2'000);
  EXPECT_GT(level, 100);
}

/// ---- Boxes in a grid

constexpr int kLimit = 1 << 29;

/// Boxes of one kind: any size, small, strips along x or y, all sizes mixed, points, at the limits.
std::vector<ScreenBox> randomBoxes(unsigned seed, int count) {
  std::mt19937 rng{seed};
  const auto uniform = [&](int low, int high) { return std::uniform_int_distribution{low, high}(rng); };
  const int kind = static_cast<int>(seed % 7), area = 1 << uniform(4, 29);
  std::vector<ScreenBox> boxes;
  while (static_cast<int>(boxes.size()) < count) {
    const auto length = [&](bool along) {
      switch (kind) {
        case 0:
          return uniform(0, 2 * area);
        case 1:
          return uniform(0, area / 16);
        case 2:
          return along ? area : uniform(0, area / 64);
        case 3:
          return along ? uniform(0, area / 64) : area;
        case 4:
          return uniform(0, 1 << uniform(0, 30));
        case 5:
          return 0;
        default:
          return uniform(0, 2) * kLimit;
      }
    };
    const int wide = length(true), high = length(false);
    const int x = kind == 6 ? -kLimit : uniform(-area, area), y = kind == 6 ? -kLimit : uniform(-area, area);
    const auto end = [](int from, int by) {
      return static_cast<int>(std::min<std::int64_t>(kLimit, std::int64_t{from} + by));
    };
    boxes.push_back({x, y, end(x, wide), end(y, high)});
  }
  return boxes;
}

ScreenBox within(const ScreenBox& b, std::mt19937& rng) {
  const auto uniform = [&](int low, int high) { return std::uniform_int_distribution{low, high}(rng); };
  const int x0 = uniform(b.x0, b.x1), y0 = uniform(b.y0, b.y1);
  return {x0, y0, uniform(x0, b.x1), uniform(y0, b.y1)};
}

// A walk for a box visits no cell twice and reaches every box that overlaps it. If the box shrinks on the
// way, the walk reaches every box that overlaps what is left at the end.
TEST(BoxGrid, WalkFindsAllThatOverlap) {
  long long overlaps = 0, visited = 0, all = 0;
  std::size_t mostCells = 0;
  for (unsigned seed = 0; seed < 700; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const std::vector<ScreenBox> boxes = randomBoxes(seed, 1 + static_cast<int>(seed) % 150);
    for (const bool fine : {true, false}) {
      const BoxGrid grid{boxes, fine};
      mostCells = std::max(mostCells, static_cast<std::size_t>(grid.cells()));
      if (!fine) {
        ASSERT_EQ(grid.cells(), 1);
      }
      for (const ScreenBox& b : boxes) {
        ASSERT_GE(grid.cellOf(b), 0);
        ASSERT_LT(grid.cellOf(b), grid.cells());
      }
      for (const ScreenBox& whole : boxes)
        for (const bool shrinks : {false, true}) {
          std::vector<int> visits(grid.cells());
          ScreenBox box = whole;
          BoxGrid::Place place;
          while (grid.settle(box, place)) {
            ASSERT_LT(grid.cell(place), grid.cells());
            ++visits[grid.cell(place)];
            if (shrinks && rng() % 8 == 0) box = within(box, rng);
            ++place.column;
          }
          ASSERT_LE(*std::ranges::max_element(visits), 1);
          for (const ScreenBox& other : boxes) {
            const int found = visits[grid.cellOf(other)];
            if (box.overlaps(other)) {
              ASSERT_EQ(found, 1);
            }
            overlaps += box.overlaps(other);
            if (fine && !shrinks) visited += found, ++all;
          }
        }
    }
  }
  EXPECT_GT(overlaps, 100'000);
  EXPECT_GT(mostCells, 150u);
  EXPECT_LT(visited, all * 2 / 3);  // otherwise a single cell would do as well
}

}  // namespace

}  // namespace xnewell::THIS_FILE
