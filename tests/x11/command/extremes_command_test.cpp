#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "shading/color/png.h"
#include "tests/x11/support/command_fixture.h"

namespace xnewell {

// The table has a line for each way, the chart is a picture, and the JSON has every step.
TEST_F(CommandTest, ExtremesAreTold) {
  const Words words{"extremes", "cycle", "--size", "40x30"};
  const auto table = runProgram(words + Words{"-o", file("chart.png")});
  EXPECT_EQ(table.status, 0) << table.err;
  for (const char* way : {"scaled up by (powers of two)", "moved by", "eye falls to", "I0 down to"})
    EXPECT_NE(table.out.find(way), std::string::npos) << way;
  EXPECT_TRUE(std::filesystem::file_size(file("chart.png")) > 1'000);

  const auto printed = runProgram(words + Words{"--json"});
  EXPECT_EQ(printed.status, 0) << printed.err;
  const auto json = nlohmann::json::parse(printed.out);
  EXPECT_EQ(json.at("scene"), "cycle");
  ASSERT_GE(json.at("extremes").size(), 11u);
  for (const auto& way : json.at("extremes"))
    for (const auto& step : way.at("steps")) EXPECT_GE(step.at("samples").get<int>(), 0);
}

TEST_F(CommandTest, ExtremesRefuseWhatTheyDoNotTake) {
  refused({"extremes"}, 2, "extremes needs a scene, such as teapot");
  refused({"draw", "cycle", "-o", file("new.png"), "--json"}, 2, "--json works only with trade and extremes");
  refused({"extremes", "cycle", "-o", file("new.svg")}, 2,
          "-o " + file("new.svg") + ": pictures are PNG files; call it .png");
  refused({"extremes", "cycle", "--stats"}, 2,
          "--stats, --errors, --costs and --ids work only with draw and snapshot");
}

}  // namespace xnewell
