#include "x11/homework/questions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>
#include <string>

#include "depthsort/depth_sort.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene.h"

namespace xnewell::THIS_FILE {

namespace {

QuestionScene about(const std::string& name) {
  const Scene scene = readScene(name);
  PictureSettings s = scene.settings;
  s.camera = scene.camera, s.width = 160, s.height = 120;
  return QuestionScene{scene, s};
}

using Given = std::map<std::string, double>;
struct V {
  double x = 0, y = 0, z = 0;
};
V of(const Given& g, const std::string& name) {
  return {g.at(name + "x"), g.at(name + "y"), g.at(name + "z")};
}
double by(const V& a, const V& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double angleBetween(const V& a, const V& b) { return std::acos(by(a, b) / std::sqrt(by(a, a) * by(b, b))); }

/// The answer by another way than the program's.
double answered(const ExamQuestion& q) {
  const Given& g = q.given;
  if (q.kind == "cell-linear") return std::floor(11.5 + 239 * g.at("I"));
  if (q.kind == "cell-corrected") {
    int best = 0;
    double least = 1e9;
    for (int j = 0; j < 240; ++j) {
      const double held = 0.02 * std::pow(50.0, j / 239.0), ratio = std::abs(std::log(held / g.at("I")));
      if (ratio < least) least = ratio, best = j;
    }
    return 11 + best;
  }
  if (q.kind == "table-ratio") return std::pow(1 / g.at("I0"), 1 / (g.at("N") - 1));
  if (q.kind == "stored-value") return 257 * (g.at("cell") - 10);
  if (q.kind == "N.L") return std::cos(angleBetween(of(g, "N"), of(g, "L")));
  if (q.kind == "R.V") {
    // R.V = 2 (N.L)(N.V) - L.V
    const V N = of(g, "N"), L = of(g, "L"), V_ = of(g, "V");
    return 2 * std::cos(angleBetween(N, L)) * std::cos(angleBetween(N, V_)) - std::cos(angleBetween(L, V_));
  }
  if (q.kind == "equation") {
    double I = g.at("ka") * g.at("Ia");
    if (g.at("NL") > 0)
      I += g.at("Ip") * (g.at("kd") * g.at("NL") + g.at("ks") * std::exp(g.at("n") * std::log(g.at("RV"))));
    return std::min(1.0, I);
  }
  if (q.kind == "attenuation") return std::min(1.0, std::pow(g.at("d"), -g.at("power")));
  if (q.kind == "gouraud-row") {
    const double t = (g.at("x") - g.at("left")) / (g.at("right") - g.at("left"));
    return (1 - t) * g.at("A") + t * g.at("B");
  }
  if (q.kind == "normal") {
    const V a = of(g, "p0"), b = of(g, "p1"), c = of(g, "p2");
    const V N{(b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y),
              (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z),
              (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)};
    const double length = std::sqrt(by(N, N));
    return g.at("axis") == 0 ? N.x / length : g.at("axis") == 1 ? N.y / length : N.z / length;
  }
  if (q.kind == "vertex-normal") {
    const V a = of(g, "a"), b = of(g, "b");
    const double la = std::sqrt(by(a, a)), lb = std::sqrt(by(b, b));
    const V sum{a.x / la + b.x / lb, a.y / la + b.y / lb, a.z / la + b.z / lb};
    return sum.z / std::sqrt(by(sum, sum));
  }
  return NAN;
}

}  // namespace

// Every answer about numbers is the one of a second computation, within its tolerance.
TEST(Questions, AnswersAreThoseOfASecondComputation) {
  const QuestionScene scene = about("two-cards");
  std::set<std::string> kinds;
  for (unsigned seed = 0; seed < 5; ++seed)
    for (const ExamQuestion& q : makeQuestions(scene, 120, seed)) {
      const double second = answered(q);
      kinds.insert(q.kind);
      if (std::isnan(second)) continue;
      if (q.tolerance > 0) {
        EXPECT_NEAR(q.number, second, q.tolerance / 2) << q.text;
      }
      if (q.tolerance == 0) {
        EXPECT_EQ(q.number, second) << q.text;
      }
    }
  EXPECT_GE(kinds.size(), 16u);
}

/// Pictures of the scene with other orders, and what its faces are on the screen.
struct Second {
  PictureSettings settings;
  std::vector<std::uint32_t> oracle, byMeanZ;  ///< face images
  Picture unsorted, culled;
  SortedScene run;
};
Second second(const std::string& name) {
  const Scene scene = readScene(name);
  PictureSettings s = scene.settings;
  s.camera = scene.camera, s.width = 160, s.height = 120;
  const auto with = [&](Order order, Cull cull = Cull::Keep) {
    PictureSettings other = s;
    other.order = order, other.cull = cull;
    return makePicture(scene, other, 0);
  };
  const Picture unsorted = with(Order::Unsorted).withPlanes();
  SortedScene run =
      depthSort(unsorted.snapped(), {.width = 160, .height = 120, .textbook = true, .record = true});
  return {s,        with(Order::Oracle).faceImage(),   with(Order::ZMean).faceImage(),
          unsorted, with(Order::Unsorted, Cull::Back), std::move(run)};
}

/// True if the centre of the pixel lies inside a face, by the signs of its sides; an edge through the centre
/// does not come up in these scenes.
bool covers(const SnappedScene& scene, const SnappedFace& face, int i, int j) {
  bool inside = true;
  for (int k = 0; k < face.count; ++k) {
    const glm::ivec3 &a = scene.vertices[face.first + k],
                     &b = scene.vertices[face.first + (k + 1) % face.count];
    const double x = (i + 0.5) * 65536, y = (j + 0.5) * 65536;
    inside = inside && double(b.y - a.y) * (x - a.x) - double(b.x - a.x) * (y - a.y) > 0;
  }
  return inside;
}

/// True if a test of the planes settles the pair by hand: by the corners in the model, with the eye in front.
bool passesByHand(const Picture& picture, Test test, int P, int Q) {
  const Scene& scene = picture.scene();
  const ViewSpec& view = picture.camera().view;
  const glm::dvec3 eye = view.vrp + glm::transpose(vrcRotation(view)) * view.prp;
  const bool ofP = test == Test::PBehindQ || test == Test::PInFrontOfQ;
  const auto corners = [&](int face) { return scene.parts.part(picture.snapped().faces[face].part); };
  const auto of = corners(ofP ? P : Q), other = corners(ofP ? Q : P);
  const auto at = [&](int c) { return scene.mesh.points[c]; };
  const glm::dvec3 N = glm::cross(at(other[1]) - at(other[0]), at(other[2]) - at(other[0]));
  const bool behind = test == Test::PBehindQ || test == Test::QBehindP;
  return std::ranges::all_of(of, [&](int c) {
    const double inFront = glm::dot(N, at(c) - at(other[0])) * (glm::dot(N, eye - at(other[0])) > 0 ? 1 : -1);
    return (behind ? inFront : -inFront) < 1e-12;
  });
}

// Answers about a scene are those of a second way: pictures made with these orders, sides of outlines, faces
// that culling removes, and the steps of a run of the test's own.
TEST(Questions, AnswersAboutTheSceneAreThoseOfASecondWay) {
  std::map<std::string, int> asked;
  for (const std::string name : {"two-cards", "cycle", "cubes", "penetrate", "bench"}) {
    SCOPED_TRACE(name);
    const Second other = second(name);
    const SnappedScene& snapped = other.unsorted.snapped();
    for (const ExamQuestion& q : makeQuestions(about(name), 120, 3)) {
      SCOPED_TRACE(q.text);
      const auto given = [&](const char* key) { return static_cast<int>(q.given.at(key)); };
      const auto at = [&](const std::vector<std::uint32_t>& faces) {
        return static_cast<double>(faces[static_cast<std::size_t>(given("j")) * 160 + given("i")]) - 1;
      };
      if (q.kind == "nearest-face") {
        EXPECT_EQ(q.number, at(other.oracle));
      } else if (q.kind == "wrong-sort") {
        EXPECT_EQ(q.number, at(other.byMeanZ));
        EXPECT_NE(q.number, at(other.oracle));
      } else if (q.kind == "cuts") {
        EXPECT_EQ(q.number, std::ranges::count(other.run.events, Event::Kind::Split, &Event::kind));
      } else if (q.kind == "back-faces") {
        EXPECT_EQ(q.number, other.culled.snapped().culled);
      } else if (q.kind == "faces-at-pixel") {
        EXPECT_EQ(q.number, std::ranges::count_if(snapped.faces, [&](const SnappedFace& face) {
                    return covers(snapped, face, given("i"), given("j"));
                  }));
      } else if (q.kind == "settling-test") {
        EXPECT_EQ(std::set(q.choices.begin(), q.choices.end()).size(), 8u);
        const auto event = std::ranges::find_if(other.run.events, [&](const Event& e) {
          return e.kind == Event::Kind::Compare && e.P == given("P") && e.Q == given("Q");
        });
        ASSERT_NE(event, other.run.events.end());
        EXPECT_TRUE(q.choices[q.right].starts_with(
            "test " + std::string{kTestRows[static_cast<std::size_t>(event->test)].name} + ":"));
        for (const xnewell::Test test : {xnewell::Test::PBehindQ, xnewell::Test::QInFrontOfP,
                                         xnewell::Test::QBehindP, xnewell::Test::PInFrontOfQ})
          if (test <= event->test) {
            EXPECT_EQ(passesByHand(other.unsorted, test, given("P"), given("Q")), test == event->test);
          }
      } else {
        continue;
      }
      ++asked[q.kind];
    }
  }
  for (const char* kind :
       {"nearest-face", "wrong-sort", "cuts", "back-faces", "faces-at-pixel", "settling-test"})
    EXPECT_GE(asked[kind], 1) << kind;
}

// The same seed gives the same questions; no question comes twice; a GIFT file escapes what it must.
TEST(Questions, AreRepeatable) {
  const QuestionScene scene = about("cycle");
  const auto first = makeQuestions(scene, 40, 7), again = makeQuestions(scene, 40, 7),
             other = makeQuestions(scene, 40, 8);
  ASSERT_EQ(first.size(), 40u);
  EXPECT_EQ(questionsAsText(first).asked, questionsAsText(again).asked);
  EXPECT_NE(questionsAsText(first).asked, questionsAsText(other).asked);
  std::set<std::string> texts;
  for (const ExamQuestion& q : first) texts.insert(q.text);
  EXPECT_EQ(texts.size(), first.size());
  const std::string gift = questionsAsGift(first);
  EXPECT_EQ(std::ranges::count(gift, '{'), 40);
  EXPECT_NE(gift.find("round(11 + 239 I)"), std::string::npos);
  EXPECT_NE(gift.find("\\= 0.02"), std::string::npos);
  EXPECT_EQ(questionsAsText({}).asked.find("1."), std::string::npos);
}

}  // namespace xnewell::THIS_FILE
