#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "tests/x11/support/watched_viewer.h"

#include <X11/Xproto.h>
#include <X11/keysym.h>

#include "tests/x11/support/stranger.h"
#include "x11/app/snapshot.h"
#include "x11/command/report.h"

namespace xnewell::THIS_FILE {

using testing::HasSubstr;

// The program itself when it has few cells of the default map or none, or no map of its own.

namespace {

/// While an object of this class exists, the server refuses new colormaps.
struct NoMoreColormaps {
  static inline int alive = 0;
  NoMoreColormaps() { ++alive; }
  ~NoMoreColormaps() { --alive; }
};

/// The mean difference of a channel between two pictures, each taken as the means of its blocks of 8 x 8
/// pixels.
double missOfBlocks(const RgbImage& seen, const RgbImage& wanted) {
  double sum = 0;
  int blocks = 0;
  for (int top = 0; top < wanted.height; top += 8)
    for (int left = 0; left < wanted.width; left += 8)
      for (int c = 0; c < 3; ++c, ++blocks) {
        int owed = 0;
        for (int k = 0; k < 64; ++k)
          owed += seen.pixel(left + k % 8, top + k / 8)[c] - wanted.pixel(left + k % 8, top + k / 8)[c];
        sum += std::abs(owed) / 64.0;
      }
  return sum / blocks;
}

std::size_t lines(const std::string& text) { return std::ranges::count(text, '\n'); }

}  // namespace

/// Replaces Xlib's function. BadAlloc comes from the server, for a pixmap that is too large.
extern "C" Colormap XCreateColormap(Display* display, Window window, Visual* visual, int allocated) {
  if (NoMoreColormaps::alive > 0) return XCreatePixmap(display, window, 40'000, 1, 1);
  using Create = Colormap (*)(Display*, Window, Visual*, int);
  static const auto xlibs = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "XCreateColormap"));
  return xlibs(display, window, visual, allocated);
}

// Next to a program that has taken nearly all cells, the program always gives a picture. It tells so in one
// line, does not mention BadAlloc, and leaves nothing behind. If it has cells, the picture is the one with
// that many shades.
TEST(SharedCellsProgram, AlwaysAPictureAlwaysTold) {
  const TemporaryFolder folder;
  const std::string file = folder.file("picture.png");
  for (const std::size_t left : {0, 1, 50, 183})
    for (const std::string fill : {"scanline", "x11"}) {
      SCOPED_TRACE(testing::Message() << left << ' ' << fill);
      const XServer server = XServer::xvfb(8);
      const Stranger stranger{server, left};
      const std::string line = "teapot --divisions 3 --table corrected --size 160x120";
      const Finished done = runProgram(
          words("snapshot --colormap shared " + line + " --fill " + fill + " -o " + file), server.name());
      ASSERT_EQ(done.status, 0) << done.err;
      EXPECT_EQ(lines(done.err), 1u) << done.err;
      EXPECT_THAT(done.err, HasSubstr("xnewell: the default colormap has "));
      EXPECT_THAT(done.err, Not(HasSubstr("BadAlloc")));
      EXPECT_EQ(stranger.countFree(), left);
      const RgbImage picture = readPng(file);
      std::set<std::array<int, 3>> colors;
      for (std::size_t k = 0; k < picture.rgb.size(); k += 3)
        colors.insert({picture.rgb[k], picture.rgb[k + 1], picture.rgb[k + 2]});
      EXPECT_GT(colors.size(), 5u);
      if (left < 2 || fill == "x11") continue;
      const std::string told = done.err.substr(done.err.find(" for ") + 5);
      EXPECT_EQ(picture, pictureOf("draw " + line + " --shades " + told.substr(0, told.find(' '))));
    }
}

// Seen from so far that 8 x 8 pixels are one spot, a picture is never worse with some free cells than with
// none. If several hues would have too few shades each, or a channel has few levels, the map's colours are
// mixed as they are without free cells. That is decided by the colours that hues can have, not by the
// picture, so where both are about equally near the picture may be a tenth worse.
TEST(SharedCellsProgram, FewCellsShowNoLessThanNone) {
  struct Case {
    int defaultClass;
    std::string scene;
    std::vector<std::size_t> left;  ///< first so few that only black and white serve, then more
  };
  for (const Case& at :
       {Case{3, "hues", {0, 2, 20, 50, 100, 183}}, Case{5, "teapot --divisions 3", {0, 1, 2}}}) {
    SCOPED_TRACE(at.scene);
    const std::string line = at.scene + " --size 160x120";
    const RgbImage drawn = pictureOf("draw " + line);
    const TemporaryFolder folder;
    const std::string file = folder.file("picture.png");
    double none = 0;
    for (const std::size_t left : at.left) {
      const XServer server = XServer::xvfb(8, 640, 480, {"-cc", std::to_string(at.defaultClass)});
      const Stranger stranger{server, left};
      const Finished done =
          runProgram(words("snapshot --colormap shared " + line + " -o " + file), server.name());
      ASSERT_EQ(done.status, 0) << done.err;
      EXPECT_EQ(done.err.find("its colours are mixed") != std::string::npos, left < 183) << done.err;
      const double missed = missOfBlocks(readPng(file), drawn);
      if (left == 0) none = missed;
      EXPECT_LE(missed, left < 183 ? none : none * 1.1) << left;
    }
    EXPECT_GT(none, 0.0);
  }
}

