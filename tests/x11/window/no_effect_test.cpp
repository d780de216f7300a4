#include <gtest/gtest.h>

#include "tests/support/seeds.h"
#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

namespace {

using OptionsWithoutEffect = CommandTest;

}  // namespace

// An option without effect is noted in one line, and the picture is the same. Where the option has an effect
// there is no note, and the picture is another.
TEST_F(OptionsWithoutEffect, AreNamed) {
  struct Case {
    Strings option, moot, counts;
  };
  const std::vector<Case> cases{
      {{"--normals", "sum"}, {"--shade", "flat"}, {"--shade", "phong"}},
      {{"--crease", "30"}, {"--shade", "gouraud"}, {"--shade", "gouraud", "--normals", "sum"}},
      {{"--polygons", "rows"}, {"--shade", "phong"}, {"--shade", "gouraud"}},
      {{"--environment", "published"}, {"--shade", "phong"}, {"--shade", "envmap"}},
      {{"--mapping", "affine"}, {"--shade", "flat"}, {"--shade", "phong"}},
      {{"--sided", "one"}, {"--shade", "depth"}, {"--shade", "flat"}},
      {{"--ia", "0.1"}, {"--shade", "none"}, {}},
      {{"--ip", "0.1"}, {"--shade", "none"}, {}},
      {{"--ka", "0.1"}, {"--shade", "none"}, {}},
      {{"--kd", "0.1"}, {"--shade", "none"}, {}},
      {{"--ks", "0.9"}, {"--shade", "depth"}, {}},
      {{"--light", "1,0,1"}, {"--shade", "depth"}, {}},
      {{"--light-at", "1,-4,1"}, {"--shade", "depth"}, {}},
      {{"--constant-v"}, {"--ks", "0"}, {}},
      {{"--mistake", "n-forgotten"}, {"--shade", "envmap"}, {"--shade", "phong"}},
      {{"--n", "3"}, {"--ks", "0"}, {}},
      {{"--form", "half-vector"}, {"--ks", "0"}, {}},
      {{"--half-vector"}, {"--shade", "none"}, {}},
      {{"--half-vector"}, {"--shade", "envmap"}, {"--shade", "phong"}},
      {{"--form", "tutorial"}, {"--shade", "envmap"}, {"--shade", "phong"}},
      {{"--constant-v"}, {"--shade", "envmap"}, {"--shade", "phong"}},
      {{"--constant-v"}, {"--form", "tutorial"}, {}},
      {{"--constant-l"},
       {"--light-at", "1,-4,1", "--shade", "envmap"},
       {"--light-at", "1,-4,1", "--shade", "phong"}},
      {{"--shades", "20"}, {"--colors", "cube"}, {"--colors", "chosen"}},
      {{"--table", "corrected"}, {"--colors", "cube"}, {}},
      {{"--i0", "0.2"}, {}, {"--table", "corrected"}},
      {{"--pick", "search"}, {"--table", "brief"}, {"--table", "corrected", "--i0", "0.0001"}},
      {{"--hue", "0,1,0"}, {"--colors", "chosen"}, {}},
      {{"--dither"}, {}, {"--colors", "cube"}},
  };
  const auto drawn = [&](const Strings& options) {
    const Finished end = runProgram(
        Strings{"draw", "teapot", "--divisions", "4", "--size", "80x60", "--bare", "-o", file("new.png")} +
        options);
    EXPECT_EQ(end.status, 0) << end.err;
    return std::pair{end.err, contents(file("new.png"))};
  };
  for (const Case& c : someOf(cases, 6)) {
    SCOPED_TRACE(c.option[0]);
    const auto [told, picture] = drawn(c.option + c.moot);
    EXPECT_EQ(told.rfind("xnewell: note: " + c.option[0] + " has no effect here; it applies to ", 0), 0u)
        << told;
    EXPECT_EQ(std::ranges::count(told, '\n'), 1);
    EXPECT_EQ(picture, drawn(c.moot).second);
    const auto [nothing, other] = drawn(c.option + c.counts);
    EXPECT_EQ(nothing, "");
    EXPECT_NE(other, drawn(c.counts).second);
  }
}

}  // namespace xnewell::THIS_FILE
