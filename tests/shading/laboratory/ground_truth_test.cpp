#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <optional>

#include "depthsort/oracle.h"
#include "shading/color/color_difference.h"
#include "shading/laboratory/errors.h"
#include "shading/laboratory/ground_truth.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/divide_anew.h"
#include "shading/scene/scene_file.h"
#include "tests/support/small_picture.h"
#include "tests/support/temporary_folder.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- The ground truth

using Vec = glm::dvec3;

/// The surface f = 0 about its centre, in file coordinates. It ends where |x| or |y| exceeds `reach`.
struct Surface {
  Vec centre;
  std::function<double(const Vec&)> f;
  double reach = 9;

  static constexpr double kBegin = 6, kEnd = 16, kStep = 0.04;  ///< along a ray
  /// How far along it a ray meets the surface first: small steps find the place, and halves make it exact.
  [[nodiscard]] double meets(const Vec& from, const Vec& along) const {
    const auto isBelow = [&](double t) { return f(from + t * along - centre) < 0; };
    for (double t = kBegin; t < kEnd; t += kStep) {
      if (isBelow(t) == isBelow(t + kStep)) continue;
      double low = t, high = t + kStep;
      for (int k = 0; k < 40; ++k) {
        const double middle = (low + high) / 2;
        (isBelow(middle) == isBelow(low) ? low : high) = middle;
      }
      const Vec p = from + low * along - centre;
      if (std::max(std::abs(p.x), std::abs(p.y)) <= reach) return low;
    }
    return kEnd;
  }
  /// The gradient of f, a unit vector.
  [[nodiscard]] Vec normal(const Vec& p) const {
    Vec N;
    for (int axis = 0; axis < 3; ++axis) {
      Vec step{0};
      step[axis] = 1e-5;
      N[axis] = f(p - centre + step) - f(p - centre - step);
    }
    return normalize(N);
  }
};

/// A view from `eye` to `at`, z up, lit from a direction. It computes what a pixel should show.
struct Judge {
  Vec eye, at, L;
  double fov, Ia, Ip;
  std::vector<Surface> surfaces;

  /// The intensity at the centre of a pixel; nothing for background.
  [[nodiscard]] std::optional<double> operator()(int i, int j, int width, int height) const {
    const Vec n = normalize(eye - at), u = normalize(cross(Vec{0, 0, 1}, n)), v = cross(n, u);
    const double half = std::tan(fov / 360 * 3.14159265358979323846);
    const double x = half * width / height * (2 * (i + 0.5) / width - 1),
                 y = half * (1 - 2 * (j + 0.5) / height);
    const Vec along = normalize(x * u + y * v - n);
    double first = Surface::kEnd;
    const Surface* nearest = nullptr;
    for (const Surface& surface : surfaces)
      if (const double t = surface.meets(eye, along); t < first) first = t, nearest = &surface;
    if (!nearest) return std::nullopt;
    const Vec out = nearest->normal(eye + first * along), N = dot(out, along) > 0 ? -out : out;
    return Ia + Ip * std::max(0.0, dot(N, L));
  }
};

/// The patch of the vault z = 0.9 (4 - x^2) / 4: x = 4 u - 2, y = 4 v - 2.
std::string vaultPatch() {
  std::string text = "1\n3 3\n";
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      text += std::to_string(4 * i / 3.0 - 2) + ' ' + std::to_string(4 * j / 3.0 - 2) +
              (i == 1 || i == 2 ? " 1.2\n" : " 0\n");
  return text;
}

/// An ellipsoid, a torus and a vault of few polygons. The file sets the divisions of all.
const std::string kFew = R"({
  "up": "z", "camera": {"eye": [1, -9, 6], "look_at": [0, 0, 0.4], "fov": 36},
  "objects": [
    {"solid": "sphere", "around": 10, "down": 5, "scale": [1.2, 0.8, 1], "move": [-1.6, -0.6, 1.7]},
    {"file": "vault.bpt", "divisions": 2, "move": [-1, 1, -1]},
    {"solid": "torus", "around": 9, "across": 6, "move": [1.7, 0.2, 0.4]}]})";
Judge judgeOfFew() {
  return {{1, -9, 6},
          {0, 0, 0.4},
          normalize(Vec{-1, -2, 3}),
          36,
          0.2,
          0.7,
          {{{-1.6, -0.6, 1.7},
            [](const Vec& p) {
              return length(p / Vec{1.2, 0.8, 1}) - 1;
            }},
           {{-1, 1, -1}, [](const Vec& p) { return p.z - 0.225 * (4 - p.x * p.x); }, 2},
           {{1.7, 0.2, 0.4}, [](const Vec& p) { return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.4; }}}};
}

