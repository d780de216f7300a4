#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

#include "tests/x11/support/watched_viewer.h"
#include "tests/x11/support/x_server.h"
#include "x11/visual/visual.h"

namespace xnewell::THIS_FILE {

// Pictures of the program on gray visuals and on those of few colours. Every index on every visual:
// visual_matrix_test.cpp.

namespace {

using Color = std::array<int, 3>;  ///< 8-bit values

}  // namespace

// On gray visuals a ramp of one hue shows the intensities, as a white ramp would: the hue does not darken
// them. Colours outside the ramp, here the ground, have the gray of their brightness.
TEST(GrayVisuals, ShowTheIntensity) {
  const XServer server = XServer::xvfb(8);
  for (const std::string line :
       {"teapot --divisions 3 --size 160x120", "cycle --table corrected --hue 0.2,1,0.4 --size 160x120"}) {
    SCOPED_TRACE(line);
    const RgbImage drawn = pictureOf("draw " + line);
    for (const std::string visual : {"GrayScale8", "StaticGray8"}) {
      const RgbImage shown = pictureOf("snapshot " + line + " --visual " + visual, server.name());
      int ground = 0;
      for (std::size_t k = 0; k < drawn.rgb.size(); k += 3) {
        const auto* c = &drawn.rgb[k];
        const bool well = c[0] == 0x2A && c[1] == 0x2E && c[2] == 0x35;
        ground += well;
        const int expected =
            well ? (30 * 0x2A2A + 59 * 0x2E2E + 11 * 0x3535) / 100 >> 8 : *std::max_element(c, c + 3);
        for (int channel = 0; channel < 3; ++channel) ASSERT_EQ(shown.rgb[k + channel], expected) << k / 3;
      }
      EXPECT_GT(ground, 1000);
      EXPECT_LT(ground, 160 * 120 - 1000);
    }
  }
}

// With --nearest each colour of the picture becomes one colour of the screen. Without it, it becomes several.
TEST(FewColors, NearestIsAFunctionOfTheColour) {
  const XServer server = XServer::xvfb(8);
  const std::string line = "teapot --divisions 3 --size 160x120";
  const RgbImage drawn = pictureOf("draw " + line);
  for (const std::string more : {"", " --nearest"}) {
    const RgbImage shown = pictureOf("snapshot --visual TrueColor8 " + line + more, server.name());
    std::map<Color, std::set<Color>> became;
    for (std::size_t k = 0; k < drawn.rgb.size(); k += 3)
      became[{drawn.rgb[k], drawn.rgb[k + 1], drawn.rgb[k + 2]}].insert(
          {shown.rgb[k], shown.rgb[k + 1], shown.rgb[k + 2]});
    EXPECT_GT(became.size(), 50u);
    const auto several =
        std::ranges::count_if(became, [](const auto& entry) { return entry.second.size() > 1; });
    if (more.empty()) {
      EXPECT_GT(several, 30);
    } else {
      EXPECT_EQ(several, 0);
    }
  }
}

// On every visual class the window follows its keys. It shows what a fresh start with the new hue shows, and
// then what a fresh start with the server filling shows.
TEST(FewColors, TheWindowFollows) {
  for (int defaultClass = 0; defaultClass < 6; ++defaultClass) {
    const XServer server = XServer::xvfb(8, 1280, 1024, {"-cc", std::to_string(defaultClass)});
    const std::string visual{kVisualClasses[defaultClass].name};
    SCOPED_TRACE(visual);
    const std::string line = "teapot --divisions 3 --visual " + visual;
    const WatchedViewer viewer{server, line};
    const Rect seen = aboveStatus(1024, 768);
    EXPECT_TRUE(viewer.window.comesToShow(freshWindow(server, line), seen));
    viewer.window.type("H");
    EXPECT_TRUE(viewer.window.comesToShow(freshWindow(server, line + " --hue 1,0.7,0"), seen));
    viewer.window.type("uF");
    EXPECT_TRUE(viewer.window.comesToShow(freshWindow(server, line + " --fill x11"), seen));
    viewer.window.type("H");  // what the server fills follows, too
    EXPECT_TRUE(viewer.window.comesToShow(freshWindow(server, line + " --hue 1,0.7,0 --fill x11"), seen));
  }
}

}  // namespace xnewell::THIS_FILE
