#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>

#include "geometry/files/text_file.h"
#include "geometry/model/vertex_normals.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"

namespace xnewell::THIS_FILE {

/// Each built-in scene of shading shows what it says, measured in its pictures.

namespace {

const std::filesystem::path kScenes = std::filesystem::path{XNEWELL_DATA_DIR} / "scenes";
constexpr int kWidth = 400, kHeight = 300;
constexpr int kGround = 255;  ///< belongs to no ramp

PictureSettings settingsOf(const Scene& scene, const std::function<void(PictureSettings&)>& change) {
  PictureSettings settings = scene.settings;
  settings.camera = scene.camera;
  settings.width = kWidth;
  settings.height = kHeight;
  if (change) change(settings);
  return settings;
}

/// A picture as the scene asks for it, but for what `change` does.
struct Drawn {
  Picture picture;
  IndexImage image;
  std::vector<std::uint32_t> faces;  ///< face number + 1 at each sample

  explicit Drawn(const Scene& scene, const std::function<void(PictureSettings&)>& change = {})
      : picture{makePicture(scene, settingsOf(scene, change), kGround)},
        image{picture.image()},
        faces{picture.faceImage()} {}
  explicit Drawn(const std::string& name, const std::function<void(PictureSettings&)>& change = {})
      : Drawn{readScene(name), change} {}

  [[nodiscard]] int samples() const { return static_cast<int>(faces.size() - std::ranges::count(faces, 0u)); }
  /// The cell of largest number among the samples of faces from..to-1: the brightest of a ramp.
  [[nodiscard]] int brightest(int from, int to) const {
    int most = -1;
    for (std::size_t k = 0; k < faces.size(); ++k)
      if (const int f = static_cast<int>(faces[k]) - 1; f >= from && f < to)
        most = std::max(most, int{image.pixels[k]});
    return most;
  }
  [[nodiscard]] int at(int i, int j) const { return image.pixels[std::size_t(j) * kWidth + i]; }
};

std::function<void(PictureSettings&)> by(Shading method) {
  return [method](PictureSettings& s) { s.shading = method; };
}

/// Samples whose cells are more than `apart` apart.
int differing(const Drawn& a, const Drawn& b, int apart = 0) {
  int count = 0;
  for (std::size_t k = 0; k < a.image.pixels.size(); ++k)
    count += std::abs(a.image.pixels[k] - b.image.pixels[k]) > apart;
  return count;
}

constexpr double kFull = kMaxShades - 1;  ///< of full intensity over none, in a linear table

}  // namespace

// Gouraud shading loses the whole highlight in the middle of one large square, and keeps it if the square is
// cut into 16 x 16.
TEST(BuiltInScenes, HighlightIsLost) {
  const Drawn gouraud{"highlight"}, phong{"highlight", by(Shading::Phong)};
  const double highlight = phong.picture.scene().light.lights[0].Ip.r * kFull;  // ks is 1
  EXPECT_GT(phong.brightest(0, 1) - gouraud.brightest(0, 1), 0.9 * highlight);
  EXPECT_LT(phong.brightest(1, 257) - gouraud.brightest(1, 257), 0.1 * highlight);
  EXPECT_EQ(gouraud.picture.saturated(), 0);
}

// The sum over all faces leans at some corners of the cube of 12 triangles, so that it is lit differently
// from the cube of 6 squares. With distinct normals both have the normals of a cube.
TEST(BuiltInScenes, CubesDifferByRule) {
  const auto corners = [](NormalRule rule) {
    const Drawn drawn{"cubes", [&](PictureSettings& s) { s.normals = rule; }};
    const std::vector<Vertex>& vertices = drawn.picture.shading().vertices().vertices;
    EXPECT_EQ(vertices.size(), 16u);
    int leaning = 0, litOtherwise = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      const glm::dvec3 N = vertices[8 + k].N;
      leaning += std::abs(std::abs(N.x) - 1 / std::sqrt(3.0)) > 0.1 ||
                 std::abs(std::abs(N.y) - 1 / std::sqrt(3.0)) > 0.1;
      EXPECT_NEAR(std::abs(vertices[k].N.x), 1 / std::sqrt(3.0), 1e-12);
      const auto& I = drawn.picture.shading().intensities(0).I;
      litOtherwise += std::abs(I[k].front - I[8 + k].front) > 0.05;
    }
    return std::pair{leaning, litOtherwise};
  };
  EXPECT_GE(corners(NormalRule::Sum).first, 4);
  EXPECT_GE(corners(NormalRule::Sum).second, 3);
  EXPECT_EQ(corners(NormalRule::Distinct), (std::pair{0, 0}));
  EXPECT_EQ(corners(NormalRule::Angle), (std::pair{0, 0}));
  EXPECT_EQ(Drawn{"cubes"}.picture.settings().normals, NormalRule::Sum);
}

