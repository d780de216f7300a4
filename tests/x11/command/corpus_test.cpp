#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "tests/x11/support/command_fixture.h"
#include "tests/x11/support/corpus_models.h"

namespace xnewell::THIS_FILE {

namespace {

using CorpusTest = CommandTest;

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

// A picture is handed in as other programs write it: PPM of bytes or of words, or BMP.
TEST_F(CorpusTest, PicturesAreHandedInAsOthersWriteThem) {
  ASSERT_EQ(runProgram({"draw", "bench", "--size", "160x120", "-o", file("a.png")}).status, 0);
  const RgbImage picture = readPng(file("a.png"));
  std::string text = "P3\n160 120\n255\n", bytes = "P6\n160 120\n255\n";
  std::string bmp = "BM" + std::string(52, '\0');
  bmp[10] = 54, bmp[14] = 40, bmp[18] = static_cast<char>(160), bmp[22] = 120, bmp[26] = 1, bmp[28] = 24;
  for (const std::uint8_t v : picture.rgb) {
    text += std::to_string(v) + '\n';
    bytes += static_cast<char>(v);
  }
  for (int j = 119; j >= 0; --j)
    for (int i = 0; i < 160; ++i)
      for (const int c : {2, 1, 0}) bmp += static_cast<char>(picture.pixel(i, j)[c]);
  for (const auto& [name, content] : {std::pair{"a.txt.ppm", text}, {"a.ppm", bytes}, {"a.bmp", bmp}}) {
    const Finished end = runProgram({"diagnose", "bench", write(name, content)});
    EXPECT_TRUE(end.out.starts_with("right\n")) << name << end.out << end.err;
  }
}

// An outline that runs the wrong way changes nothing while both sides are lit and faces are shaded flat. If
// back faces are culled, its face is missing from the front, and its back shows.
TEST_F(CorpusTest, ATurnedFaceShowsIfBothSidesAreLit) {
  std::string right, wrong;
  for (const CorpusModel& model : corpusModels()) {
    if (model.name == "wrong.obj") wrong = write(model.name, model.content);
    if (model.name == "crlf.obj") right = write(model.name, model.content);
  }
  const Strings view{"--eye", "5,3,8", "--shade", "flat"};
  EXPECT_EQ(draw(wrong, view).png, draw(right, view).png);
  const Strings cull = view + Strings{"--cull", "back"};
  EXPECT_EQ(draw(right, cull).png, draw(right, view).png);
  EXPECT_EQ(idCounts(draw(wrong, cull).ids).count(4), 0u);
  EXPECT_GT(idCounts(draw(wrong, view).ids)[4], 100);
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

}  // namespace xnewell::THIS_FILE
