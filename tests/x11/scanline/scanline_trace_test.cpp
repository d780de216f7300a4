#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

// The lines of a filled polygon are JSON. Every sample of its spans has a pixel line, by steps and directly
// the same cell, and the values of a row are its first value and its increment.
TEST_F(CommandTest, TracesAScanline) {
  const auto end = runProgram(
      {"trace", "teapot", "--scanline", "59", "--shade", "gouraud", "--size", "200x150", "--divisions", "3"});
  ASSERT_EQ(end.status, 0) << end.err;
  std::istringstream lines{end.out};
  Json row, last;
  int samples = 0, spanned = 0, edges = 0;
  for (std::string line; std::getline(lines, line);) {
    const Json e = Json::parse(line);
    const std::string event = e.at("event");
    EXPECT_FALSE(e.at("says").get<std::string>().empty());
    edges += event == "edge";
    if (event == "row") {
      row = e;
      spanned += e.at("to").get<int>() - e.at("from").get<int>() + 1;
    }
    if (event == "pixel") {
      ++samples;
      EXPECT_EQ(e.at("step"), samples);
      EXPECT_EQ(e.at("cell"), e.at("direct_cell"));
      EXPECT_EQ(e.at("pixel").at(1), row.at("row"));
      const Json& value = row.at("values").at("value");
      const double along = e.at("pixel").at(0).get<double>() + 0.5 - row.at("left").at("x").get<double>();
      EXPECT_NEAR(value.at("left").get<double>() + along * value.value("increment", 0.0),
                  e.at("by_steps").get<double>(), 1e-4);
    }
    last = e;
  }
  EXPECT_EQ(last.at("event"), "summary");
  EXPECT_EQ(last.at("samples"), samples);
  EXPECT_EQ(samples, spanned);
  EXPECT_GT(samples, 50);
  EXPECT_EQ(edges, 6);
}

// A scene whose cells hold colours is traced in one hue, and says so.
TEST_F(CommandTest, TracesColorsInOneHue) {
  for (const char* scene : {"colored-lights", "teapot"}) {
    const auto end = runProgram({"trace", scene, "--scanline", "410", "--size", "200x150"});
    ASSERT_EQ(end.status, 0) << end.err;
    const Json polygon = Json::parse(end.out.substr(0, end.out.find('\n')));
    const bool colored = scene != std::string{"teapot"};
    EXPECT_EQ(polygon.at("one_hue"), colored);
    EXPECT_EQ(polygon.at("says").get<std::string>().find("one hue") != std::string::npos, colored);
  }
}

// A polygon that is not there, or too large, is one line.
TEST_F(CommandTest, RefusesScanlines) {
  refused({"trace", "cubes", "--scanline", "99"}, 2, "--scanline: the picture of cubes has no face 99");
  refused({"trace", "cubes", "--scanline", "1.2"}, 2,
          "--scanline: the picture of cubes has no face 1.2: of face 1 it has 1 convex part, 1");
  refused({"trace", "cubes", "--scanline", "one"}, 2,
          "--scanline: 'one' is not a row or a face, such as 59, or a part of a face, such as 59.2");
  refused({"trace", "cubes", "--scanline", "1", "--size", "2000x2000"}, 2,
          "--scanline: face 1 has more than 20,000 samples: use a smaller --size");
  refused({"trace", "cubes", "--scanline", "1", "--quick"}, 2, "--scanline and --quick exclude each other");
  refused({"draw", "cubes", "-o", "no.png", "--view", "machbands", "--scanline", "1.5"}, 2,
          "--scanline: '1.5' is not a whole number from 0 to 8191");
}

}  // namespace xnewell::THIS_FILE
