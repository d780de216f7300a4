#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

#include "geometry/files/parse_error.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/save_scene.h"
#include "shading/scene/scene_file.h"
#include "shading/scene/settings.h"
#include "tests/support/scene_text.h"
#include "tests/support/seeds.h"
#include "tests/support/temporary_folder.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Settings

/// Values of a setting that it allows, one of them its default.
std::vector<Value> someOf(const Setting& setting) {
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Value> values{setting.field.get(PictureSettings{})};
  if (setting.field.kind == ValueKind::Triple)
    values.insert(values.end(), {glm::dvec3{1, 0, 0.5}, glm::dvec3{0.25, 1, 0}});
  else if (setting.field.kind == ValueKind::Choice)
    for (std::size_t k = 0; k < setting.field.choices.size(); ++k)
      values.emplace_back(static_cast<double>(k));
  else if (setting.range.high == infinity)
    values.insert(values.end(), {0.5, 7.0});
  else if (setting.field.kind == ValueKind::Number)
    values.insert(values.end(), {0.25 * setting.range.high, 0.75 * setting.range.high});
  else
    values.insert(values.end(), {setting.range.low, setting.range.high});
  return values;
}

const Setting& row(std::string_view option) { return *settingOf(option); }

// No two settings share a key in files, an option or a control.
TEST(SettingRows, AreToldApart) {
  std::set<std::string_view> keys, options;
  std::set<char> controls;
  std::size_t withControl = 0;
  for (const Setting& setting : settingRows()) {
    EXPECT_FALSE(setting.is.empty()) << setting.key;
    EXPECT_FALSE(setting.label.empty()) << setting.key;
    EXPECT_EQ(settingOf(setting.option), &setting);
    keys.insert(setting.key), options.insert(setting.option);
    if (setting.control == 0) continue;
    ++withControl;
    controls.insert(setting.control);
    EXPECT_EQ(settingOf(setting.control), &setting);
  }
  EXPECT_EQ(keys.size(), settingRows().size());
  EXPECT_EQ(options.size(), settingRows().size());
  EXPECT_EQ(controls.size(), withControl);
  EXPECT_EQ(settingOf("--no-such-option"), nullptr);
  EXPECT_EQ(settingOf('\0'), nullptr);
}

// A row writes its own member and no other, and reads back what it wrote.
TEST(SettingRows, HoldTheirOwnMember) {
  for (const Setting& setting : settingRows()) {
    SCOPED_TRACE(setting.key);
    bool changed = false;
    for (const Value& value : someOf(setting)) {
      PictureSettings settings;
      setting.field.set(settings, value);
      EXPECT_EQ(setting.field.get(settings), value);
      changed |= settings != PictureSettings{};
      for (const Setting& other : settingRows())
        if (&other != &setting) {
          EXPECT_EQ(other.field.get(settings), other.field.get(PictureSettings{}));
        }
      setting.field.set(settings, setting.field.get(PictureSettings{}));
      EXPECT_EQ(settings, PictureSettings{});
    }
    EXPECT_TRUE(changed);
  }
}

// The rows reach every member of the settings but size and camera, and but what only the program sets: were
// one forgotten, it could be neither saved nor compared.
TEST(SettingRows, ReachEveryMember) {
  PictureSettings all, expected;
  for (const Setting& setting : settingRows())
    for (const Value& value : someOf(setting))
      if (value != setting.field.get(PictureSettings{})) setting.field.set(all, value);
  EXPECT_NE(all.light, expected.light);
  const auto& [Ia, Ip, ka, kd, ks, n, light, place, attenuation, range, c, form, farL, farV, two, texel,
               mistake] = all.light;
  const Illumination was;
  EXPECT_TRUE(Ia != was.Ia && Ip != was.Ip && ka != was.ka && kd != was.kd && ks != was.ks && n != was.n);
  EXPECT_TRUE(light != was.light && place && attenuation != was.attenuation && range && c);
  EXPECT_TRUE(form != was.form && farL != was.constantL && farV != was.constantV && two != was.twoSided);
  EXPECT_NE(texel, was.texel);
  EXPECT_NE(mistake, was.mistake);
  const auto& [width, height, camera, light1, ownLights, shading, normals, crease, polygons, interpolated,
               raw, adapt, environment, mapping, order, cull, pieces, inPixels, colors, dither, table] = all;
  EXPECT_TRUE(shading != expected.shading && normals != expected.normals && crease != expected.crease);
  EXPECT_TRUE(polygons != expected.polygons && adapt != expected.adapt && mapping != expected.mapping);
  EXPECT_TRUE(interpolated != expected.interpolated && raw != expected.unnormalized);
  EXPECT_TRUE(environment != expected.environment && order != expected.order && cull != expected.cull);
  EXPECT_TRUE(inPixels != expected.inPixels && colors != expected.colors && dither != expected.dither);
  EXPECT_TRUE(width == expected.width && height == expected.height && camera == expected.camera);
  EXPECT_TRUE(&light1 == &all.light && ownLights == expected.lights && pieces == expected.mostPieces);
  const auto& [kind, shades, I0, pick, hue, bits, first, low, high] = table;
  const TableSettings before;
  EXPECT_TRUE(kind != before.kind && shades != before.shades && I0 != before.I0 && pick != before.pick);
  EXPECT_TRUE(hue != before.hue && bits != before.bits);
  EXPECT_TRUE(first == before.first && low == before.low && high == before.high);
}

