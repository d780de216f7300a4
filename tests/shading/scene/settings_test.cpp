#include "shading/scene/settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace xnewell::THIS_FILE {

namespace {

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

}  // namespace

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
  EXPECT_FALSE(allows(row("--ka"), -0.001) || allows(row("--ka"), 1.001));
  EXPECT_FALSE(allows(row("--i0"), 0.0) || allows(row("--i0"), 1.0));
  EXPECT_FALSE(allows(row("--n"), 2.5));
  EXPECT_FALSE(allows(row("--light"), glm::dvec3{0}));
  EXPECT_FALSE(allows(row("--hue"), glm::dvec3{0.5, 0.5, 0.5}));
  EXPECT_FALSE(allows(row("--range"), 0.0));
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

// What is expected is said in words that fit behind "is not" and before "is needed".
TEST(SettingRows, SayWhatTheyExpect) {
  EXPECT_EQ(expected(row("--ka")), "a number from 0 to 1");
  EXPECT_EQ(expected(row("--i0")), "a number between 0 and 1");
  EXPECT_EQ(expected(row("--range")), "a number above 0");
  EXPECT_EQ(expected(row("--shades")), "a whole number from 2 to 240");
  EXPECT_EQ(expected(row("--pick")), "one of log, search");
  EXPECT_EQ(expected(row("--light-at")), "three finite numbers x,y,z");
  EXPECT_EQ(expected(row("--hue")), "three finite numbers r,g,b from 0 to 1, where the largest is 1");
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

}  // namespace xnewell::THIS_FILE
