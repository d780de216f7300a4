#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "depthsort/oracle.h"
#include "geometry/model/solids.h"
#include "shading/picture/cell_use.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"
#include "tests/support/seeds.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- The rule of a cell

/// A cube that reflects the ambient light as it is: all of it has the intensity Ia.
Scene evenCube(bool textured) {
  Mesh mesh = cube();
  mesh.materials = {{.name = "", .ka = 1, .kd = 0, .ks = 0}};
  std::ranges::fill(mesh.material, 0);
  if (textured) {
    mesh.materials[0].texture = 0;
    mesh.uv = {{0.5, 0.5}};
    mesh.uvOfCorner.assign(mesh.corners.size(), 0);
  }
  Scene scene = makeScene("even", mesh, UpAxis::Z);
  if (textured) {
    Texture white{.width = 1, .height = 1, .channel = {}, .gray = {255}};
    white.channel.fill({255});
    scene.textures = {white};
  }
  return scene;
}

/// The rule, said once more: the nearest of the intensities that the shades stand for, half way the brighter.
int cellByTheRule(const ColorTable& table, double I) {
  if (table.settings().kind != TableKind::Corrected)
    return static_cast<int>(table.first() + 0.5 + (table.shades() - 1) * I);
  const long double x = I;
  int shade = 0;
  for (; shade + 1 < table.shades(); ++shade) {
    const long double below = table.level(shade), above = table.level(shade + 1);
    if (table.settings().pick == Pick::Log ? x * x < below * above : x - below < above - x) break;
  }
  return table.first() + shade;
}

/// Intensities close to where one cell ends and the next begins: by 2^-14 of a cell where single precision
/// rounds the value, and for `corrected` as close as single precision and the steps of a value allow.
std::vector<double> closeToEnds(const ColorTable& table) {
  std::vector<double> I{0.0, 1.0};
  for (int j = 0; j + 1 < table.shades(); ++j) {
    const double end = table.picked(j).to;
    const double apart = table.settings().kind != TableKind::Corrected ? 0x1p-14 / (table.shades() - 1)
                                                                       : 0x1p-22 * end + 0x1p-31;
    I.insert(I.end(), {end - apart, end + apart});
  }
  return I;
}

// Every filler gives the same cell to the same intensity: flat shading, whose cells XFillPolygon takes too,
// Gouraud shading over triangles and by rows, Phong shading, textures and environment maps.
TEST(CellRule, IsOneForEveryFiller) {
  struct Filler {
    const char* name;
    Shading shading;
    Polygons polygons;
    bool textured;
  };
  for (const Filler& filler : {Filler{"flat", Shading::Flat, {}, false},
                               {"Gouraud", Shading::Gouraud, Polygons::Triangles, false},
                               {"Gouraud by rows", Shading::Gouraud, Polygons::Rows, false},
                               {"Phong", Shading::Phong, {}, false},
                               {"environment", Shading::Environment, {}, false},
                               {"flat, textured", Shading::Flat, {}, true},
                               {"Gouraud, textured", Shading::Gouraud, {}, true},
                               {"Phong, textured", Shading::Phong, {}, true}})
    for (const TableSettings& of : {TableSettings{.kind = TableKind::Brief},
                                    {.kind = TableKind::Linear},
                                    {.kind = TableKind::Corrected},
                                    {.kind = TableKind::Corrected, .I0 = 1e-6}})
      for (const int shades : {2, 61, 240}) {
        if (kSanitized && shades != 61) continue;
        SCOPED_TRACE(std::string{filler.name} + ' ' +
                     std::string{kTables[static_cast<std::size_t>(of.kind)].name} + ' ' +
                     std::to_string(shades) + ' ' + std::to_string(of.I0));
        PictureCache pictures{evenCube(filler.textured)};
        PictureSettings s;
        s.width = 32, s.height = 24;
        s.shading = filler.shading, s.polygons = filler.polygons;
        s.order = Order::ZMean;
        s.table = of;
        s.table.shades = shades;
        const ColorTable table{s.table};
        int samples = 0;
        for (const double I : closeToEnds(table)) {
          s.light.Ia = I, s.light.Ip = 0;
          const Picture picture = pictures.make(s, 0);
          for (const std::uint8_t cell : picture.image().pixels) {
            if (cell == 0) continue;
            ASSERT_EQ(cell, cellByTheRule(table, I)) << I;
            ++samples;
          }
          for (const std::uint8_t cell : picture.cells()) ASSERT_EQ(cell, cellByTheRule(table, I)) << I;
        }
        EXPECT_GT(samples, 100 * shades);
      }
}

/// ---- The use of cells

