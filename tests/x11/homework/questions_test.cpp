#include "x11/homework/questions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "depthsort/depth_sort.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene.h"
#include "tests/support/student_sort.h"
#include "tests/support/student_world.h"
#include "tests/support/temporary_folder.h"
#include "x11/command/commands.h"
#include "x11/homework/judge_run.h"

namespace xnewell::THIS_FILE {

namespace {

/// A scene, and its own settings at a size.
std::pair<Scene, PictureSettings> sized(const std::string& name, int width, int height) {
  Scene scene = readScene(name);
  PictureSettings settings = scene.settings;
  settings.camera = scene.camera, settings.width = width, settings.height = height;
  return {std::move(scene), settings};
}

QuestionScene about(const std::string& name) {
  const auto [scene, settings] = sized(name, 160, 120);
  return QuestionScene{scene, settings};
}

using V = glm::dvec3;
std::vector<V> pointsIn(const std::string& text) {
  std::vector<V> all;
  const std::regex point{R"(\((-?[\d.]+), (-?[\d.]+), (-?[\d.]+)\))"};
  for (std::sregex_iterator at{text.begin(), text.end(), point}, end; at != end; ++at)
    all.emplace_back(std::stod(at->str(1)), std::stod(at->str(2)), std::stod(at->str(3)));
  return all;
}
/// The number behind these words.
double after(const ExamQuestion& q, const std::string& words) {
  const std::size_t at = q.text.find(words);
  EXPECT_NE(at, q.text.npos) << words << " in " << q.text;
  return at == q.text.npos ? NAN : std::stod(q.text.substr(at + words.size()));
}
double cosine(const V& a, const V& b) { return glm::dot(a, b) / (glm::length(a) * glm::length(b)); }

/// The answer by another way than the program's.
double answered(const ExamQuestion& q) {
  const std::vector<V> v = pointsIn(q.text);
  if (q.kind == "cell-linear") return std::floor(11.5 + 239 * after(q, "does I = "));
  if (q.kind == "cell-corrected") {
    int best = 0;
    double least = 1e9;
    for (int j = 0; j < 240; ++j) {
      const double held = 0.02 * std::pow(50.0, j / 239.0),
                   ratio = std::abs(std::log(held / after(q, "ratio to I = ")));
      if (ratio < least) least = ratio, best = j;
    }
    return 11 + best;
  }
  if (q.kind == "table-ratio") return std::pow(1 / after(q, "I0 = "), 1 / (after(q, "table has ") - 1));
  if (q.kind == "stored-value") return 257 * (after(q, "stored in cell ") - 10);
  if (q.kind == "N.L") return cosine(v[0], v[1]);
  if (q.kind == "R.V") {
    // R.V = 2 (N.L)(N.V) - L.V
    const V N = v[0], L = v[1], V_ = v[2];
    return 2 * cosine(N, L) * cosine(N, V_) - cosine(L, V_);
  }
  if (q.kind == "equation") {
    const double NL = after(q, "N.L = ");
    double I = after(q, "ka = ") * after(q, "Ia = ");
    if (NL > 0)
      I += after(q, "Ip = ") *
           (after(q, "kd = ") * NL +
            after(q, "ks = ") * std::exp(after(q, " n = ") * std::log(after(q, "R.V = "))));
    return std::min(1.0, I);
  }
  if (q.kind == "attenuation")
    return std::min(1.0, std::pow(after(q, "distance d = "), q.text.find("d^2") == q.text.npos ? -1 : -2));
  if (q.kind == "gouraud-row") {
    std::smatch of;
    EXPECT_TRUE(std::regex_search(
        q.text, of, std::regex{R"(is ([\d.]+) at x = (\d+) and ([\d.]+) at x = (\d+).*at x = (\d+))"}));
    const double left = std::stod(of.str(2)),
                 t = (std::stod(of.str(5)) - left) / (std::stod(of.str(4)) - left);
    return (1 - t) * std::stod(of.str(1)) + t * std::stod(of.str(3));
  }
  if (q.kind == "normal") {
    const V N = glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0]));
    return N[q.text[q.text.find(" component") - 1] - 'x'];
  }
  if (q.kind == "vertex-normal") return glm::normalize(glm::normalize(v[0]) + glm::normalize(v[1])).z;
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
  EXPECT_GE(kinds.size(), 13u);
}

