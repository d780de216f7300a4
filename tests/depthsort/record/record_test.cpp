#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "depthsort/record/explain.h"
#include "depthsort/record/replay.h"
#include "tests/support/exact_region.h"
#include "tests/support/random_scenes.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Explanations of decisions

constexpr int kSize = 40;

SortedScene recorded(const SnappedScene& scene, bool textbook = true) {
  SortSettings settings{kSize, kSize, textbook};
  settings.record = true;
  return depthSort(scene, settings);
}

/// A mesh of `faces` faces without names. Their points do not matter here.
Mesh namelessMesh(int faces) {
  Mesh mesh;
  mesh.groupNames = {""};
  mesh.points.resize(3);
  for (int f = 0; f < faces; ++f) mesh.addFace(std::array{0, 1, 2}, 0);
  return mesh;
}

/// How the corners of triangle p lie from the plane of triangle q, in fractions.
CornerCounts exactCounts(const SnappedScene& scene, int p, int q) {
  CornerCounts counts;
  for (int k = 0; k < 3; ++k) {
    const glm::ivec3& v = scene.vertices[scene.faces[p].first + k];
    const ExactLine ahead = exactDifference({.D = v.z}, scene.planes[scene.faces[q].plane]);
    const int side = valueAt(ahead, {v.x, v.y}).sign();
    ++(side > 0 ? counts.inFront : side < 0 ? counts.behind : counts.on);
  }
  return counts;
}

/// True if the numbers of a test say yes.
bool passes(const Explainer& explainer, Test test, int P, int Q) {
  const auto apart = [](const Range& p, const Range& q) { return p.high <= q.low || q.high <= p.low; };
  switch (test) {
    case Test::SamePlane:
      return explainer.corners(P, Q).inFront == 0 && explainer.corners(P, Q).behind == 0;
    case Test::XExtents:
      return apart(explainer.xExtent(P), explainer.xExtent(Q));
    case Test::YExtents:
      return apart(explainer.yExtent(P), explainer.yExtent(Q));
    case Test::PBehindQ:
      return explainer.corners(P, Q).inFront == 0 && explainer.corners(P, Q).behind > 0;
    case Test::QInFrontOfP:
      return explainer.corners(Q, P).behind == 0 && explainer.corners(Q, P).inFront > 0;
    case Test::Projections:
      return explainer.separatingEdge(P, Q).has_value();
    case Test::QBehindP:
      return explainer.corners(Q, P).inFront == 0 && explainer.corners(Q, P).behind > 0;
    case Test::PInFrontOfQ:
      return explainer.corners(P, Q).behind == 0 && explainer.corners(P, Q).inFront > 0;
    case Test::Overlap:
      return true;
  }
  return false;
}

// The numbers confirm every test that was made. All tests before the last one fail, and the last one does
// not. For test 6 the signs over the common area give the verdict.
TEST(Explain, NumbersDecideAsTheRunDid) {
  std::array<int, kTests> settled{};
  int withPieces = 0, contacts = 0;
  for (unsigned seed = 0; seed < 210; ++seed) {
    const bool textbook = seed % 3 != 0;
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomScene(seed, 2 + seed % 17, kSize);
    const SortedScene sorted = recorded(scene, textbook);
    const Mesh mesh = namelessMesh(static_cast<int>(scene.faces.size()));
    const Explainer explainer{mesh, scene, sorted, textbook};
    for (const Event& e : sorted.events) {
      if (e.kind != Event::Kind::Compare) continue;
      const std::vector<xnewell::Test> made = explainer.testsMade(e);
      ASSERT_EQ(made.back(), e.test);
      for (const xnewell::Test test : made)
        ASSERT_EQ(passes(explainer, test, e.P, e.Q), test == e.test)
            << kTestRows[static_cast<int>(test)].name << " of " << e.P << ", " << e.Q;
      ++settled[static_cast<int>(e.test)];
      withPieces += explainer.fragments().isPiece(e.P) || explainer.fragments().isPiece(e.Q);
      if (e.test != xnewell::Test::Overlap) continue;
      const CommonArea common = explainer.commonArea(e.P, e.Q);
      EXPECT_GE(common.corners, 3);
      EXPECT_EQ(common.P.inFront + common.P.on + common.P.behind, common.corners);
      EXPECT_GT(common.area, 0.0);
      EXPECT_EQ(common.P.inFront > 0, e.contact || e.verdict != Verdict::PFirst);
      EXPECT_EQ(common.P.behind > 0, e.contact || e.verdict != Verdict::QFirst);
      contacts += e.contact;
    }
  }
  for (const TestRow& row : kTestRows) EXPECT_GT(settled[static_cast<int>(row.id)], 100) << row.name;
  EXPECT_GT(withPieces, 1000);
  EXPECT_GT(contacts, 0);
}

