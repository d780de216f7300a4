#include <gtest/gtest.h>

#include "tests/command_fixture.h"

namespace {

using MootOptions = CommandTest;

}  // namespace

// Of an option that does nothing the user is told, in one line, beside the picture; where it counts nothing
// is said, and the picture is then another.
TEST_F(MootOptions, AreNamed) {
  struct Case {
    Words option, moot, counts;
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
      {{"--n", "3"}, {"--ks", "0"}, {}},
      {{"--form", "half-vector"}, {"--ks", "0"}, {}},
      {{"--half-vector"}, {"--shade", "none"}, {}},
      {{"--table", "corrected"}, {"--colors", "cube"}, {}},
      {{"--i0", "0.2"}, {}, {"--table", "corrected"}},
      {{"--pick", "search"}, {"--table", "brief"}, {"--table", "corrected", "--i0", "0.0001"}},
      {{"--hue", "0,1,0"}, {"--colors", "chosen"}, {}},
      {{"--dither"}, {}, {"--colors", "cube"}},
  };
  const auto drawn = [&](const Words& options) {
    const Finished end = runProgram(
        Words{"draw", "teapot", "--divisions", "4", "--size", "80x60", "-o", file("new.png")} + options);
    EXPECT_EQ(end.status, 0) << end.err;
    return std::pair{end.err, contents(file("new.png"))};
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.option[0]);
    const auto [told, picture] = drawn(c.option + c.moot);
    EXPECT_EQ(told.rfind("xnewell: note: " + c.option[0] + " does nothing here; it counts with ", 0), 0u)
        << told;
    EXPECT_EQ(std::ranges::count(told, '\n'), 1);
    EXPECT_EQ(picture, drawn(c.moot).second);
    const auto [nothing, other] = drawn(c.option + c.counts);
    EXPECT_EQ(nothing, "");
    EXPECT_NE(other, drawn(c.counts).second);
  }
}