// Gouraud shading gets the edge of the cone wrong. The finer the floor, the smaller the error.
TEST(BuiltInScenes, SpotlightIsRagged) {
  const auto wrong = [](const std::string& divisions) {
    std::string text = readTextFile(kScenes / "spotlight.json");
    const std::string coarse = R"("divisions": 8)";
    const std::size_t at = text.find(coarse);
    EXPECT_NE(at, std::string::npos);
    text.replace(at, coarse.size(), R"("divisions": )" + divisions);
    const Drawn gouraud{parseSceneFile(text, "spotlight", kScenes)},
        phong{parseSceneFile(text, "spotlight", kScenes), by(Shading::Phong)};
    return static_cast<double>(differing(gouraud, phong, 40)) / phong.samples();
  };
  EXPECT_GT(wrong("8"), 0.08);
  EXPECT_LT(wrong("64"), wrong("8") / 4);
}

// Along a row, facets are steps in flat shading. In Gouraud shading intensities are continuous, but their
// slope has steps at the facets' edges. In Phong shading neither has steps.
TEST(BuiltInScenes, MachBandsAreSteps) {
  struct Row {
    int steps = 0, kinks = 0;
  };
  const auto along = [](Shading method) {
    const Drawn drawn{"mach-bands", by(method)};
    const Illumination& light = drawn.picture.settings().light;
    const int dark = drawn.picture.table().cell(light.ka * light.Ia);
    Row row;
    for (int i = 40; i < kWidth - 40; ++i)
      row.steps += std::abs(drawn.at(i, kHeight / 2) - drawn.at(i - 1, kHeight / 2)) > 6;
    // Slopes over 8 samples on both sides, in cells. Each is rounded by at most 1 cell.
    for (int i = 40; i < kWidth - 40; ++i) {
      const auto I = [&](int k) { return drawn.at(k, kHeight / 2); };
      const bool lit = std::min(I(i - 8), I(i + 8)) > dark + 1;
      row.kinks += lit && std::abs(I(i + 8) - 2 * I(i) + I(i - 8)) > 5;
    }
    return row;
  };
  EXPECT_GE(along(Shading::Flat).steps, 7);
  EXPECT_EQ(along(Shading::Gouraud).steps, 0);
  EXPECT_EQ(along(Shading::Phong).steps, 0);
  EXPECT_GT(along(Shading::Gouraud).kinks, 0);
  EXPECT_EQ(along(Shading::Phong).kinks, 0);
  EXPECT_EQ(Drawn{"mach-bands"}.picture.settings().shading, Shading::Flat);
}

// Every lit method cuts off intensities above 1, which leaves an area of full intensity. Without the
// highlight nothing is cut off.
TEST(BuiltInScenes, SaturatedIsClamped) {
  for (const Shading method : {Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::Environment}) {
    const Drawn drawn{"saturated", by(method)};
    EXPECT_GT(drawn.picture.saturated(), 0);
    EXPECT_GT(std::ranges::count(drawn.image.pixels, drawn.picture.table().cell(1.0)), drawn.samples() / 50);
    const Drawn dull{"saturated", [&](PictureSettings& s) { s.shading = method, s.light.ks = 0; }};
    EXPECT_EQ(dull.picture.saturated(), 0);
  }
}

