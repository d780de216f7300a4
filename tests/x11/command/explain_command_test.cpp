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

namespace {

const Strings kPixel{"explain",     "teapot", "288,158", "--size", "404x268",
                     "--divisions", "11",     "--shade", "phong"};

}  // namespace

// The pixel of the manual. Its numbers were also computed by hand from the textbook's formulas: 0.9 x 0.2 +
// 0.7 (0.9 x 0.8948 + 0.4 x 0.9504^20) = 0.8449, 239 x 0.8449 = 201.9, and 11 + 202 = 213.
TEST_F(CommandTest, ExplainsThePixelOfTheManual) {
  const auto end = runProgram(kPixel);
  EXPECT_EQ(end.status, 0) << end.err;
  for (const char* line : {"404 x 268: shaded\n", "4  1954.2, spout ", " 137.131  shows\n",
                           "= 0.90 x 0.20 + 1.0000 x 0.70 [ 0.90 x 0.8948 + 0.40 x 0.9504^20 ]\n",
                           "= 0.1800 + 0.5637 + 0.1012 = 0.8449\n", "cell 11 + 202 = 213\n",
                           "the picture has cell 213 here: the chain explains it\n"})
    EXPECT_NE(end.out.find(line), std::string::npos) << line << end.out;

  const auto json = runProgram(kPixel + Strings{"--json"});
  EXPECT_EQ(json.status, 0) << json.err;
  const Json e = Json::parse(json.out);
  EXPECT_EQ(e.at("cell"), 213);
  EXPECT_EQ(e.at("verdict"), "shaded");
  EXPECT_EQ(e.at("explained"), true);
  EXPECT_NEAR(e.at("I").get<double>(), 0.8449, 5e-5);
  const Json& terms = e.at("terms");
  EXPECT_NEAR(terms.at("ambient").get<double>() + terms.at("diffuse").get<double>() +
                  terms.at("specular").get<double>(),
              e.at("I").get<double>(), 1e-12);
  EXPECT_EQ(e.at("shade"), 202);
  EXPECT_EQ(e.at("table").at("first"), 11);
  EXPECT_NEAR(e.at("interval").at(0).get<double>(), 201.5 / 239, 1e-9);
  EXPECT_NEAR(e.at("interval").at(1).get<double>(), 202.5 / 239, 1e-9);
  EXPECT_EQ(e.at("color"), Json({52171, 0, 0}));
  EXPECT_EQ(e.at("mistake"), "none");
}

// The same pixel with mistakes, by hand: (0.9 x 0.8948 + 0.4 x 0.9504)^20 = 4.76 is far above 1; without the
// exponent the highlight is 0.7 x 0.4 x 0.9504 = 0.2661; with R reversed R.V is below 0.
TEST_F(CommandTest, ExplainsMistakes) {
  const auto lines = [&](const char* mistake, const Strings& expected) {
    const auto end = runProgram(kPixel + Strings{"--mistake", mistake});
    EXPECT_EQ(end.status, 0) << end.err;
    for (const std::string& line : expected)
      EXPECT_NE(end.out.find(line), std::string::npos) << mistake << ": " << line << '\n' << end.out;
    EXPECT_NE(end.out.find("here: the chain explains it\n"), std::string::npos) << end.out;
  };
  lines("n-on-the-sum", {"I = ka Ia + f Ip (kd N.L + ks (R.V))^n\n",
                         "= 0.90 x 0.20 + 1.0000 x 0.70 (0.90 x 0.8948 + 0.40 x 0.9504)^20\n",
                         "a mistake: The exponent is on the sum", ", clamped to 1\n"});
  lines("n-forgotten",
        {"+ f Ip [ kd N.L + ks (R.V) ]\n", "= 0.1800 + 0.5637 + 0.2661 = 1.0098, clamped to 1\n"});
  lines("R-sign", {"+ 0.40 x 0.0000^20 ]\n", "R.V -0.9504, counts as 0; R is L - 2 N (N.L)\n",
                   "= 0.1800 + 0.5637 + 0.0000 = 0.7437\n"});
  lines("spec-forgotten", {"I = ka Ia + f Ip kd N.L\n", "= 0.90 x 0.20 + 1.0000 x 0.70 x 0.90 x 0.8948\n"});
  lines("Ia-forgotten", {"I = f Ip [ kd N.L", "= 0.0000 + 0.5637 + 0.1012 = 0.6649\n"});
  lines("Ia-twice", {"I = 2 ka Ia + f Ip [", "= 2 x 0.90 x 0.20 + 1.0000 x 0.70 ["});
}

