#include "x11/window/setting_controls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace xnewell::THIS_FILE {

namespace {

/// The control of a key, which changes `setup`.
Control controlOf(char key, xnewell::Setup& setup) {
  return settingControl(key, setup, setup, [&setup](char, const auto& edit) { edit(setup); });
}
void stepBy(xnewell::Setup& setup, char key, int steps) {
  const Control control = controlOf(key, setup);
  control.set(stepped(control.range, control.value, steps));
}
/// The controls of all settings that have a track.
Controls sliders() {
  Controls all;
  xnewell::Setup s;
  for (const Setting& setting : settingRows())
    if (setting.slider) all.push_back(controlOf(setting.control, s));
  return all;
}
}  // namespace

// Ia and Ip push each other: their sum never exceeds 1, and pushing back leaves no dust.
TEST(Controls, IntensitiesPushEachOther) {
  xnewell::Setup s;
  for (int k = 0; k <= 100; ++k) {
    controlOf('i', s).set(k / 100.0);
    ASSERT_LE(s.picture.light.Ia + s.picture.light.Ip, 1.0);
    ASSERT_EQ(s.picture.light.Ia, k / 100.0);
  }
  EXPECT_EQ(s.picture.light.Ip, 0.0);
  controlOf('p', s).set(0.3);
  EXPECT_EQ(s.picture.light.Ia, 0.7);
  controlOf('p', s).set(0.1);
  EXPECT_EQ(s.picture.light.Ia, 0.7);  // with room to spare nobody is pushed
}

// A control of a setting has the setting's own words, and acts on it alone.
TEST(Controls, AreRowsOfSettings) {
  std::size_t controls = 0;
  for (const Setting& setting : settingRows()) {
    if (setting.control == 0) continue;
    SCOPED_TRACE(setting.option);
    ++controls;
    xnewell::Setup s;
    const Control control = controlOf(setting.control, s);
    EXPECT_EQ(control.is, setting.is);
    if (setting.key == "fill") continue;
    const Value before = setting.field.get(s.picture);
    if (control.kind == Control::Kind::Slider)
      control.set(stepped(control.range, control.value, control.value == control.range.high ? -1 : 1));
    else
      activate(control);
    EXPECT_NE(setting.field.get(s.picture), before);
    setting.field.set(s.picture, before);
    EXPECT_EQ(s, xnewell::Setup{});
  }
  const xnewell::Setup s;
  EXPECT_EQ(controls + 2, settingControls(s, s, {}, readScene("teapot")).size());  // with P and W
}

// A slider without effect is off and says why in the one pattern of such sentences.
TEST(Controls, AreOffWithoutEffect) {
  xnewell::Setup s;
  EXPECT_EQ(controlOf('o', s).off, "I0 has no effect here; it applies to ramps of the corrected table.");
  s.picture.table.kind = TableKind::Corrected;
  EXPECT_TRUE(controlOf('o', s).enabled());
  EXPECT_TRUE(controlOf('n', s).enabled());
  s.picture.light.ks = 0;
  EXPECT_FALSE(controlOf('n', s).enabled());
  EXPECT_TRUE(controlOf('a', s).enabled());
  s.picture.shading = Shading::Depth;
  for (const char key : std::string{"ipadsn"}) EXPECT_FALSE(controlOf(key, s).enabled()) << key;
}