// Without short cuts, every short cut has its exact value, which it allows, and every model setting stays.
TEST(SettingRows, ShortCutsHaveAnExactValue) {
  PictureSettings all;
  for (const Setting& setting : settingRows())
    for (const Value& value : someOf(setting))
      if (value != setting.field.get(PictureSettings{})) setting.field.set(all, value);
  all.width = 123;
  const PictureSettings exact = withoutShortCuts(all), sameFromDefaults = withoutShortCuts({});
  EXPECT_EQ(exact.width, 123);
  EXPECT_EQ(withoutShortCuts(exact), exact);
  for (const Setting& setting : settingRows()) {
    SCOPED_TRACE(setting.key);
    const Value value = setting.field.get(exact);
    if (!setting.role.isShortCut()) {
      EXPECT_EQ(value, setting.field.get(all));
      continue;
    }
    EXPECT_TRUE(allows(setting, value));
    EXPECT_EQ(value, setting.field.get(sameFromDefaults));
    if (const auto* choice = std::get_if<std::string_view>(&setting.role.exact())) {
      EXPECT_EQ(textOf(setting, value), *choice);
    }
  }
  // How many there are of each kind: a new setting is counted on purpose.
  EXPECT_EQ(std::ranges::count_if(settingRows(), [](const Setting& s) { return s.role.isShortCut(); }), 21);
  EXPECT_EQ(settingRows().size(), 37u);
}

// The defaults are values that the settings allow, and so are those at the ends of a range, unless it is
// open.
TEST(SettingRows, AllowTheirRanges) {
  for (const Setting& setting : settingRows()) {
    SCOPED_TRACE(setting.key);
    for (const Value& value : someOf(setting))
      EXPECT_TRUE(std::holds_alternative<std::monostate>(value) || allows(setting, value));
    EXPECT_FALSE(allows(setting, Value{}));
    EXPECT_FALSE(allows(setting, std::numeric_limits<double>::quiet_NaN()));
    EXPECT_FALSE(allows(setting, glm::dvec3{std::numeric_limits<double>::infinity(), 0, 1}));
  }
  EXPECT_TRUE(allows(row("--ka"), 0.0) && allows(row("--ka"), 1.0));
}

// Where two set-ups are compared, two values of a setting never read alike.
TEST(SettingRows, PhrasesTellValuesApart) {
  for (const Setting& setting : settingRows()) {
    const auto phrase = [&](const Value& value) {
      PictureSettings settings;
      setting.field.set(settings, value);
      return phraseOf(setting, settings);
    };
    const std::vector<Value> values = someOf(setting);
    for (const Value& a : values)
      for (const Value& b : values) EXPECT_EQ(phrase(a) == phrase(b), a == b) << setting.key << phrase(a);
  }
}

// A value's text is read back as the same number: default coefficients are printed from the settings.
TEST(SettingRows, TextsAreShort) {
  const PictureSettings s;
  EXPECT_EQ(textOf(row("--ks"), row("--ks").field.get(s)), "0.4");
  EXPECT_EQ(textOf(row("--shade"), row("--shade").field.get(s)), "flat");
  EXPECT_EQ(textOf(row("--hue"), row("--hue").field.get(s)), "1,0,0");
  EXPECT_EQ(textOf(row("--range"), row("--range").field.get(s)), "");
  for (const double v : {0.1 + 0.2, 1e-300, 1e300, 1.0 / 3.0}) EXPECT_EQ(std::stod(textOf(v)), v);
}

// Ia and Ip: the one that was not set gives way, without the dust of binary fractions, and never less than it
// must.
TEST(SettingRows, IntensitiesKeepWithinOne) {
  const auto kept = [](double Ia, double Ip, bool IaSet) {
    Illumination light{.Ia = Ia, .Ip = Ip};
    EXPECT_TRUE(keepWithinOne(light, IaSet, !IaSet));
    EXPECT_LE(light.Ia + light.Ip, 1.0);
    return IaSet ? light.Ip : light.Ia;
  };
  EXPECT_EQ(kept(0.9, 0.7, true), 0.1);
  EXPECT_EQ(kept(0.2, 0.9, false), 0.1);
  EXPECT_EQ(kept(0.2, 0.7, true), 0.7);
  for (int k = 1; k < 1000; ++k) EXPECT_NEAR(kept(k / 1000.0 + 1e-10, 1.0, true), 1 - k / 1000.0, 1e-9);
  Illumination light{.Ia = 0.6, .Ip = 0.6};
  EXPECT_FALSE(keepWithinOne(light, true, true));
}