struct Few {
  Few() {
    folder.write("vault.bpt", vaultPatch());
    scene = parseSceneFile(kFew, "few", folder.path());
    settings.width = 160, settings.height = 120;
    settings.camera = completed({}, scene.camera);
    settings.light = {.Ia = 0.2, .Ip = 0.7, .ka = 1, .kd = 1, .ks = 0, .n = 5, .light = {-1, -2, 3}};
  }
  TemporaryFolder folder;
  Scene scene;
  PictureSettings settings;
};

Errors errorsOfPicture(const Scene& scene, PictureSettings s, int width, int height) {
  s.width = width, s.height = height;
  const CellPlan cells{s.table.kind};
  const Picture picture = makePicture(scene, s, cells[Cell::Well]);
  return errorsOf(picture, picture.palette(cells));
}

// Rays meet the true ellipsoid, torus and vault, however few polygons the file asks for. The truth has the
// same intensity at every sample, but for a few at outlines: the fine polygons are up to 0.02 pixels inside
// of them.
TEST(GroundTruth, IsThatOfTheSurfaces) {
  const Few few;
  const Judge judge = judgeOfFew();
  const Picture picture = makePicture(few.scene, few.settings);
  const GroundTruth truth{picture};
  int shown = 0, off = 0, beyond = 0;
  for (int j = 0; j < few.settings.height; ++j)
    for (int i = 0; i < few.settings.width; ++i) {
      const std::size_t k = std::size_t(j) * few.settings.width + i;
      const std::optional<double> I = judge(i, j, few.settings.width, few.settings.height);
      const bool shows = truth.reference().faces()[k] != kNothing;
      shown += I.has_value();
      beyond += I && truth.polygons().faces()[k] == kNothing;
      off += I.has_value() != shows ||
             (I && std::abs(static_cast<double>(*I) - truth.reference().I(k).r) > 0.002);
    }
  EXPECT_GT(shown, 3'500);
  EXPECT_GT(beyond, 100);  // the file's polygons miss that much of the surfaces
  EXPECT_LE(off, 8);
}

// So the errors of a picture are those of a comparison with the true surfaces.
TEST(GroundTruth, GivesTheErrorsOfThePolygons) {
  Few few;
  const Judge judge = judgeOfFew();
  for (const Shading shading : {Shading::Flat, Shading::Phong}) {
    few.settings.shading = shading;
    few.settings.table.hue = glm::dvec3{1};
    const Picture picture = makePicture(few.scene, few.settings, CellPlan{}[Cell::Well]);
    double squares = 0;
    int samples = 0;
    for (int j = 0; j < few.settings.height; ++j)
      for (int i = 0; i < few.settings.width; ++i) {
        const int cell = picture.image().row(j)[i];
        const bool shows = cell != picture.ground();
        const std::optional<double> due = judge(i, j, few.settings.width, few.settings.height);
        if (!shows && !due) continue;
        const double error =
            (shows ? picture.colors().intensityOf(cell) : 0.0) - static_cast<double>(due.value_or(0));
        ++samples, squares += error * error;
      }
    const Errors errors = errorsOf(picture, picture.palette(CellPlan{}));
    const double expected = std::sqrt(squares / samples);
    EXPECT_GT(expected, 0.05);
    EXPECT_NEAR(errors.afterTable.rootMeanSquare, expected, 0.02 * expected);
    EXPECT_NEAR(static_cast<double>(errors.samples), samples, 8);
    EXPECT_EQ(errors.wrongFaces, 0);
    // At an outline, where the polygons show nothing, the face is the one that stands for the surface.
    ASSERT_FALSE(errors.worst.empty());
    for (const WorstPlace& place : errors.worst) {
      EXPECT_EQ(place.due.r > 0, place.face >= 0);
      EXPECT_LT(place.face, few.scene.mesh.faceCount());
    }
  }
}

// The figures of another program, which has true spheres, and patches of many polygons.
TEST(GroundTruth, IsThatOfBuiltInScenes) {
  const auto errorOf = [](const std::string& name, int divisions, ColorPlan colors, int width, int height) {
    const Scene scene = readScene(name, divisions);
    PictureSettings s = scene.settings;
    s.colors = colors, s.camera = completed({}, scene.camera);
    return errorsOfPicture(scene, s, width, height).afterTable.rootMeanSquare;
  };
  EXPECT_NEAR(errorOf("colored-lights", 8, ColorPlan::OneHue, 320, 240), 0.0116, 0.0002);
  EXPECT_NEAR(errorOf("colored-lights", 2, ColorPlan::OneHue, 320, 240), 0.0487, 0.0005);
  EXPECT_NEAR(errorOf("hues", 8, ColorPlan::Needed, 640, 480), 0.0376, 0.002);
}

// A patch is as wrong if its file sets the divisions as if the user does.
TEST(GroundTruth, DoesNotAskWhoSetTheDivisions) {
  const Scene own = readScene("coarse-teapot"), open = readScene("teapot", 3);
  const Errors a = errorsOfPicture(own, own.settings, 120, 90),
               b = errorsOfPicture(open, own.settings, 120, 90);
  EXPECT_NEAR(a.afterTable.rootMeanSquare, b.afterTable.rootMeanSquare, 1e-9);
  EXPECT_GT(a.afterTable.rootMeanSquare, 0.08);
}

// A scene whose surfaces are as fine as those of the reference is not divided again: nothing is held twice.
TEST(GroundTruth, NeedsNoSecondSceneIfTheFirstIsFine) {
  EXPECT_TRUE(fineSceneOf(readScene("teapot", 63)));
  EXPECT_FALSE(fineSceneOf(readScene("teapot", 64)));
  EXPECT_FALSE(fineSceneOf(readScene("cycle")));
  const Few few;
  EXPECT_TRUE(fineSceneOf(few.scene));
  EXPECT_FALSE(fineSceneOf(finelyDivided(few.scene)));
}

// A face of one division is a face of any other: at poles, edges, and beside other objects.
TEST(GroundTruth, FindsTheFaceOfOtherDivisions) {
  const Few few;
  const Scene fine = finelyDivided(few.scene);
  EXPECT_EQ(finestDivisions(few.scene), 64);
  EXPECT_EQ(fine.mesh.faceCount(), 256 * 128 + 64 * 64 + 256 * 256);
  for (int face = 0; face < few.scene.mesh.faceCount(); ++face) {
    ASSERT_EQ(sameFaceIn(few.scene, few.scene, face), face);
    ASSERT_EQ(sameFaceIn(few.scene, fine, sameFaceIn(fine, few.scene, face)), face);
  }
  // Its middle is within the size of a coarse face of that face's middle.
  const auto middle = [](const Scene& scene, int face) {
    glm::dvec3 sum{0};
    for (const int c : scene.mesh.face(face)) sum += scene.mesh.points[c];
    return std::ldexp(1.0, scene.exponent) * sum / static_cast<double>(scene.mesh.face(face).size());
  };
  for (int face = 0; face < fine.mesh.faceCount(); face += 37)
    ASSERT_LT(glm::length(middle(fine, face) - middle(few.scene, sameFaceIn(few.scene, fine, face))), 1.8)
        << face;
}

// The last truth stays as long as nothing that decides it changes. A short cut does not.
TEST(GroundTruth, IsKept) {
  Few few;
  PictureCache pictures{few.scene};
  CachedGroundTruth last;
  const GroundTruth* const first = &last.of(pictures.make(few.settings));
  const double before = first->reference().I(60 * 160 + 80).r;
  std::vector<int> faces = first->reference().faces();
  few.settings.shading = Shading::Phong, few.settings.order = Order::ZSort;
  EXPECT_EQ(last.of(pictures.make(few.settings)).reference().faces(), faces);
  few.settings.light.Ia = 0.1;
  EXPECT_NEAR(last.of(pictures.make(few.settings)).reference().I(60 * 160 + 80).r, before - 0.1, 1e-12);
  few.settings.camera.fov = 50;
  EXPECT_NE(last.of(pictures.make(few.settings)).reference().faces(), faces);
  const Picture other = makePicture(readScene("cycle"), few.settings);
  EXPECT_EQ(last.of(other).reference().picture().scene().name, "cycle");
}

/// ---- Errors

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Cards that face the viewer of a parallel view 8 units high, in a picture of 80 x 80 pixels: a unit is ten
/// pixels. The light comes from the viewer, so N.L is 1 on a card at right angles.
struct Cards {
  explicit Cards(const std::string& objects, const std::string& materials = "{}")
      : pictures{
            parseSceneFile(R"({"up": "y", "materials": )" + materials + R"(, "objects": )" + objects + "}",
                           "cards", XNEWELL_DATA_DIR)} {
    settings.width = settings.height = 80;
    settings.camera.eye = {0, 0, 20};
    settings.camera.lookAt = glm::dvec3{0};
    settings.camera.parallel = true;
    settings.camera.height = 8;
    settings.light = {.Ia = 0.25, .Ip = 0.5, .ka = 1, .kd = 1, .ks = 0, .n = 5, .light = {0, 0, 1}};
    settings.table.hue = glm::dvec3{1};
  }
  const Picture& paint() {
    pictures.make(settings, CellPlan{settings.table.kind}[Cell::Well]);
    return pictures.last();
  }
  Errors errors() {
    const Picture& picture = paint();
    return errorsOf(picture, picture.palette(CellPlan{settings.table.kind}));
  }
  PictureCache pictures;
  PictureSettings settings;
};

/// One card of 4 x 4 units, 40 x 40 pixels.
const std::string kCard = R"([{"polygons": [[[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0]]]}])";

void expectAll(const Spread& spread, double error, std::int64_t count) {
  EXPECT_NEAR(spread.mean, error, 1e-7);
  EXPECT_NEAR(spread.rootMeanSquare, error, 1e-7);
  EXPECT_NEAR(spread.p99, error, 1e-7);
  EXPECT_NEAR(spread.largest, error, 1e-7);
  EXPECT_EQ(spread.count, count);
}

// Mean, root mean square, percentile and maximum of numbers for which they are known.
TEST(Errors, SpreadOfNumbers) {
  std::vector<float> hundred(100);
  std::iota(hundred.begin(), hundred.end(), 1.0F);
  std::ranges::reverse(hundred);
  hundred.insert(hundred.begin() + 50, 7, kNone);
  Spread spread = spreadOf(hundred);
  EXPECT_EQ(spread.count, 100);
  EXPECT_EQ(spread.mean, 50.5);
  EXPECT_DOUBLE_EQ(spread.rootMeanSquare, std::sqrt(338350 / 100.0));
  EXPECT_EQ(spread.p99, 99);
  EXPECT_EQ(spread.largest, 100);
  hundred.push_back(1000);  // of 101 numbers 99 % are 99.99, so 100 of them must not exceed it
  EXPECT_EQ(spreadOf(hundred).p99, 100);
  std::vector<float> sixty(60);  // 99 % are 59.4: the largest is one of them
  std::iota(sixty.begin(), sixty.end(), 1.0F);
  EXPECT_EQ(spreadOf(sixty).p99, 60);
  expectAll(spreadOf(std::vector{0.5F}), 0.5, 1);
  expectAll(spreadOf(std::vector{kNone, kNone}), 0, 0);
}

// The worst samples are the largest errors, at least eight pixels from each other.
TEST(Errors, WorstSamplesAreApart) {
  constexpr int kWide = 40;
  std::vector<float> errors(kWide * 30, kNone);
  const auto at = [&](int x, int y) -> float& { return errors[std::size_t(y) * kWide + x]; };
  for (int y = 10; y < 20; ++y)
    for (int x = 0; x < kWide; ++x) at(x, y) = 0;
  at(5, 12) = 3, at(12, 12) = 2.5F, at(13, 12) = 2, at(5, 19) = 1, at(5, 20) = 0.5F;
  EXPECT_EQ(worstSamples(errors, kWide),
            (std::vector<std::size_t>{12 * kWide + 5, 12 * kWide + 13, 20 * kWide + 5}));
  std::ranges::fill(errors, 1.0F);
  EXPECT_EQ(worstSamples(errors, kWide).size(), std::size_t{kMostWorstPlaces});
  EXPECT_EQ(worstSamples(errors, kWide).front(), 0u);
}

// A card has intensity Ia + Ip = 0.75 everywhere. Flat shading knows it, and 5 shades have it. Of 3 shades
// the nearest is off by 1/4. At full intensity, and as a back that is not painted, the error is known too.
TEST(Errors, OfOneCard) {
  Cards card{kCard};
  card.settings.table.shades = 5;
  Errors e = card.errors();
  expectAll(e.beforeTable, 0, 1600);
  expectAll(e.afterTable, 0, 1600);
  EXPECT_EQ(e.samples, 1600);
  EXPECT_EQ(e.wrongFaces, 0);
  EXPECT_TRUE(e.worst.empty());
  EXPECT_FALSE(e.patches || e.blocks);

  card.settings.table.shades = 3;
  e = card.errors();
  expectAll(e.beforeTable, 0, 1600);
  expectAll(e.afterTable, 0.25, 1600);
  ASSERT_FALSE(e.worst.empty());
  EXPECT_EQ(e.worst.front().x, 20);
  EXPECT_EQ(e.worst.front().y, 20);
  EXPECT_EQ(e.worst.front().face, 0);
  EXPECT_EQ(e.worst.front().shownFace, 0);
  EXPECT_EQ(e.worst.front().due, glm::dvec3{0.75});
  EXPECT_EQ(e.worst.front().shown, glm::dvec3{1.0});
  EXPECT_EQ(e.worst.front().error, 0.25);
  // The linear table stores 240/255 for full intensity. The hue belongs to the model: the reference has it
  // too.
  const auto difference = [](const glm::dvec3& hue) {
    const auto lab = [&](double v) {
      const glm::dvec3 c = glm::floor(65535 * v * hue + 0.5);
      return labFromSrgb(Rgb16{std::uint16_t(c.r), std::uint16_t(c.g), std::uint16_t(c.b)});
    };
    return ciede2000(lab(0.75), lab(240.0 / 255));
  };
  expectAll(e.color, static_cast<float>(difference({1, 1, 1})), 1600);
  card.settings.table.hue = {1, 0.5, 0};
  EXPECT_NEAR(card.errors().color.mean, difference({1, 0.5, 0}), 0.01);

  card.settings.shading = Shading::Full;
  expectAll(card.errors().beforeTable, 0.25, 1600);
}

// Where two cards overlap by 10 x 20 pixels, the wrong order shows 200 samples of the wrong one. Where backs
// are not painted, all samples of a card show nothing.
TEST(Errors, CountWrongFaces) {
  Cards cards{R"([{"polygons": [[[-2, -2, 1], [0, -2, 1], [0, 2, 1], [-2, 2, 1]],
                                [[-1, 0, 0], [-1, 2, 0], [3, 2, 0], [3, 0, 0]]]}])"};
  EXPECT_EQ(cards.errors().wrongFaces, 0);
  cards.settings.order = Order::Unsorted;
  Errors e = cards.errors();
  EXPECT_EQ(e.wrongFaces, 200);
  EXPECT_EQ(e.samples, 20 * 40 + 40 * 20 - 200);
  expectAll(e.beforeTable, 0, e.samples);  // both cards are equally bright

  cards.settings.order = Order::Newell;
  cards.settings.cull = Cull::Back;  // the second card turns its back
  e = cards.errors();
  EXPECT_EQ(e.wrongFaces, 600);
  EXPECT_EQ(e.samples, 1400);
  EXPECT_NEAR(e.beforeTable.largest, 0.75, 1e-7);
  EXPECT_NEAR(e.beforeTable.mean, 0.75 * 600 / 1400, 1e-7);
  EXPECT_NEAR(e.afterTable.largest, 0.75, 1e-7);
  ASSERT_FALSE(e.worst.empty());
  EXPECT_EQ(e.worst.front().face, 1);
  EXPECT_EQ(e.worst.front().shownFace, kNothing);
  EXPECT_EQ(e.worst.front().shown, glm::dvec3{0.0});
}

