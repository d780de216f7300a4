#include <nlohmann/json.hpp>

#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

namespace {

using FigureCommandTest = CommandTest;

/// How often `what` stands in a text.
int occurrences(const std::string& text, const std::string& what) {
  int count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

}  // namespace

// `figure` writes the format that the file's name asks for, the same bytes each time, with the paper below
// all paths and the command of the picture. The counts of --stats are those of the file.
TEST_F(FigureCommandTest, WritesWhatTheNameAsksFor) {
  const Strings line{"figure",  "cubes",   "--shade", "flat",    "--size",
                     "200x150", "--paper", "#12ff00", "--stats", "-o"};
  const Finished first = runProgram(line + Strings{file("a.svg"), "--ids", file("ids.pdf")});
  ASSERT_EQ(first.status, 0) << first.err;
  const std::string svg = contents(file("a.svg"));
  const auto stats = nlohmann::json::parse(first.out);
  EXPECT_EQ(stats.at("bytes"), svg.size());
  EXPECT_EQ(stats.at("paths"), occurrences(svg, "<path "));
  EXPECT_EQ(stats.at("loops"), occurrences(svg, "z\"") + occurrences(svg, "zM"));
  EXPECT_NE(svg.find("<rect width=\"100%\" height=\"100%\" fill=\"#12ff00\"/>\n<g "), std::string::npos);
  EXPECT_NE(svg.find("<desc>xnewell draw cubes --size 200x150 --shade flat -o picture.png</desc>"),
            std::string::npos);
  EXPECT_TRUE(contents(file("ids.pdf")).starts_with("%PDF-1.4\n"));
  ASSERT_EQ(runProgram(line + Strings{file("b.svg")}).status, 0);
  EXPECT_TRUE(contents(file("b.svg")) == svg);
  ASSERT_EQ(runProgram(line + Strings{file("c.eps"), "--bare"}).status, 0);
  EXPECT_TRUE(contents(file("c.eps")).starts_with("%!PS-Adobe-3.0 EPSF-3.0\n"));
  EXPECT_EQ(contents(file("c.eps")).find("xnewell draw"), std::string::npos);
}

// The face image has faces alone: no lines over them.
TEST_F(FigureCommandTest, TheFaceImageHasNoLines) {
  const Finished end = runProgram({"figure", "cubes", "--size", "200x150", "--edges", "all", "-o",
                                   file("a.svg"), "--ids", file("ids.svg")});
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_GT(occurrences(contents(file("a.svg")), " stroke="), 1);
  EXPECT_EQ(occurrences(contents(file("ids.svg")), " stroke="), 0);
  EXPECT_GT(occurrences(contents(file("ids.svg")), "<path "), 5);
}

// --errors measures the figure as `draw` measures its picture, and both beside each other.
TEST_F(FigureCommandTest, MeasuresItsErrors) {
  const Strings scene{"coarse-teapot", "--size", "200x150", "--shade", "phong", "--errors"};
  const Finished drawn = runProgram(Strings{"draw"} + scene + Strings{"-o", file("a.png")});
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  const auto picture = nlohmann::json::parse(drawn.out).at("errors");
  double last = -1;
  for (const std::string tolerance : {"0", "32"}) {
    const Finished made =
        runProgram(Strings{"figure"} + scene +
                   Strings{"--tolerance", tolerance, "--paper", "#123456", "-o", file("a.svg")});
    ASSERT_EQ(made.status, 0) << made.err;
    const auto errors = nlohmann::json::parse(made.out).at("errors");
    EXPECT_EQ(errors.at("samples"), picture.at("samples"));
    EXPECT_EQ(errors.at("ciede2000_of_the_picture"), picture.at("ciede2000"));
    EXPECT_LE(errors.at("differ"), 20);
    EXPECT_GT(errors.at("ciede2000").at("mean"), last) << "more tolerance, more error";
    last = errors.at("ciede2000").at("mean");
  }
}

// --smooth makes a small PDF of Gouraud shading, and says so where there is none.
TEST_F(FigureCommandTest, SmoothTrianglesInPdf) {
  const Strings scene{"figure", "coarse-teapot", "--size", "200x150", "--shade"};
  const Finished bands =
      runProgram(scene + Strings{"gouraud", "--tolerance", "0", "--stats", "-o", file("a.pdf")});
  const Finished smooth = runProgram(scene + Strings{"gouraud", "--smooth", "--stats", "-o", file("b.pdf")});
  ASSERT_EQ(smooth.status, 0) << smooth.err;
  EXPECT_EQ(smooth.err.find("changed nothing"), std::string::npos);
  EXPECT_NE(contents(file("b.pdf")).find("/ShadingType 4"), std::string::npos);
  EXPECT_LT(3 * nlohmann::json::parse(smooth.out).at("bytes").get<int>(),
            nlohmann::json::parse(bands.out).at("bytes").get<int>());
  const Finished flat = runProgram(scene + Strings{"flat", "--smooth", "-o", file("c.pdf")});
  EXPECT_EQ(flat.status, 0);
  EXPECT_NE(flat.err.find("--smooth changed nothing"), std::string::npos) << flat.err;
}

// Colours that change over a face: one line tells how far they are off, and less tolerance makes more areas.
TEST_F(FigureCommandTest, TellsHowFarColorsAreOff) {
  const auto made = [&](const std::string& method, const std::string& tolerance) {
    return runProgram({"figure", "coarse-teapot", "--size", "200x150", "--shade", method, "--tolerance",
                       tolerance, "--stats", "-o", file("a.svg")});
  };
  for (const std::string method : {"gouraud", "phong"}) {
    const Finished exact = made(method, "0"), coarse = made(method, "4");
    ASSERT_EQ(exact.status, 0) << exact.err;
    const auto fine = nlohmann::json::parse(exact.out), rough = nlohmann::json::parse(coarse.out);
    EXPECT_EQ(fine.at("off"), 0);
    EXPECT_LE(rough.at("off"), 4);
    EXPECT_GT(rough.at("off"), 0);
    EXPECT_GT(fine.at("loops"), rough.at("loops"));
    EXPECT_NE(coarse.err.find("a.svg: colours are at most "), std::string::npos) << coarse.err;
  }
}

}  // namespace xnewell::THIS_FILE
