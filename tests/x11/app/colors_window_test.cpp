#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/x11/support/watched_viewer.h"
#include "x11/views/colors_page.h"

#include <X11/Xproto.h>
#include <X11/keysym.h>

namespace xnewell {

// The view of the colour table in the window, on real servers: what is stored, and that nothing is drawn.

namespace {

constexpr Rect kSeen{0, 0, 1024, 724};  ///< but for the status line
const std::string kTeapot = "teapot --divisions 4 --table corrected";

/// All requests that matter to a frame are stores.
bool onlyStores(RequestRecord& record) { return record.count(X_StoreColors) > 0 && record.drawing() == 0; }

}  // namespace

class ColorsWindowAt : public testing::TestWithParam<int> {
 protected:
  XServer server = XServer::xvfb(GetParam(), 1280, 1024);
  const RgbImage picture = freshWindow(server, kTeapot),
                 colors = freshWindow(server, kTeapot + " --view colours");
  const WatchedViewer viewer{server, kTeapot};
  const WatchedWindow& window = viewer.window;
  bool real = GetParam() == 8;

  void enter() {
    ASSERT_TRUE(window.comesToShow(picture, kSeen));
    window.moveTo(500, 15);  // where it inspects nothing
    window.type("3");
    ASSERT_TRUE(window.comesToShow(colors, kSeen));
    ASSERT_TRUE(window.settles());
  }
};
INSTANTIATE_TEST_SUITE_P(Depths, ColorsWindowAt, testing::Values(8, 24), testing::PrintToStringParamName());

// Key 3 shows the view as a snapshot of it does, and 1 the picture again.
TEST_P(ColorsWindowAt, TabsAreKeys) {
  EXPECT_NE(picture, colors);
  enter();
  window.type("1");
  EXPECT_TRUE(window.comesToShow(picture, kSeen));
}

// As long as h is held the shade is lit, in the picture, the grid and the strip; let go, the window is as it
// was. A real colormap takes a store for either, and nothing is drawn.
TEST_P(ColorsWindowAt, AHeldKeyLightsTheShade) {
  enter();
  RequestRecord record{server, window.id()};
  window.hold(XK_h, true);
  ASSERT_TRUE(window.comesToDiffer(colors, kSeen));
  std::this_thread::sleep_for(std::chrono::milliseconds(900));  // longer than a key takes to repeat
  const RgbImage lit = window.shown(kSeen);
  EXPECT_NE(lit, colors);
  const Rect small = layoutOfColors(layoutOf(1024, 768).body).picture;
  int yellow = 0, others = 0;
  for (int j = 0; j < kSeen.height; ++j)
    for (int i = 0; i < kSeen.width; ++i) {
      const std::uint8_t *const now = lit.pixel(i, j), *const before = colors.pixel(i, j);
      if (std::equal(now, now + 3, before)) continue;
      (now[0] == 0xFF && now[1] == 0xE0 && now[2] == 0 ? yellow : others) += 1;
    }
  EXPECT_GT(yellow, 500);
  EXPECT_EQ(others, 0);
  EXPECT_NE(cropped(lit, small), cropped(colors, small));
  window.hold(XK_h, false);
  EXPECT_TRUE(window.comesToShow(colors, kSeen));
  if (real) {
    EXPECT_TRUE(onlyStores(record));
    EXPECT_EQ(record.count(X_StoreColors), 2);
  }
}

// The ramp moves by itself, on a real colormap through stores alone, and no faster than its clock: the
// program sleeps in between. Esc brings the view back, and leaving the picture.
TEST_P(ColorsWindowAt, TheRampMovesThroughStoresAlone) {
  enter();
  for (const bool byEscape : {true, false}) {
    window.type("m");
    ASSERT_TRUE(window.comesToDiffer(colors, kSeen));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));  // until the line that says so is drawn
    RequestRecord record{server, window.id()};
    const auto start = std::chrono::steady_clock::now();
    std::this_thread::sleep_for(std::chrono::milliseconds(1000));
    (void)comesTrue([&] { return real ? record.count(X_StoreColors) >= 3 : record.drawing() >= 3; });
    if (real) {
      EXPECT_TRUE(onlyStores(record));
      const double ms =
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
      EXPECT_GE(record.count(X_StoreColors), 3);
      EXPECT_LE(static_cast<double>(record.count(X_StoreColors)), ms / 40 + 4);
    } else {
      EXPECT_EQ(record.count(X_StoreColors), 0);
      EXPECT_GE(record.drawing(), 3);
    }
    if (byEscape)
      window.press(XK_Escape);
    else
      window.type("1");
    EXPECT_TRUE(window.comesToShow(byEscape ? colors : picture, kSeen));
  }
}

// Dragging the curve changes what is stored: brighter where it goes up, and the small picture's samples with
// it. The picture comes back on leaving.
TEST_P(ColorsWindowAt, DraggingTheCurveBrightensThePicture) {
  enter();
  const ColorsLayout at = layoutOfColors(layoutOf(1024, 768).body);
  const int x = at.stored.x + at.stored.width / 2, y = at.stored.y + at.stored.height - 20;
  window.moveTo(x, y);
  window.button(1, true);
  window.moveTo(x, at.stored.y + 10);
  window.button(1, false);
  window.moveTo(500, 15);
  ASSERT_TRUE(window.settles());
  const RgbImage bent = window.shown(at.picture), before = cropped(colors, at.picture);
  int brighter = 0, darker = 0;
  for (std::size_t k = 0; k < bent.rgb.size(); k += 3) {
    brighter += bent.rgb[k] > before.rgb[k];
    darker += bent.rgb[k] < before.rgb[k];
  }
  EXPECT_GT(brighter, 5000);
  EXPECT_EQ(darker, 0);
  window.type("1");
  EXPECT_TRUE(window.comesToShow(picture, kSeen));
}

}  // namespace xnewell
