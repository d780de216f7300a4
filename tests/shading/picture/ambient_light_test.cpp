#include <gtest/gtest.h>

#include "shading/laboratory/profile.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr std::uint8_t kGround = 3;

/// A ball, a torus and a card with a texture. `kd` is that of all of them; ks is 0.
Scene solids(const std::string& light, const std::string& kd, bool colored) {
  const std::string first = colored ? R"("color": [1, 0.4, 0.1], )" : "";
  const std::string text = R"({"up": "z", "ambient": 0.47, "lights": [)" + light +
                           R"(], "materials": {"ball": {)" + first + R"("ks": 0, "ka": 0.83, "kd": )" + kd +
                           R"(}, "torus": {"ks": 0, "ka": 0.31, "kd": )" + kd +
                           R"(}, "card": {"ks": 0, "texture": "textures/checks.png", "kd": )" + kd + R"(}},
    "objects": [{"solid": "sphere", "material": "ball"},
      {"solid": "torus", "material": "torus", "move": [0.5, 0.3, 0.8], "rotate": [30, 0, 0]},
      {"polygons": [[[-1, -1, 2], [1, -1, 2], [1, 1, 2], [-1, 1, 2]]],
       "uv": [[[0, 0], [1, 0], [1, 1], [0, 1]]], "material": "card"}]})";
  return parseSceneFile(text, "solids", XNEWELL_DATA_DIR);
}

constexpr std::string_view kSun = R"({"Ip": 0.5, "towards": [0, -1, 1]})";
constexpr std::string_view kLamp =
    R"({"kind": "point", "Ip": 0.5, "at": [0, 0, 4], "attenuation": "inverse"})";
constexpr std::string_view kSpot =
    R"({"kind": "spot", "Ip": 0.5, "at": [0, 0, 4], "shines": [0, 0, -1], "inner": 5, "outer": 40})";

/// A coefficient that changes no bit of any sum, but asks for all that a light needs.
constexpr const char* kAlmostNothing = "1e-300";

}  // namespace

// Where kd = ks = 0 there are no normals, and the picture is the same to the bit as one that computes them.
TEST(AmbientLight, ShowsTheSameWithoutNormals) {
  int pictures = 0;
  for (const std::string_view light : {kSun, kLamp, kSpot})
    for (const Shading method : {Shading::Flat, Shading::Gouraud, Shading::Phong})
      for (const Form form : {Form::Textbook, Form::HalfVector, Form::Tutorial})
        for (const ColorPlan plan : {ColorPlan::OneHue, ColorPlan::Hues, ColorPlan::Chosen})
          for (const TableKind table : {TableKind::Linear, TableKind::Corrected}) {
            SCOPED_TRACE(testing::Message() << light << ' ' << rowOf(method).name << ' ' << int(form) << ' '
                                            << int(plan) << ' ' << int(table));
            PictureSettings s;
            s.width = 90, s.height = 70;
            s.shading = method, s.light.form = form, s.colors = plan, s.table.kind = table;
            const bool colored = plan != ColorPlan::OneHue || pictures % 2 == 0;
            const Picture with =
                PictureCache{solids(std::string{light}, kAlmostNothing, colored)}.make(s, kGround);
            const Picture without = PictureCache{solids(std::string{light}, "0", colored)}.make(s, kGround);
            ASSERT_FALSE(with.shading().points().N.empty());
            ASSERT_TRUE(without.shading().points().N.empty() &&
                        without.shading().vertices().vertices.empty());
            ASSERT_EQ(with.image().pixels, without.image().pixels);
            ASSERT_EQ(with.palette(CellPlan{table}), without.palette(CellPlan{table}));
            ASSERT_EQ(with.cells(), without.cells());
            ASSERT_EQ(with.saturated(), without.saturated());
            const SeenRows rows = with.seen(0, s.height);
            for (int c = 0; c < with.shading().lighting().channels; ++c) {
              const std::vector<double> a = with.intensities(rows, c), b = without.intensities(rows, c);
              for (std::size_t k = 0; k < a.size(); ++k) ASSERT_TRUE(a[k] == b[k] || a[k] != a[k]);
            }
            ++pictures;
          }
  EXPECT_EQ(pictures, 3 * 3 * 3 * 3 * 2);
}

// What shows normals or asks for them shows the same: the view of normals, and the surfaces that a scanline
// crosses.
TEST(AmbientLight, NormalsAreThereForWhoAsks) {
  for (const Shading method : {Shading::Flat, Shading::Gouraud, Shading::Phong})
    for (const double crease : {180.0, 20.0}) {
      PictureSettings s;
      s.width = 90, s.height = 70;
      s.shading = method, s.crease = crease;
      const Picture with = makePicture(solids(std::string{kSun}, kAlmostNothing, false), s, kGround);
      const Picture without = makePicture(solids(std::string{kSun}, "0", false), s, kGround);
      const SeenRows rows = with.seen(0, s.height);
      ASSERT_EQ(with.normals(rows), without.normals(rows));
      const int row = defaultScanline(with);
      const Scanline a = scanlineOf(with, row, kGround), b = scanlineOf(without, row, kGround);
      ASSERT_GT(a.edges, 0);
      ASSERT_EQ(a.edges, b.edges);
      for (std::size_t k = 0; k < a.profiles.size(); ++k) ASSERT_EQ(a.profiles[k].cells, b.profiles[k].cells);
    }
}

// A cache that made a picture without normals makes the next one, with light, as if it were the first; and
// back.
TEST(AmbientLight, NormalsComeWithTheLight) {
  const Scene scene = readScene("teapot");
  for (const Shading method : {Shading::Flat, Shading::Gouraud, Shading::Phong})
    for (const double adapt : {0.0, 0.05}) {
      PictureSettings lit;
      lit.width = 90, lit.height = 70;
      lit.shading = method, lit.adapt = adapt;
      PictureSettings dark = lit;
      dark.light.Ip = 0;
      PictureCache cache{scene};
      for (const PictureSettings& s : {lit, dark, lit, dark}) {
        const Picture kept = cache.make(s, kGround), fresh = makePicture(scene, s, kGround);
        ASSERT_EQ(kept.image().pixels, fresh.image().pixels);
        ASSERT_EQ(kept.shading().points().N.empty(), s.light.Ip == 0);
        ASSERT_EQ(kept.shading().refined().has_value(), fresh.shading().refined().has_value());
      }
    }
}

}  // namespace xnewell::THIS_FILE
