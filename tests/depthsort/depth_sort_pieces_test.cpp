#include <gtest/gtest.h>

#include "depthsort/fragment_spans.h"
#include "tests/support/exact_region.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kSize = 32;

/// The splits of a run as its events tell them. The tree finds the fragment that owns a sample from the
/// events alone: it goes down from the face, at every split to the piece on the sample's side of the
/// splitting plane.
class SplitTree {
 public:
  SplitTree(const SnappedScene& scene, const SortedScene& sorted)
      : scene_{scene},
        faces_{static_cast<int>(scene.faces.size())},
        by_(faces_ + sorted.pieces.size(), -1),
        first_(by_.size(), -1) {
    int splits = 0;
    for (const Event& event : sorted.events)
      if (event.kind == Event::Kind::Split) {
        by_[event.P] = event.Q;
        first_[event.P] = faces_ + 2 * splits++;
      }
    faceOf_.resize(by_.size());
    for (int f = 0; f < faces_; ++f) faceOf_[f] = f;
    for (std::size_t k = 0; k < sorted.pieces.size(); ++k) faceOf_[faces_ + k] = sorted.pieces[k].face;
  }
  [[nodiscard]] const ScreenPlane& planeOf(int id) const {
    return scene_.planes[scene_.faces[faceOf_[id]].plane];
  }
  /// The fragment whose plane split it, or -1 if it was not split.
  [[nodiscard]] int splitBy(int id) const { return by_[id]; }
  [[nodiscard]] int owner(int face, int i, int j) const {
    int id = face;
    while (by_[id] >= 0) id = first_[id] + (nearer(planeOf(id), planeOf(by_[id]), i, j) > 0);
    return id;
  }

 private:
  const SnappedScene& scene_;
  int faces_;
  std::vector<int> by_, first_, faceOf_;
};

}  // namespace

// Every painted sample of a face belongs to one of its fragments, the one on its side of all splits, and is
// painted by it once. The rows of a piece contain all its samples.
TEST(ConvexParts, OwnTheSamplesOfTheirFaceOnce) {
  const Seeds seeds{960};
  int splits = 0, ofPieces = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(testing::Message() << "XNEWELL_SEED=" << seed);
    const SnappedScene scene = randomScene(seed, 3 + static_cast<int>(seed / kSceneKinds.size()) % 16, kSize);
    SortSettings settings{kSize, kSize, seed % 2 == 0};
    settings.record = true;
    const SortedScene sorted = depthSort(scene, settings);
    const SplitTree tree{scene, sorted};
    const int faces = static_cast<int>(scene.faces.size());
    std::vector<std::vector<int>> painter(faces, std::vector<int>(kSize * kSize, -1));
    for (const Fragment& fragment : sorted.fragments) {
      const int id = fragment.piece < 0 ? fragment.face : faces + fragment.piece;
      forEachSpan(scene, sorted, fragment, kSize, kSize, [&](int row, int from, int to) {
        ASSERT_TRUE(row >= 0 && row < kSize && from >= 0 && from < to && to <= kSize);
        for (int i = from; i < to; ++i) {
          int& before = painter[fragment.face][row * kSize + i];
          ASSERT_EQ(before, -1) << "painted twice";
          before = id;
        }
      });
    }
    for (int f = 0; f < faces; ++f)
      forEachSpan(&scene.vertices[scene.faces[f].first], scene.faces[f].count, kSize, kSize,
                  [&](int row, int from, int to) {
                    for (int i = from; i < to; ++i) {
                      const int owner = tree.owner(f, i, row);
                      ASSERT_EQ(painter[f][row * kSize + i], owner)
                          << "face " << f << ", " << i << ", " << row;
                      if (owner < faces) continue;
                      ++ofPieces;
                      const Piece& piece = sorted.pieces[owner - faces];
                      ASSERT_GE(row, piece.area.top);
                      ASSERT_LT(row, piece.area.bottom);
                    }
                  });
    splits += static_cast<int>(sorted.statistics.splits);
    if (HasFatalFailure()) return;
  }
  if (!seeds.all()) return;
  EXPECT_GT(splits, 4'000);
  EXPECT_GT(ofPieces, 100'000);
}

// A split is proper. Both pieces have an area, together that of the polygon that was split, and they have no
// common area. So no plane splits a piece of a polygon that it split. Each piece lies within its parent and
// is of the same face.
TEST(ConvexParts, ComeFromProperCuts) {
  const Seeds seeds{480};
  int checked = 0;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(testing::Message() << "XNEWELL_SEED=" << seed);
    const SnappedScene scene = randomScene(seed, 3 + static_cast<int>(seed / kSceneKinds.size()) % 10, kSize);
    SortSettings settings{kSize, kSize, seed % 2 == 0};
    settings.record = true;
    const SortedScene sorted = depthSort(scene, settings);
    const SplitTree tree{scene, sorted};
    const int faces = static_cast<int>(scene.faces.size());
    const auto regionOf = [&](int id) {
      return id < faces ? exactFragment(scene, sorted, {id})
                        : exactFragment(scene, sorted, {sorted.pieces[id - faces].face, id - faces});
    };
    int k = 0;
    for (const Event& event : sorted.events) {
      if (event.kind != Event::Kind::Split) continue;
      const Piece &behind = sorted.pieces[2 * k], &front = sorted.pieces[2 * k + 1];
      ++k;
      ++checked;
      ASSERT_EQ(behind.parent, event.P);
      ASSERT_EQ(front.parent, event.P);
      const int face = event.P < faces ? event.P : sorted.pieces[event.P - faces].face;
      ASSERT_EQ(behind.face, face);
      ASSERT_EQ(front.face, face);
      const ExactRegion whole = regionOf(event.P), back = regionOf(faces + 2 * k - 2),
                        rest = regionOf(faces + 2 * k - 1);
      const ExactLine ahead = exactDifference(tree.planeOf(event.P), tree.planeOf(event.Q));
      ASSERT_FALSE(back.empty());
      ASSERT_FALSE(rest.empty());
      ASSERT_EQ(exactDoubleArea(back) + exactDoubleArea(rest), exactDoubleArea(whole));
      ASSERT_LE(greatest(ahead, back), 0);
      ASSERT_LE(greatest({-ahead.a, -ahead.b, -ahead.c}, rest), 0);
      ASSERT_EQ(exactDoubleArea(common(back, whole)), exactDoubleArea(back));
      for (int id = event.P; id >= faces;) {
        id = sorted.pieces[id - faces].parent;
        ASSERT_FALSE(samePlane(tree.planeOf(event.Q), tree.planeOf(tree.splitBy(id))))
            << "split by it before";
      }
    }
    ASSERT_EQ(sorted.pieces.size(), 2u * k);
  }
  if (!seeds.all()) return;
  EXPECT_GT(checked, 1'000);
}

}  // namespace xnewell::THIS_FILE
