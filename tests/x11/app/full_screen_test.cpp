#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "tests/x11/support/watched_viewer.h"

#include <X11/Xatom.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

#include "x11/server/screen.h"

namespace xnewell::THIS_FILE {

namespace {

const std::string kCycle = "cycle";

/// Where a window lies on its screen.
Rect placeOf(const WatchedWindow& window) {
  XWindowAttributes now{};
  XGetWindowAttributes(window.display(), window.id(), &now);
  int x = 0, y = 0;
  Window child = 0;
  XTranslateCoordinates(window.display(), window.id(), DefaultRootWindow(window.display()), 0, 0, &x, &y,
                        &child);
  return {x, y, now.width, now.height};
}

[[nodiscard]] bool comesToLie(const WatchedWindow& window, const Rect& place) {
  return comesTrue([&] { return placeOf(window) == place; });
}

/// What the whole window shows at a scale, above the status line.
RgbImage windowAt(const XServer& server, int width, int height, int scale) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  const RgbImage whole =
      pictureOf("snapshot --whole-window " + kCycle + " --size " + size + " --scale " + std::to_string(scale),
                server.name());
  const Layout at = layoutOf(width, height, scale);
  return cropped(whole, {0, 0, width, at.status.y * scale});
}

[[nodiscard]] bool comesToBe(const WatchedWindow& window, const RgbImage& expected) {
  return window.comesToShow(expected, {0, 0, expected.width, expected.height});
}

void setResources(const WatchedWindow& window, const std::string& text) {
  XChangeProperty(window.display(), DefaultRootWindow(window.display()), XA_RESOURCE_MANAGER, XA_STRING, 8,
                  PropModeReplace, reinterpret_cast<const unsigned char*>(text.data()),
                  static_cast<int>(text.size()));
  XSync(window.display(), 0);
}

}  // namespace

TEST(ScaleOfTheScreen, FollowsTheResourcesElseTheSize) {
  struct {
    const char* resources;
    glm::ivec2 screen;
    int scale;
  } constexpr kRows[]{
      {"", {1024, 768}, 1},
      {"", {1920, 1080}, 1},
      {"", {2560, 1440}, 1},
      {"", {3840, 2160}, 2},
      {"", {3840, 1080}, 1},  // two screens side by side
      {"", {7680, 4320}, 4},
      {"", {15360, 8640}, 4},
      {"Xft.dpi:\t96\n", {3840, 2160}, 1},
      {"Xft.dpi: 143", {1024, 768}, 1},
      {"Xft.dpi: 144", {1024, 768}, 2},
      {"*color: red\nXft.antialias: 1\nXft.dpi: 192\nXft.hinting: 0\n", {1024, 768}, 2},
      {"Xft.dpi: 1e9", {1024, 768}, 4},
      {"Xft.dpi: 1", {1024, 768}, 1},
      {"Xft.dpi: many", {3840, 2160}, 2},
      {"Xft.dpi: -96", {3840, 2160}, 2},
      {"Xft.dpi: nan", {3840, 2160}, 2},
      {"*dpi: 192", {1024, 768}, 2},  // as the X resource manager matches names
  };
  for (const auto& row : kRows)
    EXPECT_EQ(scaleFor(row.resources, row.screen, 4), row.scale) << row.resources << ' ' << row.screen.x;
}

// Without a window manager, F11 fills the screen in letters as large as fit. Esc puts the window back.
TEST(FullScreenWindow, NeedsNoWindowManager) {
  const XServer server = XServer::xvfb(24, 1920, 1080);
  WatchedViewer viewer{server, kCycle};
  const RgbImage before = windowAt(server, 1024, 768, 1);
  XMoveWindow(viewer.window.display(), viewer.window.id(), 300, 200);
  for (const KeySym goesBack : {XK_Escape, XK_F11}) {
    viewer.window.press(XK_F11);
    EXPECT_TRUE(comesToLie(viewer.window, {0, 0, 1920, 1080}));
    EXPECT_TRUE(comesToBe(viewer.window, windowAt(server, 1920, 1080, 2)));
    viewer.window.press(goesBack);
    EXPECT_TRUE(comesToLie(viewer.window, {300, 200, 1024, 768}));
    EXPECT_TRUE(comesToBe(viewer.window, before));
  }
}

