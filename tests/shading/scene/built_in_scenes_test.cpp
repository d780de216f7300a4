#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>

#include "geometry/model/vertex_normals.h"
#include "shading/color/png.h"
#include "shading/laboratory/errors.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/mesh_textures.h"
#include "shading/scene/scene_file.h"
#include "tests/support/reader_fixture.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- The built-in scenes

/// Some built-in scenes of shading show what they say, measured in their pictures.

constexpr int kWidth = 400, kHeight = 300;
constexpr int kGround = 255;  ///< belongs to no ramp

/// A picture as the scene asks for it, but for what `change` does.
struct Drawn {
  Picture picture;
  IndexImage image;
  std::vector<std::uint32_t> faces;  ///< face number + 1 at each sample

  explicit Drawn(const std::string& name, const std::function<void(PictureSettings&)>& change = {})
      : picture{made(readScene(name), change)}, image{picture.image()}, faces{picture.faceImage()} {}

  static Picture made(const Scene& scene, const std::function<void(PictureSettings&)>& change) {
    PictureSettings settings = setUpOf(scene, kWidth, kHeight);
    if (change) change(settings);
    return makePicture(scene, settings, kGround);
  }
  [[nodiscard]] int samples() const { return static_cast<int>(faces.size() - std::ranges::count(faces, 0u)); }
  /// The cell of largest number among the samples of faces from..to-1: the brightest of a ramp.
  [[nodiscard]] int brightest(int from, int to) const {
    int most = -1;
    for (std::size_t k = 0; k < faces.size(); ++k)
      if (const int f = static_cast<int>(faces[k]) - 1; f >= from && f < to)
        most = std::max(most, int{image.pixels[k]});
    return most;
  }
};

std::function<void(PictureSettings&)> by(Shading method) {
  return [method](PictureSettings& s) { s.shading = method; };
}

/// Samples whose cells are more than `apart` apart.
int differing(const Drawn& a, const Drawn& b, int apart) {
  int count = 0;
  for (std::size_t k = 0; k < a.image.pixels.size(); ++k)
    count += std::abs(a.image.pixels[k] - b.image.pixels[k]) > apart;
  return count;
}

constexpr double kFull = kMaxShades - 1;  ///< of full intensity over none, in a linear table

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
  EXPECT_EQ(readScene("cubes").settings.normals, NormalRule::Sum);
  for (const NormalRule rule : {NormalRule::Sum, NormalRule::Distinct, NormalRule::Angle}) {
    const Drawn drawn{"cubes", [&](PictureSettings& s) { s.normals = rule; }};
    const std::vector<Vertex>& vertices = drawn.picture.shading().vertices().vertices;
    ASSERT_EQ(vertices.size(), 16u);
    const auto leans = [&](std::size_t k, double by) {
      const glm::dvec3 off = abs(abs(vertices[k].N) - 1 / std::sqrt(3.0));
      return std::max(off.x, off.y) > by;
    };
    const auto& I = drawn.picture.shading().intensities(0).I;
    int leaning = 0, litOtherwise = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      EXPECT_FALSE(leans(k, 1e-12));
      leaning += leans(8 + k, 0.1);
      litOtherwise += std::abs(I[k].front - I[8 + k].front) > 0.05;
    }
    EXPECT_EQ(leaning >= 4, rule == NormalRule::Sum) << leaning;
    EXPECT_EQ(litOtherwise >= 3, rule == NormalRule::Sum) << litOtherwise;
    EXPECT_TRUE(rule == NormalRule::Sum || leaning + litOtherwise == 0);
  }
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
    for (std::uint32_t face = 0; face < 2; ++face) {
      // The middle of a square is the mean of its samples' places.
      long i = 0, j = 0, n = 0;
      for (std::size_t k = 0; k < drawn.faces.size(); ++k)
        if (drawn.faces[k] == face + 1) i += k % kWidth, j += k / kWidth, ++n;
      EXPECT_GT(n, 4000);
      cells[face] = drawn.image.row(static_cast<int>(j / n))[i / n];
    }
    return cells;
  };
  const auto triangles = middles(Polygons::Triangles, false), rows = middles(Polygons::Rows, false);
  const auto triangles45 = middles(Polygons::Triangles, true), rows45 = middles(Polygons::Rows, true);
  EXPECT_NEAR(triangles[0], triangles[1], 4);  // within a few samples of the middle
  EXPECT_GT(std::abs(rows[0] - rows[1]), 30);
  for (const int square : {0, 1}) {
    EXPECT_NEAR(triangles[square], triangles45[square], 4);
    EXPECT_GT(std::abs(rows[square] - rows45[square]), 30);
  }
}

