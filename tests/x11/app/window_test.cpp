#include <gtest/gtest.h>

#include <signal.h>

#include <csignal>
#include <cstring>
#include <functional>
#include <string>

#include "tests/support/seeds.h"
#include "tests/x11/support/watched_viewer.h"
#include "x11/server/screen.h"

#include <X11/Xatom.h>
#include <X11/Xproto.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

namespace xnewell::THIS_FILE {

namespace {

const std::string kTeapot = "teapot --divisions 4";

XServer serverFor(int depth) { return XServer::xvfb(depth, 1280, 1024); }

RgbImage fresh(const XServer& server, int width, int height, const std::string& more = "") {
  return freshWindow(server, kTeapot + " " + more, width, height);
}

std::string sized(int width, int height) {
  return kTeapot + " --size " + std::to_string(width) + "x" + std::to_string(height);
}

/// Another program's colormap, which that program installs without asking.
OwnedColormap stealColormap(const WatchedWindow& window) {
  Display* d = window.display();
  OwnedColormap other{d, XCreateColormap(d, DefaultRootWindow(d), DefaultVisual(d, 0), AllocNone)};
  XInstallColormap(d, other.get());
  XSync(d, 0);
  return other;
}

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

// The window among other windows: how it ends, is covered, is resized, keeps its colours, and fills the
// screen.

class WindowAt : public testing::TestWithParam<int> {
 protected:
  XServer server = serverFor(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Depths, WindowAt, testing::ValuesIn(someOf({8, 24}, 1)),
                         testing::PrintToStringParamName());

// `q` and the close button end the program with status 0, SIGINT with 130, SIGTERM with 143. It says nothing
// and leaves no window.
TEST_P(WindowAt, EndsAsAsked) {
  const auto signal = [](int number) {
    return [number](const WatchedViewer& viewer) { viewer.program.signal(number); };
  };
  const std::vector<std::pair<int, std::function<void(const WatchedViewer&)>>> ends{
      {0, [](const WatchedViewer& v) { v.window.type("q"); }},
      {0, [](const WatchedViewer& v) { v.window.askToClose(); }},
      {130, signal(SIGINT)},
      {143, signal(SIGTERM)},
      {129, signal(SIGHUP)}};
  for (const auto& [status, ask] : ends) {
    WatchedViewer viewer{server, kTeapot};
    ask(viewer);
    const Finished end = viewer.program.wait(std::chrono::seconds{90});
    EXPECT_EQ(end.status, status);
    EXPECT_EQ(end.out, "");
    EXPECT_EQ(end.err, "");
    EXPECT_TRUE(comesTrue([&] {
      Window root = 0, parent = 0, *children = nullptr;
      unsigned left = 0;
      XQueryTree(viewer.window.display(), DefaultRootWindow(viewer.window.display()), &root, &parent,
                 &children, &left);
      XFree(children);
      return left == 0;
    }));
  }
}

// Another program may destroy the window while pictures are on their way to it. One line says so.
TEST_P(WindowAt, IsDestroyedInOneLine) {
  for (int k = 0; k < 5; ++k) {
    WatchedViewer viewer{server, kTeapot};
    viewer.window.moveTo(300, 300);
    viewer.window.type("ttt");
    XDestroyWindow(viewer.window.display(), viewer.window.id());
    XSync(viewer.window.display(), 0);
    const Finished end = viewer.program.wait(std::chrono::seconds{90});
    EXPECT_EQ(end.status, 1);
    EXPECT_EQ(end.err, "xnewell: the window was destroyed by another program\n");
  }
}

// A program that `nohup` has started outlives its terminal.
TEST_P(WindowAt, IgnoresAHangupThatWasIgnored) {
  const auto before = std::signal(SIGHUP, SIG_IGN);  // the program inherits it
  WatchedViewer viewer{server, kTeapot};
  std::signal(SIGHUP, before);
  viewer.program.signal(SIGHUP);
  EXPECT_TRUE(viewer.window.settles());
  viewer.window.type("q");
  EXPECT_EQ(viewer.program.wait(std::chrono::seconds{90}).status, 0);
}

// What another window covered comes back by a copy on the server when that window goes. Nothing is drawn
// again. This holds for both ways to fill.
TEST_P(WindowAt, UncoveringCopiesThePictureBack) {
  for (const std::string fill : {"--fill scanline", "--fill x11"}) {
    SCOPED_TRACE(fill);
    const Rect all = aboveStatus(1024, 768);
    const RgbImage expected = fresh(server, 1024, 768, fill);
    const WatchedViewer viewer{server, kTeapot + " " + fill};
    const WatchedWindow& window = viewer.window;
    ASSERT_TRUE(window.comesToShow(expected, all));
    RequestRecord record{server, window.id()};

    Display* d = window.display();
    XSetWindowAttributes attributes{};
    attributes.override_redirect = 1;
    attributes.background_pixel = WhitePixel(d, 0);
    OwnedWindow cover{
        d, XCreateWindow(d, DefaultRootWindow(d), 100, 50, 700, 600, 0, CopyFromParent, InputOutput,
                         CopyFromParent, CWOverrideRedirect | CWBackPixel, &attributes)};
    XMapWindow(d, cover.get());
    XSync(d, 0);
    cover = {};  // our window has no background, so its white stays until we copy
    EXPECT_TRUE(window.comesToShow(expected, all));
    EXPECT_GE(record.count(X_CopyArea), 1);
    EXPECT_EQ(record.drawing(), record.count(X_CopyArea));
  }
}

// After many sizes in a row while keys arrive, the window shows what a fresh start shows, and the program has
// said nothing.
TEST_P(WindowAt, SurvivesResizingWhileKeysArrive) {
  const RgbImage expected = fresh(server, 900, 700);
  WatchedViewer viewer{server, kTeapot};
  const WatchedWindow& window = viewer.window;
  XSetInputFocus(window.display(), window.id(), RevertToPointerRoot, CurrentTime);
  constexpr std::string_view kKeys = "TFOHSPK+L[]-VJ";
  for (int i = 0; i < 60; ++i) {
    XResizeWindow(window.display(), window.id(), 1 + i * 337 % 1400, 1 + i * 211 % 1100);
    window.type(kKeys.substr(i % kKeys.size(), 1));
    if (i % 7 == 0) window.press(XK_Right, true);
  }
  window.resize(900, 700);
  window.type("rs");
  EXPECT_TRUE(window.comesToShow(expected, aboveStatus(900, 700)));
  window.type("q");
  const Finished end = viewer.program.wait(std::chrono::seconds{90});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.err, "");
}

// Two windows on one server have their own colours and keys, and one outlives the other.
TEST_P(WindowAt, TwoDoNotDisturbEachOther) {
  const Rect all = aboveStatus(600, 450);
  const RgbImage red = fresh(server, 600, 450),
                 amber = fresh(server, 600, 450, "--hue 1,0.7,0 --table brief");
  WatchedViewer one{server, sized(600, 450)};
  ASSERT_TRUE(one.window.comesToShow(red, all));
  WatchedViewer two{server, sized(600, 450) + " --table brief", one.window.id()};
  XMoveWindow(two.window.display(), two.window.id(), 620, 500);
  two.window.moveTo(700, 600);
  two.window.type("H");
  EXPECT_TRUE(two.window.comesToShow(amber, all));
  EXPECT_TRUE(one.window.comesToShow(red, all));  // once it has copied back what the other window covered
  two.window.type("q");
  EXPECT_EQ(two.program.wait().status, 0);
  EXPECT_EQ(one.window.shown(all), red);
  one.window.moveTo(300, 200);
  one.window.type("q");
  EXPECT_EQ(one.program.wait().status, 0);
}

// Without a window manager, the program takes back a colormap that was stolen while the pointer is in its
// window. While the pointer is elsewhere, the thief keeps it until the pointer comes back.
TEST(WindowColormap, IsTakenBackWhereThePointerIs) {
  const XServer server = serverFor(8);
  const WatchedViewer viewer{server, sized(800, 600)};
  const WatchedWindow& window = viewer.window;
  XSetInputFocus(window.display(), window.id(), RevertToPointerRoot, CurrentTime);
  window.moveTo(200, 200);
  EXPECT_TRUE(comesTrue([&] { return window.colormapInstalled(); }));
  ASSERT_TRUE(window.settles());
  RequestRecord record{server, window.id()};

  const OwnedColormap inside = stealColormap(window);
  EXPECT_TRUE(comesTrue([&] { return record.count(X_InstallColormap) == 1 && window.colormapInstalled(); }));

  window.moveTo(1200, 1000);
  ASSERT_TRUE(window.settles());
  record.forget();
  const OwnedColormap outside = stealColormap(window);
  ASSERT_TRUE(window.settles());
  EXPECT_EQ(record.count(X_InstallColormap), 0);
  EXPECT_FALSE(window.colormapInstalled());

  window.moveTo(200, 200);
  EXPECT_TRUE(comesTrue([&] { return window.colormapInstalled(); }));
}

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
  WatchedViewer viewer{server, "cycle"};
  const RgbImage before = freshWindow(server, "cycle");
  XMoveWindow(viewer.window.display(), viewer.window.id(), 300, 200);
  for (const KeySym goesBack : {XK_Escape, XK_F11}) {
    viewer.window.press(XK_F11);
    EXPECT_TRUE(comesToLie(viewer.window, {0, 0, 1920, 1080}));
    EXPECT_TRUE(comesToBe(viewer.window, freshWindow(server, "cycle", 1920, 1080, 2)));
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
  WatchedViewer viewer{server, "cycle"};
  const Rect place = placeOf(viewer.window);
  const auto setState = [&](int count) {
    XChangeProperty(d, viewer.window.id(), state, XA_ATOM, 32, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(&full), count);
    XSync(d, 0);
  };
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
    setState(fills ? 1 : 0);
  }

