#include "shading/scene/save_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/files/parse_error.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"
#include "tests/support/scene_text.h"
#include "tests/support/seeds.h"
#include "tests/support/temporary_folder.h"

namespace xnewell::THIS_FILE {

namespace {

/// Settings with every choice drawn at random and with numbers of many digits.
PictureSettings randomSettings(std::mt19937& rng) {
  const auto of = [&](const auto& rows) { return rows[rng() % rows.size()].id; };
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(rng);
  };
  const auto some = [&] { return rng() % 2 == 0; };
  PictureSettings s;
  CameraSettings& c = s.camera;
  const auto point = [&] { return glm::dvec3{number(-3, 3), number(-3, 3), number(2, 5)}; };
  if (some())
    c.eye = point(), c.lookAt = point(), c.up = point();
  else if (some())
    c.vrp = point(), c.vpn = point(), c.vup = point(), c.prp = point();
  if (some()) c.front = number(0, 1), c.back = number(-2, -1);
  if (some()) c.window = glm::dvec4{-1, number(0, 1), -1, number(0, 1)};
  switch (rng() % 4) {
    case 0:
      if (!c.window) c.fov = number(1, 179);
      break;
    case 1:
      c.parallel = true, c.height = number(0.1, 9);
      break;
    case 2:
      c.parallel = true;
      break;
    default:
      c.oblique = Oblique{some() ? 0.5 : 1.0, number(0, 90)};
  }
  Illumination& l = s.light;
  l.Ia = number(0, 0.5), l.Ip = number(0, 0.5);
  l.ka = number(0, 1), l.kd = number(0, 1), l.ks = number(0, 1), l.n = static_cast<int>(rng() % 1000);
  l.light = point();
  if (some()) l.lightPosition = point();
  if (l.lightPosition) l.attenuation = of(kAttenuations);
  if (some() && l.attenuation == Attenuation::Linear) l.range = number(0.1, 10);
  if (some() && l.attenuation == Attenuation::Textbook)
    l.c = glm::dvec3{number(0, 1), number(0, 1), number(0, 1)};
  l.form = of(kForms), l.constantL = some(), l.constantV = some(), l.twoSided = some(),
  l.texel = of(kTexelUses);
  s.shading = of(kShadings), s.normals = of(kNormalRules), s.crease = number(0, 180);
  s.interpolated = of(kInterpolated), s.unnormalized = some();
  s.polygons = of(kPolygons), s.adapt = some() ? 0.0 : number(0, 1), s.environment = of(kEnvironmentForms);
  s.mapping = of(kTextureMappings), s.order = of(kOrders), s.cull = some() ? Cull::Back : Cull::Keep;
  s.inPixels = some(), s.colors = of(kColorPlans), s.dither = some();
  s.table = {of(kTables), 2 + static_cast<int>(rng() % 239), number(0.001, 0.5), of(kPicks)};
  s.table.hue = {1, number(0, 1), number(0, 1)};
  s.table.bits = some() ? 8 : 16;
  return s;
}

/// The set-up that a reader of the file gets.
PictureSettings opened(const Scene& scene) {
  PictureSettings s = scene.settings;
  s.camera = scene.camera;
  return s;
}

}  // namespace

// A saved scene sets up the same scene in the same way, bit for bit, for any settings, also if the scene's
// units are not the file's.
TEST(SaveScene, ReadsBackAsItWas) {
  std::mt19937 rng{5};
  const TemporaryFolder folder;
  const std::string far = folder.write("far.obj", "v 0 0 0\nv 3e9 0 0\nv 0 3e9 1\nf 1 2 3\n");
  for (const std::string& name : {std::string{"teapot"}, std::string{"cycle"}, far}) {
    const Scene scene = readScene(name, 3);
    for (int trial = 0; trial < 200; ++trial) {
      const PictureSettings settings = randomSettings(rng);
      const std::string text = savedScene(scene, settings, folder.path());
      SCOPED_TRACE(text);
      const Scene again = parseSceneFile(text, "saved.json", folder.path(), 8);
      ASSERT_EQ(again.mesh.points, scene.mesh.points);
      EXPECT_EQ(again.origin.of.substr(again.origin.of.find_last_of('/') + 1),
                name.substr(name.find_last_of('/') + 1));
      const PictureSettings back = opened(again);
      ASSERT_EQ(back.camera, settings.camera);
      ASSERT_EQ(back.light, settings.light);
      ASSERT_EQ(back.table, settings.table);
      ASSERT_EQ(back, settings);
    }
  }
}