// If each sample is painted once, clamped samples that are evaluated or looked up are counted in pixels: as
// many as have intensity 1, except for the few where the fixed point of a fill steps to a neighbour.
TEST(BuiltInScenes, SaturatedCountsPixels) {
  for (const Shading method : {Shading::Phong, Shading::Environment}) {
    Drawn drawn{"saturated", [&](PictureSettings& s) { s.shading = method, s.order = Order::Oracle; }};
    const auto I = drawn.picture.intensities(drawn.picture.seen(0, kHeight));
    int full = 0;
    for (std::size_t k = 0; k < I.size(); ++k) full += drawn.faces[k] != 0 && I[k] >= 1.0;
    EXPECT_GT(full, drawn.samples() / 50);
    EXPECT_NEAR(static_cast<double>(drawn.picture.saturated()), full, full / 50.0);
  }
}

// One scene with coloured lights and one with a coloured texture need three channels. All others need one.
TEST(BuiltInScenes, ChannelsThatAreRequired) {
  int three = 0;
  for (const BuiltInScene& scene : builtInScenes()) {
    const Drawn drawn{scene.name, [](PictureSettings& s) {
                        if (!rowOf(s.shading).lit) s.shading = Shading::Flat;
                        s.width = 40, s.height = 30;
                      }};
    const bool colored = scene.name == "colored-lights" || scene.name == "textured-cube";
    EXPECT_EQ(drawn.picture.shading().lighting().channels, colored ? 3 : 1) << scene.name;
    three += colored;
  }
  EXPECT_EQ(three, 2);
}

// The floor of coloured lights shows each light alone, each two mixed, and all three. A light of one channel
// does not affect the others.
TEST(BuiltInScenes, ColoredLightsMix) {
  const Drawn drawn{"colored-lights"};
  const Palette palette = drawn.picture.palette(CellPlan{TableKind::Linear});
  std::array<int, 8> mixed{};  // by which of red, green, blue are bright
  for (std::size_t k = 0; k < drawn.faces.size(); ++k) {
    if (drawn.faces[k] == 0 || drawn.faces[k] > 144) continue;
    const Rgb16 c = palette[drawn.image.pixels[k]];
    ++mixed[(c.r > 0x6000) + 2 * (c.g > 0x6000) + 4 * (c.b > 0x6000)];
  }
  for (const int samples : mixed) EXPECT_GT(samples, 500);
}

// Perspective and affine texture coordinates differ everywhere on a cube seen at an angle, and nowhere on a
// face seen straight on.
TEST(BuiltInScenes, AffineTexturesBend) {
  const auto mapped = [](TextureMapping mapping, bool straight) {
    return Drawn{"textured-cube", [=](PictureSettings& s) {
                   s.mapping = mapping;
                   s.colors = ColorPlan::OneHue;  // so that cells are intensities
                   if (straight) s.camera.eye = glm::dvec3{0, -1.5, 0}, s.camera.lookAt = glm::dvec3{0};
                 }};
  };
  const auto apart = [&](bool straight) {
    const Drawn perspective = mapped(TextureMapping::Perspective, straight),
                affine = mapped(TextureMapping::Affine, straight);
    EXPECT_GT(perspective.samples(), 5000);
    return static_cast<double>(differing(perspective, affine, 10)) / perspective.samples();
  };
  EXPECT_GT(apart(false), 0.15);
  EXPECT_EQ(apart(true), 0.0);
}

