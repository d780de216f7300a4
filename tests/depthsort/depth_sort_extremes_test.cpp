#include <gtest/gtest.h>

#include "tests/support/painted.h"
#include "tests/support/random_scenes.h"

namespace xnewell::THIS_FILE {

namespace {

/// Adds a rectangle of the screen, in half pixels. Its depth starts at z and grows by `rise` for each half
/// pixel along (dx, dy).
void addShingle(SnappedScene& scene, int x, int y, int wide, int high, int dx, int dy, int z, int rise) {
  const auto corner = [&](int u, int v) {
    const int along = (dx > 0 ? u : dx < 0 ? wide - u : 0) + (dy > 0 ? v : 0);
    return glm::ivec3{(x + u) * kGrid / 2, (y + v) * kGrid / 2, z + along * rise};
  };
  addFace(scene, {corner(0, 0), corner(0, high), corner(wide, high), corner(wide, 0)});
}

constexpr int kPerRow = 400;

/// A band of shingles that winds down the picture. Each lies on the beginning of the next one, although that
/// is nearer at its farthest point. So all must be painted in the opposite order of their farthest z.
SnappedScene shingles(int count) {
  SnappedScene scene;
  constexpr int kStep = 10'000, kRise = 10'000;
  for (int i = 0; i < count; ++i) {
    const int row = i / kPerRow, column = row % 2 ? kPerRow - 1 - i % kPerRow : i % kPerRow;
    const int x = 4 * column + 4, y = 4 * row, z = i * kStep;
    if (i % kPerRow == kPerRow - 1)
      addShingle(scene, x, y, 3, 6, 0, 1, z, kRise);
    else if (row % 2 == 0)
      addShingle(scene, x, y, 6, 3, 1, 0, z, kRise);
    else
      addShingle(scene, x - 3, y, 6, 3, -1, 0, z, kRise);
  }
  return scene;
}

void expectOracle(const SnappedScene& scene, const SortedScene& sorted, int width, int height) {
  EXPECT_EQ(painted(scene, sorted, width, height), visibleFaces(scene, width, height));
}

}  // namespace

// A chain as long as the scene: the stack of marks is a hundred thousand deep, and nothing recurses.
TEST(DepthSortExtremes, ChainOfAHundredThousand) {
  const SnappedScene scene = shingles(100'000);
  const int width = 2 * kPerRow + 4, height = 2 * 100'000 / kPerRow + 4;
  const SortedScene sorted = depthSort(scene, {width, height});
  EXPECT_EQ(sorted.statistics.deepest, 100'000);
  EXPECT_EQ(sorted.statistics.moves, 99'999);
  EXPECT_EQ(sorted.statistics.splits, 0);
  for (int k = 0; k < 100'000; ++k) ASSERT_EQ(sorted.fragments[k].face, 99'999 - k);
  expectOracle(scene, sorted, width, height);
}

TEST(DepthSortExtremes, ChainInEveryRun) {
  const SnappedScene scene = shingles(2'000);
  for (const bool textbook : {false, true})
    for (const bool grid : {false, true}) {
      const SortedScene sorted = depthSort(scene, {2 * kPerRow + 4, 40, textbook, grid});
      EXPECT_EQ(sorted.statistics.deepest, 2'000);
      expectOracle(scene, sorted, 2 * kPerRow + 4, 40);
    }
}

// Copies lie in one plane. Nothing is split, and the last one of the scene is seen.
TEST(DepthSortExtremes, OfThousandsOfCopiesTheLastIsSeen) {
  SnappedScene scene = randomScene(SceneKind::BigTriangles, 1, 1, 16);
  while (scene.faces.size() < 2'000) addCopy(scene, 0);
  for (const bool textbook : {false, true}) {
    const SortedScene sorted = depthSort(scene, {16, 16, textbook});
    EXPECT_EQ(sorted.fragments.size(), 2'000u);
    EXPECT_EQ(sorted.statistics.splits, 0);
    EXPECT_EQ(sorted.statistics.moves, 0);
    int covered = 0;
    for (const int face : painted(scene, sorted, 16, 16)) {
      EXPECT_TRUE(face == kNothing || face == 1'999);
      covered += face != kNothing;
    }
    EXPECT_GT(covered, 0);
  }
}

// The same with faces that cross the copies: the splits go through all copies.
TEST(DepthSortExtremes, CopiesThatCross) {
  SnappedScene scene = randomScene(SceneKind::BigTriangles, 5, 4, 16);
  for (int i = 0; i < 200; ++i) addCopy(scene, i % 4);
  for (const bool textbook : {false, true}) {
    const SortedScene sorted =
        depthSort(scene, {.width = 16, .height = 16, .textbook = textbook, .areas = false});
    EXPECT_GT(sorted.statistics.splits, 100);
    expectOracle(scene, sorted, 16, 16);
  }
  // In areas, copies are dropped before anything is split by them.
  const SortedScene sorted = depthSort(scene, {16, 16});
  EXPECT_GT(sorted.statistics.hidden, 100);
  expectOracle(scene, sorted, 16, 16);
}

TEST(DepthSortExtremes, NothingToPaint) {
  for (const bool textbook : {false, true}) {
    const SortedScene sorted = depthSort({}, {5, 5, textbook});
    EXPECT_TRUE(sorted.fragments.empty());
    EXPECT_EQ(sorted.statistics.pairs(), 0);
  }
}

TEST(DepthSortExtremes, OneFace) {
  const SnappedScene scene = randomScene(SceneKind::BigTriangles, 3, 1, 8);
  for (const bool textbook : {false, true}) {
    const SortedScene sorted = depthSort(scene, {8, 8, textbook});
    ASSERT_EQ(sorted.fragments.size(), 1u);
    EXPECT_EQ(sorted.fragments[0].piece, -1);
    EXPECT_EQ(sorted.statistics.deepest, 1);
    expectOracle(scene, sorted, 8, 8);
  }
}

// Faces on every side of the picture, up to its border. The quick run drops them; the textbook's run sorts
// them.
TEST(DepthSortExtremes, AllOutsideThePicture) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const SnappedScene inside = randomScene(SceneKind::Lattice, seed, 8, 10);
    for (const glm::ivec3& away : {glm::ivec3{-10, 0, 0}, {10, 0, 0}, {0, -10, 0}, {0, 10, 0}}) {
      SnappedScene scene;
      for (const SnappedFace& face : inside.faces) {
        std::vector<glm::ivec3> outline;
        for (int k = 0; k < face.count; ++k)
          outline.push_back(inside.vertices[face.first + k] + away * kGrid);
        addFace(scene, outline);
      }
      EXPECT_TRUE(depthSort(scene, {10, 10}).fragments.empty());
      EXPECT_GE(depthSort(scene, {10, 10, true}).fragments.size(), scene.faces.size());
      expectOracle(scene, depthSort(scene, {10, 10, true}), 10, 10);
    }
  }
}

// The widest and the highest picture: walls from corner to corner over the whole depth. Two of them rise by
// the whole depth within one step of the grid.
TEST(DepthSortExtremes, LimitsOfTheGrid) {
  constexpr int L = 1 << 29, Z = 1 << 30;
  SnappedScene scene;
  addFace(scene, {{-L, -L, 0}, {-L, L, 0}, {L, L, Z}, {L, -L, Z}});
  addFace(scene, {{-L, -L, Z}, {-L, L, Z}, {L, L, 0}, {L, -L, 0}});
  addFace(scene, {{-L, -L, 0}, {-L, L, Z}, {L, L, 0}});
  addFace(scene, {{-L, -L, Z}, {L, L, 0}, {L, -L, Z}});
  addFace(scene, {{-L, -L, 0}, {L, L, Z}, {L - 1, L, 0}});
  addFace(scene, {{-L, L, Z}, {L, -L, 0}, {L, -L + 1, Z}});
  for (const bool textbook : {false, true}) {
    SortSettings settings{kMaxPicture, 3, textbook};
    const SortedScene sorted = depthSort(scene, settings);
    EXPECT_GE(sorted.statistics.splits, 3);
    expectOracle(scene, sorted, kMaxPicture, 3);
    settings.width = 3, settings.height = kMaxPicture;
    expectOracle(scene, depthSort(scene, settings), 3, kMaxPicture);
  }
}

// The steepest planes: triangles as thin as a step that cross a sample, over the whole depth, before and
// behind flat faces.
TEST(DepthSortExtremes, EdgeOn) {
  SnappedScene scene;
  const int c = kGrid / 2, Z = 1 << 30;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 sample{i * kGrid + c, 3 * kGrid + c, 0};
    addFace(scene, {sample + glm::ivec3{0, -1, i % 2 ? Z : 0}, sample + glm::ivec3{0, 1, 0},
                    sample + glm::ivec3{1, 0, Z}});
    addFace(scene, {sample + glm::ivec3{0, -1, Z}, sample + glm::ivec3{0, 1, i % 3 ? 0 : Z},
                    sample + glm::ivec3{1, 0, 0}});
  }
  addFace(scene, {{0, 0, Z / 2}, {0, 8 * kGrid, Z / 2}, {16 * kGrid, 0, Z / 2}});
  for (const bool textbook : {false, true}) {
    const SortedScene sorted = depthSort(scene, {8, 8, textbook});
    EXPECT_GT(sorted.statistics.pairs(), 16);
    expectOracle(scene, sorted, 8, 8);
  }
}

}  // namespace xnewell::THIS_FILE
