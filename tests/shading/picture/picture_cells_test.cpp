#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>
#include <set>

#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/painted_picture.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

// Which cells the samples of a picture take, and how many samples are clamped.

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
    s.order = kOrders[rng() % kOrders.size()].id;
    s.table = {.kind = kTables[rng() % kTables.size()].id,
               .shades = rng() % 2 ? 2 : 240,
               .I0 = rng() % 2 ? 1e-6 : 0.5};
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

}  // namespace xnewell::THIS_FILE
