#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <random>

#include "tests/support/seeds.h"
#include "tests/x11/support/command_fixture.h"
#include "tests/x11/support/corpus_models.h"
#include "tests/x11/support/program_picture.h"

namespace xnewell::THIS_FILE {

/// What the program draws: the face image against independent decisions, models as people have them, and the
/// code for newer processors against the code for any.

namespace {

using DrawnPicture = CommandTest;
using CorpusTest = CommandTest;
using Baseline = CommandTest;

/// A polygon in a plane of constant z.
struct Sheet {
  std::vector<glm::dvec2> outline;
  double z;
  bool clockwise;                   ///< seen from +z
  glm::dvec2 low{1e9}, high{-1e9};  ///< the box around the outline
};

/// Stars of 3 to 12 corners, most of them concave, some far larger than the picture, each at its own z, in
/// random order.
std::vector<Sheet> sheets(unsigned seed, int count) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  std::vector<Sheet> all;
  for (int k = 0; k < count; ++k) {
    Sheet sheet{{}, std::remainder(k * 7 + 0.5, count) / count, unit(rng) < 0.5};
    const int corners = 3 + static_cast<int>(unit(rng) * 10);
    const glm::dvec2 centre{3 * unit(rng) - 1.5, 3 * unit(rng) - 1.5};
    const double radius = k % 16 == 0 ? 4000 : 0.7;
    const glm::dvec2 around = k % 16 == 0 ? glm::dvec2{centre.x + radius * 0.5, centre.y} : centre;
    for (int c = 0; c < corners; ++c) {
      const double a = 2 * 3.14159265358979 * c / corners, r = radius * (0.25 + 0.75 * unit(rng));
      const glm::dvec2 p = sheet.outline.emplace_back(around + r * glm::dvec2{std::cos(a), std::sin(a)});
      sheet.low = glm::min(sheet.low, p), sheet.high = glm::max(sheet.high, p);
    }
    if (sheet.clockwise) std::ranges::reverse(sheet.outline);
    all.push_back(sheet);
  }
  return all;
}

std::string objOf(const std::vector<Sheet>& all) {
  std::string text;
  for (const Sheet& s : all) {
    for (const glm::dvec2& p : s.outline)
      text += "v " + number(p.x) + " " + number(p.y) + " " + number(s.z) + "\n";
    text += "f";
    for (int back = static_cast<int>(s.outline.size()); back > 0; --back) text += " -" + std::to_string(back);
    text += "\n";
  }
  return text;
}

enum class Where { In, Out, TooNear };

/// Counts the crossings of a ray. A point within `margin` of an edge is too near.
Where where(const std::vector<glm::dvec2>& outline, glm::dvec2 p, double margin) {
  bool in = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    const glm::dvec2 off = a + t * (b - a) - p;
    if (glm::dot(off, off) < margin * margin) return Where::TooNear;
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
  }
  return in ? Where::In : Where::Out;
}

/// The ids of a picture of sheets seen from (0, 0, eye) along -z. `slope` is half the picture's height: at
/// unit distance in perspective, at every distance in a parallel picture.
void expectSheets(const RgbImage& ids, const std::vector<Sheet>& all, double eye, double slope,
                  bool perspective, bool culled) {
  int decided = 0, hidden = 0;
  for (int j = 0; j < ids.height; ++j)
    for (int i = 0; i < ids.width; ++i) {
      int front = -1;
      bool near = false;
      for (int k = 0; k < std::ssize(all) && !near; ++k) {
        if (culled && all[k].clockwise) continue;
        const double half = perspective ? slope * (eye - all[k].z) : slope, pixel = 2 * half / ids.height;
        const glm::dvec2 p{(i + 0.5 - ids.width / 2.0) * pixel, (ids.height / 2.0 - j - 0.5) * pixel};
        const double margin = 1e-3 * pixel;  // vertices move by up to 2^-17 pixel
        if (p.x < all[k].low.x - margin || p.x > all[k].high.x + margin || p.y < all[k].low.y - margin ||
            p.y > all[k].high.y + margin)
          continue;
        const Where w = where(all[k].outline, p, margin);
        near = w == Where::TooNear;
        if (w != Where::In) continue;
        hidden += front >= 0;
        if (front < 0 || all[k].z > all[front].z) front = k;
      }
      if (near) continue;
      ++decided;
      ASSERT_EQ(idAt(ids, i, j), front + 1) << i << ", " << j;
    }
  EXPECT_GT(decided, ids.width * ids.height * 9 / 10);
  EXPECT_GT(hidden, 1000);
}

