#include "shading/laboratory/profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"
#include "tests/bench/triangulated.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

PictureSettings wide(int width) {
  PictureSettings s;
  s.width = width;
  s.height = width / 2;
  s.light.n = 5;  // a highlight that some vertex has a part of
  return s;
}

/// The scanline of a ball of triangles, and which of its faces each pixel shows.
struct BallLine {
  Scanline line;
  std::vector<int> faces;

  explicit BallLine(int width) {
    const PictureSettings s = wide(width);
    const Picture picture = makePicture(makeScene("ball", triangulated(sphere(14, 9)), UpAxis::Z), s);
    line = scanlineOf(picture, s.height / 2, 8);
    faces = picture.seen(line.row, line.row + 1).faces;
  }
  [[nodiscard]] const Profile& of(Shading method) const {
    return *std::ranges::find(line.profiles, method, &Profile::method);
  }
};

Profile sloped(const std::vector<double>& I) {
  Profile profile;
  profile.I = I;
  std::vector<bool> joined(I.size() - 1);
  for (std::size_t i = 0; i + 1 < I.size(); ++i) joined[i] = !std::isnan(I[i]) && !std::isnan(I[i + 1]);
  addSlopes(profile, joined);
  return profile;
}

}  // namespace

// On a ball the profiles of the three methods are as they should be. Flat shading has one value for each
// face. Gouraud shading is a straight line within a face, and its step from one face to the next lies between
// the slopes of the two, so it is continuous. Phong shading bends within a face. The whole ball is one
// surface.
TEST(Profile, MethodsAreWhatTheyInterpolate) {
  const BallLine ball{500};
  const Profile &flat = ball.of(Shading::Flat), &gouraud = ball.of(Shading::Gouraud),
                &phong = ball.of(Shading::Phong);
  EXPECT_EQ(ball.line.outlines, 0);
  EXPECT_GT(ball.line.samples, 150);
  int within = 0, across = 0;
  double bend = 0;
  for (std::size_t i = 2; i + 2 < ball.faces.size(); ++i) {
    const int* const f = &ball.faces[i];
    if (f[-2] < 0 || f[2] < 0) continue;
    if (f[0] == f[1]) {
      EXPECT_EQ(flat.slope[i], 0.0);
    }
    if (f[-1] == f[0] && f[0] == f[1]) {
      ++within;
      EXPECT_NEAR(gouraud.slope[i - 1], gouraud.slope[i], 1e-12);
      bend = std::max(bend, std::abs(phong.slope[i] - phong.slope[i - 1]));
    }
    if (f[-1] == f[0] && f[0] != f[1] && f[1] == f[2]) {
      ++across;
      const auto [low, high] = std::minmax(gouraud.slope[i - 1], gouraud.slope[i + 1]);
      EXPECT_GE(gouraud.slope[i], low - 1e-12);
      EXPECT_LE(gouraud.slope[i], high + 1e-12);
    }
  }
  EXPECT_GT(within, 100);
  EXPECT_GT(across, 5);
  EXPECT_GT(bend, 1e-5);
}

// Twice as many pixels halve the steps of continuous profiles, but not the jumps of flat shading.
TEST(Profile, ContinuousStepsShrinkWithThePixels) {
  const BallLine coarse{400}, fine{1600};
  const auto ratio = [&](Shading method) {
    return fine.of(method).largestJump / coarse.of(method).largestJump;
  };
  EXPECT_GT(ratio(Shading::Flat), 0.9);
  EXPECT_LT(ratio(Shading::Gouraud), 0.35);
  EXPECT_LT(ratio(Shading::Phong), 0.35);
  EXPECT_GT(coarse.of(Shading::Gouraud).largestJump, 0.001);
}

// Known slopes: a staircase has jumps, an even bend has one kink, and nothing is measured across a gap.
TEST(Profile, MeasuresJumpsAndKinks) {
  std::vector<double> steps, bend, roof;
  for (int i = 0; i < 60; ++i) {
    steps.push_back(0.1 * (i / 12));
    bend.push_back(0.001 * i * i);
  }
  Profile p = sloped(steps);
  EXPECT_NEAR(p.largestJump, 0.1, 1e-12);
  EXPECT_NEAR(p.largestKink, 0.1, 1e-12);
  p = sloped(bend);
  EXPECT_NEAR(p.largestJump, 0.001 * (59 * 59 - 58 * 58), 1e-12);
  EXPECT_NEAR(p.largestKink, 0.002, 1e-12);
  for (int i = 0; i < 41; ++i) roof.push_back(0.01 * (20 - std::abs(i - 20)));
  EXPECT_NEAR(sloped(roof).largestKink, 0.02, 1e-12);
  roof[20] = kNone;
  EXPECT_TRUE(std::isnan(sloped(roof).slope[19]) && std::isnan(sloped(roof).slope[20]));
  EXPECT_FALSE(std::isnan(sloped(roof).slope[18]));
}