/// A polygon as a question lists it.
struct Listed {
  int number = 0;
  std::vector<V> corners;
};
std::vector<Listed> listed(const ExamQuestion& q) {
  std::vector<Listed> all;
  for (const std::string& line : q.lines) all.push_back({std::stoi(line.substr(5)), pointsIn(line)});
  return all;
}

/// z of a polygon's plane, by the areas of three triangles. The corners that span the most are taken.
double zAt(const Listed& p, double x, double y) {
  double most = 0, z = 0;
  const auto area = [](const V& a, const V& b, double cx, double cy) {
    return (b.x - a.x) * (cy - a.y) - (b.y - a.y) * (cx - a.x);
  };
  for (const V& a : p.corners)
    for (const V& b : p.corners)
      for (const V& c : p.corners)
        if (const double all = area(a, b, c.x, c.y); std::abs(all) > most)
          most = std::abs(all),
          z = (area(b, c, x, y) * a.z + area(c, a, x, y) * b.z + area(a, b, x, y) * c.z) / all;
  return z;
}
/// By the angles that the corners turn around a place.
bool covers(const Listed& p, double x, double y) {
  double turn = 0;
  for (std::size_t k = 0; k < p.corners.size(); ++k) {
    const V &a = p.corners[k], &b = p.corners[(k + 1) % p.corners.size()];
    turn += std::remainder(std::atan2(b.y - y, b.x - x) - std::atan2(a.y - y, a.x - x), 2 * std::acos(-1.0));
  }
  return std::abs(turn) > 3;
}
/// By the turn at the leftmost corner.
bool runsClockwise(const Listed& p) {
  std::size_t k = 0;
  for (std::size_t i = 0; i < p.corners.size(); ++i)
    if (p.corners[i].x < p.corners[k].x) k = i;
  const std::size_t n = p.corners.size();
  const V &a = p.corners[(k + n - 1) % n], &b = p.corners[k], &c = p.corners[(k + 1) % n];
  return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) > 0;  // y goes down
}
/// How far two lists of numbers lie apart.
double apart(const std::vector<double>& p, const std::vector<double>& q) {
  return std::max(std::ranges::min(q) - std::ranges::max(p), std::ranges::min(p) - std::ranges::max(q));
}
/// How far the outlines lie apart along the normal of an edge.
double apart(const Listed& p, const Listed& q) {
  double most = -1e9;
  for (const Listed* of : {&p, &q})
    for (std::size_t k = 0; k < of->corners.size(); ++k) {
      const V &a = of->corners[k], &b = of->corners[(k + 1) % of->corners.size()];
      const auto along = [&](const Listed& one) {
        std::vector<double> all;
        for (const V& c : one.corners)
          all.push_back(((c.x - a.x) * (b.y - a.y) - (c.y - a.y) * (b.x - a.x)) /
                        std::hypot(b.x - a.x, b.y - a.y));
        return all;
      };
      most = std::max(most, apart(along(p), along(q)));
    }
  return most;
}
/// The first of the depth sort's tests that passes.
std::string settledBy(const Listed& P, const Listed& Q) {
  const auto along = [](const Listed& p, int axis) {
    std::vector<double> all;
    for (const V& c : p.corners) all.push_back(c[axis]);
    return all;
  };
  const auto onSide = [](const Listed& p, const Listed& plane, int side) {
    return std::ranges::all_of(p.corners,
                               [&](const V& c) { return side * (c.z - zAt(plane, c.x, c.y)) > -0.1; });
  };
  constexpr double kTouch = -0.005;  // outlines that touch do not overlap
  if (apart(along(P, 0), along(Q, 0)) > kTouch) return "1";
  if (apart(along(P, 1), along(Q, 1)) > kTouch) return "2";
  if (onSide(P, Q, -1)) return "3";
  if (onSide(Q, P, 1)) return "4";
  if (apart(P, Q) > kTouch) return "5";
  if (onSide(Q, P, -1)) return "3'";
  if (onSide(P, Q, 1)) return "4'";
  return "6";
}

