#include <gtest/gtest.h>

#include <signal.h>
#include <csignal>

#include <array>
#include <functional>

#include "tests/support/seeds.h"
#include "tests/x11/support/watched_viewer.h"

#include <X11/Xproto.h>
#include <X11/keysym.h>

namespace xnewell::THIS_FILE {

// The window among other windows: how it ends, is covered, is resized, and keeps its colours.

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

}  // namespace

class WindowAt : public testing::TestWithParam<int> {
 protected:
  XServer server = serverFor(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Depths, WindowAt, testing::ValuesIn(someOf({8, 24}, 1)),
                         testing::PrintToStringParamName());

// `q` and the close button end the program with status 0, SIGINT with 130, SIGTERM with 143. It says nothing
// and leaves no window.
TEST_P(WindowAt, EndsAsAsked) {
  struct End {
    int status;
    std::function<void(const WatchedViewer&)> ask;
  };
  const auto signal = [](int number) {
    return [number](const WatchedViewer& viewer) { viewer.program.signal(number); };
  };
  for (const auto& [status, ask] :
       {End{0, [](const WatchedViewer& v) { v.window.type("q"); }},
        End{0, [](const WatchedViewer& v) { v.window.askToClose(); }}, End{130, signal(SIGINT)},
        End{143, signal(SIGTERM)}, End{129, signal(SIGHUP)}}) {
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

// At every size, from one pixel to more than the screen, the part of the window on the screen shows what a
// fresh start at that size shows.
TEST_P(WindowAt, ShowsTheRightPictureAtEverySize) {
  constexpr std::array<std::array<int, 2>, 9> kSizes{{{1, 1},
                                                      {2, 300},
                                                      {799, 599},
                                                      {800, 600},
                                                      {1023, 767},
                                                      {1280, 1024},
                                                      {1500, 1100},
                                                      {3, 2},
                                                      {640, 480}}};
  std::vector<RgbImage> expected;
  for (const auto& [w, h] : kSizes) expected.push_back(fresh(server, w, h));
  WatchedViewer viewer{server, kTeapot};
  for (std::size_t i = 0; i < kSizes.size(); ++i) {
    const auto [w, h] = kSizes[i];
    SCOPED_TRACE(testing::Message() << w << " x " << h);
    viewer.window.resize(w, h);
    const Rect seen = intersection(aboveStatus(w, h), {0, 0, 1280, 1024});
    EXPECT_TRUE(viewer.window.comesToShow(cropped(expected[i], seen), seen));
  }
  EXPECT_TRUE(viewer.program.running());
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

// Under a window manager the program installs no colormap: that is the manager's task.
TEST(WindowColormap, IsLeftToTheWindowManager) {
  const XServer server = serverFor(8);
  const OwnedDisplay manager = openDisplay(server.name());
  XSelectInput(manager.get(), DefaultRootWindow(manager.get()), SubstructureRedirectMask);
  XSync(manager.get(), 0);
  RunningProgram program{words("view " + sized(800, 600)), server.name()};
  XEvent event{};
  ASSERT_TRUE(comesTrue([&] { return XCheckTypedEvent(manager.get(), MapRequest, &event) != 0; }));
  RequestRecord record{server, event.xmaprequest.window};
  XMapWindow(manager.get(), event.xmaprequest.window);
  XSync(manager.get(), 0);
  const WatchedWindow window{server};
  XSetInputFocus(window.display(), window.id(), RevertToPointerRoot, CurrentTime);
  window.moveTo(200, 200);
  const OwnedColormap other = stealColormap(window);
  ASSERT_TRUE(window.settles());
  EXPECT_EQ(record.count(X_InstallColormap), 0);
}

// The window shows the right colours even if the default colormap has no free cell: it has its own map.
TEST(WindowColormap, NeedsNoFreeCellInTheDefaultMap) {
  const XServer server = serverFor(8);
  const RgbImage drawn = pictureOf("draw " + sized(320, 240)), expected = fresh(server, 1024, 768);
  const OwnedDisplay greedy = openDisplay(server.name());
  int taken = 0;
  for (unsigned long pixel = 0;
       XAllocColorCells(greedy.get(), DefaultColormap(greedy.get(), 0), 0, nullptr, 0, &pixel, 1) != 0;)
    ++taken;
  ASSERT_GT(taken, 0);
  EXPECT_EQ(pictureOf("snapshot " + sized(320, 240), server.name()), drawn);
  const WatchedViewer viewer{server, kTeapot};
  // The strip is left out: it also shows cells with the default map's colours, which are others now.
  const Layout at = layoutOf(1024, 768);
  const Rect seen{0, 0, 1024, at.strip.y};
  EXPECT_TRUE(viewer.window.comesToShow(cropped(expected, seen), seen));
  EXPECT_NE(viewer.window.colormap(), DefaultColormap(viewer.window.display(), 0));
  EXPECT_TRUE(comesTrue([&] { return viewer.window.colormapInstalled(); }));
}

}  // namespace xnewell::THIS_FILE