// Every rule for normals shades the coarse teapot differently. Its file has none of its own.
TEST(BuiltInScenes, CoarseTeapotDiffersByRule) {
  std::vector<Drawn> drawn;
  for (const NormalRow& rule : kNormalRules)
    if (rule.id != NormalRule::File)
      drawn.emplace_back("coarse-teapot", [&](PictureSettings& s) { s.normals = rule.id; });
  for (std::size_t a = 0; a < drawn.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_GT(differing(drawn[a], drawn[b], 2), drawn[a].samples() / 100)
          << kNormalRules[a].name << " and " << kNormalRules[b].name;
}

// The middle of a square with one bright corner depends on how a fill interpolates. Triangles give the same
// value however the square is turned. Rows give the mean of all corners or of two, whether the square or the
// view is turned.
TEST(BuiltInScenes, RowsTurnWithTheView) {
  const auto middles = [](Polygons polygons, bool turned) {
    const Drawn drawn{"bright-corner", [&](PictureSettings& s) {
                        s.polygons = polygons;
                        s.camera.height = *s.camera.height * 1.5;  // nothing cut off
                        if (turned) s.camera.up = glm::dvec3{1, 1, 0};
                      }};
    std::array<int, 2> cells{};
    for (int face = 0; face < 2; ++face) {
      // The value in the middle of a square is the mean of the samples there.
      long i = 0, j = 0, n = 0;
      for (std::size_t k = 0; k < drawn.faces.size(); ++k)
        if (static_cast<int>(drawn.faces[k]) == face + 1) i += k % kWidth, j += k / kWidth, ++n;
      EXPECT_GT(n, 4000);
      cells[face] = drawn.at(static_cast<int>(i / n), static_cast<int>(j / n));
    }
    return cells;
  };
  const auto triangles = middles(Polygons::Triangles, false), rows = middles(Polygons::Rows, false);
  const auto triangles45 = middles(Polygons::Triangles, true), rows45 = middles(Polygons::Rows, true);
  const int near = 4;  // within a few samples of the middle
  EXPECT_NEAR(triangles[0], triangles[1], near);
  EXPECT_NEAR(triangles[0], triangles45[0], near);
  EXPECT_NEAR(triangles[1], triangles45[1], near);
  EXPECT_GT(std::abs(rows[0] - rows[1]), 30);
  EXPECT_GT(std::abs(rows[0] - rows45[0]), 30);
  EXPECT_GT(std::abs(rows[1] - rows45[1]), 30);
}

// Each ball of the hues shows only shades of its own hue, in its own cells.
TEST(BuiltInScenes, HuesHaveRampsOfTheirOwn) {
  const Drawn drawn{"hues"};
  EXPECT_EQ(planOf(drawn.picture.scene(), drawn.picture.settings()), ColorPlan::Hues);
  const Palette palette = drawn.picture.palette(CellPlan{TableKind::Linear});
  std::map<int, std::vector<bool>> cellsOf;  // by material
  for (std::size_t k = 0; k < drawn.faces.size(); ++k) {
    if (drawn.faces[k] == 0) continue;
    const int material = drawn.picture.scene().mesh.material[drawn.faces[k] - 1];
    const glm::dvec3 color =
        material < 0 ? glm::dvec3{1.0} : drawn.picture.scene().mesh.materials[material].diffuse;
    const Rgb16 c = palette[drawn.image.pixels[k]];
    const double brightness = std::max({c.r, c.g, c.b}), largest = std::max({color.r, color.g, color.b});
    ASSERT_NEAR(c.r, brightness * color.r / largest, 1) << k;
    ASSERT_NEAR(c.g, brightness * color.g / largest, 1) << k;
    ASSERT_NEAR(c.b, brightness * color.b / largest, 1) << k;
    cellsOf[material].resize(256);
    cellsOf[material][drawn.image.pixels[k]] = true;
  }
  EXPECT_EQ(cellsOf.size(), 7u);
  for (int cell = 0; cell < 256; ++cell)
    EXPECT_LE(std::ranges::count_if(cellsOf, [&](const auto& of) { return of.second[cell]; }), 1) << cell;
  for (const auto& [material, cells] : cellsOf)
    EXPECT_GT(std::ranges::count(cells, true), material < 0 ? 0 : 10) << material;
}

// Intensities that no surface has get no shades. The floor, which has one intensity, gets two shades, or
// three if it is found pixel by pixel. Every ramp begins and ends within 1/255 of an intensity that occurs,
// or within 3/255 pixel by pixel.
TEST(BuiltInScenes, HuesSpanTheIntensitiesThatAreThere) {
  for (const Shading method : {Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::Environment}) {
    SCOPED_TRACE(rowOf(method).name);
    const bool atPixels = method == Shading::Phong || method == Shading::Environment;
    const Drawn drawn{"hues", [&](PictureSettings& s) {
                        s.shading = method;
                        if (atPixels) s.cull = Cull::Back;  // nearly all samples are seen
                      }};
    const Scene& scene = drawn.picture.scene();
    const SceneColors& colors = drawn.picture.colors();
    const SeenRows rows = drawn.picture.seen(0, drawn.image.height);
    const std::vector<double> I = drawn.picture.intensities(rows);
    int inside = 0;
    for (std::size_t k = 0; k < I.size(); ++k) {
      if (rows.faces[k] < 0) continue;
      const ColorTable& table =
          colors.tableOf(scene.mesh.material[drawn.picture.snapped().faces[rows.faces[k]].number]);
      ASSERT_GE(std::min(I[k], 1.0), table.low() - 1e-9);
      ASSERT_LE(std::min(I[k], 1.0), table.high() + 1e-9);
      ++inside;
    }
    EXPECT_GT(inside, 10'000);
    EXPECT_LE(colors.tableOf(-1).shades(), atPixels ? 3 : 2);
    const auto& stored = drawn.picture.shading().intensities(0).I;
    for (const ColorTable& table : colors.tables()) {
      const auto has = [&](double end) {
        if (atPixels)
          return std::ranges::any_of(
              I, [&](double at) { return std::abs(std::min(at, 1.0) - end) <= 3 / 255.0; });
        return std::ranges::any_of(stored, [&](const FrontBack<double>& ofVertex) {
          return std::abs(ofVertex.front - end) <= 1 / 255.0 || std::abs(ofVertex.back - end) <= 1 / 255.0;
        });
      };
      EXPECT_TRUE(has(table.low())) << table.low();
      EXPECT_TRUE(has(table.high())) << table.high();
    }
  }
}

// The farther a square of the floor is from the lamp, the darker it is. Beyond the lamp's range there is only
// ambient light.
TEST(BuiltInScenes, LampFallsWithDistance) {
  const Drawn drawn{"lamp", by(Shading::Flat)};
  const Scene& scene = drawn.picture.scene();
  const Light& lamp = scene.light.lights.at(0);
  const auto& intensities = drawn.picture.shading().intensities(0);
  const auto& points = drawn.picture.shading().points();
  std::vector<std::pair<double, double>> floor;  // distance, intensity
  for (int f = 0; f < 36; ++f)
    floor.emplace_back(glm::length(points.at[f] - lamp.position), intensities.I[f].front);
  std::ranges::sort(floor);
  for (std::size_t k = 1; k < floor.size(); ++k) EXPECT_LE(floor[k].second, floor[k - 1].second + 1e-12);
  const double ambient = scene.settings.light.ka * scene.light.Ia->r;
  EXPECT_NEAR(floor.back().second, ambient, 1e-12);
  EXPECT_GT(floor.back().first, lamp.range);
  EXPECT_GT(floor.front().second, 0.5);
}

// P and Q are roles of the depth sort, so no part of a scene is called so.
TEST(BuiltInScenes, NoNameIsARole) {
  for (const BuiltInScene& scene : builtInScenes())
    for (const std::string& name : readScene(scene.name, 2).mesh.groupNames)
      for (const char* const role : {"p", "q", "P", "Q"}) EXPECT_NE(name, role) << scene.name;
}

}  // namespace xnewell::THIS_FILE
