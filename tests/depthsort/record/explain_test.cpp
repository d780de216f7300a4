#include "depthsort/record/explain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/random_scenes.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kSize = 40;

SortedScene recorded(const SnappedScene& scene, bool textbook) {
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

/// How the corners of triangle p lie from the plane of triangle q, from the volumes that they span. No plane
/// record is used.
CornerCounts byVolumes(const SnappedScene& scene, int p, int q) {
  const glm::ivec3 *const P = &scene.vertices[scene.faces[p].first], *const Q =
                                                                         &scene
                                                                              .vertices[scene.faces[q].first];
  const auto minus = [](const glm::ivec3& a, const glm::ivec3& b) {
    return std::array<Int128, 3>{Int128{a.x} - b.x, Int128{a.y} - b.y, Int128{a.z} - b.z};
  };
  CornerCounts counts;
  for (int k = 0; k < 3; ++k) {
    const auto u = minus(Q[1], Q[0]), v = minus(Q[2], Q[0]), w = minus(P[k], Q[0]);
    const Int128 volume = u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
                          u[2] * (v[0] * w[1] - v[1] * w[0]);
    // The outline is counter-clockwise as seen, with y down: u x v points away from the viewer if x and y do
    // so.
    const Int128 side = (u[0] * v[1] - u[1] * v[0]) > 0 ? volume : -volume;
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

}  // namespace

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

// The volumes of tetrahedra say on which side of another plane a face's corners lie. The extents are those of
// the vertices.
TEST(Explain, NumbersOfFacesAreThoseOfTheirVertices) {
  int on = 0;
  for (unsigned seed = 0; seed < 70; ++seed) {
    // Leaves out the kinds Limits and EqualZ. They would fit too: volumes are below 2^95.
    if (seed % 7 == 2) continue;
    SCOPED_TRACE(seed);
    const SnappedScene scene = randomScene(kSceneKinds[seed % kTriangleKinds].id, seed, 8, kSize);
    const SortedScene sorted = recorded(scene, true);
    const Mesh mesh = namelessMesh(8);
    const Explainer explainer{mesh, scene, sorted, true};
    for (int p = 0; p < 8; ++p) {
      const glm::ivec3* const v = &scene.vertices[scene.faces[p].first];
      const Range x = explainer.xExtent(p), y = explainer.yExtent(p), z = explainer.zExtent(p);
      EXPECT_EQ(x.low, std::min({v[0].x, v[1].x, v[2].x}) / 65536.0);
      EXPECT_EQ(x.high, std::max({v[0].x, v[1].x, v[2].x}) / 65536.0);
      EXPECT_EQ(y.low, std::min({v[0].y, v[1].y, v[2].y}) / 65536.0);
      EXPECT_EQ(y.high, std::max({v[0].y, v[1].y, v[2].y}) / 65536.0);
      EXPECT_EQ(z.low, std::min({v[0].z, v[1].z, v[2].z}) / 65536.0);
      EXPECT_EQ(z.high, std::max({v[0].z, v[1].z, v[2].z}) / 65536.0);
      for (int q = 0; q < 8; ++q) {
        if (p == q) continue;
        EXPECT_EQ(explainer.corners(p, q), byVolumes(scene, p, q)) << p << ", " << q;
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

}  // namespace xnewell::THIS_FILE
