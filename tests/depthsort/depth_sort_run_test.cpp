#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "depthsort/depth_sort.h"
#include "depthsort/fragment_spans.h"
#include "tests/support/exact_region.h"
#include "tests/support/painted.h"
#include "tests/support/random_scenes.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Events

/// Follows the events of a run with nothing but the textbook's marks, and checks whether each event may
/// happen.
class Replay {
 public:
  Replay(const SnappedScene& scene, const SortedScene& sorted)
      : sorted_{sorted},
        faces_{static_cast<int>(scene.faces.size())},
        state_(faces_ + sorted.pieces.size()) {}

  void follow() {
    for (const Event& event : sorted_.events) {
      SCOPED_TRACE(testing::Message() << "event " << at_ << ", P " << event.P << ", Q " << event.Q);
      step(event);
      if (testing::Test::HasFatalFailure()) return;
      ++at_;
    }
    EXPECT_TRUE(marked_.empty());
    EXPECT_EQ(painted_, static_cast<int>(sorted_.fragments.size()));
    EXPECT_EQ(sorted_.pieces.size(), 2u * statistics.splits);
  }

  SortStatistics statistics;

 private:
  enum class State { Waiting, Marked, Split, Painted };
  using Kind = Event::Kind;

  [[nodiscard]] int faceOf(int id) const { return id < faces_ ? id : sorted_.pieces[id - faces_].face; }
  [[nodiscard]] bool open(int id) const {
    return state_[id] == State::Waiting || state_[id] == State::Marked;
  }
  [[nodiscard]] bool exists(int id) const {
    return id >= 0 && id < faces_ + 2 * static_cast<int>(statistics.splits);
  }
  void mark(int id) {
    ASSERT_EQ(state_[id], State::Waiting);
    state_[id] = State::Marked;
    marked_.push_back(id);
    statistics.deepest = std::max(statistics.deepest, static_cast<int>(marked_.size()));
  }
  void unmarkFrom(std::vector<int>::const_iterator first) {
    for (auto id = first; id != marked_.end(); ++id) state_[*id] = State::Waiting;
    marked_.erase(first, marked_.end());
  }
  /// True if the polygon is marked and not below the polygon that closed the last cycle.
  [[nodiscard]] bool inCycle(int id) const { return std::find(cycle_, marked_.end(), id) != marked_.end(); }
  void step(const Event& event);

  const SortedScene& sorted_;
  int faces_, at_ = 0, painted_ = 0;
  std::vector<State> state_;
  std::vector<int> marked_;
  std::vector<int>::const_iterator cycle_;
  Event last_{};
};

void Replay::step(const Event& event) {
  const auto [kind, test, verdict, contact, P, Q] = event;
  ASSERT_TRUE(exists(P));
  ASSERT_EQ(Q >= 0, kind != Kind::Take && kind != Kind::Paint);
  if (Q >= 0) {
    ASSERT_TRUE(exists(Q));
    ASSERT_NE(faceOf(P), faceOf(Q)) << "of one face";
    ASSERT_TRUE(open(P));
    ASSERT_TRUE(open(Q));
  }
  const bool qFirst =
      last_.kind == Kind::Compare && last_.verdict == Verdict::QFirst && last_.P == P && last_.Q == Q;
  switch (kind) {
    case Kind::Take:
      ASSERT_TRUE(marked_.empty());
      mark(P);
      break;
    case Kind::Compare:
      ASSERT_EQ(P, marked_.back());
      ++statistics.settled[static_cast<int>(test)];
      statistics.contacts += contact;
      if (test != xnewell::Test::Overlap) {
        ASSERT_FALSE(contact);
        ASSERT_NE(verdict, Verdict::Crossing);
        const bool canOnlyPass = test >= xnewell::Test::XExtents && test <= xnewell::Test::Projections;
        const bool canOnlyFail = test == xnewell::Test::QBehindP || test == xnewell::Test::PInFrontOfQ;
        ASSERT_FALSE(canOnlyPass && verdict != Verdict::PFirst);
        ASSERT_FALSE(canOnlyFail && verdict != Verdict::QFirst);
      }
      break;
    case Kind::Move:
      ASSERT_TRUE(qFirst);
      ++statistics.moves;
      mark(Q);
      break;
    case Kind::Cycle:
      ASSERT_TRUE(qFirst);
      ASSERT_EQ(state_[Q], State::Marked);
      ++statistics.cycles;
      cycle_ = std::ranges::find(marked_, Q);
      break;
    case Kind::Impossible:
    case Kind::Vain:
      ASSERT_TRUE(last_.kind == Kind::Cycle || last_.kind == Kind::Impossible || last_.kind == Kind::Vain);
      ASSERT_TRUE(inCycle(P) && inCycle(Q));
      ++(kind == Kind::Vain ? statistics.vain : statistics.impossible);
      break;
    case Kind::Void: {
      ASSERT_EQ(last_.kind, Kind::Cycle);
      ASSERT_TRUE(inCycle(P));
      const auto above = std::ranges::find(marked_, P) + 1;
      ASSERT_EQ(Q, above == marked_.end() ? *cycle_ : *above) << "no edge of the cycle";
      ++statistics.voids;
      unmarkFrom(above);
      break;
    }
    case Kind::Split:
      if (last_.kind == Kind::Compare) {
        ASSERT_EQ(last_.verdict, Verdict::Crossing);
        ASSERT_EQ(std::minmax(P, Q), std::minmax(last_.P, last_.Q));
      } else {
        ASSERT_TRUE(last_.kind == Kind::Cycle || last_.kind == Kind::Impossible || last_.kind == Kind::Vain);
        ASSERT_TRUE(inCycle(P) && inCycle(Q));
      }
      ++statistics.splits;
      unmarkFrom(std::ranges::find(marked_, P));
      state_[P] = State::Split;
      break;
    case Kind::Paint: {
      ASSERT_EQ(P, marked_.back());
      const Fragment& fragment = sorted_.fragments.at(painted_++);
      ASSERT_EQ(P, fragment.piece < 0 ? fragment.face : faces_ + fragment.piece);
      ASSERT_EQ(fragment.face, faceOf(P));
      marked_.pop_back();
      state_[P] = State::Painted;
      break;
    }
  }
  last_ = event;
}