// Perspective and affine texture coordinates show the same on a face seen straight on, and not on a cube seen
// at an angle.
TEST(BuiltInScenes, AffineTexturesBend) {
  for (const bool straight : {false, true}) {
    const auto mapped = [&](TextureMapping mapping) {
      return Drawn{"textured-cube",
                   [&](PictureSettings& s) {
                     s.mapping = mapping, s.colors = ColorPlan::OneHue;
                     if (straight) s.camera.eye = glm::dvec3{0, -1.5, 0}, s.camera.lookAt = glm::dvec3{0};
                   }}
          .image;
    };
    EXPECT_EQ(mapped(TextureMapping::Perspective) == mapped(TextureMapping::Affine), straight);
  }
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

// P and Q are roles of the depth sort, so no part of a scene is called so.
TEST(BuiltInScenes, NoNameIsARole) {
  for (const BuiltInScene& scene : builtInScenes())
    for (const std::string& name : readScene(scene.name, 2).mesh.groupNames)
      for (const char* const role : {"p", "q", "P", "Q"}) EXPECT_NE(name, role) << scene.name;
}

/// ---- Textures of meshes

constexpr int kColumns = 4, kRows = 3;

/// Texels of which no two are alike in any channel.
RgbImage texels() {
  RgbImage image{kColumns, kRows};
  for (std::size_t k = 0; k < image.rgb.size(); ++k) image.rgb[k] = static_cast<std::uint8_t>(7 * k + 3);
  return image;
}

/// A quadrilateral that leans away from the viewer, with texture coordinates that leave [0, 1], and one
/// without any beside it.
constexpr std::string_view kObj = R"(mtllib a.mtl
v -0.9 -0.5 0.4
v 0.3 -0.5 -0.4
v 0.3 0.6 -0.4
v -0.9 0.6 0.4
v 0.4 -0.5 -0.4
v 0.9 -0.5 -0.4
v 0.9 0.6 -0.4
v 0.4 0.6 -0.4
vt -0.25 0
vt 1.5 0
vt 1.5 1
vt -0.25 1
usemtl pictured
f 1/1 2/2 3/3 4/4
f 5 6 7 8
)";

class MapKd : public testing::Test {
 protected:
  MapKd() { writePng(file("t.png"), texels()); }
  [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }
  /// The scene of kObj with this library.
  [[nodiscard]] Scene scene(const std::string& mtl, std::string_view obj = kObj) const {
    (void)folder_.write("a.mtl", mtl);
    return readScene(folder_.write("a.obj", obj));
  }
  TemporaryFolder folder_;
};

/// What the test computes by itself: a ray through the centre of a pixel meets the plane of the leaning
/// quadrilateral, whose z is a function of x.
struct Ray {
  static constexpr double kEye = 3, kFov = 50;  // on the z axis; degrees
  static constexpr int kWidth = 90, kHeight = 70;
  double x, y;  ///< where it meets the quadrilateral

  Ray(int i, int j) {
    const double half = std::tan(kFov / 2 * std::acos(-1.0) / 180);
    const double dx = half * kWidth / kHeight * (2 * (i + 0.5) / kWidth - 1),
                 dy = half * (1 - 2 * (j + 0.5) / kHeight);
    // z = 0.4 - 0.8 (x + 0.9) / 1.2 = kEye - t, x = t dx
    const double slope = -0.8 / 1.2, t = (kEye - 0.4 - slope * 0.9) / (1 + slope * dx);
    x = t * dx, y = t * dy;
  }
  [[nodiscard]] bool meets() const { return x > -0.9 && x < 0.3 && y > -0.5 && y < 0.6; }
  /// In texels.
  [[nodiscard]] double u() const { return kColumns * (-0.25 + 1.75 * (x + 0.9) / 1.2); }
  [[nodiscard]] double v() const { return kRows * (y + 0.5) / 1.1; }
};

PictureSettings settings(const Scene& scene, Shading shading) {
  PictureSettings s = scene.settings;
  s.width = Ray::kWidth, s.height = Ray::kHeight;
  s.camera.eye = glm::dvec3{0, 0, Ray::kEye}, s.camera.lookAt = glm::dvec3{0}, s.camera.fov = Ray::kFov;
  s.shading = shading;
  s.light.ks = 0, s.light.ka = 0.5, s.light.Ia = 0.3, s.light.kd = 0.8, s.light.Ip = 0.7;
  s.light.light = {0, 0, 1};
  return s;
}

