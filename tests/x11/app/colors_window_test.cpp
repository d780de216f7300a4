#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "tests/support/seeds.h"
#include "tests/x11/support/watched_viewer.h"
#include "x11/views/colors_page.h"

#include <X11/Xproto.h>
#include <X11/keysym.h>

namespace xnewell::THIS_FILE {

// The view of the colour table in the window, on real servers: what is stored, and what is drawn.

namespace {

constexpr Rect kSeen{0, 0, 1024, 724};  ///< all but the status line
constexpr double kTick = 40;            ///< milliseconds at least between two moves of the ramp
const std::string kTeapot = "teapot --divisions 4 --table corrected";

/// The yellow of a lit shade.
bool isLit(const std::uint8_t* rgb) { return rgb[0] == 0xFF && rgb[1] == 0xE0 && rgb[2] == 0; }

/// Pixels of `now` that differ from `before` and that `counts`.
template <typename Counts>
int changed(const RgbImage& now, const RgbImage& before, const Counts& counts) {
  int pixels = 0;
  for (std::size_t k = 0; k < now.rgb.size(); k += 3)
    pixels += !std::equal(&now.rgb[k], &now.rgb[k] + 3, &before.rgb[k]) && counts(&now.rgb[k]);
  return pixels;
}

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
    window.moveTo(500, 15);  // where no cell is inspected
    window.type("3");
    ASSERT_TRUE(window.comesToShow(colors, kSeen));
    ASSERT_TRUE(window.settles());
  }
};
INSTANTIATE_TEST_SUITE_P(Depths, ColorsWindowAt, testing::ValuesIn(someOf({8, 24}, 1)),
                         testing::PrintToStringParamName());

// While h is held the shade is lit, in the picture, the grid and the strip. When h is let go the window is as
// it was; after a tap, with the second tap. Keys that the keyboard repeats meanwhile change nothing. A real
// colormap takes one store for the light and one for its end, and nothing is drawn.
TEST_P(ColorsWindowAt, AHeldKeyLightsTheShade) {
  enter();
  Display* const d = window.display();
  XSelectInput(d, window.id(), KeyPressMask);
  const auto layout = layoutOf(1024, 768);
  const Rect small = layoutOfColors(layout.body).picture, strip = intersection(layout.strip, kSeen);
  RequestRecord record{server, window.id()};
  RgbImage lit;
  /// Holds h until it is repeated so often, and lets it go; without repeats, taps it twice. Returns the
  /// requests that draw.
  const auto hold = [&](int repeats) {
    record.forget();
    window.hold(XK_h, true);
    EXPECT_TRUE(comesTrue([&] {
      lit = window.shown(kSeen);
      return changed(lit, colors, isLit) > 500 && cropped(lit, small) != cropped(colors, small) &&
             cropped(lit, strip) != cropped(colors, strip);
    }));
    if (repeats == 0) window.hold(XK_h, false), window.hold(XK_h, true);
    for (int key = 0; key <= std::max(1, repeats); ++key) {  // the first is the key itself
      XEvent event;
      EXPECT_TRUE(comesTrue([&] { return XCheckMaskEvent(d, KeyPressMask, &event) != 0; })) << key;
    }
    window.hold(XK_h, false);
    EXPECT_TRUE(window.comesToShow(colors, kSeen));
    return record.drawing();
  };
  XAutoRepeatOff(d);
  const std::ptrdiff_t once = hold(0);
  const RgbImage litOnce = lit;
  EXPECT_EQ(changed(lit, colors, [](const std::uint8_t* rgb) { return !isLit(rgb); }), 0);
  XAutoRepeatOn(d);
  EXPECT_EQ(hold(3), once);
  EXPECT_EQ(lit, litOnce);
  EXPECT_EQ(record.count(X_StoreColors), real ? 2 : 0);
  EXPECT_EQ(once > 0, !real);
}

// The ramp moves by itself, no faster than its clock. On a real colormap it moves through stores alone. Esc
// brings the view back, and leaving brings the picture back.
TEST_P(ColorsWindowAt, TheRampMovesThroughStoresAlone) {
  constexpr int kMoves = 12;
  enter();
  for (const bool byEscape : {true, false}) {
    RequestRecord record{server, window.id()};
    const auto start = std::chrono::steady_clock::now();
    window.type("m");
    if (real) {
      EXPECT_TRUE(comesTrue([&] { return record.count(X_StoreColors) >= kMoves; }));
      const std::vector<int> all = record.opcodes();
      // Read after the requests: so many moves, of which the first needs no time, took no longer than this.
      const double ms =
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
      // The key may store and draw by itself before the first move. Everything is drawn before the second.
      EXPECT_LE(static_cast<double>(std::ranges::count(all, X_StoreColors) - 2), ms / kTick);
      auto moved = all.begin();
      for (int store = 0; store < 2; ++store) moved = std::next(std::find(moved, all.end(), X_StoreColors));
      EXPECT_TRUE(std::none_of(moved, all.end(), [&](int opcode) { return record.isDrawing(opcode); }));
    } else {
      RgbImage last = colors;
      for (int move = 0; move < 3; ++move) {
        ASSERT_TRUE(window.comesToDiffer(last, kSeen)) << move;
        last = window.shown(kSeen);
      }
      EXPECT_EQ(record.count(X_StoreColors), 0);
    }
    if (byEscape)
      window.press(XK_Escape);
    else
      window.type("1");
    EXPECT_TRUE(window.comesToShow(byEscape ? colors : picture, kSeen));
  }
}

}  // namespace xnewell::THIS_FILE