// Fractions say on which side of another plane a face's corners lie. The extents are those of the vertices.
TEST(Explain, NumbersOfFacesAreThoseOfTheirVertices) {
  int on = 0;
  for (unsigned seed = 0; seed < 70; ++seed) {
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomScene(kSceneKinds[seed % kTriangleKinds].id, seed, 8, kSize);
    const SortedScene sorted = recorded(scene, true);
    const Mesh mesh = namelessMesh(8);
    const Explainer explainer{mesh, scene, sorted, true};
    for (int p = 0; p < 8; ++p) {
      const glm::ivec3* const v = &scene.vertices[scene.faces[p].first];
      for (const auto& [is, axis] :
           {std::pair{explainer.xExtent(p), 0}, {explainer.yExtent(p), 1}, {explainer.zExtent(p), 2}}) {
        const auto [low, high] = std::minmax({v[0][axis], v[1][axis], v[2][axis]});
        EXPECT_EQ(is.low, low / 65536.0);
        EXPECT_EQ(is.high, high / 65536.0);
      }
      for (int q = 0; q < 8; ++q) {
        if (p == q) continue;
        EXPECT_EQ(explainer.corners(p, q), exactCounts(scene, p, q)) << p << ", " << q;
        on += explainer.corners(p, q).on;
      }
    }
  }
  EXPECT_GT(on, 100);
}

// Each fragment of a run has its own name. The name of a piece begins with its parent's.
TEST(Explain, NamesAreUnique) {
  int pieces = 0;
  for (unsigned seed = 0; seed < 70; ++seed) {
    SCOPED_TRACE(seed);
    SnappedScene scene = randomScene(SceneKind::BigTriangles, seed, 12, kSize);
    // Faces 3 and 4 are parts of one face. Two groups have one face each, two groups share a name, and one
    // group has the rest.
    for (int f = 4; f < 12; ++f) scene.faces[f].number = f - 1;
    Mesh mesh = namelessMesh(11);
    mesh.groupNames = {"rest", "bar-1", "bar", "twice", "twice", std::string(200, 'x')};
    for (int f = 0; f < 5; ++f) mesh.group[f + 4] = f + 1;
    const SortedScene sorted = recorded(scene, true);
    const Fragments fragments{mesh, scene, sorted};
    std::set<std::string> names;
    const int count = static_cast<int>(scene.faces.size() + sorted.pieces.size());
    for (int id = 0; id < count; ++id) {
      const std::string name = fragments.name(id);
      EXPECT_LT(name.size(), 80u);
      EXPECT_TRUE(names.insert(name).second) << name;
      if (fragments.isPiece(id)) {
        EXPECT_TRUE(name.starts_with(fragments.name(fragments.parent(id)))) << name;
      }
    }
    EXPECT_EQ(fragments.name(2), "face 2");
    EXPECT_EQ(fragments.name(3), "face 3.1");
    EXPECT_EQ(fragments.name(4), "face 3.2");
    EXPECT_EQ(fragments.name(5), "bar-1");
    EXPECT_EQ(fragments.name(6), "bar");
    EXPECT_EQ(fragments.name(7), "face 6");
    // A fragment with a name of its own is called by it, otherwise by its group's.
    for (int id = 2; id <= 7; ++id) {
      const bool named = id == 5 || id == 6;
      EXPECT_EQ(fragments.hasName(id), named);
      if (named) {
        EXPECT_EQ(fragments.part(id), fragments.name(id));
      }
    }
    EXPECT_EQ(fragments.number(4), "3.2");
    for (const Event& e : sorted.events)
      if (e.kind == Event::Kind::Split && (e.P == 5 || e.P == 6)) ++pieces;
    for (int id = 12; id < count; ++id) {
      if (fragments.parent(id) == 5) {
        EXPECT_EQ(fragments.name(id), id % 2 == 0 ? "bar-1a" : "bar-1b");
      }
      if (fragments.parent(id) == 6) {
        EXPECT_EQ(fragments.name(id), id % 2 == 0 ? "bar.a" : "bar.b");
      }
    }
  }
  EXPECT_GT(pieces, 20);
}

