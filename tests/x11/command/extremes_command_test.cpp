#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "shading/color/png.h"
#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

// The table has a line for each way, the chart is a picture, and the JSON has every step.
TEST_F(CommandTest, ExtremesAreTold) {
  const Strings words{"extremes", "cycle", "--size", "40x30"};
  const auto table = runProgram(words + Strings{"-o", file("chart.png")});
  EXPECT_EQ(table.status, 0) << table.err;
  for (const char* way : {"scaled up by (powers of two)", "moved by", "eye falls to", "I0 down to"})
    EXPECT_NE(table.out.find(way), std::string::npos) << way;
  EXPECT_TRUE(std::filesystem::file_size(file("chart.png")) > 1'000);

  const auto printed = runProgram(words + Strings{"--json"});
  EXPECT_EQ(printed.status, 0) << printed.err;
  const auto json = nlohmann::json::parse(printed.out);
  EXPECT_EQ(json.at("scene"), "cycle");
  ASSERT_GE(json.at("extremes").size(), 11u);
  for (const auto& way : json.at("extremes"))
    for (const auto& step : way.at("steps")) EXPECT_GE(step.at("samples").get<int>(), 0);
}

// A set-up that is wrong from the start is told once, above the table, and no way claims to explain it.
TEST_F(CommandTest, ExtremesTellASetUpThatIsWrong) {
  const auto end = runProgram({"extremes", "two-cards", "--size", "40x30"});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_TRUE(end.out.starts_with("The set-up itself is wrong: a face that is not the nearest at "))
      << end.out;
  EXPECT_NE(end.out.find("1 to 2^900    wrong as the set-up itself, at all values\nscaled down"),
            std::string::npos)
      << end.out;
}

// Where numbers are so large that no light can be computed, cells are told wrong, and nothing else happens.
TEST_F(CommandTest, ExtremesOfAPillarAsLongAsTheWorld) {
  const auto end = runProgram(
      {"extremes", XNEWELL_DATA_DIR "/../tests/data/long-pillar.json", "--size", "16x12", "--json"});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_EQ(Json::parse(end.out).at("extremes").size(), 13u);
}

// After an interrupt the finished ways are told, and that it was stopped. A second interrupt ends the
// program.
TEST_F(CommandTest, ExtremesCanBeInterrupted) {
  const Strings words{"extremes", "cycle", "--size", "1200x900", "-o", file("chart.png")};
  bool some = false;
  for (int seconds = 1; !some && seconds <= 32; seconds *= 2) {
    std::filesystem::remove(file("chart.png"));
    RunningProgram child{words};
    std::this_thread::sleep_for(std::chrono::seconds{seconds});
    child.signal(SIGINT);
    const Finished end = child.wait();
    ASSERT_EQ(end.status, 130) << end.out;
    if (!end.out.starts_with("Stopped: ")) continue;  // on a busy machine it may not have begun
    EXPECT_EQ(end.out.find("light falls to"), std::string::npos);
    EXPECT_GT(readPng(file("chart.png")).height, 50);
    some = end.out.find("scaled up by (powers of two)") != std::string::npos;
  }
  EXPECT_TRUE(some);

  std::filesystem::remove(file("chart.png"));
  RunningProgram child{words};
  std::this_thread::sleep_for(std::chrono::milliseconds{500});
  child.signal(SIGINT);
  child.signal(SIGINT);
  EXPECT_EQ(child.wait().status, 130);
}

// If the system refuses threads, one thread does all.
TEST_F(CommandTest, ExtremesNeedNoThread) {
  const Strings words{"extremes", "cycle", "--size", "8x6"};
  ::setenv("XNEWELL_HINDER", "alone", 1);
  RunningProgram alone{builtProgram("tests/xnewell_hindered"), words, ""};
  ::unsetenv("XNEWELL_HINDER");
  const Finished end = alone.wait();
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_EQ(end.out, runProgram(words).out);
}

// A chart that cannot be written is an error before anything is measured: the size would take hours.
TEST_F(CommandTest, ExtremesCheckTheirOutputFirst) {
  const Strings words{"extremes", "teapot", "--size", "8192x8192", "-o"};
  refused(words + Strings{file("none/chart.png")}, 1, file("none/chart.png") + ": No such file or directory");
  std::filesystem::create_directory(file("folder.png"));
  refused(words + Strings{file("folder.png")}, 1, file("folder.png") + ": Is a directory");
  refused(words + Strings{file("old.png/chart.png")}, 1, file("old.png/chart.png") + ": Not a directory");
}

TEST_F(CommandTest, ExtremesRefuseWhatTheyDoNotTake) {
  refused({"extremes"}, 2, "extremes needs a scene, such as teapot");
  refused({"draw", "cycle", "-o", file("new.png"), "--json"}, 2,
          "--json works only with explain, trade, extremes, diagnose and judge");
  refused({"extremes", "cycle", "-o", file("new.svg")}, 2,
          "-o " + file("new.svg") + ": pictures are PNG files; call it .png");
  refused({"extremes", "cycle", "--stats"}, 2, "--stats works only with draw, snapshot and figure");
}

}  // namespace xnewell::THIS_FILE
