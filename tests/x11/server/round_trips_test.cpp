#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>

#include "tests/support/seeds.h"
#include "tests/x11/support/watched_viewer.h"
#include "tests/x11/support/x_proxy.h"

#include <X11/keysym.h>

namespace xnewell::THIS_FILE {

// How often the program waits for the server, which is what a slow connection costs.

namespace {

const std::string kTeapot = "teapot --divisions 4";
constexpr Rect kSeen{0, 0, 1024, 724};  ///< the window of 1024 x 768 but for its status line

}  // namespace

// A round trip takes at least the latency, and the latency does not change the picture.
TEST(XProxy, IsLateByItsLatency) {
  constexpr std::chrono::milliseconds kLatency{10};
  const XServer server = XServer::xvfb(8);
  XProxy proxy{server, kLatency};
  const OwnedDisplay display = openDisplay(proxy.name());
  proxy.begin();
  const auto start = std::chrono::steady_clock::now();
  XSync(display.get(), 0);
  EXPECT_GE(std::chrono::steady_clock::now() - start, kLatency);
  EXPECT_EQ(proxy.answered().size(), 1u);
  EXPECT_EQ(proxy.requests(), proxy.answered());
  const std::string line = "snapshot " + kTeapot + " --size 64x48";
  EXPECT_EQ(pictureOf(line, proxy.name()), pictureOf(line, server.name()));
}

class RoundTripsAt : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Depths, RoundTripsAt, testing::ValuesIn(someOf({8, 24}, 1)),
                         testing::PrintToStringParamName());

// New colours are stored without waiting if there is a colormap to store them in. A repaint waits at most
// three times.
TEST_P(RoundTripsAt, AreFew) {
  for (const std::string fill : {"", " --fill x11"}) {
    SCOPED_TRACE(fill);
    const XServer server = XServer::xvfb(GetParam(), 1280, 1024);
    XProxy proxy{server};
    const RunningProgram program{words("view " + kTeapot + fill), proxy.name()};
    const WatchedWindow window{server};
    // The first key asks for the keyboard's mapping.
    ASSERT_TRUE(window.settles());

    const RgbImage before = window.shown(kSeen);
    const auto waits = [&](const std::function<void()>& act, const RgbImage& from) {
      proxy.begin();
      act();
      EXPECT_TRUE(window.comesToDiffer(from, kSeen));
      EXPECT_FALSE(proxy.requests().empty());
      return proxy.answered().size();
    };
    const std::size_t forColors = waits([&] { window.type("H"); }, before);
    EXPECT_LE(forColors, GetParam() == 8 ? 0u : 3u);
    const RgbImage colored = window.shown(kSeen);
    EXPECT_LE(waits([&] { window.press(XK_Right); }, colored), 3u);
    ASSERT_TRUE(window.settles());
    const RgbImage changed = window.shown(kSeen);
    EXPECT_LE(waits([&] { window.type("T"); }, changed), 3u);
  }
}

// In every view, and over a connection that is 50 ms late, a key waits at most three times. What Xlib asks
// for the first watch cursor, which appears when work takes long, is not counted.
TEST_P(RoundTripsAt, AreFewInEveryView) {
  const XServer server = XServer::xvfb(GetParam(), 1280, 1024);
  XProxy proxy{server, std::chrono::milliseconds{50}};
  const RunningProgram program{words("view " + kTeapot), proxy.name()};
  const WatchedWindow window{server};
  window.moveTo(700, 15);  // on nothing
  ASSERT_TRUE(window.settles());
  const auto waits = [&] {
    return std::ranges::count_if(proxy.answered(), [&](const XRequest& request) {
      const std::string name = proxy.nameOf(request);
      return name != "X_QueryExtension" && !name.starts_with("RENDER.") && !name.starts_with("XFIXES.");
    });
  };
  struct Press {
    char view;
    KeySym key;
  };
  for (const auto& [view, key] : {Press{'2', XK_End}, Press{'3', XK_Right}, Press{'4', XK_Down},
                                  Press{'5', XK_n}, Press{'7', XK_Down}, Press{'1', XK_Right}}) {
    SCOPED_TRACE(view);
    RgbImage before = window.shown(kSeen);
    proxy.begin();
    window.type({&view, 1});
    EXPECT_TRUE(window.comesToDiffer(before, kSeen));
    EXPECT_LE(waits(), 3);
    ASSERT_TRUE(window.settles());
    before = window.shown(kSeen);
    proxy.begin();
    window.press(key);
    EXPECT_TRUE(window.comesToDiffer(before, kSeen));
    EXPECT_LE(waits(), 3);
    ASSERT_TRUE(window.settles());
  }
}

}  // namespace xnewell::THIS_FILE