// A slider's steps lead from end to end and back. Every step moves it, and it stays in its range.
TEST(Controls, StepsReachBothEnds) {
  for (const Control& row : sliders()) {
    SCOPED_TRACE(row.key);
    xnewell::Setup s;
    const auto now = [&] { return controlOf(row.key, s).value; };
    s.picture.light.Ia = s.picture.light.Ip = 0;
    s.picture.table.kind = TableKind::Corrected;
    controlOf(row.key, s).set(row.range.low);
    int steps = 0;
    for (double before = -1; now() != before && steps < 5000; ++steps) {
      before = now();
      stepBy(s, row.key, 1);
      ASSERT_GE(now(), before);
    }
    EXPECT_EQ(now(), row.range.high);
    EXPECT_GT(steps, 50);
    stepBy(s, row.key, -100'000);
    EXPECT_EQ(now(), row.range.low);
  }
}

// The place on a track and the value there belong together, on linear and logarithmic tracks.
TEST(Controls, TracksInvert) {
  for (const Control& row : sliders()) {
    const TrackRange& range = row.range;
    for (int k = 0; k <= 50; ++k) {
      const double v = valueAt(range, k / 50.0);
      EXPECT_GE(v, range.low);
      EXPECT_LE(v, range.high);
      EXPECT_EQ(valueAt(range, shareOf(range, v)), v) << row.label;
    }
  }
}

// Azimuth and elevation, worked by hand: the default light comes from the upper left. Turns by degrees add
// up, stop at the zenith and wrap at 180.
TEST(Controls, LightAngles) {
  for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
    Light light;
    light.direction = up == UpAxis::Z ? glm::dvec3{-1, -1, 0} : glm::dvec3{-1, 0, 1};
    EXPECT_NEAR(lightAngles(light, up).azimuth, -45, 1e-12);
    EXPECT_NEAR(lightAngles(light, up).elevation, 0, 1e-12);
    turnLight(light, up, 60, 30);
    EXPECT_NEAR(lightAngles(light, up).azimuth, 15, 1e-9);
    EXPECT_NEAR(lightAngles(light, up).elevation, 30, 1e-9);
    turnLight(light, up, 170, 0);
    EXPECT_NEAR(lightAngles(light, up).azimuth, -175, 1e-9);
    turnLight(light, up, 0, 500);
    EXPECT_NEAR(lightAngles(light, up).elevation, 90, 1e-6);
  }
}

// No two controls share a key, and no control has the key of an action.
TEST(Controls, KeysAreUnique) {
  std::set<char> keys;
  std::size_t count = 0;
  const xnewell::Setup s;
  for (const Control& row : settingControls(s, s, {}, readScene("teapot"))) keys.insert(row.key), ++count;
  for (const char acts : std::string_view{"ltzqurU?[]+-="}) keys.insert(acts), ++count;
  EXPECT_EQ(keys.size(), count);
}

// After the last hue comes the first.
TEST(Controls, HuesGoRound) {
  xnewell::Setup s;
  const glm::dvec3 first = s.picture.table.hue;
  for (std::size_t i = 0; i < controlOf('H', s).options.size(); ++i) activate(controlOf('H', s));
  EXPECT_EQ(s.picture.table.hue, first);
  s.picture.table.hue = {1, 0.123, 0};
  activate(controlOf('H', s));
  EXPECT_EQ(controlOf('H', s).value, 0);
}

// A shade slider and an exponent are whole numbers.
TEST(Controls, WholeNumbersStayWhole) {
  for (const char key : {'n', 'c'}) {
    xnewell::Setup s;
    for (int k = 0; k < 30; ++k) {
      stepBy(s, key, -1);
      EXPECT_EQ(controlOf(key, s).value, std::round(controlOf(key, s).value));
    }
  }
}

// A point light turns about the scene's centre and keeps its distance.
TEST(Controls, PointLightKeepsItsDistance) {
  Light light{.kind = LightKind::Point};
  const glm::dvec3 centre{1, 2, 3};
  light.position = centre + glm::dvec3{0, -4, 3};
  EXPECT_NEAR(lightAngles(light, UpAxis::Z, centre).azimuth, 0, 1e-12);
  turnLight(light, UpAxis::Z, 90, 0, centre);
  const glm::dvec3 arm = light.position - centre;
  EXPECT_NEAR(std::sqrt(arm.x * arm.x + arm.y * arm.y + arm.z * arm.z), 5, 1e-12);
  EXPECT_NEAR(lightAngles(light, UpAxis::Z, centre).azimuth, 90, 1e-9);
}

}  // namespace xnewell::THIS_FILE