// Without ambient light the surface keeps its ka; without any other light the sum has one term, written once.
TEST_F(CommandTest, ExplainsWithoutAmbientLight) {
  const auto dark = runProgram(kPixel + Strings{"--ia", "0"});
  EXPECT_NE(dark.out.find("= 0.90 x 0.00 + "), std::string::npos) << dark.out;
  const Json e = Json::parse(runProgram(kPixel + Strings{"--ia", "0", "--json"}).out);
  EXPECT_DOUBLE_EQ(e.at("equations").at(0).at("ka").get<double>(), 0.9);
  const auto ambient = runProgram(kPixel + Strings{"--ia", "0.3", "--ip", "0"});
  EXPECT_NE(ambient.out.find("= 0.90 x 0.30\n        = 0.2700\n"), std::string::npos) << ambient.out;
}

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

// Three triangles, the second 1 behind the first and the third 4: the corners of the second have z = 1, and
// a = 3 x 4.
TEST_F(CommandTest, ExplainsShadingByDepth) {
  const std::string steps = write("steps.obj",
                                  "v -3 -1 0\nv -1 -1 0\nv -2 1 0\nv -1 -1 -1\nv 1 -1 -1\nv 0 1 -1\n"
                                  "v 1 -1 -4\nv 3 -1 -4\nv 2 1 -4\nf 1 2 3\nf 4 5 6\nf 7 8 9\n");
  const Strings middle{"explain", steps,    "50,50",           "--size",     "100x100",
                       "--eye",   "0,0,20", "--look-at=0,0,0", "--parallel", "8"};
  const Strings byDepth = middle + Strings{"--shade", "depth"};
  const auto end = runProgram(byDepth);
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_NE(end.out.find("      I = 1 - (z1 + z2 + z3) / a\n"
                         "        = 1 - (1 + 1 + 1) / 12 = 0.7500\n"),
            std::string::npos)
      << end.out;
  EXPECT_NE(end.out.find("a = 3 x 4: "), std::string::npos) << end.out;
  EXPECT_EQ(Json::parse(runProgram(byDepth + Strings{"--json"}).out).at("depth"),
            (Json{{"z", {1.0, 1.0, 1.0}}, {"a", 12.0}}));
  // Places have the file's units, too: the centroid of the second triangle.
  const Json flat = Json::parse(runProgram(middle + Strings{"--shade", "flat", "--json"}).out);
  EXPECT_NEAR(flat.at("equations").at(0).at("at").at(1).get<double>(), -1.0 / 3.0, 1e-12);
  EXPECT_DOUBLE_EQ(flat.at("equations").at(0).at("at").at(2).get<double>(), -1.0);
}

