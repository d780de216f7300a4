#include <gtest/gtest.h>

#include "tests/support/seeds.h"
#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

/// Settings in a scene file and on the command line. The command line wins, then the scene, then the
/// program's defaults.

namespace {

class SceneCommandTest : public CommandTest {
 protected:
  /// A scene file with a sphere and these settings.
  [[nodiscard]] std::string sphere(const std::string& name, const std::string& said,
                                   const std::string& ofObject = "") const {
    return write(name, R"({"up": "z", )" + said +
                           R"("objects": [{"solid": "sphere", "around": 9, "down": 6)" + ofObject + "}]}");
  }
};

}  // namespace

// A setting in a scene has the same effect as its option, and each option has the same effect over both.
TEST_F(SceneCommandTest, OptionsWinOverTheSceneOverDefaults) {
  const std::string plain = sphere("plain.json", "");
  const std::string asks =
      sphere("asks.json", R"("shading": {"method": "gouraud", "normals": "sum", "crease": 100,
    "polygons": "rows", "form": "half-vector", "order": "zsort", "Ia": 0.05, "Ip": 0.9, "ka": 0.8, "kd": 0.7,
    "ks": 0.6, "n": 5, "light": [-1, -1, 0], "table": {"kind": "corrected", "shades": 40, "i0": 0.1,
    "pick": "search", "hue": [0, 1, 0.5], "bits": 8}}, )");
  const std::vector<Strings> same{
      {"--shade", "gouraud"},    {"--normals", "sum"},     {"--crease", "100"}, {"--polygons", "rows"},
      {"--form", "half-vector"}, {"--order", "zsort"},     {"--ia", "0.05"},    {"--ip", "0.9"},
      {"--ka", "0.8"},           {"--kd", "0.7"},          {"--ks", "0.6"},     {"--n", "5"},
      {"--light", "-1,-1,0"},    {"--table", "corrected"}, {"--shades", "40"},  {"--i0", "0.1"},
      {"--pick", "search"},      {"--hue", "0,1,0.5"},     {"--bits", "8"}};
  const std::vector<Strings> other{
      {"--shade", "phong"},   {"--normals", "distinct"}, {"--crease", "0"},  {"--polygons", "triangles"},
      {"--form", "textbook"}, {"--order", "newell"},     {"--ia", "0.1"},    {"--ip", "0.5"},
      {"--ka", "0.1"},        {"--kd", "0.1"},           {"--ks", "0.1"},    {"--n", "50"},
      {"--light", "-1,1,1"},  {"--table", "brief"},      {"--shades", "10"}, {"--i0", "0.3"},
      {"--pick", "log"},      {"--hue", "1,0,0"},        {"--bits", "16"}};
  Strings all;
  for (const Strings& option : same) all = all + option;
  const std::string as = draw(asks).png;
  EXPECT_EQ(as, draw(plain, all).png);
  EXPECT_NE(as, draw(plain).png);

  const std::size_t tried = kSanitized ? 5 : same.size();
  std::size_t changed = 0;
  for (std::size_t k = 0; k < tried; ++k) {
    Strings rest = other[k];
    for (std::size_t i = 0; i < same.size(); ++i)
      if (i != k) rest = rest + same[i];
    const std::string over = draw(asks, other[k]).png;
    EXPECT_EQ(over, draw(plain, rest).png) << other[k][0];
    changed += over != as;
  }
  EXPECT_GE(changed + 4, tried);  // not every one can be seen: for a sphere alone the order does not matter
}

// An option of light replaces the scene's own light, and an option of surfaces replaces the scene's surfaces.
TEST_F(SceneCommandTest, OwnLightAndSurfacesGiveWay) {
  const std::string plain = sphere("plain.json", "");
  const std::string lit =
      sphere("lit.json", R"("ambient": 0.1, "lights": [{"Ip": 0.6, "towards": [1, 0, 0]}], )");
  EXPECT_NE(draw(lit).png, draw(plain).png);
  const Strings light{"--ia", "0.3", "--ip", "0.4", "--light", "0,0,1"};
  EXPECT_EQ(draw(lit, light).png, draw(plain, light).png);
  EXPECT_EQ(draw(lit, {"--light", "0,0,1"}).png, draw(plain, {"--light", "0,0,1", "--ia", "0.1"}).png);
  EXPECT_EQ(draw(lit, {"--light-at", "0,0,3"}).png, draw(plain, {"--light-at", "0,0,3", "--ia", "0.1"}).png);
  EXPECT_EQ(draw(lit, {"--ia", "0.3"}).png,
            draw(plain, {"--ia", "0.3", "--ip", "0.6", "--light", "1,0,0"}).png);

  // This ambient light leaves less for Ip than the user's default.
  const std::string bright = sphere("bright.json", R"("ambient": 0.5, )");
  EXPECT_EQ(draw(bright).png, draw(plain, {"--ia", "0.5", "--ip", "0.5"}).png);
  EXPECT_EQ(draw(bright, {"--light", "0,0,1"}).png,
            draw(plain, {"--ia", "0.5", "--ip", "0.5", "--light", "0,0,1"}).png);

  const std::string shiny =
      sphere("shiny.json", R"("materials": {"m": {"ka": 0.1, "kd": 0.2, "ks": 0.3, "n": 4}}, )",
             R"(, "material": "m")");
  const Strings surface{"--ka", "0.1", "--kd", "0.2", "--ks", "0.3", "--n", "4"};
  EXPECT_EQ(draw(shiny).png, draw(plain, surface).png);
  for (std::size_t k = 0; k < surface.size(); k += 2) {
    Strings rest = surface;
    rest[k + 1] = "1";
    EXPECT_EQ(draw(shiny, {surface[k], "1"}).png, draw(plain, rest).png) << surface[k];
    EXPECT_NE(draw(shiny, {surface[k], "1"}).png, draw(shiny).png) << surface[k];
  }
}

