#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/x11/support/ready_workbench.h"
#include "tests/x11/support/staged_view.h"
#include "x11/views/cell_facts.h"
#include "x11/window/picture_view.h"
#include "x11/window/setting_controls.h"

namespace xnewell::THIS_FILE {

namespace {

glm::dvec2 thumbsOf(const Workbench& b) {
  const Illumination& light = b.setup().picture.light;
  return {light.Ia, light.Ia + light.Ip};
}
ControlColumn columnOf(const Workbench& b) {
  return layoutOfControls(b.layout(), b.bench().controls(), thumbsOf(b));
}
const ControlPlace& placeOf(const Workbench& b, char key) { return *b.bench().list().find({key}); }
const Control& withKey(const Controls& controls, char key) {
  return *std::ranges::find(controls, key, &Control::key);
}
Control controlOf(const Workbench& b, char key) { return withKey(b.bench().controls(), key); }
glm::ivec2 middle(const Rect& r) { return {r.x + r.width / 2, r.y + r.height / 2}; }

void click(ReadyWorkbench& b, glm::ivec2 at) { b.click(at.x, at.y); }

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

// The controls under the pointer, and values that are typed.

// Every setting has its place in the column of controls, at every size of window.
TEST(ControlColumn, EveryControlHasItsPlace) {
  for (const auto& [w, h] :
       {std::pair{800, 540}, {800, 570}, {800, 599}, {800, 600}, {1023, 768}, {1024, 768}, {1600, 1200}}) {
    SCOPED_TRACE(w);
    const ReadyWorkbench b{{}, w, h};
    for (const auto& [id, place] : columnOf(b).places)
      EXPECT_EQ(intersection(place.area, {b.layout().controls.x, 0, w, b.layout().strip.y}), place.area)
          << id.key;
    for (const char key : {'l', 'P', 'W'}) EXPECT_TRUE(b.bench().list().find({key})) << key;
    for (const Setting& row : settingRows()) {
      const bool hasRoom = row.section != Section::Hidden && !(h < 600 && row.control == 'R');
      EXPECT_TRUE(!hasRoom || b.bench().list().find({row.control})) << row.label;
    }
  }
}

// The status line says what the control under the pointer is for, in whole words, and ends in the window.
TEST(PictureView, SaysWhatAControlIsForAsFarAsTheWindowReaches) {
  for (const auto& [w, h] : {std::pair{1024, 768}, {1152, 864}, {1920, 1080}}) {
    SCOPED_TRACE(w);
    ReadyWorkbench b{{}, w, h};
    for (const auto& [id, place] : columnOf(b).places) {
      const glm::ivec2 m = middle(place.area);
      b.pointAt(m.x, m.y);
      const WindowView& bench = b.bench();
      const std::string line = bench.status() + "   " + bench.aside();
      EXPECT_LE(16 + textWidth(line) + 16, w) << line;
      const Controls controls = b.bench().controls();
      EXPECT_NE(line.find(withKey(controls, id.key).is), std::string::npos) << id.key << ": " << line;
    }
  }
}

// Esc and the first drag end the opening page, and h brings it back. Beside it are few controls until D.
TEST(PictureView, OpensWithSentencesThatAreButtons) {
  ReadyWorkbench b;
  b.welcome();
  b.finish();
  const auto shows = [&](const ControlId& id) { return b.bench().list().find(id) != nullptr; };
  EXPECT_FALSE(shows({'F'}));
  for (const char key : {'l', 's', 'n', 'S', 'O'}) EXPECT_TRUE(shows({key})) << key;
  b.drag(30, 10);
  b.settle();
  b.finish();
  EXPECT_FALSE(shows({0, 100}));
  b.does('h');
  EXPECT_TRUE(shows({0, 100}));
  b.does(NamedKey::Escape);
  EXPECT_FALSE(shows({0, 100}));
  b.does('D');
  EXPECT_TRUE(shows({'F'}));
}

// A slider goes where its thumb is dragged, and stops at its ends if the pointer goes beyond. A drag is one
// undo step.
TEST(PictureView, SlidersAreDragged) {
  for (const Setting& row : settingRows()) {
    if (!row.slider || row.control == 'i' || row.control == 'p') continue;
    SCOPED_TRACE(row.label);
    xnewell::Setup setup;
    setup.picture.table.kind = TableKind::Corrected;  // otherwise I0 is off, and the crease angle
    setup.picture.shading = Shading::Gouraud, setup.picture.normals = NormalRule::Sum;
    ReadyWorkbench b{setup};
    const Rect track = placeOf(b, row.control).track;
    ASSERT_TRUE(b.grab(track.x + track.width / 4, track.y));
    const Control control = controlOf(b, row.control);
    EXPECT_NEAR(shareOf(control.range, control.value), 0.25, 0.02);
    b.update(true);
    b.dragTo(track.x + track.width + 500, track.y - 90);
    EXPECT_EQ(controlOf(b, row.control).value, row.slider->high);
    b.dragTo(-500, track.y);
    EXPECT_EQ(controlOf(b, row.control).value, row.slider->low);
    b.settle();
    b.update();
    b.type("u");
    EXPECT_EQ(b.setup(), setup);
  }
}

// Ia and Ip push each other on one bar. Their sum never exceeds 1, wherever either thumb is dragged, and each
// thumb follows the pointer.
TEST(PictureView, IntensitiesPushEachOther) {
  ReadyWorkbench b;
  const Rect bar = columnOf(b).bar;
  const auto at = [&](double v) { return bar.x + static_cast<int>(std::lround(v * (bar.width - 1))); };
  const auto light = [&]() -> const Illumination& { return b.setup().picture.light; };
  for (const char key : {'i', 'p'})
    for (const double from : {0.0, 0.3, 0.9})
      for (int k = -5; k <= 105; k += 5) {
        SCOPED_TRACE(key + std::to_string(k));
        b.type("r");
        const double thumb = light().Ia + (key == 'p' ? light().Ip : 0);
        ASSERT_TRUE(b.grab(at(thumb), bar.y));
        b.dragTo(at(from), bar.y);
        b.dragTo(at(k / 100.0), bar.y + 30);
        b.settle();
        EXPECT_LE(light().Ia + light().Ip, 1.0);
        EXPECT_GE(std::min(light().Ia, light().Ip), 0.0);
        EXPECT_NEAR(light().Ia + (key == 'p' ? light().Ip : 0), std::clamp(k / 100.0, 0.0, 1.0), 0.0051);
      }
}

// Toggles and buttons do what their keys do.
TEST(PictureView, ButtonsAreKeys) {
  for (const char key : {'L', 'V', '[', ']', 'u', 'r', 'U'}) {
    SCOPED_TRACE(key);
    ReadyWorkbench clicked, typed;
    for (ReadyWorkbench* b : {&clicked, &typed}) b->type("TSu");
    click(clicked, middle(placeOf(clicked, key).area));
    typed.type({&key, 1});
    EXPECT_EQ(clicked.setup(), typed.setup());
  }
}

// The light comes from where it is dropped on the ball: from the viewer in the middle, from the side at the
// rim, and from behind outside the rim. The ring is drawn at that place.
TEST(PictureView, TheLightIsDragged) {
  for (const char* scene : {"teapot", "cycle"}) {
    ReadyWorkbench b{{}, 1024, 768, scene};
    const ControlColumn at = columnOf(b);
    const glm::ivec2 centre{at.ball.x + at.ball.width / 2, at.ball.y + at.ball.height / 2};
    ASSERT_TRUE(b.grab(centre.x, centre.y));
    const auto towardsEye = [&] {
      const Camera& camera = b.picture().camera();
      return glm::dot(glm::normalize(b.setup().picture.light.light),
                      glm::normalize(camera.eye - camera.lookAt));
    };
    EXPECT_NEAR(towardsEye(), 1, 1e-9);
    b.dragTo(centre.x + at.radius, centre.y);
    EXPECT_NEAR(towardsEye(), 0, 1e-9);
    b.dragTo(centre.x + at.radius + at.radius / 2, centre.y);
    EXPECT_LT(towardsEye(), -0.8);
    b.dragTo(centre.x - 20, centre.y - 31);
    b.settle();
    b.update();
    EXPECT_EQ(b.image().row(centre.y - 31)[centre.x - 20], b.plan()[Cell::White]);
  }
}

// q is no part of a number, and no key of the window while something is typed. The close button acts even
// then.
TEST(PictureView, QIsNoKeyWhileAValueIsTyped) {
  ReadyWorkbench b;
  b.type("n=q");
  EXPECT_FALSE(b.quitAsked());
  b.askToQuit();
  EXPECT_TRUE(b.quitAsked());
}

// The strip tells about what is shown in the picture's place: its cells, and what they hold.
TEST(PictureView, TheStripIsOfWhatIsShown) {
  for (const View show : {View::Picture, View::Wireframe, View::Normals, View::Overdraw}) {
    SCOPED_TRACE(static_cast<int>(show));
    xnewell::Setup setup;
    setup.show = show;
    StagedView stage{"teapot", 3, 1024, 768, setup};
    PictureView bench{stage, [&] { return Subject{stage.pictures.scene(), {}, 1.0}; }};
    stage.draw(bench);
    const CellUse shaded = cellUse(stage.pictures.last().image());
    ASSERT_EQ(bench.use() == nullptr, show == View::Picture);
    if (bench.use() != nullptr) {
      EXPECT_NE(bench.use()->samples, shaded.samples);
    }
    ASSERT_EQ(bench.colors() == nullptr, show != View::Normals);
    if (show != View::Normals) continue;
    const SceneCellWords& words = bench.colors()->words.value();
    EXPECT_EQ(words.what, "colours");
    EXPECT_EQ(usedCells(*bench.use(), words.cells), words.cells.count);
    EXPECT_EQ(words.cells.first, stage.pictures.last().colors().table().first());
  }
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

// A slider's steps lead from end to end and back. Every step moves it, and it stays in its range; whole
// numbers stay whole.
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
      ASSERT_TRUE((row.key != 'n' && row.key != 'c') || now() == std::round(now()));
    }
    EXPECT_EQ(now(), row.range.high);
    EXPECT_GT(steps, 50);
    stepBy(s, row.key, -100'000);
    EXPECT_EQ(now(), row.range.low);
  }
}

// Azimuth and elevation, worked by hand: the default light comes from the upper left. Turns by degrees add
// up, stop at the zenith and wrap at 180. A point light turns about the scene's centre and keeps its
// distance.
TEST(Controls, LightAngles) {
  for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
    Light light;
    light.direction = up == UpAxis::Z ? glm::dvec3{-1, -1, 0} : glm::dvec3{-1, 0, 1};
    const auto expectAngles = [&](double azimuth, double elevation, double bound) {
      EXPECT_NEAR(lightAngles(light, up).azimuth, azimuth, bound);
      EXPECT_NEAR(lightAngles(light, up).elevation, elevation, bound);
    };
    expectAngles(-45, 0, 1e-12);
    turnLight(light, up, 60, 30);
    expectAngles(15, 30, 1e-9);
    turnLight(light, up, 170, 0);
    expectAngles(-175, 30, 1e-9);
    turnLight(light, up, 0, 500);
    EXPECT_NEAR(lightAngles(light, up).elevation, 90, 1e-6);
  }
  Light light{.kind = LightKind::Point};
  const glm::dvec3 centre{1, 2, 3};
  light.position = centre + glm::dvec3{0, -4, 3};
  EXPECT_NEAR(lightAngles(light, UpAxis::Z, centre).azimuth, 0, 1e-12);
  turnLight(light, UpAxis::Z, 90, 0, centre);
  EXPECT_NEAR(glm::distance(light.position, centre), 5, 1e-12);
  EXPECT_NEAR(lightAngles(light, UpAxis::Z, centre).azimuth, 90, 1e-9);
}

}  // namespace xnewell::THIS_FILE
