#include "x11/window/picture_view.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/x11/support/ready_workbench.h"
#include "tests/x11/support/staged_view.h"
#include "x11/views/cell_facts.h"

namespace xnewell::THIS_FILE {

// The controls under the pointer, and values that are typed.

namespace {

using Kind = Control::Kind;

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

void click(ReadyWorkbench& b, glm::ivec2 at) {
  (void)b.grab(at.x, at.y);
  b.settle();
  b.update();
}

}  // namespace

// No two controls share a pixel, all lie inside the column, and a click in the middle of each row finds the
// control with its key. This holds at every size of window.
TEST(ControlColumn, EveryControlHasItsPlace) {
  for (const auto& [w, h] :
       {std::pair{800, 540}, {800, 570}, {800, 599}, {800, 600}, {1023, 768}, {1024, 768}, {1600, 1200}}) {
    SCOPED_TRACE(w);
    const ReadyWorkbench b{{}, w, h};
    const Layout& layout = b.layout();
    const ControlColumn at = columnOf(b);
    WindowView& bench = b.bench();
    for (std::size_t p = 0; p < at.places.size(); ++p) {
      const auto& [id, place] = at.places[p];
      EXPECT_LE(place.area.y + place.area.height, layout.strip.y) << id.key;
      EXPECT_GE(place.area.x, layout.controls.x);
      EXPECT_LE(place.area.x + place.area.width, w);
      const glm::ivec2 m = middle(place.area);
      bench.hover(m.x, m.y);
      const Controls controls = bench.controls();
      const Control* const hit = bench.list().hovered(controls);
      ASSERT_TRUE(hit);
      EXPECT_EQ(hit->key, id.key);
      for (std::size_t q = 0; q < p; ++q)
        EXPECT_TRUE(intersection(place.area, at.places[q].second.area).empty()) << id.key;
    }
    for (const char key : {'l', 'P', 'W'}) EXPECT_TRUE(bench.list().find({key})) << key;
    for (const Setting& row : settingRows()) {
      const bool hasRoom = row.section != Section::Hidden && !(h < 600 && row.control == 'R');
      EXPECT_TRUE(!hasRoom || bench.list().find({row.control})) << row.label;
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
      b.hover(m.x, m.y);
      b.update();
      const WindowView& bench = b.bench();
      const std::string line = bench.status() + "   " + bench.aside();
      EXPECT_LE(16 + textWidth(line) + 16, w) << line;
      const Controls controls = b.bench().controls();
      EXPECT_NE(line.find(withKey(controls, id.key).is), std::string::npos) << id.key << ": " << line;
    }
  }
}

// The opening page: each sentence and door does what it says, Esc and the first drag end it, and h brings it
// back. Beside it are few controls until D.
TEST(PictureView, OpensWithSentencesThatAreButtons) {
  const std::vector<std::pair<int, View>> leads{{100, View::Picture},
                                                {101, View::Picture},
                                                {102, View::Pixel},
                                                {103, View::Lesson},
                                                {104, View::Picture}};
  for (const auto& [part, view] : leads) {
    SCOPED_TRACE(part);
    ReadyWorkbench b;
    b.welcome();
    b.finish();
    EXPECT_FALSE(b.bench().list().find({'F'}));
    for (const char key : {'l', 's', 'n', 'S', 'O'}) EXPECT_TRUE(b.bench().list().find({key})) << key;
    const ControlPlace* const place = b.bench().list().find({0, part});
    ASSERT_TRUE(place);
    click(b, middle(place->area));
    b.finish();
    EXPECT_EQ(b.view(), view);
    EXPECT_EQ(b.setup() != b.defaults(), part <= 102);
    EXPECT_EQ(b.isAsking(), part == 104);
  }
  ReadyWorkbench b;
  b.welcome();
  b.finish();
  b.drag(30, 10);
  b.settle();
  b.finish();
  EXPECT_FALSE(b.bench().list().find({0, 100}));
  b.does('h');
  EXPECT_TRUE(b.bench().list().find({0, 100}));
  b.does(NamedKey::Escape);
  EXPECT_FALSE(b.bench().list().find({0, 100}));
  b.does('D');
  EXPECT_TRUE(b.bench().list().find({'F'}));
}

// If the column is too low for its controls, the rows are closer together, and still none shares a pixel.
TEST(ControlColumn, FitsALowerColumn) {
  for (const auto& [w, h] : {std::pair{800, 600}, {1024, 768}}) {
    SCOPED_TRACE(w);
    const ReadyWorkbench b{{}, w, h};
    Layout layout = b.layout();
    const ControlColumn usual = columnOf(b);
    const auto heightOf = [](const ControlColumn& column) {
      const auto found =
          std::ranges::find(column.places, ControlId{'a'}, [](const auto& one) { return one.first; });
      return found->second.area.height;
    };
    const auto bottom = [](const ControlColumn& column) {
      const Rect& last = column.places.back().second.area;
      return last.y + last.height;
    };
    layout.controls.height = bottom(usual) - layout.controls.y - heightOf(usual);
    const ControlColumn at = layoutOfControls(layout, b.bench().controls(), thumbsOf(b));
    EXPECT_LT(heightOf(at), heightOf(usual));
    EXPECT_LE(bottom(at), layout.controls.y + layout.controls.height);
    for (std::size_t p = 0; p < at.places.size(); ++p)
      for (std::size_t q = 0; q < p; ++q)
        EXPECT_TRUE(intersection(at.places[p].second.area, at.places[q].second.area).empty());
  }
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

// A click on the name of a slider gives it the keyboard and changes nothing.
TEST(PictureView, NamesTakeTheKeyboard) {
  xnewell::Setup setup;
  setup.picture.table.kind = TableKind::Corrected;  // otherwise I0 is off
  ReadyWorkbench b{setup};
  const xnewell::Setup before = b.setup();
  for (const Setting& row : settingRows()) {
    if (!row.slider) continue;
    const Rect place = placeOf(b, row.control).area;
    EXPECT_FALSE(b.grab(place.x + 30, place.y + 5)) << row.label;
    EXPECT_EQ(b.setup(), before);
    b.press({NamedKey::End});
    EXPECT_EQ(controlOf(b, row.control).value, row.slider->high) << row.label;
    b.type("r");
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

// A click on an option chooses it. A click on the name of its row chooses the next one.
TEST(PictureView, OptionsAreClicked) {
  ReadyWorkbench b;
  int taken = 0;
  const Controls controls = b.bench().controls();
  for (const Control& row : controls) {
    if (row.kind != Kind::Choice || !b.bench().list().find(row.id())) continue;
    const ControlPlace place = placeOf(b, row.key);
    const auto now = [&] { return static_cast<int>(controlOf(b, row.key).value); };
    for (int k = 0; k < static_cast<int>(row.options.size()); ++k) {
      SCOPED_TRACE(row.label);
      b.type("r");
      click(b, middle(place.options[k]));
      if (row.key == 'F' && k == 0) {
        EXPECT_EQ(b.setup().fill, Fill::XFillPolygon);
      }
      EXPECT_EQ(now(), k);
      ++taken;
    }
    const auto next = controlOf(b, row.key).next;
    const int due = next ? static_cast<int>(*next) : (now() + 1) % static_cast<int>(row.options.size());
    click(b, {place.area.x + 30, place.area.y + 5});
    EXPECT_EQ(now(), due);
  }
  EXPECT_GT(taken, 20);
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

// The control under the pointer looks different, and as before when the pointer leaves.
TEST(PictureView, HoverShowsAndPasses) {
  ReadyWorkbench b;
  const auto aboveStatus = [&] {  // the status line tells times
    const std::uint8_t* const pixels = b.image().pixels.data();
    return std::vector<std::uint8_t>(pixels, pixels + std::ptrdiff_t{1024} * b.layout().status.y);
  };
  const std::vector<std::uint8_t> before = aboveStatus();
  int shown = 0;
  const Controls controls = b.bench().controls();
  for (const auto& [id, place] : columnOf(b).places) {
    const Kind kind = std::ranges::find(controls, id, &Control::id)->kind;
    if (std::string_view{"lipoR"}.find(id.key) != std::string_view::npos) continue;
    SCOPED_TRACE(id.key);
    const glm::ivec2 m = kind == Kind::Choice ? middle(place.options.back()) : middle(place.area);
    if (kind == Kind::Choice && id.key != 'O' && id.key != 'T')
      continue;  // the last option is chosen already
    b.hover(m.x, m.y);
    b.update();
    EXPECT_NE(aboveStatus(), before);
    b.hover(300, 300);
    b.update();
    EXPECT_EQ(aboveStatus(), before);
    ++shown;
  }
  EXPECT_GT(shown, 10);
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

// What the scene has of its own cannot be changed, so its controls are off, and the caption has the shades
// that each hue has.
TEST(PictureView, WhatTheSceneHasIsOff) {
  ReadyWorkbench own{{}, 1024, 768, "spotlight"}, usual;
  for (const char key : {'l', 'i', 'p'}) {
    EXPECT_TRUE(withKey(usual.bench().controls(), key).enabled()) << key;
    EXPECT_EQ(withKey(own.bench().controls(), key).enabled(), key != 'i') << key;
  }
  const ReadyWorkbench hues{{}, 1024, 768, "hues"};
  const std::size_t ramps = hues.picture().colors().tables().size();
  const std::string each = std::to_string(hues.picture().colors().tables().front().shades());
  EXPECT_TRUE(shadesText(hues.picture()).starts_with(each + " ")) << shadesText(hues.picture());
  EXPECT_TRUE(shadesText(hues.picture()).ends_with("for each of " + std::to_string(ramps) + " hues"));
}

}  // namespace xnewell::THIS_FILE