// Every sentence ends in a full stop, names its polygons and has no placeholder left.
TEST(Explain, SentencesNameTheirPolygons) {
  std::set<std::string> beginnings;
  for (unsigned seed = 0; seed < 140; ++seed) {
    const bool textbook = seed % 3 != 0;
    const SnappedScene scene = randomScene(seed, 2 + seed % 17, kSize);
    const SortedScene sorted = recorded(scene, textbook);
    const Mesh mesh = namelessMesh(static_cast<int>(scene.faces.size()));
    const Explainer explainer{mesh, scene, sorted, textbook};
    int splits = 0;
    for (const Event& e : sorted.events) {
      std::vector<std::string> sentences{explainer.sentence(e, splits)};
      splits += e.kind == Event::Kind::Split;
      if (e.kind == Event::Kind::Compare)
        for (const xnewell::Test test : explainer.testsMade(e)) {
          sentences.push_back(explainer.sentence(e, test));
          // A plane test fails by a part on the other side.
          if (const auto plane = planeTestOf(test); plane && test != e.test) {
            ASSERT_NE(sentences.back().find(plane->side < 0 ? "in front of the plane" : "behind the plane"),
                      std::string::npos)
                << sentences.back();
          }
        }
      for (const std::string& s : sentences) {
        ASSERT_TRUE(s.ends_with('.') && s.find_first_of("{}") == std::string::npos) << s;
        if (e.kind != Event::Kind::Move) {
          ASSERT_NE(s.find(explainer.name(e.P)), std::string::npos) << s;
        }
        if (e.Q >= 0) {
          ASSERT_NE(s.find(explainer.name(e.Q)), std::string::npos) << s;
        }
        beginnings.insert(s.substr(0, s.find(':') + (e.kind == Event::Kind::Compare ? 4 : 0)));
      }
    }
  }
  for (const char* event :
       {"Take", "Move", "Cycle", "Cut", "Cut impossible", "Cut in vain", "Contact", "Paint"})
    EXPECT_TRUE(beginnings.contains(event)) << event;
  for (const char* test : {"1", "2", "3", "4", "5", "3'", "4'"})
    EXPECT_TRUE(beginnings.contains(std::string{"Test "} + test + ": no")) << test;
}

/// ---- Landmarks