/// The face that a ray meets first, from 1, or 0: each outline is projected along its largest axis, and a
/// point is inside if a half line from it crosses the outline an odd number of times. A triangle's plane is
/// that of its corners; an outline's goes through its vector area.
int firstHit(const std::vector<glm::dvec3>& points, const std::vector<std::vector<int>>& faces,
             const glm::dvec3& from, const glm::dvec3& along) {
  int hit = 0;
  double nearest = INFINITY;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::vector<int>& face = faces[f];
    glm::dvec3 N{0.0};
    for (std::size_t k = 0; k < face.size(); ++k)
      N += glm::cross(points[face[k]], points[face[(k + 1) % face.size()]]);
    const double slope = glm::dot(N, along), t = glm::dot(N, points[face[0]] - from) / slope;
    if (slope == 0.0 || t >= nearest) continue;
    const glm::dvec3 P = from + t * along, n = glm::abs(N);
    const int drop = n.x > n.y ? (n.x > n.z ? 0 : 2) : (n.y > n.z ? 1 : 2), a = (drop + 1) % 3,
              b = (drop + 2) % 3;
    bool inside = false;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const glm::dvec3 &p = points[face[k]], &q = points[face[(k + 1) % face.size()]];
      if ((p[b] > P[b]) != (q[b] > P[b]) && P[a] < p[a] + (P[b] - p[b]) / (q[b] - p[b]) * (q[a] - p[a]))
        inside = !inside;
    }
    if (inside) nearest = t, hit = static_cast<int>(f) + 1;
  }
  return hit;
}

/// The faces of a shape as triangles, for outlines of four corners that are not planar, along one diagonal or
/// the other; and the face of each triangle.
std::vector<std::vector<int>> alongDiagonal(const std::vector<std::vector<int>>& faces, int first) {
  std::vector<std::vector<int>> triangles;
  for (const std::vector<int>& f : faces)
    for (const int k : {first, first + 2}) triangles.push_back({f[k % 4], f[(k + 1) % 4], f[(k + 2) % 4]});
  return triangles;
}

}  // namespace

// The face image names the frontmost face at each sample away from edges. This holds in parallel and in
// perspective pictures, with triangulation, clipping and culling.
TEST_F(DrawnPicture, IdsNameTheFaceInFront) {
  const Seeds seeds{4};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<Sheet> all = sheets(seed, 48);
    const std::string obj = write("sheets.obj", objOf(all));
    const Strings eye{"--eye", "0,0,9", "--look-at", "0,0,0", "--up", "0,1,0"};
    expectSheets(draw(obj, eye + Strings{"--parallel", "3"}).ids, all, 9, 1.5, false, false);
    expectSheets(draw(obj, eye + Strings{"--fov", "20"}).ids, all, 9, std::tan(3.14159265358979 / 18), true,
                 false);
    const Drawn culled = draw(obj, eye + Strings{"--parallel", "3", "--cull", "back"});
    expectSheets(culled.ids, all, 9, 1.5, false, true);
    EXPECT_GT(culled.stats["culled"], 0);
  }
}

// Models as people have them: the program counts their faces, their open, turned and crowded edges, says what
// it leaves out, and shows at each sample the face that a ray meets first. Samples within 1/50 pixel of an
// edge are not judged.
TEST_F(CorpusTest, EachModelIsShownAsItIs) {
  constexpr int kWidth = 160, kHeight = 120;
  const glm::dvec3 eye{5, 3, 8}, n = glm::normalize(eye), u = glm::normalize(glm::cross({0, 1, 0}, n)),
                                 v = glm::cross(n, u);
  for (const CorpusModel& model : corpusModels()) {
    SCOPED_TRACE(model.name);
    glm::dvec3 low{INFINITY}, high{-INFINITY};
    std::vector<glm::dvec3> points;
    for (const auto& [x, y, z] : model.shape.points) {
      points.emplace_back(x, y, z);
      low = glm::min(low, points.back()), high = glm::max(high, points.back());
    }
    const glm::dvec3 center = 0.5 * (low + high);
    const double height = 1.3 * glm::length(high - low), pixel = height / kHeight;
    const double unit = model.name == "huge.obj" ? 1e300 : model.name == "tiny.obj" ? 1e-300 : 1.0;
    const auto triple = [&](const glm::dvec3& p) {
      return number(p.x * unit) + ',' + number(p.y * unit) + ',' + number(p.z * unit);
    };
    const std::string name = write(model.name, model.content);
    const Finished end =
        runProgram({"draw", name, "-o", file("out.png"), "--ids", file("ids.png"), "--stats", "--size",
                    "160x120", "--eye=" + triple(center + eye), "--look-at=" + triple(center), "--up",
                    "0,1,0", "--parallel", number(height * unit)});
    std::string notes;
    for (std::string note : model.notes) {
      if (const auto at = note.find("FOLDER/"); at != note.npos) note.replace(at, 7, file(""));
      notes += "xnewell: note: " + name + note + "\n";
    }
    EXPECT_EQ(end.err, notes);
    ASSERT_EQ(end.status, 0);
    const Json stats = Json::parse(end.out);
    EXPECT_EQ(stats["faces"], model.shape.faces.size());
    EXPECT_EQ(stats["open_edges"], model.open);
    EXPECT_EQ(stats["turned_edges"], model.turned);
    EXPECT_EQ(stats["crowded_edges"], model.crowded);

    const RgbImage ids = readPng(file("ids.png"));
    const bool bent = model.name == "bent.obj";
    int judged = 0, shown = 0;
    for (int j = 0; j < kHeight; ++j)
      for (int i = 0; i < kWidth; ++i) {
        const auto hitBy = [&](double dx, double dy, const std::vector<std::vector<int>>& faces) {
          const double x = (i + 0.5 + dx - kWidth / 2.0) * pixel, y = (kHeight / 2.0 - j - 0.5 + dy) * pixel;
          return firstHit(points, faces, center + eye + x * u + y * v, -n);
        };
        const auto faceBy = [&](double dx, double dy, int diagonal) {
          return bent ? (hitBy(dx, dy, alongDiagonal(model.shape.faces, diagonal)) + 1) / 2
                      : hitBy(dx, dy, model.shape.faces);
        };
        const int face = faceBy(0, 0, 0);
        bool clear = true;
        for (const auto& [dx, dy] : {std::pair{0.02, 0.0}, {-0.02, 0.0}, {0.0, 0.02}, {0.0, -0.02}})
          for (const int diagonal : {0, 1}) clear = clear && faceBy(dx, dy, diagonal) == face;
        if (!clear) continue;
        ++judged, shown += face > 0;
        ASSERT_EQ(idAt(ids, i, j), face) << i << ", " << j;
      }
    EXPECT_GT(judged, kWidth * kHeight * 9 / 10);
    EXPECT_GT(shown, kWidth * kHeight / 20);
  }
}