Picture made(const char* scene, ColorPlan plan) {
  Scene read = readScene(scene, 4);
  PictureSettings s;
  s.width = 200, s.height = 150;
  s.shading = Shading::Gouraud;
  s.colors = plan;
  s.camera = completed({}, read.camera);
  return makePicture(std::move(read), s, CellPlan{}[Cell::Well]);
}

// The counts of samples and polygons are those of a count over all pixels, cell by cell, and the samples add
// up to the picture. This holds also if the depth sort has split faces and if a plan has several hues or
// colours.
TEST(CellUse, EqualsBruteForce) {
  int cells = 0, shared = 0;
  for (const auto& [scene, plan] : {std::pair{"teapot", ColorPlan::Needed},
                                    {"tori", ColorPlan::Needed},
                                    {"hues", ColorPlan::Needed},
                                    {"hues", ColorPlan::Cube},
                                    {"hues", ColorPlan::Chosen}}) {
    SCOPED_TRACE(scene);
    const Picture picture = made(scene, plan);
    const IndexImage& image = picture.image();
    const std::vector<std::uint32_t> faces = picture.faceImage();
    const CellUse use = cellUse(image, faces);
    for (int cell = 0; cell < 256; ++cell) {
      int samples = 0;
      std::set<std::uint32_t> shown;
      for (std::size_t k = 0; k < faces.size(); ++k) {
        samples += image.pixels[k] == cell;
        if (image.pixels[k] == cell && faces[k] != 0) shown.insert(faces[k]);
      }
      ASSERT_EQ(use.samples[cell], samples) << cell;
      ASSERT_EQ(use.polygons[cell], static_cast<int>(shown.size())) << cell;
      cells += samples > 0;
      shared += shown.size() > 1;
    }
    EXPECT_EQ(std::accumulate(use.samples.begin(), use.samples.end(), 0), 200 * 150);
    EXPECT_EQ(cellUse(image).samples, use.samples);
  }
  EXPECT_GT(cells, 500);
  EXPECT_GT(shared, 200);
}

// Samples that show a face have the scene's cells, and the others have the ground. Ramps divide the scene's
// cells.
TEST(CellUse, SceneCellsAreThoseOfItsSurfaces) {
  for (const ColorPlan plan : {ColorPlan::OneHue, ColorPlan::Hues, ColorPlan::Cube, ColorPlan::Chosen}) {
    const Picture picture = made("hues", plan);
    const IndexImage& image = picture.image();
    const CellRange scene = sceneCells(picture);
    const std::vector<std::uint32_t> faces = picture.faceImage();
    for (std::size_t k = 0; k < faces.size(); ++k) ASSERT_EQ(scene.has(image.pixels[k]), faces[k] != 0) << k;
    const std::vector<CellRange> ramps = rampsOf(picture);
    const bool colors = plan == ColorPlan::Cube || plan == ColorPlan::Chosen;
    EXPECT_EQ(ramps.size(), colors ? 0u : plan == ColorPlan::Hues ? 7u : 1u);
    int next = scene.first;
    for (const CellRange& ramp : ramps) EXPECT_EQ(std::exchange(next, ramp.last() + 1), ramp.first);
    if (!colors) {
      EXPECT_EQ(next, scene.last() + 1);
    }
    EXPECT_GT(usedCells(cellUse(image), scene), 20);
  }
}

// At most half of the samples lie below the middle cell and at most half above it, and polygons show that
// cell.
TEST(CellUse, MedianHasHalfOnEitherSide) {
  std::mt19937 rng{4};
  for (int trial = 0; trial < 200; ++trial) {
    CellUse use;
    const CellRange cells{11, 1 + static_cast<int>(rng() % 240)};
    int all = 0;
    for (int cell = 0; cell < 256; ++cell) {
      use.polygons[cell] = rng() % 3 ? 0 : static_cast<int>(rng() % 100);
      if (cells.has(cell)) all += use.polygons[cell];
    }
    const int median = medianCell(use, cells);
    const auto from = use.polygons.begin() + cells.first, at = use.polygons.begin() + median;
    const int below = std::accumulate(from, at, 0);
    EXPECT_LE(2 * below, all);
    EXPECT_LE(2 * (all - below - *at), all);
    EXPECT_TRUE(all == 0 ? median == cells.first : *at > 0);
  }
}

/// ---- The cells of a picture

// Which cells the samples of a picture take, and how many samples are clamped.

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