// The counts, next() and previous() agree with a walk over all events, at every step.
TEST(Landmarks, AgreeWithAWalk) {
  std::array<int, kLandmarks.size()> seen{};
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomScene(seed, 30, kSize);
    const SortedScene sorted = recorded(scene);
    const Landmarks landmarks{sorted};
    const int steps = static_cast<int>(sorted.events.size());
    for (const LandmarkRow& row : kLandmarks) {
      int count = 0, pairs = 0, last = 0;
      for (int step = 0; step <= steps; ++step) {
        const bool is = step > 0 && landmarkOf(sorted.events[step - 1]) == row.id;
        pairs += step > 0 && sorted.events[step - 1].kind == Event::Kind::Compare;
        ASSERT_EQ(landmarks.previous(row.id, step), last ? std::optional{last} : std::nullopt);
        if (is) {
          ++count;
          if (step > last + 1) {
            ASSERT_EQ(landmarks.next(row.id, last), step);
          }
          last = step;
        }
        ASSERT_EQ(landmarks.count(row.id, step), count);
        ASSERT_EQ(landmarks.pairs(step), pairs);
      }
      ASSERT_EQ(landmarks.next(row.id, last), std::nullopt);
      seen[static_cast<int>(row.id)] += count;
    }
    ASSERT_EQ(landmarks.count(Landmark::Move, steps), sorted.statistics.moves);
    ASSERT_EQ(landmarks.count(Landmark::Cut, steps), sorted.statistics.splits);
    ASSERT_EQ(landmarks.pairs(steps), sorted.statistics.pairs());
  }
  for (const int count : seen) EXPECT_GT(count, 20);
}

// The comparison of a step is about its two polygons. For a failed test it is the step itself. For a painted
// polygon, all tests that settled it since it was taken are counted, and none of another P.
TEST(Landmarks, TellOfThePolygonsOfAStep) {
  int moves = 0, pairs = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const SortedScene sorted = recorded(randomScene(seed, 30, kSize));
    for (int step = 1; step <= static_cast<int>(sorted.events.size()); ++step) {
      const Event& e = sorted.events[step - 1];
      const Event* const compare = comparisonAt(sorted, step);
      if (e.kind == Event::Kind::Compare) {
        ASSERT_EQ(compare, &e);
      }
      if (e.kind == Event::Kind::Take || e.kind == Event::Kind::Paint) {
        ASSERT_EQ(compare, nullptr);
      }
      if (e.kind == Event::Kind::Move) {
        ASSERT_NE(compare, nullptr);
        ASSERT_EQ(compare->P, e.P);
        ASSERT_EQ(compare->Q, e.Q);
        ASSERT_EQ(compare->verdict, Verdict::QFirst);
        ++moves;
      }
      if (e.kind != Event::Kind::Paint) continue;
      int sum = 0, expected = 0;
      for (const int count : settledFor(sorted, step)) sum += count;
      for (int k = step - 1; k-- > 0;) {
        const Event& before = sorted.events[k];
        expected += before.kind == Event::Kind::Compare && before.P == e.P;
        if (before.kind == Event::Kind::Take && before.P == e.P) break;
        if (before.kind == Event::Kind::Move && before.Q == e.P) break;
      }
      ASSERT_EQ(sum, expected);
      pairs += sum;
    }
  }
  EXPECT_GT(moves, 100);
  EXPECT_GT(pairs, 500);
}

/// ---- Replay

constexpr int kAll = 1 << 20;

/// What a step looks like.
struct Seen {
  std::vector<int> marked;
  int painted = 0, splits = 0;
  std::vector<Replay::Listed> list;
  bool operator==(const Seen&) const = default;
};

Seen seenBy(const Replay& replay) {
  return {replay.marked(), replay.painted(), replay.splits(), replay.list(kAll)};
}

/// The states of all steps by the plain words of Event::Kind. The stack is a vector, and in the list pieces
/// replace the polygon that was split.
std::vector<Seen> literally(const SnappedScene& scene, const SortedScene& sorted) {
  std::vector<int> stack, list = sorted.list;
  int painted = 0, splits = 0;
  std::vector<Seen> all;
  const auto see = [&] {
    Seen seen{{stack.rbegin(), stack.rend()}, painted, splits, {}};
    for (const int id : seen.marked) seen.list.push_back({id, true});
    for (const int id : list)
      if (std::ranges::find(stack, id) == stack.end()) seen.list.push_back({id, false});
    all.push_back(seen);
  };
  see();
  for (const Event& e : sorted.events) {
    const auto place = std::ranges::find(stack, e.P);
    switch (e.kind) {
      case Event::Kind::Take:
        stack.push_back(e.P);
        break;
      case Event::Kind::Move:
        stack.push_back(e.Q);
        break;
      case Event::Kind::Void:
        stack.erase(place + 1, stack.end());
        break;
      case Event::Kind::Split: {
        stack.erase(place, stack.end());
        const int piece = static_cast<int>(scene.faces.size()) + 2 * splits++;
        const auto at = list.erase(std::ranges::find(list, e.P));
        list.insert(at, {piece, piece + 1});
        break;
      }
      case Event::Kind::Paint:
        EXPECT_EQ(stack.back(), e.P);
        stack.pop_back();
        list.erase(std::ranges::find(list, e.P));
        ++painted;
        break;
      default:
        break;
    }
    see();
  }
  return all;
}