// A scene that is opened in the window looks as if the program had started with it. Few cells make a ramp for
// one hue; for several hues the map's colours are mixed; and for one hue there is a ramp again.
TEST(SharedCellsProgram, AreDividedAnewForAnotherScene) {
  const XServer server = XServer::xvfb(8, 1280, 1024);
  const Stranger stranger{server, 50};
  const TemporaryFolder folder;
  const std::string shared = " --colormap shared", file = folder.file("window.png");
  const Rect seen = aboveStatus(1024, 768);
  const auto fresh = [&](const std::string& scene) {
    const Finished done =
        runProgram(words("snapshot --whole-window " + scene + shared + " -o " + file), server.name());
    EXPECT_EQ(done.err.find("its colours are mixed") != std::string::npos, scene == "hues") << done.err;
    return cropped(readPng(file), seen);
  };
  const RgbImage teapot = fresh("teapot"), hues = fresh("hues");
  const WatchedViewer viewer{server, "teapot" + shared};
  ASSERT_TRUE(viewer.window.comesToShow(teapot, seen));
  EXPECT_EQ(stranger.countFree(), 12u);  // left to others
  const auto open = [&](const std::string& scene) {
    viewer.window.type("e");
    for (int k = 0; k < 20; ++k) viewer.window.press(XK_BackSpace);
    viewer.window.type(scene);
    viewer.window.press(XK_Return);
  };
  open("hues");
  EXPECT_TRUE(viewer.window.comesToShow(hues, seen));
  EXPECT_GT(stranger.countFree(), 30u);  // the ramp is given back
  { const Stranger other{server, 0}; }   // it paints them and ends
  EXPECT_TRUE(comesTrue([&] { return stranger.countFree() > 30u; }));
  open("teapot");
  EXPECT_TRUE(viewer.window.comesToShow(teapot, seen));
  EXPECT_EQ(stranger.countFree(), 12u);  // left to others
}

// The window's status line tells the number of shades. A new hue is stored and nothing is drawn.
TEST(SharedCellsProgram, StoringShowsInTheWindow) {
  struct Case {
    int depth;
    std::string line;
  };
  for (const Case& at : {Case{8, "--colormap shared"}, Case{24, "--visual DirectColor24"}}) {
    SCOPED_TRACE(at.line);
    const XServer server = XServer::xvfb(at.depth, 1280, 1024);
    const WatchedViewer viewer{server, "teapot --divisions 3 " + at.line};
    ASSERT_TRUE(viewer.window.settles());
    RequestRecord record{server, viewer.window.id()};
    viewer.window.type("H");
    EXPECT_TRUE(comesTrue([&] { return record.count(X_StoreColors) == 1; }));
    EXPECT_EQ(record.drawing(), 0);
    viewer.window.press(XK_Right);
    EXPECT_TRUE(comesTrue([&] { return record.drawing() > 0; }));
  }
}

// If the server has no room for another colormap, the default one is used, and the program says so. A visual
// that needs another map is refused.
TEST(SharedCellsProgram, ServeWhereNoMapCanBeMade) {
  const TemporaryFolder folder;
  std::string file;  // another one each time: what was read is not written
  const XServer server = XServer::xvfb(8);
  ASSERT_EQ(setenv("DISPLAY", server.name().c_str(), 1), 0);
  const NoMoreColormaps from;
  const auto snapshot = [&](const std::string& more) {
    file = folder.file("picture" + std::to_string(more.size()) + ".png");
    const std::vector<std::string> line = words("xnewell snapshot cycle --size 160x120 -o " + file + more);
    std::vector<const char*> arguments;
    for (const std::string& word : line) arguments.push_back(word.c_str());
    Options options = parseOptions(static_cast<int>(line.size()), arguments.data()).value();
    settle(options, {});
    testing::internal::CaptureStderr();
    try {
      takeSnapshot(options, readScene(options.scene, 3),
                   [&](const Picture& picture, const std::string& png, const StageTimes&, const Sent&) {
                     writePictures(options, picture, png);
                   });
    } catch (const X11Error& e) {
      return testing::internal::GetCapturedStderr() + "thrown: " + e.what();
    }
    return testing::internal::GetCapturedStderr();
  };
  const std::string told = snapshot("");
  EXPECT_EQ(lines(told), 1u) << told;
  EXPECT_THAT(told, HasSubstr("xnewell: the X server has no room for another colormap ("));
  EXPECT_THAT(told, HasSubstr("BadAlloc"));
  EXPECT_THAT(told, HasSubstr("153 of 240 shades"));
  const RgbImage picture = readPng(file);
  EXPECT_EQ(
      snapshot(" --colormap shared"),
      "xnewell: the default colormap has free cells for 153 of 240 shades, and some for other programs\n");
  EXPECT_EQ(readPng(file), picture);
  EXPECT_THAT(snapshot(" --visual StaticColor8"), testing::StartsWith("thrown: X_CreatePixmap: BadAlloc"));
  unsetenv("DISPLAY");
}

}  // namespace xnewell::THIS_FILE
