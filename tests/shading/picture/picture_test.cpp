#include "shading/picture/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>
#include <set>

#include "geometry/exact/int128.h"
#include "geometry/model/solids.h"
#include "shading/fill/scanline.h"
#include "shading/picture/exactness.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/painted_picture.h"

namespace xnewell {

namespace {

PictureSettings small() {
  PictureSettings s;
  s.width = 240;
  s.height = 180;
  return s;
}

/// How many faces cover each sample, each edge asked by itself: the sign of its function at the pixel's
/// centre, if 0 of its x coefficient, if 0 of its y coefficient.
std::vector<int> timesCovered(const SnappedScene& scene, int width, int height) {
  std::vector<int> times(std::size_t(width) * height, 0);
  for (const SnappedFace& f : scene.faces) {
    const glm::ivec3* p = &scene.vertices[f.first];
    int x0 = p[0].x, x1 = x0, y0 = p[0].y, y1 = y0;
    for (int v = 1; v < f.count; ++v) {
      x0 = std::min(x0, p[v].x), x1 = std::max(x1, p[v].x);
      y0 = std::min(y0, p[v].y), y1 = std::max(y1, p[v].y);
    }
    for (int j = std::max(0, y0 / kGrid - 1); j < std::min(height, y1 / kGrid + 2); ++j)
      for (int i = std::max(0, x0 / kGrid - 1); i < std::min(width, x1 / kGrid + 2); ++i) {
        bool inside = true;
        for (int v = 0; v < f.count && inside; ++v) {
          const glm::ivec3 &a = p[v], &b = p[(v + 1) % f.count];
          const Int128 A = std::int64_t{b.y} - a.y, B = std::int64_t{a.x} - b.x;
          const Int128 value = A * (std::int64_t{i} * kGrid + kGrid / 2 - a.x) +
                               B * (std::int64_t{j} * kGrid + kGrid / 2 - a.y);
          inside = value > 0 || (value == 0 && (A > 0 || (A == 0 && B > 0)));
        }
        times[std::size_t(j) * width + i] += inside;
      }
  }
  return times;
}

bool sameBits(const std::vector<FrontBack<double>>& a, const std::vector<FrontBack<double>>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

}  // namespace

// Every sample is painted exactly as often as faces cover it: the teapot from several sides and through
// the eye, and random triangles that cross the picture's borders.
TEST(Picture, PaintsEachSampleAsOftenAsFacesCoverIt) {
  long long samples = 0;
  const auto check = [&](PictureCache& pictures, const PictureSettings& s) {
    pictures.make(s);
    const std::vector<int> covered = timesCovered(pictures.last().snapped(), s.width, s.height);
    ASSERT_EQ(timesPainted(pictures.last().snapped(), s.width, s.height), covered);
    samples += std::ranges::count_if(covered, [](int n) { return n > 0; });
  };
  PictureCache teapot{readScene("teapot", 4)};
  for (int view = 0; view < 8; ++view) {
    SCOPED_TRACE(view);
    PictureSettings s = small();
    s.camera.parallel = view % 2 == 0;
    if (view == 3) s.camera.oblique = Oblique{};
    teapot.make(s);
    s.camera = moved(s.camera, teapot.last().camera(), 50.0 * view, 20.0 * view - 70, view == 7 ? 6.0 : 1.0);
    check(teapot, s);
  }
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    PictureCache soup{makeScene("soup", triangleSoup(300, 0.5, seed), UpAxis::Y)};
    PictureSettings s = small();
    s.camera.eye = glm::dvec3{0.1, 0.2, 0.3 + 0.1 * seed};
    s.camera.lookAt = glm::dvec3{0, 0, -1};
    check(soup, s);
  }
  EXPECT_GT(samples, 200'000);
}

// A closed surface has neither gap nor overlap: with its back faces kept, a sphere paints each sample
// twice or not at all, a torus an even number of times.
TEST(Picture, ClosedSurfacesPaintInPairs) {
  int twice = 0, four = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    PictureCache pictures{makeScene("solid", seed % 2 ? sphere(23, 11) : torus(29, 13), UpAxis::Z)};
    PictureSettings s = small();
    s.camera.parallel = seed % 3 == 0;
    pictures.make(s);
    s.camera = moved(s.camera, pictures.last().camera(), 17.0 * seed, 7.0 * seed - 100, 1.3);
    pictures.make(s);
    for (const int n : timesPainted(pictures.last().snapped(), s.width, s.height)) {
      ASSERT_EQ(n % 2, 0);
      if (seed % 2) {
        ASSERT_LE(n, 2);
      }
      twice += n == 2;
      four += n == 4;
    }
  }
  EXPECT_GT(twice, 100'000);
  EXPECT_GT(four, 10'000);
}

// What is stored with a face or a vertex does not change by a bit with projection, shear, window, size or
// zoom; when the eye moves, only the specular term does.
class StoredShading : public ::testing::TestWithParam<Shading> {};
TEST_P(StoredShading, KnowsNoCamera) {
  PictureCache pictures{readScene("teapot", 4)};
  PictureSettings s = small();
  s.shading = GetParam();
  s.camera.eye = glm::dvec3{0.3, -2, 0.8};
  s.camera.lookAt = glm::dvec3{0, 0, 0.2};
  pictures.make(s);
  const SceneShading stored = pictures.last().shading();
  ASSERT_GT(stored.intensities(0).I.size(), 200u);
  const auto expectSame = [&](const PictureSettings& changed, bool specularToo) {
    PictureCache fresh{readScene("teapot", 4)};
    fresh.make(changed);
    pictures.make(changed);
    const SceneShading &kept = pictures.last().shading(), &made = fresh.last().shading();
    EXPECT_TRUE(sameBits(kept.diffuse(0), made.diffuse(0)) && sameBits(kept.specular(0), made.specular(0)));
    EXPECT_TRUE(sameBits(kept.intensities(0).I, made.intensities(0).I));
    EXPECT_TRUE(sameBits(stored.diffuse(0), made.diffuse(0)));
    EXPECT_EQ(sameBits(stored.specular(0), made.specular(0)), specularToo);
    EXPECT_EQ(sameBits(stored.intensities(0).I, made.intensities(0).I), specularToo);
    // What stays is not even copied.
    EXPECT_EQ(&stored.diffuse(0), &kept.diffuse(0));
    EXPECT_EQ(&stored.specular(0) == &kept.specular(0), specularToo);
  };
  const auto with = [&](auto&& change) {
    PictureSettings c = s;
    change(c);
    return c;
  };
  expectSame(with([](auto& c) { c.camera.parallel = true; }), true);
  expectSame(with([](auto& c) { c.camera.oblique = Oblique{0.5, 30}; }), true);
  expectSame(with([](auto& c) { c.camera.window = glm::dvec4{-0.3, 0.1, -0.2, 0.5}; }), true);
  expectSame(with([](auto& c) { c.camera.fov = 77; }), true);
  expectSame(with([](auto& c) { c.camera.up = glm::dvec3{0.5, 0, 1}; }), true);
  expectSame(with([](auto& c) { c.width = 77, c.height = 400; }), true);
  expectSame(with([](auto& c) { c.cull = Cull::Back; }), true);
  expectSame(with([](auto& c) { c.camera.eye = glm::dvec3{0.4, -2, 0.8}; }), false);
}
INSTANTIATE_TEST_SUITE_P(Methods, StoredShading, ::testing::Values(Shading::Flat, Shading::Gouraud));

// Keeping results is invisible: after any change of settings the picture is the one made afresh.
TEST(Picture, KeptStagesPaintWhatFreshOnesPaint) {
  std::mt19937 rng{1975};
  PictureCache kept{readScene("teapot", 3)};
  PictureSettings s = small();
  int distinct = 0;
  IndexImage last;
  for (int trial = 0; trial < 120; ++trial) {
    SCOPED_TRACE(trial);
    switch (rng() % 13) {
      case 0:
        s.table.kind = kTables[rng() % 3].id;
        break;
      case 1:
        s.table.shades = 2 + static_cast<int>(rng() % 239);
        break;
      case 2:
        s.light.ks = static_cast<double>(rng() % 100) / 100;
        break;
      case 3:
        s.order = kOrders[rng() % 4].id;
        break;
      case 4:
        s.cull = rng() % 2 ? Cull::Back : Cull::Keep;
        break;
      case 5:
        s.width = 100 + static_cast<int>(rng() % 100);
        break;
      case 6:
        s.camera = moved(s.camera, kept.last().camera(), 20, 3, 1.05);
        break;
      case 7:
        s.light.constantV = !s.light.constantV;
        break;
      case 8:
        s.normals = kNormalRules[rng() % 5].id;
        break;
      case 9:
        s.light.form = kForms[rng() % 3].id;
        break;
      case 10:
        s.environment = kEnvironmentForms[rng() % 2].id;
        break;
      case 11:
        s.table.hue = rng() % 2 ? glm::dvec3{1, 0.5, 0} : glm::dvec3{0, 1, 1};
        s.table.bits = rng() % 2 ? 8 : 16;
        break;
      default:
        s.shading = kShadings[rng() % 6].id;
    }
    const IndexImage image = painted(kept, s);
    PictureCache fresh{readScene("teapot", 3)};
    ASSERT_EQ(image, painted(fresh, s));
    distinct += !(image == last);
    last = image;
  }
  EXPECT_GT(distinct, 30);
}

// A new table paints again from the stored intensities: nothing is shaded, projected or sorted.
TEST(Picture, ANewTableOnlyPaintsAgain) {
  PictureCache pictures{readScene("teapot")};
  PictureSettings s = small();
  pictures.make(s);
  EXPECT_GT(pictures.last().times().transform, 0);
  EXPECT_GT(pictures.last().times().sort, 0);
  s.table.kind = TableKind::Corrected;
  s.table.I0 = 0.1;
  s.table.shades = 12;
  pictures.make(s);
  EXPECT_EQ(pictures.last().times().transform, 0);
  EXPECT_EQ(pictures.last().times().sort, 0);
}

// Other colours in the cells hand the image on, in every plan; another ground paints it again.
TEST(Picture, NewColorsKeepTheImage) {
  for (const ColorPlan plan : {ColorPlan::OneHue, ColorPlan::Hues, ColorPlan::Chosen}) {
    PictureCache pictures{readScene("hues")};
    PictureSettings s = small();
    s.colors = plan;
    const Picture first = pictures.make(s, 8);
    s.table.hue = {0, 1, 0};
    s.table.bits = 8;
    const Picture second = pictures.make(s, 8);
    EXPECT_EQ(&second.image(), &first.image());
    EXPECT_EQ(second.image(), makePicture(readScene("hues"), s, 8).image());
    EXPECT_EQ(second.palette(CellPlan{}), makePicture(readScene("hues"), s, 8).palette(CellPlan{}));
    const Picture third = pictures.make(s, 9);
    EXPECT_NE(third.image(), first.image());
    EXPECT_EQ(third.times().sort, 0);
  }
}

// A picture stays what it is, whatever is made after it: by its own cache, by one that began with it, by one
// that failed. A cache that failed goes on from its last picture.
TEST(Picture, NeverChanges) {
  PictureCache pictures{readScene("teapot", 3)};
  PictureSettings s = small();
  s.shading = Shading::Gouraud;
  s.order = Order::ZSort;
  const Picture picture = pictures.make(s, 8);
  const IndexImage image = picture.image();
  const std::vector<std::uint32_t> faces = picture.faceImage();
  const std::vector<double> I = picture.intensities(picture.seen(90, 91));
  const auto expectSame = [&] {
    EXPECT_EQ(picture.settings(), s);
    EXPECT_EQ(picture.image(), image);
    EXPECT_EQ(picture.paint(8).image, image);
    EXPECT_EQ(picture.faceImage(), faces);
    const std::vector<double> now = picture.intensities(picture.seen(90, 91));
    EXPECT_EQ(std::memcmp(now.data(), I.data(), I.size() * sizeof I[0]), 0);
    EXPECT_TRUE(picture.snapped().planes.empty());
  };
  EXPECT_FALSE(picture.withPlanes().snapped().planes.empty());
  expectSame();
  PictureCache second{picture};
  PictureSettings other = s;
  other.shading = Shading::Phong;
  other.order = Order::Newell;
  const Picture exact = second.make(other, 8);
  EXPECT_EQ(exact.times().transform, 0);  // lent
  EXPECT_EQ(&exact.scene(), &picture.scene());
  EXPECT_NE(exact.image(), image);
  expectSame();
  other.camera = moved(s.camera, picture.camera(), 30, 10, 1.1);
  other.width = 100;
  (void)pictures.make(other, 8);
  expectSame();
  const IndexImage last = pictures.last().image();
  PictureSettings wrong = other;
  wrong.camera.eye = wrong.camera.lookAt = glm::dvec3{1, 1, 1};
  EXPECT_THROW((void)pictures.make(wrong, 8), ViewError);
  EXPECT_EQ(pictures.last().image(), last);
  EXPECT_EQ(pictures.make(other, 8).image(), last);
  expectSame();
}

// The face image names the face that is seen: number + 1, 0 where nothing is; pieces of a divided face
// carry its number.
TEST(Picture, FaceImageNamesFaces) {
  Mesh m;
  m.points = {{-1, -1, 0},    {1, -1, 0}, {1, 1, 0},     {-1, 1, 0},    {-0.5, -0.5, 1},
              {0.5, -0.5, 1}, {0, 0, 1},  {0.5, 0.5, 1}, {-0.5, 0.5, 1}};
  const int floor[] = {0, 1, 2, 3}, concave[] = {4, 5, 6, 7, 8};
  m.addFace(floor, 0);
  m.addFace(concave, 0);
  PictureCache pictures{makeScene("two", m, UpAxis::Y)};
  EXPECT_GT(pictures.scene().parts.count(), 2);
  PictureSettings s = small();
  s.camera.parallel = true;
  s.camera.eye = glm::dvec3{0, 0, 3};
  s.camera.lookAt = glm::dvec3{0};
  s.camera.height = 1.2;  // scene units: coordinates were halved
  pictures.make(s);
  const std::vector<std::uint32_t> ids = pictures.last().faceImage();
  const auto at = [&](double x, double y) {  // of the file's coordinates
    return ids[std::size_t(90 - y / 2 / 1.2 * 180) * 240 + std::size_t(120 + x / 2 / 1.2 * 180)];
  };
  EXPECT_EQ(at(-0.25, 0), 2u);
  EXPECT_EQ(at(0.3, 0), 1u);  // seen through the notch
  EXPECT_EQ(at(0.1, 0.3), 2u);
  EXPECT_EQ(at(0.8, 0.8), 1u);
  EXPECT_EQ(at(1.1, 0), 0u);
}

// Clamped evaluations are counted: none with room to spare, some when kd and ks add up to more than 1.
TEST(Picture, CountsClampedEvaluations) {
  PictureCache pictures{readScene("teapot")};
  PictureSettings s = small();
  s.light.ks = 0;
  pictures.make(s);
  EXPECT_EQ(pictures.last().saturated(), 0);
  s.light = {.Ia = 0, .Ip = 1, .kd = 1, .ks = 1, .n = 3};
  pictures.make(s);
  EXPECT_GT(pictures.last().saturated(), 100);
}

// Environment mapping counts its clamped samples where a triangle may meet the places of the map that were
// clamped: as many as there are. The samples are those of the upper of two shades for intensities just below
// 1 and 1; each is painted once, for the ball is convex and the oracle paints what is visible.
TEST(Picture, EnvironmentCountsEveryClampedSample) {
  std::vector<std::pair<PictureCache, Order>> balls;
  balls.emplace_back(PictureCache{makeScene("ball", sphere(80, 40), UpAxis::Z)},
                     Order::ZSort);  // small faces
  balls.emplace_back(PictureCache{makeScene("ball", sphere(6, 4), UpAxis::Z)}, Order::ZSort);
  balls.emplace_back(PictureCache{readScene("teapot", 4)}, Order::Oracle);
  Scene beside = makeScene("ball", sphere(30, 20), UpAxis::Z);
  beside.light.lights = {{.Ip = glm::dvec3{0.85}},  // turned to the axis; the others lie beside and behind
                         {.Ip = glm::dvec3{0.8}, .direction = {-1, -0.3, 0.5}},
                         {.Ip = glm::dvec3{0.8}, .direction = {0.2, 1, -0.6}}};
  balls.emplace_back(PictureCache{std::move(beside)}, Order::ZSort);
  int some = 0, none = 0;
  for (auto& [pictures, order] : balls)
    for (const EnvironmentRow& form : kEnvironmentForms)
      for (const glm::dvec3 towards : {glm::dvec3{1, -1, 1}, {-1, -0.3, 0.2}, {0.3, 1, -1}, {0, -1, 0}})
        for (const int n : {1, 5, 100}) {
          PictureSettings s = small();
          s.shading = Shading::Environment;
          s.environment = form.id;
          s.order = order;
          s.cull = Cull::Back;
          s.light = {.Ia = 0.1, .Ip = 1, .kd = 0.3, .ks = 0.9, .n = n, .light = towards};
          s.table = {.shades = 2, .low = 1 - 0x1p-30};
          const IndexImage image = painted(pictures, s);
          const auto full = std::ranges::count(image.pixels, pictures.last().table().cell(1.0));
          ASSERT_EQ(pictures.last().saturated(), full) << form.name << ", n " << n;
          ++(full > 0 ? some : none);
        }
  EXPECT_GT(some, 30);
  EXPECT_GT(none, 5);
}

// The painter is right where no order can be wrong: a convex solid without its back faces, in every
// order. The oracle is right everywhere, and knows where sorting the teapot by z is not.
TEST(Picture, OracleKnowsWhereTheOrderIsWrong) {
  PictureCache ball{makeScene("ball", sphere(20, 10), UpAxis::Z)};
  PictureCache teapot{readScene("teapot", 4)};
  for (const OrderRow& row : kOrders) {
    SCOPED_TRACE(row.name);
    PictureSettings s = small();
    s.order = row.id;
    teapot.make(s);
    const Exactness e = exactnessOf(teapot.last());
    EXPECT_GT(e.samples, 10'000);
    EXPECT_EQ(e.wrong == 0, row.id == Order::Oracle || row.id == Order::Newell);
    s.cull = Cull::Back;
    ball.make(s);
    EXPECT_EQ(exactnessOf(ball.last()).wrong, 0);
  }
}

// Posters in the plane of a slanted wall are in one plane, so that their order is the scene's. Had each a
// plane of its own, the snap would part them, but a picture that shows them in the scene's order is called
// right. Without the rounding's allowance it is not.
TEST(Picture, CoplanarFacesAreNotCalledWrong) {
  Scene scene = readScene("decals");
  EXPECT_EQ(std::ranges::max(scene.parts.plane), 0);
  std::iota(scene.parts.plane.begin(), scene.parts.plane.end(), 0);
  PictureCache decals{std::move(scene)};
  PictureSettings s = small();
  s.order = Order::Unsorted;
  int doubtful = 0;
  for (int view = 0; view < 12; ++view) {
    SCOPED_TRACE(view);
    decals.make(s);
    EXPECT_EQ(exactnessOf(decals.last()).wrong, 0);
    const std::vector<std::uint32_t> listed = decals.last().faceImage();
    s.order = Order::Oracle;
    decals.make(s);
    const std::vector<std::uint32_t> seen = decals.last().faceImage();
    for (std::size_t k = 0; k < seen.size(); ++k) doubtful += seen[k] != listed[k];
    s.order = Order::Unsorted;
    s.camera = moved(s.camera, decals.last().camera(), 29, view % 2 ? 11 : -9, 1.02);
  }
  EXPECT_GT(doubtful, 1000);
}

// At full intensity nothing is shaded, and a light changed meanwhile is not forgotten.
TEST(Picture, FullIntensityShadesNothing) {
  PictureCache pictures{readScene("teapot", 3)};
  PictureSettings s = small();
  painted(pictures, s);
  s.shading = Shading::Full;
  s.light.kd = 0.2;
  painted(pictures, s);
  s.shading = Shading::Flat;
  PictureCache fresh{readScene("teapot", 3)};
  EXPECT_EQ(painted(pictures, s), painted(fresh, s));
  PictureCache full{readScene("teapot", 3)};
  s.shading = Shading::Full;
  painted(full, s);
  EXPECT_TRUE(full.last().shading().intensities(0).I.empty());
}

// No lights, materials, normals or methods make a cell that is not on the ramp: no NaN, no infinity, nothing
// beyond the ends.
TEST(Picture, EveryCellIsOnTheRamp) {
  std::mt19937 rng{1975};
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(rng()) * 0x1p-32);
  };
  const auto wild = [&] { return uniform(-1, 1) * std::pow(10.0, uniform(-12, 12)); };
  std::int64_t shown = 0;
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    Mesh mesh = trial % 2 ? sphere(8, 5) : torus(7, 5);
    mesh.points[3] = mesh.points[4];  // a face without area
    mesh.materials = {{}, {}};
    for (MeshMaterial& m : mesh.materials) {
      m.ka = uniform(0, 1), m.kd = uniform(0, 1), m.ks = uniform(0, 1);
      m.n = static_cast<int>(std::pow(10.0, uniform(0, 6)) - 1);
    }
    for (int& m : mesh.material) m = static_cast<int>(rng() % 3) - 1;
    Scene scene = makeScene("random", std::move(mesh), UpAxis::Z);
    for (int k = 0; k < trial % 4; ++k) {
      Light light{.kind = kLights[rng() % 3].id, .Ip = glm::dvec3{uniform(0, 1)}};
      light.direction = {wild(), wild(), wild()};
      light.position = {wild(), wild(), wild()};
      light.attenuation = kAttenuations[rng() % 5].id;
      light.range = std::abs(wild()) + 1e-12;
      light.c = {std::abs(wild()), std::abs(wild()), std::abs(wild())};
      light.outer = uniform(0, 180), light.inner = uniform(0, light.outer);
      light.falloff = static_cast<int>(rng() % 100);
      if (k == 0) light.position = scene.mesh.points[5];  // exactly at the surface
      scene.light.lights.push_back(light);
    }
    PictureCache pictures{std::move(scene)};
    PictureSettings s = small();
    s.shading = kShadings[rng() % kShadings.size()].id;
    s.normals = kNormalRules[rng() % 5].id;
    s.light.form = kForms[rng() % 3].id;
    s.light.constantL = rng() % 2, s.light.constantV = rng() % 2, s.light.twoSided = rng() % 2;
    s.light.n = trial % 5 == 0 ? 0 : 1'000'000;
    s.environment = kEnvironmentForms[rng() % 2].id;
    s.polygons = kPolygons[rng() % 2].id;
    s.order = kOrders[rng() % 5].id;
    s.table = {.kind = kTables[rng() % 3].id, .shades = rng() % 2 ? 2 : 240, .I0 = rng() % 2 ? 1e-6 : 0.5};
    if (trial % 7 == 0) s.camera.eye = pictures.scene().mesh.points[9];  // in the surface
    const IndexImage image = painted(pictures, s);
    const int first = pictures.last().table().first(), end = first + pictures.last().table().shades();
    for (const std::uint8_t cell : image.pixels) {
      ASSERT_TRUE(cell == 8 || (cell >= first && cell < end)) << int{cell};
      shown += cell != 8;
    }
  }
  EXPECT_GT(shown, 1'000'000);
}

// Depth: the nearest face has the brightest shade, the farthest the darkest, and what lies half way between
// the middle one: the picture uses the whole range.
TEST(Picture, DepthUsesTheWholeRange) {
  Mesh m;
  for (const double z : {0.0, 1.0, 4.0}) {
    const int first = static_cast<int>(m.points.size());
    for (const double x : {-0.5, 0.5}) m.points.insert(m.points.end(), {{x + z, -0.5, z}, {x + z, 0.5, z}});
    const int corners[] = {first, first + 2, first + 3, first + 1};
    m.addFace(corners, 0);
  }
  PictureCache pictures{makeScene("steps", m, UpAxis::Y)};
  PictureSettings s = small();
  s.shading = Shading::Depth;
  s.camera.eye = glm::dvec3{0.25, 0, 8};
  s.camera.lookAt = glm::dvec3{0.25, 0, 0};
  s.table.shades = 5;
  painted(pictures, s);
  const int first = pictures.last().table().first();
  EXPECT_EQ(pictures.last().cells(), (std::vector<std::uint8_t>{std::uint8_t(first), std::uint8_t(first + 1),
                                                                std::uint8_t(first + 4)}));
}

// Hues share the table's shades where nothing is lit, too; more hues than there are pairs of shades are
// refused.
TEST(Picture, HuesWithoutLightAndTooManyOfThem) {
  PictureCache hues{readScene("hues")};
  PictureSettings s = small();
  s.colors = ColorPlan::Hues;
  for (const Shading shading : {Shading::Full, Shading::Depth, Shading::Flat}) {
    s.shading = shading;
    const IndexImage image = painted(hues, s);
    EXPECT_EQ(hues.last().colors().plan(), ColorPlan::Hues);
    EXPECT_GT(hues.last().colors().tables().size(), 5u);
    EXPECT_GE(std::set(image.pixels.begin(), image.pixels.end()).size(),
              hues.last().colors().tables().size());
  }
  Scene many = makeScene("many", sphere(24, 12), UpAxis::Z);
  for (int k = 0; k < 121; ++k) {
    many.mesh.materials.push_back({.name = "", .diffuse = {1.0, k / 121.0, 0.0}});
    many.mesh.material[k] = k;
  }
  std::ranges::replace(many.mesh.material, -1, 0);
  PictureCache pictures{std::move(many)};
  EXPECT_THROW(pictures.make(s), ViewError);
  s.colors = ColorPlan::Needed;
  EXPECT_NO_THROW(pictures.make(s));
  EXPECT_EQ(pictures.last().colors().plan(), ColorPlan::Chosen);
}

}  // namespace xnewell