// An opened set-up paints what was saved, cell for cell and colour for colour. This holds for every method,
// rule, form, mapping, order and plan of colours, and for scenes with their own lights, textures, several
// hues and patches. An adapt of 0, which divides no polygon, comes back as 0.
TEST(SaveScene, PaintsTheSamePicture) {
  std::mt19937 rng{7};
  const TemporaryFolder folder;
  const auto painted = [](PictureCache& pictures, PictureSettings settings) {
    settings.width = 64, settings.height = 48;
    return pictures.make(settings, 0).image();
  };
  int undivided = 0, shown = 0;
  const auto expectSame = [&](PictureCache& pictures, const PictureSettings& settings) {
    const std::string text = savedScene(pictures.scene(), settings, folder.path());
    SCOPED_TRACE(text);
    PictureCache again{parseSceneFile(text, "saved.json", folder.path(), 8)};
    const PictureSettings back = opened(again.scene());
    ASSERT_EQ(back, settings);
    const IndexImage image = painted(pictures, settings);
    ASSERT_EQ(painted(again, back).pixels, image.pixels);
    ASSERT_EQ(again.last().palette(CellPlan{}, {}), pictures.last().palette(CellPlan{}, {}));
    ASSERT_EQ(again.last().saturated(), pictures.last().saturated());
    undivided += settings.adapt == 0.0;
    shown += std::ranges::count(image.pixels, 0) < std::ssize(image.pixels);
  };
  int drawn = 0, pictures = 0;
  for (const char* name : {"teapot", "colored-lights", "hues", "textured-cube", "spotlight", "lamp"}) {
    SCOPED_TRACE(name);
    PictureCache original{readScene(name, 3)};
    // Each row of each table, with the other settings at random, from the scene's own camera.
    const auto each = [&](const auto& rows, auto PictureSettings::*choice) {
      for (const auto& row : rows) {
        PictureSettings settings = randomSettings(rng);
        settings.camera = original.scene().camera;
        settings.*choice = row.id;
        if (original.scene().light.placed() && !settings.light.lightPosition)  // of the scene's own lights
          settings.light.attenuation = kAttenuations[rng() % kAttenuations.size()].id;
        settings.table.shades = std::max(settings.table.shades, 14);  // two for each of seven hues
        if (drawn++ % (kSanitized ? 4 : 1) != 0) continue;
        expectSame(original, settings);
        ++pictures;
      }
    };
    each(kShadings, &PictureSettings::shading);
    each(kNormalRules, &PictureSettings::normals);
    each(kPolygons, &PictureSettings::polygons);
    each(kEnvironmentForms, &PictureSettings::environment);
    each(kTextureMappings, &PictureSettings::mapping);
    each(kOrders, &PictureSettings::order);
    each(kColorPlans, &PictureSettings::colors);
  }
  EXPECT_GT(drawn, 100);
  EXPECT_GT(undivided, pictures / 4);
  EXPECT_GT(shown, pictures * 3 / 4);
}

// A saved scene says which parts of the scene were left out.
TEST(SaveScene, KeepsWhatWasDoneToTheScene) {
  const TemporaryFolder folder;
  Scene scene = readScene("colored-lights", 2);
  ASSERT_FALSE(scene.light.lights.empty());
  strip(scene, "lights");
  const Scene again = parseSceneFile(savedScene(scene, {}, folder.path()), "s.json", folder.path(), 8);
  EXPECT_TRUE(again.light.lights.empty());
  EXPECT_EQ(again.light.Ia, scene.light.Ia);
  EXPECT_EQ(again.origin.without, std::vector<std::string>{"lights"});
  EXPECT_EQ(savedScene(again, {}, folder.path()), savedScene(scene, {}, folder.path()));
}

// A set-up that is opened, changed and saved names the scene, not the set-up. A set-up that names a set-up,
// even itself, is refused.
TEST(SaveScene, NamesTheSceneItself) {
  const TemporaryFolder folder;
  const std::string first = folder.write("first.json", savedScene(readScene("cycle"), {}, folder.path()));
  const Scene scene = readScene(first);
  EXPECT_EQ(scene.origin.of, "cycle");
  EXPECT_NE(savedScene(scene, {}, folder.path()).find("\"scene\": \"cycle\""), std::string::npos);
  for (const std::string loop : {"first.json", "loop.json"}) {
    folder.write("loop.json", R"({"scene": ")" + loop + R"("})");
    try {
      (void)readScene((folder.path() / "loop.json").string());
      FAIL() << loop;
    } catch (const ParseError& e) {
      EXPECT_NE(std::string{e.what()}.find("itself a set-up of another scene"), std::string::npos)
          << e.what();
    }
  }
}

// Next to "scene", a file may hold only choices: keys of a scene's own contents and unknown choices are
// refused.
TEST(SaveScene, Refusals) {
  const auto refused = [](const std::string& text, const std::string& word) {
    try {
      (void)parseSceneFile(text, "s.json", ".", 8);
      ADD_FAILURE() << text;
    } catch (const std::exception& e) {
      EXPECT_NE(std::string{e.what()}.find(word), std::string::npos) << e.what();
    }
  };
  refused(R"({"scene": "cycle", "objects": []})", "objects");
  refused(R"({"scene": "cycle", "without": ["light"]})", "without[0]");
  refused(R"({"scene": "cycle", "divisions": 0})", "divisions");
  refused(R"({"scene": "cycle", "texture": "no.png"})", "texture: 'no.png'");
  refused(R"({"scene": "no-such-scene"})", "no-such-scene");
  refused(R"({"scene": 3})", "scene");
}

}  // namespace xnewell::THIS_FILE
