#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "shading/color/png.h"
#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

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

}  // namespace xnewell::THIS_FILE
