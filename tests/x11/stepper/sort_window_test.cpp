#include <gtest/gtest.h>

#include "tests/support/seeds.h"
#include "tests/x11/support/twin_window.h"
#include "x11/stepper/sort_layout.h"

namespace xnewell::THIS_FILE {

// The depth-sort stepper in the window, on real servers. Keys and mouse come in as a user's do. The window
// must show what a workbench without a server shows after the same input.

class SortWindowAt : public testing::TestWithParam<int> {
 protected:
  TwinWindow twin{GetParam()};
  const SortLayout at = layoutOfSort(twin.body());

  void SetUp() override {
    twin.type("2");
    ASSERT_TRUE(twin.agrees());
  }
};
INSTANTIATE_TEST_SUITE_P(Depths, SortWindowAt, testing::ValuesIn(someOf({8, 24}, 1)),
                         testing::PrintToStringParamName());

// The student sorts: keys and clicks do what they do without a server.
TEST_P(SortWindowAt, TheStudentSorts) {
  const SortLayout own = layoutOfSort(twin.body(), false, true);
  twin.type("Y");
  EXPECT_TRUE(twin.agrees());
  const RgbImage start = twin.expected();
  twin.press(XK_Down, NamedKey::Down);
  twin.type("nt");
  EXPECT_TRUE(twin.agrees());
  twin.type("3k");
  twin.click(own.picture);
  EXPECT_TRUE(twin.agrees());
  twin.click(own.testRow(0));
  twin.click(own.acts[0]);
  EXPECT_TRUE(twin.agrees());
  EXPECT_NE(twin.expected(), start);
  twin.press(XK_BackSpace, NamedKey::Backspace);
  EXPECT_TRUE(twin.agrees());
}

// Every key of the view does what it does without a server.
TEST_P(SortWindowAt, KeysStep) {
  twin.press(XK_Right, NamedKey::Right);
  EXPECT_TRUE(twin.agrees());
  twin.press(XK_Right, NamedKey::Right, true);
  EXPECT_TRUE(twin.agrees());
  twin.type("j");
  EXPECT_TRUE(twin.agrees());
  twin.type("KKKj");
  EXPECT_TRUE(twin.agrees());
  const RgbImage cut = twin.expected();
  twin.type("J");
  twin.press(XK_Left, NamedKey::Left);
  EXPECT_TRUE(twin.agrees());
  twin.press(XK_End, NamedKey::End);
  EXPECT_TRUE(twin.agrees());
  twin.press(XK_Home, NamedKey::Home);
  twin.type("j");
  EXPECT_TRUE(twin.agrees());
  EXPECT_EQ(twin.expected(), cut);
  twin.type("g");
  twin.type("720");
  twin.press(XK_Return, NamedKey::Return);
  EXPECT_TRUE(twin.agrees());
  twin.type("y");
  twin.press(XK_Left, NamedKey::Left);
  twin.press(XK_Right, NamedKey::Right);
  EXPECT_TRUE(twin.agrees());
  twin.type("b");
  EXPECT_TRUE(twin.agrees());
  twin.type("y/");
  twin.type("92");
  twin.press(XK_Return, NamedKey::Return);
  twin.type("b2b");
  EXPECT_TRUE(twin.agrees());
  twin.type("2-+");
  EXPECT_TRUE(twin.agrees());
}

// Boxes, buttons, kinds, rows, the picture, the slider and the timeline respond to the mouse.
TEST_P(SortWindowAt, TheMouseDoesWhatItPointsAt) {
  const RgbImage start = twin.expected();
  for (int k = 0; k < kToggleCount; ++k)
    if (k != kPolygonStop) twin.click(at.toggles[k].area);
  EXPECT_TRUE(twin.agrees());
  twin.click(at.toggles[kPredict].area);
  twin.click(at.kinds.options[3]);
  EXPECT_TRUE(twin.agrees());
  twin.click(at.transport[4]);
  twin.click(at.transport[5]);
  EXPECT_TRUE(twin.agrees());
  twin.click({at.list.x, at.list.y + 5 * at.line, 40, at.line});
  EXPECT_TRUE(twin.agrees());
  twin.click({at.picture.x + 300, at.picture.y + 160, 2, 2});
  EXPECT_TRUE(twin.agrees());
  EXPECT_NE(twin.expected(), start);

  const int x = at.timeline.x + 100, y = at.timeline.y + 10;
  twin.drag(x, y, x + 400, y);
  EXPECT_TRUE(twin.agrees());
}

// Playing reaches its stop by itself.
TEST_P(SortWindowAt, PlaysToAStop) {
  twin.type("++++++++++++++");
  twin.type("b4");
  twin.press(XK_space, NamedKey::Space);
  while (twin.same.moving()) twin.same.tick();
  EXPECT_TRUE(twin.agrees());
}

}  // namespace xnewell::THIS_FILE