// The recorded events are those of the algorithm. Marks come and go as in the textbook. Only polygons that
// are left are compared, split or found to be contacts. Every split has its reason. The painted polygons are
// the fragments in their order. All counts are those of the statistics.
TEST(Events, TellTheRun) {
  const Seeds seeds{960};
  SortStatistics sum;
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(testing::Message() << "XNEWELL_SEED=" << seed);
    const SnappedScene scene = randomScene(seed, 3 + static_cast<int>(seed / kSceneKinds.size()) % 16, 32);
    SortSettings settings{.width = 32, .height = 32, .textbook = seed % 2 == 0, .areas = false};
    const SortedScene silent = depthSort(scene, settings);
    settings.record = true;
    const SortedScene sorted = depthSort(scene, settings);
    Replay replay{scene, sorted};
    replay.follow();
    if (HasFatalFailure()) return;
    const SortStatistics &told = replay.statistics, &counted = sorted.statistics;
    EXPECT_EQ(told.settled, counted.settled);
    EXPECT_EQ(told.moves, counted.moves);
    EXPECT_EQ(told.cycles, counted.cycles);
    EXPECT_EQ(told.impossible, counted.impossible);
    EXPECT_EQ(told.vain, counted.vain);
    EXPECT_EQ(told.splits, counted.splits);
    EXPECT_EQ(told.voids, counted.voids);
    EXPECT_EQ(told.contacts, counted.contacts);
    EXPECT_EQ(told.deepest, counted.deepest);
    EXPECT_TRUE(silent.events.empty());
    EXPECT_EQ(silent.statistics.settled, counted.settled);
    EXPECT_EQ(silent.fragments.size(), sorted.fragments.size());
    sum.voids += told.voids, sum.cycles += told.cycles, sum.splits += told.splits;
    sum.impossible += told.impossible, sum.vain += told.vain;
  }
  if (!seeds.all()) return;
  EXPECT_GT(sum.voids, 10);
  EXPECT_GT(sum.cycles, 1'000);
  EXPECT_GT(sum.impossible, 2'000);
  EXPECT_GT(sum.vain, 200);
  EXPECT_GT(sum.splits, 4'000);
}

/// ---- Pieces

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

/// ---- Extremes

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

TEST(DepthSortExtremes, NothingToPaint) {
  for (const bool textbook : {false, true}) {
    const SortedScene sorted = depthSort({}, {5, 5, textbook});
    EXPECT_TRUE(sorted.fragments.empty());
    EXPECT_EQ(sorted.statistics.pairs(), 0);
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

}  // namespace

}  // namespace xnewell::THIS_FILE