// What only rounding tells apart has one depth: two plates through each other whose means are the same. And
// lengths have as many digits as their sum needs: here a steep square reaches much farther than its mean lies
// behind the other square.
TEST_F(CommandTest, ExplainsDepthsThatHardlyDiffer) {
  for (const char* pixel : {"266,162", "200,150"}) {
    const auto one = runProgram({"explain", "penetrate", pixel, "--shade", "depth", "--size", "400x300"});
    EXPECT_NE(one.out.find("      I = 1: all faces have the same depth\n"), std::string::npos) << one.out;
  }
  const std::string steep =
      write("steep.obj",
            "v -2 -1 1000.003\nv -1 -1 -999.997\nv -1 1 -999.997\nv -2 1 1000.003\n"
            "v 1 -1 0.006\nv 2 -1 0.006\nv 2 1 0.006\nv 1 1 0.006\nf 1 2 3 4\nf 5 6 7 8\n");
  const auto end = runProgram({"explain", steep, "62,75", "--shade", "depth", "--size", "200x150", "--vpn",
                               "0,0,1", "--parallel", "6", "--look-at=0,0,0"});
  EXPECT_NE(end.out.find("= 1 - (-999.997 + 1000.003 + 1000.003 - 999.997) / 0.012 = 0.0000\n"),
            std::string::npos)
      << end.out;
  // Rounding gives the farthest face 1e-16, not 0. Twelve decimals would not tell that from the shade's
  // border.
  const std::string tiny = write("tiny.obj",
                                 "v 1 -1 0.9\nv 2 -1 0.9\nv 1.5 1 0.9\n"
                                 "v -2 -1 -0.13\nv -1 -1 -0.29\nv -1.5 1 -0.71\nf 1 2 3\nf 4 5 6\n");
  const Strings farthest{"explain", tiny,    "62,78", "--shade",    "depth", "--size",
                         "200x150", "--vpn", "0,0,1", "--parallel", "6",     "--look-at=0,0,0"};
  const double I = Json::parse(runProgram(farthest + Strings{"--json"}).out).at("I").get<double>();
  ASSERT_GT(I, 0.0);
  ASSERT_LT(I, 1e-15);
  const auto rounded = runProgram(farthest);
  EXPECT_NE(rounded.out.find("      I 0.0000 picks shade 0 of 240"), std::string::npos) << rounded.out;
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

// The vertices have an intensity where it is computed there, and a face without a name has a number alone.
TEST_F(CommandTest, ExplainsVerticesAndNames) {
  const std::string scene =
      write("triangle.json", R"({"objects":[{"polygons":[[[0,0,0],[1,0,0],[0,1,0]]]}]})");
  for (const char* method : {"gouraud", "phong"}) {
    const auto end = runProgram({"explain", scene, "300,350", "--shade", method, "--json"});
    ASSERT_EQ(end.status, 0) << end.err;
    const Json e = Json::parse(end.out);
    EXPECT_EQ(e.at("vertices").size(), 3u);
    for (const Json& vertex : e.at("vertices"))
      EXPECT_EQ(vertex.contains("I"), std::string{method} == "gouraud") << vertex;
    EXPECT_EQ(e.at("history").at(0).at("name"), "0");
  }
}

TEST_F(CommandTest, ExplainsGroundAndAWrongFace) {
  const auto ground = runProgram({"explain", "teapot", "0,0"});
  EXPECT_EQ(ground.status, 0) << ground.err;
  EXPECT_NE(ground.out.find("at 800 x 600: ground\nNo polygon covers this sample."), std::string::npos)
      << ground.out;
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

// A scene without area has a view, but no plane and no N: no stage is blamed for its light, and the picture
// is said to be empty.
TEST_F(CommandTest, ExplainsTheViewingOfNoArea) {
  const std::string scene = write("point.json", R"({"objects":[{"polygons":[[[0,0,0],[0,0,0],[0,0,0]]]}]})");
  const auto end = runProgram({"explain", scene, "--viewing"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.err, "xnewell: note: the picture is empty: no face has an area\n");
  EXPECT_NE(end.out.find("2 VRC: This face has no area."), std::string::npos) << end.out;
  EXPECT_EQ(end.out.find("Shade in the world"), std::string::npos) << end.out;
  EXPECT_NE(end.out.find("6  viewport  400.0000  300.0000"), std::string::npos) << end.out;
  EXPECT_EQ(runProgram({"explain", scene, "400,300"}).err, end.err);
}

TEST_F(CommandTest, ExplainRefuses) {
  refused({"explain"}, 2, "explain needs a scene, such as teapot");
  refused({"explain", "teapot"}, 2,
          "explain needs a pixel X,Y of the picture, such as 400,300: xnewell explain teapot 400,300");
  refused({"explain", "300,200", "teapot"}, 2, "the scene comes first: xnewell explain teapot 300,200");
  refused({"explain", "teapot", "800,3"}, 2, "pixel 800,3 lies outside the picture of 800x600");
  refused({"explain", "teapot", "1e2,3"}, 2,
          "X,Y: '1e2,3' is not a pixel X,Y: two whole numbers from 0, counted from the top left");
  refused({"explain", "teapot", "1,x"}, 2,
          "X,Y: '1,x' is not a pixel X,Y: two whole numbers from 0, counted from the top left");
  refused({"explain", "teapot", "1,1", "-o", file("a.png")}, 2,
          "-o works only with draw, snapshot, figure, trade, extremes, diagnose, judge and grade");
  refused({"explain", "cubes", "1,1", "--viewing"}, 2, "a pixel and --viewing exclude each other");
  refused({"explain", "cubes", "--viewing", "1.x"}, 2,
          "--viewing: '1.x' is not FACE.CORNER or the number of a vertex, such as 495.1 or 1234");
  refused({"draw", "cubes", "--viewing", "1.1", "-o", file("a.png")}, 2,
          "--viewing works only with explain and --view viewing");
  refused({"draw", "teapot", "3,3", "-o", file("a.png")}, 2, "unexpected argument: '3,3'");
}

// Only a face that has convex parts is named with one; a group whose name has a point is none.
TEST_F(CommandTest, ExplainSpeaksOfPartsWhereThereAreSome) {
  const std::string scene =
      write("dot.json", R"({"objects": [{"name": "a.b", "polygons": [[[0, 0, 0], [1, 0, 0], [0, 1, 0]]]}]})");
  const auto end = runProgram({"explain", scene, "380,320"});
  EXPECT_NE(end.out.find("0, a.b"), std::string::npos) << end.out << end.err;
  EXPECT_EQ(end.out.find("convex part"), std::string::npos) << end.out;
}

}  // namespace xnewell::THIS_FILE
