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

// If a picture leaves out something of its scene, one line says so for each. If a picture is empty, a line
// says why.
TEST_F(OptionsWithoutEffect, WhatIsLeftOutOfTheSceneIsNamed) {
  const auto told = [&](const std::string& scene, const Strings& options) {
    const Finished end =
        runProgram(Strings{"draw", scene, "--size", "80x60", "-o", file("new.png")} + options);
    EXPECT_EQ(end.status, 0) << end.err;
    return end.err;
  };
  const Strings mapped{"--shade", "envmap"}, phong{"--shade", "phong"};
  const std::string far = "xnewell: note: envmap shading puts all lights infinitely far away: ";
  EXPECT_EQ(told("spotlight", mapped), far + "spotlights lose their cones\n");
  EXPECT_EQ(told("lamp", mapped), far + "point lights act as if far away\n");
  EXPECT_EQ(told("textured-cube", mapped),
            "xnewell: note: envmap shading shows no textures: the scene's textures are left out\n");
  EXPECT_EQ(told("textured-cube", {"--shade", "depth"}),
            "xnewell: note: shading without light shows no textures: the scene's textures are left out\n");
  for (const std::string scene : {"spotlight", "lamp", "textured-cube"}) EXPECT_EQ(told(scene, phong), "");
  EXPECT_EQ(told("spotlight", mapped + Strings{"--light", "0,0,1"}), "");

  const auto nothing = [&](const std::string& object, const Strings& options, const std::string& why) {
    const std::string scene = write("empty.json", R"({"objects": [)" + object + "]}");
    EXPECT_EQ(told(scene, options), "xnewell: note: the picture is empty: of " + why + '\n');
  };
  EXPECT_EQ(told(write("point.json", R"({"objects": [{"solid": "cube", "move": [1e300, 0, 0]}]})"), {}),
            "xnewell: note: the picture is empty: no face has an area\n");
  EXPECT_EQ(
      told(write("line.json", R"({"objects": [{"polygons": [[[0, 0, 0], [1, 0, 0], [2, 0, 0]]]}]})"), {}),
      "xnewell: note: the picture is empty: no face has an area\n");
  nothing(R"({"solid": "cube"})", {"--eye", "0,0,9", "--look-at", "0,0,20"},
          "6 polygons 0 have no area on the screen, 0 are culled, 6 lie outside the view");
}

// --attenuation applies to the scene's own lights at places, as it does to the user's light at the same
// place. If neither has a light at a place, it is refused.
TEST_F(OptionsWithoutEffect, AttenuationFadesTheScenesLights) {
  const auto drawn = [&](const std::string& scene, const Strings& options) {
    return draw(scene, options).png;
  };
  const Strings inverse{"--attenuation", "inverse"}, lamp{"--light-at", "-2.3,0,2", "--ip", "0.94"};
  EXPECT_EQ(drawn("lamp", inverse), drawn("lamp", lamp + inverse));
  const Strings linear{"--attenuation", "linear", "--range", "5"};
  EXPECT_EQ(drawn("lamp", linear), drawn("lamp", lamp + linear));
  EXPECT_EQ(drawn("lamp", {"--attenuation", "linear"}),
            drawn("lamp", lamp + Strings{"--attenuation", "linear"}));
  EXPECT_NE(drawn("lamp", inverse), drawn("lamp", {}));
  EXPECT_NE(drawn("lamp", linear), drawn("lamp", {}));
  EXPECT_NE(drawn("lamp", {"--attenuation", "none"}), drawn("lamp", {}));
  EXPECT_NE(drawn("spotlight", inverse), drawn("spotlight", {}));
  refused(Strings{"draw", "teapot", "-o", file("new.png")} + inverse, 2,
          "--attenuation needs a light at a place: give --light-at x,y,z or a scene with such a light");
  refused(Strings{"draw", "lamp", "-o", file("new.png"), "--light", "0,0,1"} + inverse, 2,
          "--attenuation needs a light at a place: give --light-at x,y,z or a scene with such a light");
}

// What a scene file says of light and division gives way to the command line, and is not taken for the user's
// words.
TEST_F(OptionsWithoutEffect, TheFilesChoicesGiveWay) {
  const std::string scene = write("s.json", R"({"objects": [{"solid": "cube"}], "shading": {"method": "flat",
    "adapt": 0.1, "light_at": [3, 3, 3], "attenuation": "linear", "range": 20}})");
  const auto drawn = [&](const Strings& options) { return draw(scene, options).png; };
  EXPECT_NE(drawn({"--light", "0,0,1"}), drawn({}));
  EXPECT_NE(drawn({"--shade", "phong"}), drawn({}));
}

}  // namespace xnewell::THIS_FILE