/// Pictures of the scene with other orders.
struct Second {
  std::vector<std::uint32_t> oracle, byMeanZ;  ///< face images
  std::set<int> fronts;
};
Second second(const std::string& name) {
  const std::pair<Scene, PictureSettings> own = sized(name, 160, 120);
  const auto with = [&](Order order, Cull cull = Cull::Keep) {
    PictureSettings other = own.second;
    other.order = order, other.cull = cull;
    return makePicture(own.first, other, 0);
  };
  Second all{with(Order::Oracle).faceImage(), with(Order::ZMean).faceImage(), {}};
  const Picture culled = with(Order::Unsorted, Cull::Back);
  for (const SnappedFace& face : culled.snapped().faces) all.fronts.insert(face.number);
  return all;
}

// Who has nothing but the text of a question about a scene finds its answer; and so do pictures made with
// other orders.
TEST(Questions, AboutTheSceneAreAnsweredByTheirTextAlone) {
  std::map<std::string, int> asked;
  for (const std::string name : {"two-cards", "cycle", "cubes", "penetrate", "bench", "leaning-cards"}) {
    const Second other = second(name);
    for (const ExamQuestion& q : makeQuestions(about(name), 200, 3)) {
      if (q.lines.empty()) continue;
      SCOPED_TRACE(name + ", " + q.kind + ": " + q.text);
      const std::vector<Listed> polygons = listed(q);
      std::smatch place;
      double x = 0, y = 0;
      if (std::regex_search(q.text, place, std::regex{R"(x = ([\d.]+), y = ([\d.]+)[.,])"}))
        x = std::stod(place.str(1)), y = std::stod(place.str(2));
      const auto at = [&](const std::vector<std::uint32_t>& faces) {
        return static_cast<int>(faces[static_cast<std::size_t>(y) * 160 + static_cast<std::size_t>(x)]) - 1;
      };
      const auto z = [&](const Listed& p) { return zAt(p, x, y); };
      const auto mean = [](const Listed& p) {
        double sum = 0;
        for (const V& c : p.corners) sum += c.z;
        return sum / static_cast<double>(p.corners.size());
      };
      if (q.kind == "nearest-z") {
        const Listed& nearest = *std::ranges::max_element(polygons, {}, z);
        EXPECT_NEAR(q.number, z(nearest), q.tolerance / 4);
        EXPECT_EQ(nearest.number, at(other.oracle));
      } else if (q.kind == "wrong-sort") {
        EXPECT_EQ(q.number, std::ranges::max_element(polygons, {}, mean)->number);
        EXPECT_EQ(q.number, at(other.byMeanZ));
        EXPECT_NE(q.number, at(other.oracle));
      } else if (q.kind == "cut-place") {
        const std::vector<V> edge = pointsIn(q.text.substr(q.text.find("the edge")));
        double low = 0, high = 1;
        const auto on = [&](double t) { return edge[0] + t * (edge[1] - edge[0]); };
        const auto inFront = [&](double t) { return on(t).z > zAt(polygons[1], on(t).x, on(t).y); };
        for (int k = 0; k < 50; ++k)
          (inFront((low + high) / 2) == inFront(0) ? low : high) = (low + high) / 2;
        EXPECT_NEAR(q.number, q.text.find("At which x") != q.text.npos ? on(low).x : on(low).y,
                    q.tolerance / 4);
      } else if (q.kind == "faces-at-pixel") {
        EXPECT_EQ(q.number,
                  std::ranges::count_if(polygons, [&](const Listed& p) { return covers(p, x, y); }));
      } else if (q.kind == "back-faces") {
        EXPECT_EQ(q.number, std::ranges::count_if(polygons, runsClockwise));
        EXPECT_EQ(q.number, std::ranges::count_if(
                                polygons, [&](const Listed& p) { return !other.fronts.contains(p.number); }));
      } else {
        EXPECT_EQ(std::set(q.choices.begin(), q.choices.end()).size(), 8u);
        EXPECT_TRUE(q.choices[q.right].starts_with("test " + settledBy(polygons[0], polygons[1]) + ":"))
            << q.lines[0] << '\n'
            << q.lines[1] << '\n'
            << q.choices[q.right];
      }
      ++asked[q.kind];
    }
  }
  for (const char* kind :
       {"nearest-z", "wrong-sort", "cut-place", "back-faces", "faces-at-pixel", "settling-test"})
    EXPECT_GE(asked[kind], 1) << kind;
}

