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

// A figure that cannot be made leaves the old file as it was.
TEST_F(FigureCommandTest, KeepsTheOldFile) {
  const std::string old = write("old.svg", "mine");
  EXPECT_EQ(runProgram({"figure", "teapot", "--max-fragments", "10", "-o", old}).status, 1);
  EXPECT_EQ(runProgram({"figure", "teapot", "--shade", "phong", "-o", old}).status, 2);
  EXPECT_EQ(contents(old), "mine");
}

}  // namespace xnewell::THIS_FILE
