#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "shading/color/png.h"
#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

// The sheet stands beside the verdict, and with the mistake the pixel shows what was handed in.
TEST_F(CommandTest, DiagnoseDrawsASheet) {
  ASSERT_EQ(runProgram({"draw", "--mistake", "R-without-2", "bench-n3", "--size", "320x240", "-o",
                        file("wrong.png")})
                .status,
            0);
  const auto wrong = runProgram({"diagnose", "bench-n3", file("wrong.png"), "-o", file("sheet.png")});
  EXPECT_EQ(wrong.status, 1) << wrong.err;
  const RgbImage sheet = readPng(file("sheet.png"));
  EXPECT_EQ(sheet.width, 3 * 320 + 16);

  const auto json =
      nlohmann::json::parse(runProgram({"diagnose", "bench-n3", file("wrong.png"), "--json"}).out);
  EXPECT_EQ(json.at("pixel").at("yours"), json.at("pixel").at("with_mistake"));
}

// R = 2 (N.L) (N - L) is not in the list. With it a row explains 82 % of the faces that tell, and that is no
// name.
TEST_F(CommandTest, DiagnoseHasNoNameForParenthesesInR) {
  const std::string folder = XNEWELL_DATA_DIR "/../tests/data/diagnose/";
  const auto end = runProgram({"diagnose",
                               folder + "scene.json",
                               folder + "parentheses.png",
                               "--shade",
                               "flat",
                               "--eye",
                               "1.5,2.5,9",
                               "--look-at",
                               "0.2,0.1,0",
                               "--up",
                               "0,1,0",
                               "--fov",
                               "30",
                               "--ia",
                               "0.2",
                               "--ip",
                               "0.7",
                               "--ka",
                               "0.9",
                               "--kd",
                               "0.9",
                               "--ks",
                               "0.4",
                               "--n",
                               "8",
                               "--light=-1,1.3,1.1"});
  EXPECT_EQ(end.status, 1) << end.err;
  EXPECT_TRUE(end.out.starts_with("wrong, and none of my ")) << end.out;
}

// The picture that is named for two mistakes tells them apart: the program itself, which shares no code with
// the evaluator that chose the pixel, draws there what is promised.
TEST_F(CommandTest, DiagnoseNamesAScene) {
  for (const auto& [a, b] :
       {std::pair{"RV-abs", "RV-unclamped"}, {"NL-abs", "NL-unclamped"}, {"ks-in-the-power", "right"}}) {
    SCOPED_TRACE(a);
    const auto end = runProgram({"diagnose", "--scene-for", std::string{a} + "," + b, "--json"});
    EXPECT_EQ(end.status, 0) << end.err;
    const auto json = nlohmann::json::parse(end.out);
    EXPECT_EQ(json.at("told_apart"), true);
    EXPECT_GT(json.at("shades_apart"), 2);
    const auto shown = [&](const std::string& mistake) {
      Strings words{"draw", json.at("scene"), "--size", "640x480", "-o", file("a.png")};
      words = words + Strings{"--shade", json.at("shade"), "--table", json.at("table")};
      if (mistake != "right") words = words + Strings{"--mistake", mistake};
      EXPECT_EQ(runProgram(words).status, 0);
      return int{readPng(file("a.png")).pixel(json.at("pixel").at(0), json.at("pixel").at(1))[0]};
    };
    EXPECT_NEAR(shown(a), json.at("first_shows").at("value"), 1.5);
    EXPECT_NEAR(shown(b), json.at("second_shows").at("value"), 1.5);
    EXPECT_NEAR(shown("right"), json.at("right_shows").at("value"), 1.5);
  }
}

}  // namespace xnewell::THIS_FILE