// A list of overrides sets what it names, the last value of each. What is given also decides what gives way:
// Ia or Ip, and a light's position with its attenuation when only a direction is given.
TEST(SettingRows, OverridesAreAppliedAsAList) {
  PictureSettings s;
  s.light.lightPosition = glm::dvec3{1, 2, 3}, s.light.attenuation = Attenuation::Inverse;
  const Override up{&row("--light"), glm::dvec3{0, 0, 1}}, at{&row("--light-at"), glm::dvec3{4, 5, 6}};
  const Override inverse{&row("--attenuation"), 1.0}, none{&row("--attenuation"), {}};
  const auto with = [&](const std::vector<Override>& list) {
    PictureSettings changed = s;
    EXPECT_TRUE(applyOverrides(changed, list));
    return changed.light;
  };
  EXPECT_EQ(applyOverrides(s, {}), true);
  EXPECT_EQ(with({}), s.light);
  EXPECT_EQ(with({up}).light, (glm::dvec3{0, 0, 1}));
  EXPECT_FALSE(with({up}).lightPosition || with({up}).attenuation);
  EXPECT_EQ(with({up, inverse}).attenuation, Attenuation::Inverse);
  EXPECT_EQ(with({at, up}).lightPosition, (glm::dvec3{4, 5, 6}));
  EXPECT_EQ(with({at, up}).attenuation, Attenuation::Inverse);
  EXPECT_FALSE(with({inverse, none}).attenuation);
  s.light.attenuation = Attenuation::Linear, s.light.range = 5;
  EXPECT_EQ(with({at}).range, 5);
  EXPECT_FALSE(with({inverse}).range);
  EXPECT_EQ(with({{&row("--ia"), 1.0}}).Ip, 0.0);
  EXPECT_EQ(with({{&row("--ip"), 1.0}}).Ia, 0.0);
  EXPECT_FALSE(applyOverrides(s, {{&row("--ia"), 0.6}, {&row("--ip"), 0.6}}));
}

/// ---- Scenes that are saved

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
  const unsigned kind = rng() % 4;
  if (kind == 0 && !c.window) c.fov = number(1, 179);
  c.parallel = kind == 1 || kind == 2;
  if (kind == 1) c.height = number(0.1, 9);
  if (kind == 3) c.oblique = Oblique{some() ? 0.5 : 1.0, number(0, 90)};
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

// A saved scene sets up the same scene in the same way, bit for bit, for any settings, also if the scene's
// units are not the file's. From the scene's own camera it paints what was saved, cell for cell and colour
// for colour: so for scenes with their own lights, textures, several hues and patches.
TEST(SaveScene, ReadsBackAsItWas) {
  std::mt19937 rng{5};
  const TemporaryFolder folder;
  const std::string far = folder.write("far.obj", "v 0 0 0\nv 3e9 0 0\nv 0 3e9 1\nf 1 2 3\n");
  int undivided = 0, shown = 0, pictures = 0;
  for (const std::string& name :
       {std::string{"teapot"}, std::string{"cycle"}, far, std::string{"hues"}, std::string{"colored-lights"},
        std::string{"textured-cube"}, std::string{"spotlight"}, std::string{"lamp"}}) {
    const Scene scene = readScene(name, 3);
    PictureCache original{scene};
    for (int trial = 0; trial < (kSanitized ? 40 : 160); ++trial) {
      PictureSettings settings = randomSettings(rng);
      const bool paints = trial % 4 == 0 && name != far;
      if (paints) {
        settings.camera = scene.camera;
        if (scene.light.placed() && !settings.light.lightPosition)  // of the scene's own lights
          settings.light.attenuation = kAttenuations[rng() % kAttenuations.size()].id;
        settings.table.shades = std::max(settings.table.shades, 14);  // two for each of seven hues
      }
      const std::string text = savedScene(scene, settings, folder.path());
      SCOPED_TRACE(text);
      PictureCache again{parseSceneFile(text, "saved.json", folder.path(), 8)};
      ASSERT_EQ(again.scene().mesh.points, scene.mesh.points);
      EXPECT_EQ(again.scene().origin.of.substr(again.scene().origin.of.find_last_of('/') + 1),
                name.substr(name.find_last_of('/') + 1));
      PictureSettings back = opened(again.scene());
      ASSERT_EQ(back.camera, settings.camera);
      ASSERT_EQ(back.light, settings.light);
      ASSERT_EQ(back.table, settings.table);
      ASSERT_EQ(back, settings);
      if (!paints) continue;
      settings.width = back.width = 64, settings.height = back.height = 48;
      const Picture saved = original.make(settings, 0), read = again.make(back, 0);
      ASSERT_EQ(read.image().pixels, saved.image().pixels);
      ASSERT_EQ(read.palette(CellPlan{}, {}), saved.palette(CellPlan{}, {}));
      ASSERT_EQ(read.saturated(), saved.saturated());
      ++pictures, undivided += settings.adapt == 0.0;
      shown += std::ranges::count(saved.image().pixels, 0) < std::ssize(saved.image().pixels);
    }
  }
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

}  // namespace

}  // namespace xnewell::THIS_FILE