// Known bands: one for each jump of 1/240 or more, and one for each change of slope of 1/2 or more over the
// whole row, at the very edge between two faces. There is none between two surfaces, and a bend within a face
// counts for nothing.
TEST(Profile, BandsAreAtEdgesOfFaces) {
  constexpr int kFace = 20, kFaces = 5, kAll = kFace * kFaces;
  std::vector<FaceRun> runs;
  for (int f = 0; f < kFaces; ++f) runs.push_back({f * kFace, (f + 1) * kFace, f + 1 < kFaces});
  const auto bands = [&](auto&& I) {
    std::vector<double> row;
    for (int i = 0; i < kAll; ++i) row.push_back(I(i + 0.5));
    return bandsOf(row, runs, kAll);
  };
  const auto stairs = [&](double step) { return [=](double x) { return step * std::floor(x / kFace); }; };
  EXPECT_EQ(bands(stairs(1.01 / 240)), (std::vector<double>{20, 40, 60, 80}));
  EXPECT_EQ(bands(stairs(0.99 / 240)), std::vector<double>{});
  const auto roof = [&](double slope) {
    return [=](double x) { return slope / kAll * (x < 40 ? x : 80 - x); };
  };
  EXPECT_EQ(bands(roof(0.251)), std::vector<double>{40});
  EXPECT_EQ(bands(roof(0.249)), std::vector<double>{});
  EXPECT_EQ(bands([](double x) { return std::abs(x - 50) / 50; }), std::vector<double>{});
  EXPECT_EQ(bands([](double x) { return 1.5 * x * x / kAll / kAll; }), std::vector<double>{});
  // A steep smooth curve, as of a highlight, has none, however many faces it is made of.
  EXPECT_EQ(bands([](double x) { return std::exp(-(x - 50) * (x - 50) / 200); }), std::vector<double>{});
  runs[1].joinsNext = false;
  EXPECT_EQ(bands(stairs(0.1)), (std::vector<double>{20, 60, 80}));
}

// The flat ball has a band wherever the face changes and its intensity does, counted here from the picture's
// own row, as wide as the row of bands.
TEST(Profile, AFlatBandForEachVisibleEdge) {
  const BallLine ball{kFineWidth};
  const Profile& flat = ball.of(Shading::Flat);
  int edges = 0, visible = 0;
  for (std::size_t i = 1, since = 0; i < ball.faces.size(); ++i) {
    if (ball.faces[i] == ball.faces[since]) continue;
    ASSERT_TRUE(ball.faces[since] < 0 || i - since >= 3);
    since = i;
    if (ball.faces[i - 1] < 0 || ball.faces[i] < 0) continue;
    ++edges;
    visible += std::abs(flat.I[i] - flat.I[i - 1]) >= 1.0 / 240;
  }
  EXPECT_EQ(ball.line.edges, edges);
  EXPECT_EQ(std::ssize(flat.bands), visible);
  EXPECT_GT(visible, 5);
}

// A larger picture has the same bands in the same places. Smoother methods have fewer.
TEST(Profile, BandsAreTheSameAtEverySize) {
  for (const char* name : {"teapot", "hues", "mach-bands"}) {
    SCOPED_TRACE(name);
    PictureCache pictures{readScene(name)};
    std::array<std::vector<int>, 3> first;
    for (const int width : {2102, 422, 702}) {
      PictureSettings s = wide(width);
      s.camera = completed({}, pictures.scene().camera);
      s.colors = ColorPlan::OneHue;
      const Scanline line = scanlineOf(pictures.make(s), s.height / 2, 8);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::vector<int>& bands = line.profiles[k].bands;
        if (width == 2102) first[k] = bands;
        ASSERT_EQ(bands.size(), first[k].size()) << width << ' ' << k;
        for (std::size_t i = 0; i < bands.size(); ++i)
          EXPECT_NEAR((bands[i] + 0.5) / width, (first[k][i] + 0.5) / 2102, 1.5 / width);
      }
    }
    EXPECT_GT(first[0].size(), 5U);
    EXPECT_GE(first[0].size(), first[1].size());
    EXPECT_GE(first[1].size(), first[2].size());
  }
}

// Where one torus is in front of the other there is an outline and no band. A cube's faces are one surface if
// their normals are averaged, but not if a crease parts them.
TEST(Profile, CountsWithinOneSurface) {
  PictureSettings s = wide(300);
  PictureCache tori{readScene("tori")};
  s.camera = completed({}, tori.scene().camera);
  const Scanline both = scanlineOf(tori.make(s), 75, 8);
  EXPECT_GE(both.outlines, 1);
  for (const Profile& p : both.profiles)
    for (const double slope : p.slope) EXPECT_TRUE(std::isnan(slope) || std::abs(slope) < 0.4);

  PictureCache box{makeScene("box", cube(), UpAxis::Z)};
  s.camera = {};
  s.camera.eye = glm::dvec3{3, -2, 1};
  EXPECT_EQ(scanlineOf(box.make(s), 75, 8).outlines, 0);
  s.crease = 30;
  const Scanline creased = scanlineOf(box.make(s), 75, 8);
  EXPECT_EQ(creased.outlines, 1);
  EXPECT_EQ(creased.profiles[0].largestJump, 0.0);
}

