#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/seeds.h"
#include "tests/x11/support/ready_workbench.h"
#include "tests/x11/support/watched_viewer.h"
#include "x11/sides/sides_page.h"
#include "x11/trade/trade_view.h"

#include <X11/keysym.h>

namespace xnewell::THIS_FILE {

// Every control of the picture's view, every key, and resizes on real servers. Keys and mouse come in as a
// user's do. The window must show what a workbench without a server shows after the same input.

namespace {

/// The program's window on a server, and a workbench without a server. Both get the same keys and mouse, and
/// must show the same pixels. The window is in the upper left corner of the screen. It has 1024 x 768 pixels
/// at scale 1, 800 x 600 units at others.
class TwinWindow {
 public:
  explicit TwinWindow(int depth, const std::string& line = "teapot --divisions 3",
                      const std::string& scene = "teapot", const xnewell::Setup& setup = {}, int scale = 1)
      : unit{scale},
        server{XServer::xvfb(depth, std::max(1280, 800 * unit), std::max(1024, 600 * unit))},
        viewer{server,
               line + (unit == 1 ? ""
                                 : " --scale " + std::to_string(unit) + " --size " +
                                       std::to_string(800 * unit) + 'x' + std::to_string(600 * unit))},
        window{viewer.window},
        same{setup, 1024, 768, scene, {.shownBits = 8}} {
    if (unit > 1) {
      same.scale(unit);
      same.resize(800 * unit, 600 * unit);
      same.update();
    }
    moveTo(700, 15);  // over nothing that responds
  }

  void type(std::string_view letters) {
    window.type(letters);
    same.type(letters);
  }
  void press(KeySym symbol, NamedKey name, bool shift = false) {
    window.press(symbol, shift);
    same.press({name, 0, shift});
  }
  /// The pointer, in units.
  void moveTo(int x, int y) {
    window.moveTo(x * unit, y * unit);
    same.hover(x * unit, y * unit);
  }
  /// The button pressed, moved along and let go; then the pointer is over nothing that responds.
  void drag(int fromX, int fromY, int toX, int toY) {
    finish();
    moveTo(fromX, fromY);
    window.button(1, true);
    const bool dragging = same.grab(fromX * unit, fromY * unit);
    if (fromX != toX || fromY != toY) {
      window.moveTo(toX * unit, toY * unit);
      if (dragging)
        same.dragTo(toX * unit, toY * unit);
      else
        same.hover(toX * unit, toY * unit);
    }
    window.button(1, false);
    if (dragging) same.settle();
    moveTo(700, 15);
  }
  void click(const Rect& r) {
    const int x = r.x + r.width / 2, y = r.y + r.height / 2;
    drag(x, y, x, y);
  }
  void resize(int width, int height) {
    window.resize(width, height);
    same.resize(width, height);
  }
  /// The workbench uses the places that it drew last.
  void finish() { same.finish(); }

  [[nodiscard]] Rect body() const { return same.layout().body * unit; }
  /// The parts of the body that show no measured times, in pixels.
  [[nodiscard]] std::vector<Rect> timeless() const {
    const Layout& layout = same.layout();
    std::vector<Rect> parts{layout.body};
    if (same.view() == View::SideBySide) {
      const SidesLayout at = layoutOfSides(layout.body);
      parts = {at.captionA, at.A, at.captionB, at.B, at.difference};
    }
    if (same.view() == View::Trade) parts = {layoutOfTrade(layout.body).controls};
    for (Rect& part : parts) part = part * unit;
    return parts;
  }
  /// Compares these parts. The bands around the body tell times and facts of the server.
  [[nodiscard]] bool agrees() {
    finish();
    return std::ranges::all_of(timeless(), [&](const Rect& part) {
      return window.comesToShow(onScreen(same.image(), same.palette(), part), part);
    });
  }

  const int unit;  ///< pixels
  XServer server;
  const WatchedViewer viewer;
  const WatchedWindow& window;
  ReadyWorkbench same;
};

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
    if (row.id == View::Trade) continue;  // it shows times: trade_view_test.cpp
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
  constexpr std::string_view kLetters = "ipadsnclotzLVSNOPKTW[]HBJ+-rjgfbxAhmkyuUGDCZY";
  constexpr std::array kNamed{std::pair{XK_Right, NamedKey::Right},  std::pair{XK_Up, NamedKey::Up},
                              std::pair{XK_Home, NamedKey::Home},    std::pair{XK_End, NamedKey::End},
                              std::pair{XK_Tab, NamedKey::Tab},      std::pair{XK_Prior, NamedKey::PageUp},
                              std::pair{XK_Next, NamedKey::PageDown}};
  for (const ViewRow& row : kWindowViews) {
    if (row.id == View::Trade) continue;  // it shows times: trade_view_test.cpp
    SCOPED_TRACE(row.name);
    twin.type({&row.key, 1});
    ASSERT_TRUE(twin.agrees());
    int k = 0;
    for (const char letter : kLetters) {
      if (row.id != View::SideBySide && letter == 'f') continue;  // fills the screen: window_test.cpp
      if (row.id == View::Colors && letter == 'm') continue;      // starts colours that move by themselves
      if (row.id == View::Colors && letter == 'h') continue;      // acts only while it is held
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