// At each pixel the diffuse colour is the texel, or the texel times Kd, as the setting says. The texel is
// that of the place where the ray meets the face, in perspective and with coordinates that repeat. An .obj
// file begins with the product, as MTL defines map_Kd.
TEST_F(MapKd, ShowsTheTexelOfThePlace) {
  const glm::dvec3 Kd{0.5, 1, 0.25};
  const RgbImage image = texels();
  const double NdotL = 1.2 / std::hypot(1.2, 0.8);
  const Scene leaning = scene("newmtl pictured\nKd 0.5 1 0.25\nmap_Kd t.png\n");
  EXPECT_EQ(leaning.settings.light.texel, TexelUse::Multiplies);
  EXPECT_TRUE(leaning.mesh.notes.empty());
  for (const TexelUse use : {TexelUse::Replaces, TexelUse::Multiplies})
    for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong}) {
      PictureSettings s = settings(leaning, shading);
      s.light.texel = use;
      const Picture picture = makePicture(leaning, s);
      ASSERT_EQ(picture.shading().lighting().channels, 3);
      const SeenRows rows = picture.seen(0, s.height);
      int compared = 0;
      for (int c = 0; c < 3; ++c) {
        const std::vector<double> I = picture.intensities(rows, c);
        for (int j = 0; j < s.height; ++j)
          for (int i = 0; i < s.width; ++i) {
            const Ray ray{i, j};
            const double u = ray.u(), v = ray.v();
            // not where another texel, or nothing, is within what the snap to the grid may move
            if (!ray.meets() || std::abs(u - std::round(u)) < 1e-3 || std::abs(v - std::round(v)) < 1e-3)
              continue;
            const std::size_t k = std::size_t(j) * s.width + i;
            if (rows.faces[k] < 0) continue;
            const int column = static_cast<int>(std::floor(u) + kColumns) % kColumns,
                      row = kRows - 1 - static_cast<int>(std::floor(v));
            const double texel = image.rgb[3 * (kColumns * row + column) + c] / 255.0;
            const double Od = use == TexelUse::Replaces ? texel : texel * Kd[c];
            ASSERT_NEAR(I[k], 0.3 * 0.5 * Kd[c] + 0.7 * 0.8 * Od * NdotL, 1e-9) << i << ' ' << j << ' ' << c;
            ++compared;
          }
      }
      EXPECT_GT(compared, 3 * 800);
    }
}

// What is painted is the cell of that intensity. Only single precision may take the next one.
TEST_F(MapKd, PaintsWhatItShows) {
  const Scene leaning = scene("newmtl pictured\nKd 0.5\nmap_Kd t.png\n");
  for (const TexelUse use : {TexelUse::Replaces, TexelUse::Multiplies})
    for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong}) {
      PictureSettings s = settings(leaning, shading);
      s.light.texel = use, s.colors = ColorPlan::OneHue;
      const Picture picture = makePicture(leaning, s, 3);
      const SeenRows rows = picture.seen(0, s.height);
      const std::vector<double> I = picture.intensities(rows);
      int compared = 0;
      for (std::size_t k = 0; k < I.size(); ++k) {
        if (rows.faces[k] < 0) continue;
        ASSERT_NEAR(picture.image().pixels[k], 11 + 239 * I[k], 0.501);
        ++compared;
      }
      EXPECT_GT(compared, 800);
    }
}

// A face without texture coordinates shows Kd, also where other faces of its material show texels. The
// reference says the same of both.
TEST_F(MapKd, FacesWithoutCoordinatesShowKd) {
  const Scene both = scene("newmtl pictured\nKd 0.5 1 0.25\nmap_Kd t.png\n");
  PictureSettings s = settings(both, Shading::Phong);
  for (const TexelUse use : {TexelUse::Replaces, TexelUse::Multiplies}) {
    s.light.texel = use;
    const Picture picture = makePicture(both, s, 3);
    const SeenRows rows = picture.seen(0, s.height);
    const std::vector<double> I = picture.intensities(rows, 0);
    int plain = 0;
    for (std::size_t k = 0; k < I.size(); ++k) {
      if (rows.faces[k] < 0 || picture.snapped().faces[rows.faces[k]].number != 1) continue;
      ASSERT_NEAR(I[k], 0.3 * 0.5 * 0.5 + 0.7 * 0.8 * 0.5, 1e-9);
      ++plain;
    }
    EXPECT_GT(plain, 200);
    const Reference reference{picture};
    const Comparison beside{picture, reference, picture.palette(CellPlan{s.table.kind})};
    EXPECT_LT(spreadOf(beside.intensityErrors(TableSide::Before)).rootMeanSquare, 0.02);
  }
}