// No answer is 0 or 1. Wrong choices are what known mistakes give, and differ from the right one and each
// other.
TEST(Questions, OfferWhatMistakesGive) {
  std::map<std::string, int> seen;
  for (const ExamQuestion& q : makeQuestions(about("two-cards"), 300, 5)) {
    if (q.choices.empty() || q.tolerance > 0) {
      EXPECT_NE(std::abs(q.number), 0) << q.text;
      EXPECT_NE(std::abs(q.number), 1) << q.text;
    }
    if (q.kind != "equation" && q.kind != "R.V") continue;
    EXPECT_NEAR(std::stod(q.choices[q.right]), q.number, 0.0006) << q.text;
    EXPECT_GE(q.choices.size(), 3u);
    EXPECT_EQ(std::set(q.choices.begin(), q.choices.end()).size(), q.choices.size());
    std::map<std::string, double> given;
    if (q.kind == "R.V") {
      const std::vector<V> v = pointsIn(q.text);
      const double length = glm::length(v[0]);
      given = {{"R reversed", -q.number}, {"V from the eye", -q.number}, {"L from the light", -q.number}};
      const double LV = cosine(v[1], v[2]);
      given["R without its 2"] = (q.number + LV) / 2 - LV;
      given["N not of unit length"] = (q.number + LV) * length * length - LV;
    } else {
      const double NL = after(q, "N.L = "), RV = after(q, "R.V = "), Ip = after(q, "Ip = "),
                   ks = after(q, "ks = ");
      const bool lit = NL > 0;
      const double ambient = after(q, "ka = ") * after(q, "Ia = "), diffuse = Ip * after(q, "kd = ") * NL,
                   specular = Ip * ks * std::pow(RV, after(q, " n = "));
      given = {{"no ambient term", lit ? diffuse + specular : 0},
               {"the ambient term twice", 2 * ambient + (lit ? diffuse + specular : 0)},
               {"no specular term", ambient + (lit ? diffuse : 0)},
               {"no diffuse term", ambient + (lit ? specular : 0)},
               {"no exponent", ambient + (lit ? diffuse + Ip * ks * RV : 0)},
               {"N.L not clamped", ambient + diffuse + (lit ? specular : 0)}};
      for (auto& [words, I] : given) I = std::clamp(I, 0.0, 1.0);
    }
    for (std::size_t k = 0; k < q.choices.size(); ++k) {
      if (k == q.right) continue;
      EXPECT_GT(std::abs(std::stod(q.choices[k]) - q.number), 0.003) << q.text;
      const std::size_t made = q.solution.find(" " + q.choices[k] + ": ");
      ASSERT_NE(made, q.solution.npos) << q.solution;
      const std::string words = q.solution.substr(made + q.choices[k].size() + 3);
      for (const auto& [name, value] : given)
        if (words.starts_with(name + ".")) {
          EXPECT_NEAR(std::stod(q.choices[k]), value, 0.0006) << q.text << name;
          ++seen[name];
        }
    }
  }
  EXPECT_GE(seen.size(), 9u);
}