// Where one looks into a tube, the near wall's outside ends at the far walls' inside. This is an outline,
// although all three walls meet in their corners.
TEST(Profile, TheTwoSidesAreTwoSurfaces) {
  Mesh tube;
  tube.points = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {-1, -1, 1}, {1, -1, 1}, {0, 1, 1}};
  for (const auto& wall : {std::array{0, 1, 4, 3}, std::array{1, 2, 5, 4}, std::array{2, 0, 3, 5}})
    tube.addFace(wall, 0);
  PictureSettings s = wide(300);
  s.camera.eye = glm::dvec3{2, -3, 4};
  const Picture picture = makePicture(makeScene("tube", tube, UpAxis::Z), s);
  int edges = 0, samples = 0;
  for (int row = 0; row < s.height; ++row) {
    const Scanline line = scanlineOf(picture, row, 8);
    const std::vector<int> seen = picture.seen(row, row + 1).faces;
    int sides = 0;  // neighbours of which one shows its front and one its back
    for (std::size_t i = 1; i < seen.size(); ++i)
      if (seen[i - 1] >= 0 && seen[i] >= 0)
        sides += picture.snapped().faces[seen[i - 1]].back != picture.snapped().faces[seen[i]].back;
    EXPECT_EQ(line.outlines, sides);
    edges += sides, samples += line.samples;
  }
  EXPECT_GT(edges, 10);
  EXPECT_GT(samples, 500);
}

// The strip is the row of the method's picture, whatever method the given picture is in.
TEST(Profile, ShowsTheRowOfEachMethod) {
  PictureCache pictures{readScene("teapot", 4)};
  PictureSettings s = wide(200);
  s.shading = Shading::Gouraud;
  const Scanline line = scanlineOf(pictures.make(s), 60, 8);
  for (const Profile& p : line.profiles) {
    s.shading = p.method;
    const IndexImage image = pictures.make(s, 8).image();
    EXPECT_TRUE(std::equal(p.cells.begin(), p.cells.end(), image.row(60), image.row(61)));
  }
  EXPECT_NE(line.profiles[0].cells, line.profiles[1].cells);
}

// The default is the middle row, unless it shows nothing.
TEST(Profile, DefaultScanlineShowsSomething) {
  Mesh m;
  m.points = {{-1, 0.5, 0}, {1, 0.5, 0}, {0, 0.9, 0}};
  const int triangle[] = {0, 1, 2};
  m.addFace(triangle, 0);
  PictureSettings s = wide(100);
  s.camera.parallel = true;
  s.camera.eye = glm::dvec3{0, 0, 3};
  s.camera.lookAt = glm::dvec3{0};
  s.camera.height = 2.0;
  const Picture above = makePicture(makeScene("above", m, UpAxis::Y), s);
  const SeenRows middle = above.seen(25, 26);
  const SeenRows chosen = above.seen(defaultScanline(above), defaultScanline(above) + 1);
  const auto shown = [](const SeenRows& r) {
    return std::ranges::count_if(r.faces, [](int f) { return f >= 0; });
  };
  EXPECT_EQ(shown(middle), 0);
  EXPECT_GT(shown(chosen), 10);
  EXPECT_EQ(defaultScanline(makePicture(readScene("teapot", 3), wide(100))), 25);
}

// The cells of every strip are those of the picture's plan, whatever method the picture has: cell by cell,
// the ramp of the surface's hue. The method of the picture has its own row.
TEST(Profile, CellsAreOfThePicturesPlan) {
  for (const Shading shading : {Shading::Full, Shading::Depth, Shading::Flat, Shading::Gouraud,
                                Shading::Phong, Shading::Environment}) {
    Scene scene = readScene("hues");
    PictureSettings settings = scene.settings;
    settings.camera = scene.camera;
    settings.width = 200, settings.height = 150, settings.shading = shading;
    const Picture picture = makePicture(std::move(scene), settings, 8);
    for (const int row : {60, 80, 100}) {
      const Scanline line = scanlineOf(picture, row, 8);
      const SeenRows seen = picture.seen(row, row + 1);
      for (const Profile& p : line.profiles) {
        SCOPED_TRACE(testing::Message() << static_cast<int>(shading) << ' ' << row);
        if (p.method == shading) {
          EXPECT_TRUE(std::equal(p.cells.begin(), p.cells.end(), picture.image().row(row)));
        }
        for (int i = 0; i < 200; ++i) {
          if (seen.faces[i] < 0) {
            ASSERT_EQ(p.cells[i], 8);
            continue;
          }
          const int face = picture.snapped().faces[seen.faces[i]].number;
          const ColorTable& table = picture.colors().tableOf(picture.scene().mesh.material[face]);
          ASSERT_GE(p.cells[i], table.first());
          ASSERT_LT(p.cells[i], table.first() + table.shades());
          ASSERT_NEAR(picture.colors().intensityOf(p.cells[i]), p.I[i], 2.0 / table.shades());
        }
      }
    }
  }
}

}  // namespace xnewell::THIS_FILE