// Each file is read once. What cannot be shown has one note with its place, and its surfaces have Kd. A file
// that is no PNG in spite of its name is an error with the place of map_Kd.
TEST_F(MapKd, SaysWhatItCannotShow) {
  std::filesystem::create_directory(file("deep"));
  writePng(file("deep/my t.PNG"), texels());
  const std::string obj = std::string{kObj} + "usemtl other\nf 1/1 2/2 3/3\nusemtl third\nf 1 2 3\n";
  const Scene s = scene(
      "newmtl pictured\nmap_Kd t.png\nnewmtl other\nmap_Kd -clamp off -blendu on .\\deep\\my t.PNG\n"
      "newmtl third\nmap_Kd C:\\Users\\me\\t.png\nnewmtl unused\nmap_Kd gone.png\n",
      obj);
  EXPECT_TRUE(s.mesh.notes.empty());
  EXPECT_EQ(s.textures.size(), 2u);
  const auto textureOf = [&](int face) { return s.mesh.materials[s.mesh.material[face]].texture; };
  EXPECT_EQ(textureOf(0), 0);
  EXPECT_EQ(textureOf(1), -1);
  EXPECT_EQ(textureOf(2), 1);
  EXPECT_EQ(textureOf(3), -1);

  const auto noted = [&](const std::string& line, std::string_view of) {
    const Scene shown = scene("newmtl pictured\n" + line + "\n", of);
    EXPECT_TRUE(shown.textures.empty());
    EXPECT_EQ(shown.settings.light.texel, TexelUse::Replaces);
    return shown.mesh.notes.size() == 1 ? shown.mesh.notes[0] : "not one note";
  };
  const std::string place = file("a.mtl") + ":2: ";
  EXPECT_EQ(noted("map_Kd t.jpg", kObj),
            place + "the texture '" + file("t.jpg") + "' is not a .png file: its surfaces have Kd");
  EXPECT_EQ(noted("map_Kd gone.png", kObj),
            place + "the texture '" + file("gone.png") +
                "' cannot be read (No such file or directory): its surfaces have Kd");
  EXPECT_EQ(noted("map_Kd t.png", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl pictured\nf 1 2 3\n"),
            place + "the texture '" + file("t.png") + "' is not shown: its faces have no vt");
  const auto refused = [&](const std::string& map) {
    return complaint([&] { return scene("newmtl pictured\nmap_Kd " + map + "\n"); });
  };
  (void)folder_.write("bad.png", "no picture");
  EXPECT_EQ(refused("bad.png").substr(0, place.size()), place);
  EXPECT_NE(refused("bad.png").find("bad.png"), std::string::npos);
  EXPECT_EQ(refused(""), place + "map_Kd needs a file");
}

// In a scene file, an .obj file brings its textures along. A material of the scene takes their place.
TEST_F(MapKd, InASceneFile) {
  (void)scene("newmtl pictured\nmap_Kd t.png\n");
  const auto read = [&](const std::string& more) {
    return parseSceneFile(R"({"materials": {"m": {"texture": "t.png"}, "plain": {}}, "objects": [
      {"file": "a.obj", "material": "m"}, {"file": "a.obj")" +
                              more + "}]}",
                          "s.json", folder_.path());
  };
  const Scene both = read("");
  ASSERT_EQ(both.textures.size(), 1u);  // one file
  EXPECT_EQ(both.mesh.materials[both.mesh.material[0]].texture, 0);
  EXPECT_EQ(both.mesh.materials[both.mesh.material[2]].texture, 0);
  EXPECT_EQ(both.mesh.materials[both.mesh.material[3]].texture, -1);
  EXPECT_EQ(both.settings.light.texel, TexelUse::Replaces);
  const Scene plain = read(R"(, "material": "plain")");
  EXPECT_EQ(plain.mesh.materials[plain.mesh.material[2]].texture, -1);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