// A window manager that knows EWMH is asked, and it alone changes the window.
TEST(FullScreenWindow, AsksItsWindowManager) {
  const XServer server = XServer::xvfb(24, 1280, 1024);
  const OwnedDisplay manager = openDisplay(server.name());
  Display* const d = manager.get();
  const Window root = DefaultRootWindow(d);
  const auto atom = [&](const char* name) { return XInternAtom(d, name, 0); };
  const Atom state = atom("_NET_WM_STATE"), full = atom("_NET_WM_STATE_FULLSCREEN");
  XChangeProperty(d, root, atom("_NET_SUPPORTED"), XA_ATOM, 32, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(&full), 1);
  XSelectInput(d, root, SubstructureNotifyMask);
  XSync(d, 0);
  WatchedViewer viewer{server, kCycle};
  const Rect place = placeOf(viewer.window);
  for (const bool fills : {true, false}) {
    viewer.window.press(fills ? XK_F11 : XK_Escape);
    XEvent event{};
    ASSERT_TRUE(comesTrue([&] { return XCheckTypedEvent(d, ClientMessage, &event) != 0; }));
    EXPECT_EQ(event.xclient.window, viewer.window.id());
    EXPECT_EQ(event.xclient.message_type, state);
    EXPECT_EQ(event.xclient.format, 32);
    EXPECT_EQ(event.xclient.data.l[0], fills ? 1 : 0);
    EXPECT_EQ(event.xclient.data.l[1], static_cast<long>(full));
    EXPECT_EQ(placeOf(viewer.window), place);
    XChangeProperty(d, viewer.window.id(), state, XA_ATOM, 32, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(&full), fills ? 1 : 0);
    XSync(d, 0);
  }

  // If the manager ends full screen by itself, Esc asks for nothing more.
  const auto setState = [&](int count) {
    XChangeProperty(d, viewer.window.id(), state, XA_ATOM, 32, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(&full), count);
    XSync(d, 0);
  };
  viewer.window.press(XK_F11);
  XEvent event{};
  ASSERT_TRUE(comesTrue([&] { return XCheckTypedEvent(d, ClientMessage, &event) != 0; }));
  setState(1);
  setState(0);
  viewer.window.press(XK_Escape);
  ASSERT_TRUE(viewer.window.settles());
  EXPECT_EQ(XCheckTypedEvent(d, ClientMessage, &event), 0);
}

// The usual scale and size of a window come from the screen. They follow a change of its resolution, until
// the user takes a scale of his own.
TEST(ScaleOfTheWindow, IsThatOfTheScreenUntilChosen) {
  const XServer server = XServer::xvfb(24, 1920, 1080);
  {
    const WatchedViewer first{server, kCycle};
    setResources(first.window, "Xft.dpi: 192\n");
    EXPECT_TRUE(first.window.settles());
    EXPECT_EQ(placeOf(first.window), (Rect{0, 0, 1024, 768})) << "no room for scale 2";
  }
  WatchedViewer viewer{server, kCycle};
  EXPECT_EQ(placeOf(viewer.window), (Rect{0, 0, 1920, 1080}));
  const RgbImage small = windowAt(server, 1920, 1080, 1), large = windowAt(server, 1920, 1080, 2);
  EXPECT_TRUE(comesToBe(viewer.window, large));
  setResources(viewer.window, "Xft.dpi: 96\n");
  EXPECT_TRUE(comesToBe(viewer.window, small));
  viewer.window.type("Z");
  EXPECT_TRUE(comesToBe(viewer.window, large));
  setResources(viewer.window, "Xft.dpi: 100\n");
  EXPECT_TRUE(viewer.window.comesToShow(large, {0, 0, large.width, large.height}));
  viewer.window.type("Z");
  EXPECT_TRUE(comesToBe(viewer.window, small));
}

// --scale is the user's word, whatever the screen says.
TEST(ScaleOfTheWindow, IsTheOptions) {
  const XServer server = XServer::xvfb(24, 1920, 1080);
  const OwnedDisplay other = openDisplay(server.name());
  WatchedViewer viewer{server, kCycle + " --size 1920x1080 --scale 2"};
  const RgbImage large = windowAt(server, 1920, 1080, 2);
  EXPECT_TRUE(comesToBe(viewer.window, large));
  setResources(viewer.window, "Xft.dpi: 96\n");
  EXPECT_TRUE(comesToBe(viewer.window, large));
}

}  // namespace xnewell::THIS_FILE