// A lamp above a card: L constant takes N.L = 1 everywhere. The error is 1 - cos of the angle to the lamp.
TEST(Errors, OfConstantL) {
  Cards card{kCard};
  card.settings.light.lightPosition = glm::dvec3{0, 0, 2};
  card.settings.shading = Shading::Phong;
  const auto cosine = [](int i, int j) {
    const double x = (i + 0.5 - 40) / 10, y = (j + 0.5 - 40) / 10;
    return 2 / std::sqrt(x * x + y * y + 4);
  };
  EXPECT_LT(card.errors().beforeTable.largest, 1e-12);
  card.settings.light.constantL = true;
  const Errors e = card.errors();
  double sum = 0, squares = 0, largest = 0;
  for (int j = 20; j < 60; ++j)
    for (int i = 20; i < 60; ++i) {
      const double error = 0.5 * (1 - cosine(i, j));
      sum += error, squares += error * error, largest = std::max(largest, error);
    }
  EXPECT_NEAR(e.beforeTable.mean, sum / 1600, 1e-7);
  EXPECT_NEAR(e.beforeTable.rootMeanSquare, std::sqrt(squares / 1600), 1e-7);
  EXPECT_NEAR(e.beforeTable.largest, largest, 1e-7);
  EXPECT_GT(largest, 0.19);
  ASSERT_FALSE(e.worst.empty());
  EXPECT_EQ(e.worst.front().x, 20);
  EXPECT_EQ(e.worst.front().y, 20);
}

