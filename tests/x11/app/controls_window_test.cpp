#include <gtest/gtest.h>

#include "tests/support/seeds.h"
#include "tests/x11/support/twin_window.h"

namespace xnewell::THIS_FILE {

// Every control of the picture's view, every key, and resizes on real servers. Keys and mouse come in as a
// user's do. The window must show what a workbench without a server shows after the same input.

namespace {

/// Times differ between two windows: sides_test.cpp and trade_view_test.cpp look at these views.
bool showsTimes(View view) { return view == View::SideBySide || view == View::Trade; }

/// Uses the corrected table, so that no slider is off.
const std::string kCorrected = "teapot --divisions 3 --table corrected";
xnewell::Setup corrected() {
  xnewell::Setup setup;
  setup.picture.table.kind = TableKind::Corrected;
  return setup;
}

// Sliders, both thumbs of the bar and the ball of the light follow a drag. Each option of each choice, each
// box and each button responds to a click.
void expectAllToAnswer(TwinWindow& twin) {
  int dragged = 0, clicked = 0;
  const auto places = twin.same.bench().list().places();
  ASSERT_GE(places.size(), 20u);
  for (const auto& [id, place] : places) {
    SCOPED_TRACE(id.key);
    // F: other pixels; w and e ask for a file; D moves all others away; R: the normals of patches have no
    // crease
    if (std::string_view{"FweDR"}.find(id.key) != std::string_view::npos) continue;
    const xnewell::Setup before = twin.same.setup();
    const bool drags = !place.grip.empty();
    if (drags) {
      const Rect& grip = place.grip;
      const int x = grip.x + grip.width / 2, y = grip.y + grip.height / 2;
      twin.drag(x, y, x + 30, y - 20);
    } else if (place.options.empty()) {
      twin.click(place.area);
    } else {
      for (const Rect& option : place.options) {
        twin.click(option);
        ASSERT_TRUE(twin.agrees());
        ++clicked;
      }
      twin.click({place.x, place.area.y, 20, place.area.height});
    }
    ASSERT_TRUE(twin.agrees());
    if (drags) {
      EXPECT_NE(twin.same.setup(), before);
    }
    ++(drags ? dragged : clicked);
    twin.type("r");
    ASSERT_TRUE(twin.agrees());  // the next drag acts on what is drawn: the ball is seen by the camera
  }
  EXPECT_GE(dragged, 9);
  EXPECT_GE(clicked, 30);
}

}  // namespace

class ControlsWindowAt : public testing::TestWithParam<int> {
 protected:
  TwinWindow twin{GetParam(), kCorrected, "teapot", corrected()};
  void SetUp() override { ASSERT_TRUE(twin.agrees()); }
};
INSTANTIATE_TEST_SUITE_P(Depths, ControlsWindowAt, testing::ValuesIn(someOf({8, 24}, 1)),
                         testing::PrintToStringParamName());

TEST_P(ControlsWindowAt, AllAnswerToTheMouse) { expectAllToAnswer(twin); }

// So they do at a larger scale.
TEST(ControlsWindow, AllAnswerAtScaleTwo) {
  TwinWindow twin{8, kCorrected, "teapot", corrected(), 2};
  ASSERT_TRUE(twin.agrees());
  expectAllToAnswer(twin);
}

// And so does what the other views have: each place that answers to the pointer is pressed where the window
// draws it.
TEST(ControlsWindow, OtherViewsAnswerAtScaleThree) {
  TwinWindow twin{24, kCorrected, "teapot", corrected(), 3};
  int pressed = 0;
  for (const ViewRow& row : kWindowViews) {
    if (row.id == View::Picture) continue;
    SCOPED_TRACE(row.name);
    twin.type({&row.key, 1});
    ASSERT_TRUE(twin.agrees());
    const auto places = twin.same.bench().list().places();
    for (std::size_t k = 0; k < places.size(); ++k) {
      const ControlPlace& place = places[k].second;
      if (place.area.empty() || place.passive) continue;
      twin.click(place.grip.empty() ? place.area : place.grip);
      if (twin.same.moving()) {  // the two windows have clocks of their own
        twin.press(XK_Escape, NamedKey::Escape);
        twin.press(XK_Home, NamedKey::Home);
      }
      ASSERT_TRUE(twin.agrees()) << k;
      ++pressed;
      if (twin.same.view() == row.id && twin.same.bench().list().places().size() == places.size()) continue;
      twin.type("r1");
      twin.type({&row.key, 1});
      ASSERT_TRUE(twin.agrees()) << k;
    }
    twin.press(XK_Escape, NamedKey::Escape);
    twin.type("1r");
  }
  EXPECT_GE(pressed, 60);
}

// Every view is drawn again at each size, and responds to a drag there.
TEST_P(ControlsWindowAt, EveryViewAtEverySize) {
  for (const ViewRow& row : kWindowViews) {
    if (showsTimes(row.id)) continue;
    SCOPED_TRACE(row.name);
    twin.type({&row.key, 1});
    ASSERT_TRUE(twin.agrees());
    for (const glm::ivec2 size :
         {glm::ivec2{800, 600}, glm::ivec2{1280, 1024}, glm::ivec2{1000, 640}, glm::ivec2{1024, 768}}) {
      twin.resize(size.x, size.y);
      ASSERT_TRUE(twin.agrees()) << size.x << " x " << size.y;
      const Rect& body = twin.body();
      twin.drag(body.x + body.width / 4, body.y + body.height / 4, body.x + body.width / 3,
                body.y + body.height / 4);
      ASSERT_TRUE(twin.agrees()) << "dragged, " << size.x << " x " << size.y;
    }
    twin.press(XK_Escape, NamedKey::Escape);
    twin.type("1r");
  }
}

// Every key in every view does what it does without a server. The keys are pressed a few at a time. Esc
// leaves a line that is typed.
TEST_P(ControlsWindowAt, EveryKeyInEveryView) {
  // f, which needs a screen to fill, is in full_screen_test.cpp.
  constexpr std::string_view kLetters = "ipadsnclotzLVSNOPKTW[]HBJ+-rjgbxAhmkyuUGDCZ";
  constexpr std::array kNamed{std::pair{XK_Right, NamedKey::Right},  std::pair{XK_Up, NamedKey::Up},
                              std::pair{XK_Home, NamedKey::Home},    std::pair{XK_End, NamedKey::End},
                              std::pair{XK_Tab, NamedKey::Tab},      std::pair{XK_Prior, NamedKey::PageUp},
                              std::pair{XK_Next, NamedKey::PageDown}};
  for (const ViewRow& row : kWindowViews) {
    if (showsTimes(row.id)) continue;
    SCOPED_TRACE(row.name);
    twin.type({&row.key, 1});
    ASSERT_TRUE(twin.agrees());
    int k = 0;
    for (const char letter : kLetters) {
      if (row.id == View::Colors && letter == 'm') continue;  // starts colours that move by themselves
      if (row.id == View::Colors && letter == 'h') continue;  // acts only while it is held
      twin.type({&letter, 1});
      twin.press(XK_Escape, NamedKey::Escape);
      if (row.id == View::Lesson) twin.type("7");
      // A key that follows a change of the set-up acts on what has been drawn by then.
      if (++k % 4 == 0 || std::string_view{"uUrD"}.find(letter) != std::string_view::npos) {
        ASSERT_TRUE(twin.agrees()) << letter;
      }
    }
    for (const auto& [symbol, name] : kNamed) {
      twin.press(static_cast<KeySym>(symbol), name);
      ASSERT_TRUE(twin.agrees()) << symbol;
    }
    twin.type("1r");
  }
}

}  // namespace xnewell::THIS_FILE
