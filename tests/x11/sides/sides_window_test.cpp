#include <gtest/gtest.h>

#include "tests/support/seeds.h"
#include "tests/x11/support/twin_window.h"
#include "x11/sides/sides_page.h"

namespace xnewell::THIS_FILE {

// Two setups side by side in the window, on real servers, with keys and mouse.

namespace {

constexpr Rect kSeen{0, 0, 1024, 724};  ///< all but the status line
const std::string kTeapot = "teapot --divisions 3 --order zsort";

xnewell::Setup sorted() {
  xnewell::Setup setup;
  setup.picture.order = Order::ZSort;
  return setup;
}

}  // namespace

class SidesWindowAt : public testing::TestWithParam<int> {
 protected:
  XServer server = XServer::xvfb(GetParam(), 1280, 1024);
  const RgbImage picture = freshWindow(server, kTeapot);
  const WatchedViewer viewer{server, kTeapot};
  const WatchedWindow& window = viewer.window;
  ReadyWorkbench expected{sorted()};
  const SidesLayout at = layoutOfSides(layoutOf(1024, 768).body);

  void enter() {
    ASSERT_TRUE(window.comesToShow(picture, kSeen));
    window.moveTo(500, 15);
    type("5");
    shows();
  }
  void type(std::string_view letters) {
    window.type(letters);
    expected.type(letters);
    expected.finish();
  }
  /// All but the numbers, which include measured times.
  void shows() {
    for (const Rect& rect : {at.captionA, at.captionB, at.A, at.B, at.difference})
      EXPECT_TRUE(window.comesToShow(onScreen(expected, rect), rect)) << rect.x << ", " << rect.y;
  }
};
INSTANTIATE_TEST_SUITE_P(Depths, SidesWindowAt, testing::ValuesIn(someOf({8, 24}, 1)),
                         testing::PrintToStringParamName());

// Every key of the view does on a server what it does without one, pixel for pixel, also with two tables in
// one palette. Key 1 brings the picture back as it was.
TEST_P(SidesWindowAt, KeysShowWhatTheyShowWithoutAServer) {
  enter();
  for (const std::string_view keys : {"f", "n", "S", "A", "O", "u", "x", "x", "gggg", "T", "f"}) {
    SCOPED_TRACE(keys);
    type(keys);
    shows();
  }
  window.press(XK_space);
  expected.press({NamedKey::Space});
  expected.finish();
  shows();
}

TEST_P(SidesWindowAt, LeavingBringsThePictureBack) {
  enter();
  type("ST");  // keys for B: other colours in the cells
  shows();
  type("1");
  EXPECT_TRUE(window.comesToShow(picture, kSeen));
}

// A drag turns both pictures at once. When it is over, the numbers are there as if there had been no drag.
TEST_P(SidesWindowAt, ADragTurnsBoth) {
  enter();
  const RgbImage before = window.shown(at.B);
  const int x = at.A.x + 100, y = at.A.y + 100;
  window.moveTo(x, y);
  window.button(1, true);
  window.moveTo(x + 60, y - 20);
  window.button(1, false);
  window.moveTo(500, 15);
  EXPECT_TRUE(window.comesToDiffer(before, at.B));
  ASSERT_TRUE(expected.grab(x, y));
  expected.dragTo(x + 60, y - 20);
  expected.settle();
  expected.finish();
  shows();
}

}  // namespace xnewell::THIS_FILE