// In a ramp of one hue, a white highlight is as red as the surface: green and blue lack ks Ip.
TEST(Errors, OfHuesHaveThreeChannels) {
  Cards card{R"([{"material": "red", "polygons": [[[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0]]]}])",
             R"({"red": {"color": [1, 0, 0]}})"};
  card.settings.light = {.Ia = 0, .Ip = 1, .ka = 0, .kd = 0.5, .ks = 0.25, .n = 0, .light = {0, 0, 1}};
  card.settings.colors = ColorPlan::Hues;
  const Errors e = card.errors();
  expectAll(e.beforeTable, 0.25, 1600);
  EXPECT_EQ(e.worst.front().due, (glm::dvec3{0.75, 0.25, 0.25}));
}

// The error of a block is that of its mean, and only whole blocks count. Dithering is made for it.
TEST(Errors, OfBlocks) {
  Cards card{kCard};
  card.settings.colors = ColorPlan::Cube;
  card.settings.light.Ip = 0.55;
  card.settings.dither = true;
  const Errors e = card.errors();
  ASSERT_TRUE(e.blocks);
  EXPECT_EQ(e.blocks->count, 16);  // the card covers pixels 20 to 59: blocks 3 to 6 of ten
  const Picture& picture = card.paint();
  const Palette palette = picture.palette(CellPlan{});
  double worst = 0;
  for (int by = 3; by < 7; ++by)
    for (int bx = 3; bx < 7; ++bx) {
      glm::dvec3 mean{0.0};
      for (int k = 0; k < 64; ++k) {
        const Rgb16& c = palette[picture.image().pixels[std::size_t(8 * by + k / 8) * 80 + 8 * bx + k % 8]];
        mean += glm::dvec3{c.r, c.g, c.b} / (64 * 65535.0);
      }
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(mean[c] - 0.8));
    }
  EXPECT_NEAR(e.blocks->largest, worst, 1e-6);
  EXPECT_LT(e.blocks->largest, 0.01);
  EXPECT_GT(e.afterTable.rootMeanSquare, 0.03);
  card.settings.dither = false;
  EXPECT_FALSE(card.errors().blocks);
}

