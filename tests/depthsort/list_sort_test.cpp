#include "tests/support/list_sort.h"

#include <gtest/gtest.h>

#include "tests/support/painted.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kSize = 24;

/// The index of the face painted last at each pixel's centre. For scenes without ties this is the picture.
std::vector<int> paintedList(const ListSorted& sorted) {
  std::vector<int> faces(kSize * kSize, kNothing);
  for (int j = 0; j < kSize; ++j)
    for (int i = 0; i < kSize; ++i)
      for (const ListPolygon& P : sorted.painted)
        if (exactlyCovers(P.region, i, j)) faces[j * kSize + i] = P.face;
  return faces;
}

/// A rectangle from column x0 to x1, with depth z0 at its left side and z1 at its right.
void addRectangle(SnappedScene& scene, int x0, int x1, int z0, int z1) {
  const int top = 4 * kGrid, bottom = 8 * kGrid;
  addFace(scene,
          {{x0 * kGrid, top, z0}, {x0 * kGrid, bottom, z0}, {x1 * kGrid, bottom, z1}, {x1 * kGrid, top, z1}});
}

}  // namespace

// Without splits, the list and the stack paint in the same order, face by face. Moving Q to the end and
// marking it is a depth-first search, and the stack holds the marks.
TEST(ListSort, WithoutSplitsPaintsInTheOrderOfTheStack) {
  const Seeds seeds{640};
  int same = 0, moves = 0, faces = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomScene(seed, 2 + static_cast<int>(seed / kSceneKinds.size()) % 8, kSize);
    const SortedScene stack = depthSort(scene, {kSize, kSize, true});
    ListSettings settings;
    settings.mostSplits = 1;
    const ListSorted list = listSort(scene, settings);
    if (list.splits > 0 || stack.statistics.contacts > 0) continue;
    ++same;
    moves += list.moves;
    ASSERT_EQ(stack.statistics.splits, 0);
    ASSERT_EQ(stack.statistics.moves, list.moves);
    ASSERT_EQ(stack.fragments.size(), list.painted.size());
    for (std::size_t k = 0; k < list.painted.size(); ++k, ++faces)
      ASSERT_EQ(stack.fragments[k].face, list.painted[k].face) << k;
  }
  if (!seeds.all()) return;
  EXPECT_GT(same, 200);
  EXPECT_GT(moves, 100);
  EXPECT_GT(faces, 1'000);
}

// The textbook always splits P by Q's plane, but that plane need not cross P. Then the list stays as it was,
// and the run goes on for ever, most often in cycles.
TEST(ListSort, DemandsSplitsThatDoNotCut) {
  const Seeds seeds{16};
  for (const SceneKind kind : {SceneKind::BigTriangles, SceneKind::Pinwheels}) {
    int idle = 0, endless = 0;
    for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
      SCOPED_TRACE(seed);
      const ListSorted list = listSort(randomScene(kind, seed, 8, kSize));
      idle += list.idle > 0, endless += list.endless;
      // one such split is enough, and nothing else makes the run endless
      EXPECT_EQ(list.idle > 0, list.endless);
    }
    if (!seeds.all()) continue;
    EXPECT_GE(idle, 4);
    EXPECT_GE(endless, 4);
  }
}

// After a move the list is no longer sorted. P rises from depth 0 to 100 over A's end. A lies over B's end,
// and B over C's. So A is moved before P, and B before A. Now B is first, and the list then has A, beyond B's
// z-extent. A scan that stops there does not reach C: B is painted before C, which then hides B's end.
TEST(ListSort, WrongIfItStopsAtTheFirstBeyond) {
  SnappedScene scene;
  addRectangle(scene, 0, 10, 0, 100);   // P
  addRectangle(scene, 8, 14, 50, 50);   // A
  addRectangle(scene, 12, 20, 40, 40);  // B
  addRectangle(scene, 18, 23, 30, 30);  // C
  ListSettings settings;
  const ListSorted patient = listSort(scene, settings);
  settings.stopAtFirstBeyond = true;
  const ListSorted hasty = listSort(scene, settings);
  const std::vector<int> seen = visibleFaces(scene, kSize, kSize);
  EXPECT_EQ(patient.moves, 3);
  EXPECT_EQ(paintedList(patient), seen);
  EXPECT_EQ(hasty.moves, 2);
  EXPECT_EQ(seen[5 * kSize + 19], 2);
  EXPECT_EQ(paintedList(hasty)[5 * kSize + 19], 3);
}

// ConvexParts that keep the mark of their parent are split where moving them would do, and again: more than
// sixty splits of five triangles, where a few are enough.
TEST(ListSort, EndlessIfPiecesInheritMarks) {
  const Seeds seeds{60};
  int endless = 0, better = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    const SnappedScene scene = randomScene(SceneKind::BigTriangles, seed, 5, kSize);
    ListSettings settings;
    const ListSorted plain = listSort(scene, settings);
    if (plain.splits == 0 || plain.endless) continue;
    settings.piecesInheritMarks = true;
    ++better;
    endless += listSort(scene, settings).endless;
  }
  if (!seeds.all()) return;
  EXPECT_GT(better, 30);
  EXPECT_GT(endless, 10);
}

}  // namespace xnewell::THIS_FILE
