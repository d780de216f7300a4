#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <glm/geometric.hpp>

#include "tests/support/seeds.h"
#include "tests/x11/support/command_fixture.h"
#include "x11/drawing/wording.h"

namespace xnewell::THIS_FILE {

// With --constant-l the share of a spot is each place's own. explain prints that place's direction to the
// spot, and its share can be computed from it: 1 inside 15 degrees, 0 outside 17.
TEST_F(CommandTest, ExplainsASpotWithLConstant) {
  const Strings edge{"explain", "spotlight", "400,420", "--shade", "phong", "--constant-l"};
  const auto told = runProgram(edge);
  ASSERT_EQ(told.status, 0) << told.err;
  const std::string says = ": L and the distance are those of the scene's centre\n";
  EXPECT_NE(told.out.find(says), std::string::npos) << told.out;
  EXPECT_EQ(runProgram({"explain", "spotlight", "400,420"}).out.find(says), std::string::npos);
  const glm::dvec3 spot{-1.5, 1, 7}, axis = glm::normalize(glm::dvec3{0.2, 0, 0} - spot);
  int between = 0;
  for (int y = 300; y < 560; y += 3) {
    Strings pixel = edge;
    pixel[2] = "400," + std::to_string(y);
    pixel.emplace_back("--json");
    const Json e = Json::parse(runProgram(pixel).out);
    if (e.at("history").empty()) continue;
    const Json& equation = e.at("equations").at(0);
    const Json& light = equation.at("lights").at(0);
    const auto vector = [](const Json& v) { return glm::dvec3{v.at(0), v.at(1), v.at(2)}; };
    const glm::dvec3 ownL = vector(light.at("L_for_cone"));
    EXPECT_LT(glm::length(ownL - glm::normalize(spot - vector(equation.at("at")))), 1e-12);
    EXPECT_GT(glm::length(ownL - vector(light.at("L"))), 1e-4);
    const auto cosine = [](double degrees) { return std::cos(degrees * std::acos(-1.0) / 180); };
    const double share =
        std::clamp((glm::dot(-ownL, axis) - cosine(17)) / (cosine(15) - cosine(17)), 0.0, 1.0);
    EXPECT_NEAR(light.at("spot"), share, 1e-9);
    between += share > 0 && share < 1;
  }
  EXPECT_GT(between, 1);
}

// The cell is that of the picture that `draw` writes, for every method, with textures, colours and lights.
TEST_F(CommandTest, ExplainsWhatDrawWrites) {
  for (const char* scene : someOf({"teapot", "hues", "colored-lights", "textured-cube", "spotlight"}, 2))
    for (const char* method : {"none", "depth", "flat", "gouraud", "phong", "envmap"}) {
      const Strings settings{"--size", "160x120", "--shade", method, "--colors", "one"};
      ASSERT_EQ(runProgram(Strings{"draw", scene, "-o", file("a.png")} + settings).status, 0);
      const auto explained = runProgram(Strings{"explain", scene, "80,70", "--json"} + settings);
      ASSERT_EQ(explained.status, 0) << explained.err;
      const Json e = Json::parse(explained.out);
      // Cell i of the linear table holds (i - 10) / 255 of red.
      const RgbImage drawn = readPng(file("a.png"));
      EXPECT_EQ(e.at("cell"), 10 + drawn.rgb[3 * (70 * 160 + 80)]) << scene << ' ' << method;
      EXPECT_EQ(e.at("explained"), true) << scene << ' ' << method;
      const auto told = runProgram(Strings{"explain", scene, "80,70"} + settings);
      EXPECT_EQ(told.status, 0) << told.err;
      EXPECT_NE(told.out.find("the chain explains it"), std::string::npos) << told.out;
    }
}

// Where the cells hold colours, the chain ends in the nearest of them. Both colours have one unit.
TEST_F(CommandTest, ExplainsColors) {
  for (const char* scene : someOf({"colored-lights", "textured-cube"}, 1)) {
    const auto end = runProgram({"explain", scene, "400,300"});
    ASSERT_EQ(end.status, 0) << end.err;
    EXPECT_NE(end.out.find("here: the chain explains it\n"), std::string::npos) << end.out;
    std::array<int, 3> wanted{}, held{};
    const auto read = [&](const char* before, std::array<int, 3>& color) {
      const std::size_t at = end.out.find(before);
      ASSERT_NE(at, std::string::npos) << before << end.out;
      ASSERT_EQ(std::sscanf(end.out.c_str() + at + std::strlen(before), "%d, %d, %d", &color[0], &color[1],
                            &color[2]),
                3);
    };
    read("; as a colour ", wanted);
    read(" has ", held);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_LT(std::abs(wanted[c] - held[c]), 24) << end.out;
  }
}

TEST_F(CommandTest, ExplainsAWrongFace) {
  // Somewhere on the way along the spout's foot, the sort by z shows a face that another one hides.
  int wrong = 0;
  for (int x = 480; x < 620 && wrong == 0; x += 4) {
    const auto end =
        runProgram({"explain", "teapot", std::to_string(x) + ",330", "--order", "zsort", "--json"});
    wrong += Json::parse(end.out).at("verdict") == "wrong face";
  }
  EXPECT_EQ(wrong, 1);
}

// The vertex of the manual: the text has the numbers of the JSON object, rounded; the matrices lead from row
// to row; and in the JSON object the product of all of them leads to the snapped vertex.
TEST_F(CommandTest, ExplainsTheViewing) {
  const Strings vertex{"explain", "teapot", "--viewing", "495.1", "--prp=-4,1,12"};
  const auto end = runProgram(vertex);
  EXPECT_EQ(end.status, 0) << end.err;
  const auto json = runProgram(vertex + Strings{"--json"});
  EXPECT_EQ(json.status, 0) << json.err;
  const Json e = Json::parse(json.out);
  EXPECT_EQ(e.at("vertex"), "495.1");
  EXPECT_EQ(e.at("group"), "upper body");
  EXPECT_EQ(e.at("agrees"), true);
  for (const Json& stage : e.at("stages")) {
    const std::string name = stage.at("name").get<std::string>();
    if (name == "clipped" || name == "snapped") continue;
    const std::string row = fixed(stage.at("N").at(2).get<double>(), 4) + "  " +
                            fixed(stage.at("N.L").get<double>(), 4) + "  " +
                            fixed(stage.at("I").get<double>(), 4);
    EXPECT_NE(end.out.find(row), std::string::npos) << name << ": " << row << '\n' << end.out;
  }
  const auto NdotL = [&](int stage) { return e.at("stages").at(stage).at("N.L").get<double>(); };
  EXPECT_NEAR(NdotL(1), NdotL(0), 1e-14);
  EXPECT_GT(std::abs(NdotL(2) - NdotL(0)), 0.05);
  const Json& place = e.at("stages").at(0).at("at");
  std::array<double, 4> q{};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t k = 0; k < 4; ++k)
      q[row] += e.at("stages").at(6).at("so_far").at(row).at(k).get<double>() * place.at(k).get<double>();
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(q[k] / q[3] * 65536, e.at("snapped").at(k).get<double>(), 0.5001) << k;
  for (const char* line :
       {"2 VRC: A turn keeps angles.", "3 sheared: Shade in the world, not behind the shear.",
        "the one that the stages lead to, to the last bit\n", "matrix 3 sheared: SH T(-PRP)\n"})
    EXPECT_NE(end.out.find(line), std::string::npos) << line << end.out;
}

// Without a vertex it takes one in the middle, and the number of a vertex is one of its corners.
TEST_F(CommandTest, ExplainsTheViewingOfAnyVertex) {
  for (const char* scene : someOf({"teapot", "cubes", "hues", "colored-lights", "textured-cube"}, 2))
    for (const Strings& view : {Strings{}, Strings{"--oblique", "cabinet"}, Strings{"--fov", "60"}}) {
      for (const Strings& which :
           {Strings{"--viewing"}, Strings{"--viewing", "3"}, Strings{"--viewing=0.2"}}) {
        const auto end = runProgram(Strings{"explain", scene} + which + view + Strings{"--json"});
        ASSERT_EQ(end.status, 0) << end.err;
        EXPECT_EQ(Json::parse(end.out).at("agrees"), true) << scene;
      }
      const auto end = runProgram(Strings{"explain", scene, "--viewing"} + view);
      EXPECT_EQ(end.out.find("nan"), std::string::npos) << end.out;
    }
}

}  // namespace xnewell::THIS_FILE