/// ---- Runs.

namespace {

const std::vector<std::string> kScenes{"cycle", "nested-cycles", "penetrate",
                                       "bench", "two-cards",     "crossing-sheets"};

Picture pictureOf(const std::string& name) {
  auto [scene, settings] = sized(name, 400, 300);
  settings.order = Order::Unsorted;
  return makePicture(scene, settings).withPlanes();
}

std::string toldOf(const RunReport& report) { return page::asText(pageOf(report)); }

}  // namespace

// Another program's runs are right, whatever it chooses among what is legal.
TEST(JudgeRun, LegalChoicesAreRight) {
  const TemporaryFolder folder;
  int ended = 0;
  for (const std::string& name : kScenes) {
    const Picture picture = pictureOf(name);
    const student::World world = studentsWorld(picture);
    const unsigned seeds = picture.snapped().faces.size() > 50 ? 8 : 120;
    for (unsigned seed = 0; seed < seeds; ++seed) {
      const std::string file = folder.file("run.jsonl");
      const student::Sorted run = student::writeRun(world, 400, 300, file.c_str(), seed);
      if (!run.ended) continue;
      ++ended;
      const RunReport report = judgeRun(picture, RunFile{file});
      ASSERT_TRUE(report.wrong.empty()) << name << ' ' << seed << ": " << toldOf(report);
      ASSERT_EQ(report.untested, 0) << name << ' ' << seed;
    }
  }
  EXPECT_GE(ended, 400);
}

// Each planted mistake is told by its kind and its line, wherever it is done, and nothing is told before it.
TEST(JudgeRun, FirstFalseStepsAreNamed) {
  const TemporaryFolder folder;
  std::map<std::string_view, std::pair<int, int>> named;  // done, and named
  std::string missed;
  for (const std::string& name : kScenes) {
    const Picture picture = pictureOf(name);
    const student::World world = studentsWorld(picture);
    for (const student::Fault& fault : student::kFaults) {
      const std::string file = folder.file("run.jsonl");
      const student::Sorted run = student::writeRun(world, 400, 300, file.c_str(), 1, fault.name);
      const RunReport report = judgeRun(picture, RunFile{file});
      const std::string of =
          name + ", " + std::string{fault.name} + ", line " + std::to_string(run.line) + ": ";
      if (!run.done) {
        EXPECT_TRUE(report.wrong.empty() || !run.ended) << of << toldOf(report);
        continue;
      }
      auto& [done, told] = named[fault.name];
      ++done;
      if (!report.wrong.empty() && report.wrong[0].line == run.line &&
          kFalsehoods[static_cast<std::size_t>(report.wrong[0].kind)] == fault.kind)
        ++told;
      else
        missed += of + toldOf(report);
    }
  }
  int done = 0, told = 0;
  for (const auto& [fault, counts] : named) done += counts.first, told += counts.second;
  EXPECT_GE(told, 0.95 * done) << missed;
  EXPECT_EQ(named.size(), student::kFaults.size());
}

// What trace writes is a right run, in every scene: the textbook's where it is short, and the
// quick one.
TEST(JudgeRun, OwnRunsAreRight) {
  const TemporaryFolder folder;
  for (const BuiltInScene& scene : builtInScenes())
    for (const bool textbook : {true, false}) {
      const Picture picture = pictureOf(scene.name);
      if (textbook && picture.snapped().faces.size() > 400) continue;
      Options options;
      options.quick = !textbook, options.scene = scene.name;
      std::ofstream out{folder.file("run.jsonl")};
      printTrace(options, picture, recordedRun(options, picture), out);
      out.close();
      const RunReport report = judgeRun(picture, RunFile{folder.file("run.jsonl")});
      EXPECT_TRUE(report.wrong.empty()) << scene.name << ' ' << textbook << ": " << toldOf(report);
      EXPECT_EQ(report.untested, 0) << scene.name << ' ' << textbook;
    }
}

}  // namespace xnewell::THIS_FILE