// Every step looks as in the literal replay from the start, whether it is reached forward, back or by a jump
// from anywhere. P is always taken from the head of the list, which is sorted by farthest z.
TEST(Replay, AnyStepIsReachedFromAnyOther) {
  int farBack = 0, splits = 0, voids = 0, unmarked = 0, taken = 0;
  for (unsigned seed = 0; seed < 140; ++seed)
    for (const bool textbook : {false, true}) {
      SCOPED_TRACE(seed);
      const SnappedScene scene = randomScene(seed, 2 + seed % 17, kSize);
      const SortedScene sorted = recorded(scene, textbook);
      const std::vector<Seen> expected = literally(scene, sorted);
      Replay replay{scene, sorted};
      ASSERT_EQ(std::ssize(expected), replay.steps() + 1);
      EXPECT_TRUE(std::ranges::is_sorted(sorted.list, {},
                                         [&](int face) { return extentsOf(scene, scene.faces[face]).zFar; }));
      const auto check = [&](int step) {
        replay.goTo(step);
        EXPECT_EQ(replay.step(), step);
        EXPECT_EQ(replay.event(), step == 0 ? nullptr : &sorted.events[step - 1]);
        return seenBy(replay) == expected[step];
      };
      for (int step = 0; step <= replay.steps(); ++step) {
        ASSERT_TRUE(check(step)) << step;
      }
      for (int step = replay.steps(); step >= 0; --step) {
        ASSERT_TRUE(check(step)) << step;
      }
      std::mt19937 rng{seed};
      for (int leap = 0; leap < 100; ++leap) {
        const int from = replay.step(), to = static_cast<int>(rng() % expected.size());
        ASSERT_TRUE(check(to)) << from << " to " << to;
        farBack += from - to > Replay::kCheckpoint;
      }
      splits += static_cast<int>(sorted.statistics.splits);
      voids += static_cast<int>(sorted.statistics.voids);
      for (std::size_t k = 0; k < sorted.events.size(); ++k) {
        const Event& e = sorted.events[k];
        unmarked += k > 0 && e.kind == Event::Kind::Split && expected[k].marked.front() == e.Q;
        if (e.kind != Event::Kind::Take) continue;
        ASSERT_EQ(expected[k].list.front(), (Replay::Listed{e.P, false}));
        ++taken;
      }
    }
  EXPECT_GT(taken, 500);
  EXPECT_GT(farBack, 1000);
  EXPECT_GT(splits, 1000);
  EXPECT_GT(voids, 0);
  EXPECT_GT(unmarked, 100);
}

// A run with more events than allowed throws instead of keeping them. A run with exactly as many does not
// throw, nor does one that is not recorded.
TEST(Replay, TooManyEventsAreRefused) {
  const SnappedScene scene = randomScene(0, 12, kSize);
  const std::size_t count = recorded(scene, true).events.size();
  SortSettings settings{kSize, kSize, true};
  settings.mostEvents = count - 1;
  EXPECT_NO_THROW(static_cast<void>(depthSort(scene, settings)));
  settings.record = true;
  EXPECT_THROW(static_cast<void>(depthSort(scene, settings)), TooManyEvents);
  settings.mostEvents = count;
  EXPECT_EQ(depthSort(scene, settings).events.size(), count);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