  // If the manager ends full screen by itself, Esc asks for nothing more.
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
// the user takes a scale of his own, by a key or by --scale.
TEST(ScaleOfTheWindow, IsThatOfTheScreenUntilChosen) {
  const XServer server = XServer::xvfb(24, 1920, 1080);
  {
    const WatchedViewer first{server, "cycle"};
    setResources(first.window, "Xft.dpi: 192\n");
    EXPECT_TRUE(first.window.settles());
    EXPECT_EQ(placeOf(first.window), (Rect{0, 0, 1024, 768})) << "no room for scale 2";
  }
  const RgbImage small = freshWindow(server, "cycle", 1920, 1080),
                 large = freshWindow(server, "cycle", 1920, 1080, 2);
  {
    const WatchedViewer chosen{server, "cycle --size 1920x1080 --scale 2"};
    EXPECT_TRUE(comesToBe(chosen.window, large));
    setResources(chosen.window, "Xft.dpi: 96\n");
    EXPECT_TRUE(comesToBe(chosen.window, large));
    setResources(chosen.window, "Xft.dpi: 192\n");
  }
  WatchedViewer viewer{server, "cycle"};
  EXPECT_EQ(placeOf(viewer.window), (Rect{0, 0, 1920, 1080}));
  EXPECT_TRUE(comesToBe(viewer.window, large));
  setResources(viewer.window, "Xft.dpi: 96\n");
  EXPECT_TRUE(comesToBe(viewer.window, small));
  viewer.window.type("Z");
  EXPECT_TRUE(comesToBe(viewer.window, large));
  setResources(viewer.window, "Xft.dpi: 100\n");
  EXPECT_TRUE(comesToBe(viewer.window, large));
  viewer.window.type("Z");
  EXPECT_TRUE(comesToBe(viewer.window, small));
}

}  // namespace xnewell::THIS_FILE