// Settings that exclude each other are refused, whether the scene or the command line gives them.
TEST_F(SceneCommandTest, RefusesWhatExceedsOrCannotBeShown) {
  const std::string lit = sphere("lit.json", R"("lights": [{"Ip": 0.6}], )");
  const std::string ambient = sphere("ambient.json", R"("ambient": 0.6, )");
  const std::string smooth = sphere("smooth.json", R"("shading": {"method": "gouraud"}, )");
  const Strings to{"-o", file("new.png")};
  refused(Strings{"draw", lit, "--ia", "0.5"} + to, 2,
          "--ia and the scene's lights: their sum must not exceed 1");
  refused(Strings{"draw", ambient, "--ip", "0.5"} + to, 2,
          "--ip and the scene's ambient light: their sum must not exceed 1");
  refused(Strings{"snapshot", smooth, "--fill", "x11"} + to, 2,
          "--fill x11 gives a polygon one cell: use --shade none, depth or flat");
  refused(Strings{"snapshot", "textured-cube", "--shade", "flat", "--fill", "x11"} + to, 2,
          "--fill x11 paints each polygon in one colour, so it cannot show the scene's textures");
  EXPECT_EQ(runProgram(Strings{"draw", lit, "--ia", "0.4"} + to).status, 0);
  EXPECT_EQ(runProgram(Strings{"draw", ambient, "--ip", "0.4"} + to).status, 0);
  const std::string decimals =
      sphere("decimals.json", R"("lights": [{"Ip": 0.55}, {"Ip": 0.3}, {"Ip": 0.1}], )");
  EXPECT_GT(0.05 + 0.55 + 0.3 + 0.1, 1.0);  // in doubles
  EXPECT_EQ(runProgram(Strings{"draw", decimals, "--ia", "0.05"} + to).status, 0);
}

// A command about the depth sort says so if the scene asks for another order.
TEST_F(SceneCommandTest, TraceFollowsTheDepthSort) {
  const Finished end = runProgram({"trace", sphere("s.json", R"("shading": {"order": "zmean"}, )")});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_GT(std::ranges::count(end.out, '\n'), 54);
}

// The user's number of divisions applies to patches that do not give their own.
TEST_F(SceneCommandTest, DivisionsOfPatches) {
  EXPECT_EQ(draw("saturated", {"--divisions", "2"}).stats["faces"], 128);
  EXPECT_EQ(draw("coarse-teapot", {"--divisions", "2"}).stats["faces"], 288);
}

// The program says so if a tolerance is not reached. This happens at the rim of a hard spot, which is a step,
// but not at a soft one.
TEST_F(SceneCommandTest, TellsWhereAdaptIsNotReached) {
  const auto told = [&](const std::string& outer) {
    const std::string floor = write("floor.json", R"({"up": "z", "shading": {"method": "gouraud"}, "lights": [
      {"kind": "spot", "Ip": 0.7, "at": [0.1, 0.2, 4], "look_at": [0, 0, 0], "inner": 15, "outer": )" +
                                                      outer + R"(}],
      "objects": [{"polygons": [[[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0]]]}]})");
    const Finished end = runProgram(Strings{"draw", floor, "-o", file("out.png"), "--adapt", "0.1"});
    EXPECT_EQ(end.status, 0);
    return end.err;
  };
  EXPECT_EQ(told("15"),
            "xnewell: --adapt 0.1 is not reached everywhere: that would take parts smaller than a "
            "thousandth of a polygon\n");
  EXPECT_EQ(told("25"), "");
}

// A cube on a floor of 16 km is seen. What is nearer than the default front plane can be is told, and the
// user's plane keeps the file's eye.
TEST_F(SceneCommandTest, TellsWhatTheFrontPlaneCutsAway) {
  const auto ground = [&](const std::string& height) {
    return write("ground.json", R"({"up": "z", "camera": {"eye": [0, -6, )" + height +
                                    R"(], "look_at": [0, 0, 0], "fov": 40}, "objects": [
        {"solid": "cube", "move": [0, 0, 1]},
        {"polygons": [[[-8000, -8000, 0], [8000, -8000, 0], [8000, 8000, 0], [-8000, 8000, 0]]]}]})");
  };
  const auto seen = draw(ground("3"));
  EXPECT_EQ(seen.stats["cut_by_front"], 0);
  EXPECT_EQ(seen.stats["painted"], 7);
  EXPECT_EQ(draw(ground("0.001")).stats["cut_by_front"], 1);
  const Finished end = runProgram(Strings{"draw", ground("0.001"), "-o", file("out.png")});
  EXPECT_EQ(
      end.err,
      "xnewell: note: the front plane cuts away 1 polygon in view, wholly or in part; --front moves it\n");
  EXPECT_EQ(draw(ground("0.001"), {"--front", "5.9"}).stats["cut_by_front"], 0);
  EXPECT_EQ(draw(ground("3"), {"--back", "-20000"}).stats["painted"], 7);
}

}  // namespace xnewell::THIS_FILE