// Hues share the table's shades where nothing is lit, too; more hues than there are pairs of shades are
// refused.
TEST(Picture, HuesWithoutLightAndTooManyOfThem) {
  PictureCache hues{readScene("hues")};
  PictureSettings s = small();
  s.colors = ColorPlan::Hues;
  for (const Shading shading : {Shading::Full, Shading::Depth, Shading::Flat}) {
    s.shading = shading;
    const IndexImage image = painted(hues, s);
    if (shading == Shading::Full) {
      EXPECT_TRUE(hues.last().shading().intensities(0).I.empty());
    }
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

/// ---- One hue

/// A red and a cyan light on coloured surfaces: a ball, a card with a texture of four colours, and patches.
constexpr std::string_view kColored = R"({
  "up": "z", "camera": {"eye": [1, -9, 6], "look_at": [0, 0, 0.4], "fov": 34},
  "ambient": [0.1, 0.2, 0.05],
  "lights": [{"color": [0.6, 0, 0.1], "towards": [-1, -1, 1]},
             {"kind": "point", "color": [0, 0.75, 0.6], "at": [3, -3, 4]}],
  "materials": {"green": {"color": [0.1, 1, 0.3], "specular": [1, 0.8, 0.5], "kd": 1, "ks": 1, "n": 1},
                "checks": {"texture": "CHECKS"}},
  "objects": [
    {"solid": "sphere", "move": [-1.6, 0.2, 0.5], "material": "green"},
    {"solid": "cube", "move": [0, -1.8, 0.3], "scale": 0.7, "material": "checks"},
    {"file": "teapot.bpt", "divisions": 3, "scale": 0.5, "move": [1.5, 1, 0], "color": [0.9, 0.3, 0.6]}
  ]})";

Scene colored() {
  std::string text{kColored};
  text.replace(text.find("CHECKS"), 6, "textures/checks.png");
  Scene scene = parseSceneFile(text, "colored", XNEWELL_DATA_DIR);
  // The built-in texture is gray. This one has colours.
  Texture& texture = scene.textures.front();
  for (std::size_t k = 0; k < texture.gray.size(); ++k)
    for (int c = 0; c < 3; ++c)
      texture.channel[c][k] = static_cast<std::uint8_t>(texture.gray[k] / (1 + (k / 8 + c) % 3));
  texture.colored = true;
  return scene;
}

PictureSettings settingsOf(const Scene& scene, Shading shading) {
  PictureSettings s;
  s.width = 120, s.height = 90;
  s.shading = shading;
  s.light.kd = 1;
  // Rotated maps have axes for each channel in colours, and the same axes for a luminance. On a coarse mesh
  // the error of a look-up depends on the axes.
  s.environment = EnvironmentForm::Published;
  s.camera = completed({}, scene.camera);
  return s;
}

// A picture of one hue shows the luminance of what a picture in colours has, at every sample and with every
// method. It is the luminance of the sum, not the product of the luminances of light and surface.
TEST(OneHue, IsTheLuminanceOfTheColors) {
  PictureCache pictures{colored()};
  for (const ShadingRow& method : kShadings) {
    if (!method.lit) continue;
    SCOPED_TRACE(method.name);
    PictureSettings s = settingsOf(pictures.scene(), method.id);
    s.colors = ColorPlan::Chosen;
    const Picture full = pictures.make(s, 8);
    const SeenRows seen = full.seen(0, s.height);
    const std::vector<double> r = full.intensities(seen, 0), g = full.intensities(seen, 1),
                              b = full.intensities(seen, 2);
    s.colors = ColorPlan::OneHue;
    const Picture one = pictures.make(s, 8);
    const std::vector<double> I = one.intensities(seen);
    const Ramp ramp = one.colors().ramps().front();
    int samples = 0, clamped = 0, otherCells = 0;
    for (std::size_t k = 0; k < I.size(); ++k) {
      if (seen.faces[k] == kNothing) continue;
      ++samples;
      ASSERT_NEAR(I[k], 0.30 * r[k] + 0.59 * g[k] + 0.11 * b[k],
                  method.id == Shading::Environment ? 1e-6 : 1e-12);
      clamped += std::max({r[k], g[k], b[k]}) >= 1.0;
      const int apart = one.image().pixels[k] - ramp.cell(I[k]);
      ASSERT_LE(std::abs(apart), 1);
      otherCells += apart != 0;  // where the filler's precision decides
    }
    EXPECT_GT(samples, 1500);
    EXPECT_GT(clamped, 0);
    EXPECT_LT(otherCells, samples / 100);
    EXPECT_GT(full.saturated(), 0);
    EXPECT_EQ(one.saturated() > 0,
              method.id != Shading::Environment);  // its map holds what is clamped already
  }
}

}  // namespace

}  // namespace xnewell::THIS_FILE