// One cube in eleven spellings is one picture, to the byte, in the program's own view of it.
TEST_F(CorpusTest, OneCubeIsOnePicture) {
  std::string first;
  int cubes = 0;
  for (const CorpusModel& model : corpusModels()) {
    if (model.open + model.turned > 0 || model.shape.points.size() != 8) continue;
    const Finished end = runProgram(
        {"draw", write(model.name, model.content), "-o", file("out.png"), "--bare", "--size", "160x120"});
    ASSERT_EQ(end.status, 0) << end.err;
    if (first.empty()) first = contents(file("out.png"));
    EXPECT_TRUE(contents(file("out.png")) == first) << model.name;
    ++cubes;
  }
  EXPECT_EQ(cubes, 11);
}

// A million faces: all are counted, the border is found, and each sampled face is the one that lies there.
TEST_F(CorpusTest, AMillionFaces) {
  constexpr int n = 1000;
  const Drawn drawn =
      draw(write("hill.obj", hillObj(n)), {"--eye", "500,500,9000", "--look-at", "500,500,0", "--up", "0,1,0",
                                           "--parallel", "1000", "--size", "200x200"});
  EXPECT_EQ(drawn.stats["faces"], n * n);
  EXPECT_EQ(drawn.stats["open_edges"], 4 * n);
  EXPECT_EQ(drawn.stats["turned_edges"], 0);
  // Five faces for each pixel: its centre lies in the third one.
  for (int j = 0; j < 200; ++j)
    for (int i = 0; i < 200; ++i)
      ASSERT_EQ(idAt(drawn.ids, i, j), n * (n - 1 - (5 * j + 2)) + 5 * i + 3) << i << ", " << j;
}

// The code for newer processors and the code for any processor give the same picture, bit for bit.
TEST_F(Baseline, GivesTheSameBits) {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "both programs run the same code here";
#endif
  const std::string program = builtProgram(), baseline = builtProgram("tests/xnewell_baseline");
  if (kSanitized) GTEST_SKIP() << "a sanitized build has only the latter";
  const auto drawn = [&](const std::string& by, const std::string& line) {
    RunningProgram child{by, Strings{"draw", "-o", file("drawn.png")} + words(line), ""};
    const Finished end = child.wait();
    EXPECT_EQ(end.status, 0) << line << ": " << end.err;
    return end.err + contents(file("drawn.png"));
  };
  int pictures = 0;
  for (const std::string scene : {"teapot", "saturated", "highlight", "colored-lights", "spotlight", "hues"})
    for (const std::string method : {"flat", "gouraud", "phong", "phong --constant-v", "envmap"}) {
      const std::string line = scene + " --size 320x240 --shade " + method;
      EXPECT_EQ(drawn(program, line), drawn(baseline, line)) << line;
      ++pictures;
    }
  EXPECT_EQ(pictures, 30);
}

}  // namespace xnewell::THIS_FILE