// The vault z = 3 c u (1 - u) as one flat polygon. Its top is 3c/4 above the middle, and elsewhere the
// nearest point is found by trying many.
TEST(Errors, DistanceToAPatch) {
  constexpr double c = 0.4;
  std::vector<BezierPatch> patches(1);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      patches[0].p[4 * i + j] = {4 * i / 3.0 - 2, 4 * j / 3.0 - 2, i == 1 || i == 2 ? c : 0.0};
  Cards card{kCard};
  Scene scene = makeScene("vault", tessellate(patches, 1), UpAxis::Y, 1);
  scene.patches.push_back({0, patches, 1});
  card.pictures = PictureCache{std::move(scene)};
  const Errors e = card.errors();
  ASSERT_TRUE(e.patches);
  EXPECT_EQ(e.patches->samples, 1600);
  double sum = 0, largest = 0;
  for (int i = 0; i < 40; ++i) {
    const double x = (i + 0.5) / 10 - 2;
    double nearest = 1;
    for (int k = 0; k <= 40'000; ++k) {
      const double u = k / 40'000.0;
      nearest = std::min(nearest, std::hypot(4 * u - 2 - x, 3 * c * u * (1 - u)));
    }
    sum += nearest, largest = std::max(largest, nearest);
  }
  EXPECT_NEAR(e.patches->mean, sum / 40, 1e-7);
  EXPECT_NEAR(e.patches->largest, largest, 1e-7);
  EXPECT_NEAR(e.patches->largest, 0.75 * c, 0.001);
  EXPECT_NEAR(e.patches->meanPixels, 10 * e.patches->mean, 1e-9);
  EXPECT_NEAR(e.patches->largestPixels, 10 * e.patches->largest, 1e-9);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
