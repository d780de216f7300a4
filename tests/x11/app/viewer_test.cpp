#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/support/seeds.h"
#include "tests/x11/support/watched_viewer.h"

#include <X11/Xproto.h>
#include <X11/keysym.h>

namespace xnewell::THIS_FILE {

// What keys and mouse do to the picture in the window, on real servers.

namespace {

constexpr Rect kSeen{0, 0, 1024, 724};  ///< the window of 1024 x 768 but for its status line
const std::string kTeapot = "teapot --divisions 4";

XServer serverFor(int depth) { return XServer::xvfb(depth, 1280, 1024); }

/// The requests that matter to a frame, in order. `S` stands for StoreColors, `[` and `]` for GrabServer and
/// UngrabServer, `c` for CopyArea, and `d` for all other drawing.
std::string frames(RequestRecord& record) {
  std::string seen;
  for (const int opcode : record.opcodes()) {
    if (opcode == X_StoreColors) seen += 'S';
    if (opcode == X_GrabServer) seen += '[';
    if (opcode == X_UngrabServer) seen += ']';
    if (opcode == X_CopyArea)
      seen += 'c';
    else if (record.isDrawing(opcode))
      seen += 'd';
  }
  return seen;
}

}  // namespace

class ViewerAt : public testing::TestWithParam<int> {
 protected:
  XServer server = serverFor(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Depths, ViewerAt, testing::ValuesIn(someOf({8, 24}, 1)),
                         testing::PrintToStringParamName());

// A new hue shows the window as a fresh start with that hue would. After five hues the first comes again. On
// a real colormap colours are stored and nothing is drawn. The counter of drawing does count: a key that
// changes the panel draws.
TEST_P(ViewerAt, NewHueStoresColorsAndDrawsNothingWhereCellsAreReal) {
  const RgbImage red = freshWindow(server, kTeapot), amber = freshWindow(server, kTeapot + " --hue 1,0.7,0");
  EXPECT_NE(red, amber);
  const WatchedViewer viewer{server, kTeapot};
  ASSERT_TRUE(viewer.window.comesToShow(red, kSeen));
  RequestRecord record{server, viewer.window.id()};

  viewer.window.type("H");
  EXPECT_TRUE(viewer.window.comesToShow(amber, kSeen));
  viewer.window.type("HHHH");
  EXPECT_TRUE(viewer.window.comesToShow(red, kSeen));
  // Key presses that arrive together may share one frame.
  const std::ptrdiff_t stores = record.count(X_StoreColors);
  if (GetParam() == 8) {
    EXPECT_GE(stores, 2);
    EXPECT_EQ(frames(record), std::string(stores, 'S'));
    record.forget();
    viewer.window.press(XK_Right);
    EXPECT_TRUE(comesTrue([&] { return record.count(X_UngrabServer) == 1; }));
    EXPECT_EQ(frames(record), "d[c]");
  } else {
    EXPECT_EQ(stores, 0);
    EXPECT_GE(record.drawing(), 4);
  }
}

// Under a layout of other letters, a key has the Latin letter of the layout's other group, with Shift and
// with Caps Lock.
TEST(Viewer, TakesTheLetterOfAnotherGroup) {
  const XServer server = serverFor(24);
  const RgbImage amber = freshWindow(server, kTeapot + " --hue 1,0.7,0"), red = freshWindow(server, kTeapot);
  const WatchedViewer viewer{server, kTeapot};
  ASSERT_TRUE(viewer.window.comesToShow(red, kSeen));
  std::array<KeySym, 4> er{XK_Cyrillic_er, XK_Cyrillic_ER, XK_h, XK_H};
  const KeyCode h = XKeysymToKeycode(viewer.window.display(), XK_h);
  XChangeKeyboardMapping(viewer.window.display(), h, 4, er.data(), 1);
  XSync(viewer.window.display(), False);
  XEvent changed{};  // so that this test finds the keys of the letters, too
  changed.xmapping.type = MappingNotify, changed.xmapping.display = viewer.window.display();
  changed.xmapping.request = MappingKeyboard, changed.xmapping.first_keycode = h, changed.xmapping.count = 1;
  XRefreshKeyboardMapping(&changed.xmapping);
  viewer.window.press(XK_Cyrillic_er, true);
  EXPECT_TRUE(viewer.window.comesToShow(amber, kSeen));
  viewer.window.press(XK_Caps_Lock);
  for (int k = 0; k < 4; ++k) viewer.window.press(XK_Cyrillic_er);
  EXPECT_TRUE(viewer.window.comesToShow(red, kSeen));
}

// A change of table, shades or I0 gives intensities other cells. Colours and indices arrive together, between
// GrabServer and UngrabServer. Then the window looks like a fresh start with these values.
TEST_P(ViewerAt, CellsAndIndicesChangeInOneFrame) {
  struct Change {
    std::string before;
    std::function<void(const WatchedWindow&)> focus, act;
    std::string after;
  };
  const auto nothing = [](const WatchedWindow&) {};
  const auto key = [](KeySym symbol) { return [symbol](const WatchedWindow& w) { w.press(symbol); }; };
  const auto type = [](const char* letters) {
    return [letters](const WatchedWindow& w) { w.type(letters); };
  };
  std::vector<Change> changes{
      Change{"--shades 64", type("c"), key(XK_Left), "--shades 63"},
      Change{"--table corrected --shades 64", type("c"), key(XK_Home), "--table corrected --shades 2"},
      Change{"--table corrected", type("o"), key(XK_End), "--table corrected --i0 0.5"},
  };
  for (std::size_t k = 0; k < kTables.size(); ++k) {
    const auto table = [](std::size_t row) {
      return "--table " + std::string{kTables[row % kTables.size()].name};
    };
    changes.push_back({table(k), nothing, type("T"), table(k + 1)});
  }
  // The marks of the defaults on the sliders of the colour table differ from those of a fresh start.
  const Layout at = layoutOf(1024, 768);
  const Rect tracks{at.controls.x + 78, at.controls.y + at.controls.height - 160, 180, 160};
  const auto withoutTracks = [&](RgbImage image) {
    for (int y = tracks.y; y < tracks.y + tracks.height; ++y)
      std::fill_n(image.pixel(tracks.x, y), 3 * tracks.width, 0);
    return image;
  };
  for (const Change& change : changes) {
    SCOPED_TRACE(change.before + " -> " + change.after);
    const RgbImage before = freshWindow(server, kTeapot + " " + change.before),
                   after = withoutTracks(freshWindow(server, kTeapot + " " + change.after));
    const WatchedViewer viewer{server, kTeapot + " " + change.before};
    ASSERT_TRUE(viewer.window.comesToShow(before, kSeen));
    change.focus(viewer.window);
    ASSERT_TRUE(viewer.window.settles());
    RequestRecord record{server, viewer.window.id()};
    change.act(viewer.window);
    EXPECT_TRUE(comesTrue([&] { return record.count(X_UngrabServer) == 1; }));
    EXPECT_EQ(frames(record), GetParam() == 8 ? "d[Sc]" : "d[c]");
    viewer.window.type("s");  // a fresh start has the keyboard there
    EXPECT_TRUE(comesTrue([&] { return withoutTracks(viewer.window.shown(kSeen)) == after; }));
  }
}

// Dragging over the picture turns the scene until the button is released, but only if the button went down
// over the picture. The wheel zooms. Undo takes each of these back.
TEST_P(ViewerAt, MouseTurnsAndZooms) {
  const RgbImage start = freshWindow(server, kTeapot);
  const WatchedViewer viewer{server, kTeapot};
  const WatchedWindow& window = viewer.window;
  ASSERT_TRUE(window.comesToShow(start, kSeen));

  window.moveTo(300, 300);
  window.button(1, true);
  window.moveTo(340, 310);
  window.button(1, false);
  ASSERT_TRUE(window.comesToDiffer(start, kSeen));
  ASSERT_TRUE(window.settles());
  const RgbImage turned = window.shown(kSeen);
  window.moveTo(100, 100);
  ASSERT_TRUE(window.settles());
  EXPECT_EQ(window.shown(kSeen), turned);
  window.type("u");
  EXPECT_TRUE(window.comesToShow(start, kSeen));

  window.moveTo(900, 343);  // in the column of controls, but on none of them
  window.button(1, true);
  window.moveTo(300, 300);
  window.button(1, false);
  ASSERT_TRUE(window.settles());
  EXPECT_EQ(window.shown(kSeen), start);

  for (const unsigned wheel : {4u, 5u}) {
    window.button(wheel, true);
    window.button(wheel, false);
    EXPECT_TRUE(window.comesToDiffer(start, kSeen));
    window.type("u");
    EXPECT_TRUE(window.comesToShow(start, kSeen));
  }
}

}  // namespace xnewell::THIS_FILE
