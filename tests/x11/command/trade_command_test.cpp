#include <gtest/gtest.h>

#include <cmath>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/seeds.h"
#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

namespace {

/// A small picture, and time for all of it on the slowest machine.
Strings tradeOf(const std::string& scene) { return {"trade", scene, "--size", "60x45", "--budget", "60"}; }

/// The words of a printed command, after the program's name. No word of these tests needs quotes.
Strings wordsOf(const std::string& command, const std::string& picture) {
  Strings words;
  std::istringstream in{command};
  for (std::string word; in >> word;) words.push_back(word == "picture.png" ? picture : word);
  words.erase(words.begin());
  return words;
}

}  // namespace

// A row has its command, and the command has the errors of the row. They may differ by roundings: the
// trade holds the camera still while divisions change, and the command places it anew.
TEST_F(CommandTest, EachRowOfATradeCanBeRepeated) {
  const auto told = runProgram(tradeOf(XNEWELL_DATA_DIR "/../tests/data/dome.bpt") +
                               Strings{"--json", "--axes", kSanitized ? "shade,order" : "shade,divisions"});
  ASSERT_EQ(told.status, 0) << told.err;
  const auto trade = nlohmann::json::parse(told.out);
  auto rows = trade.at("rows");
  ASSERT_GT(rows.size(), 5u);
  for (const auto& one : trade.at("combinations"))
    if (one.at("front").get<bool>()) rows.push_back(one);
  for (std::size_t k = 0; k < rows.size(); k += kSanitized ? 6 : 2) {
    const auto& row = rows[k];
    const std::string command = row.at("command");
    SCOPED_TRACE(command);
    const auto drawn = runProgram(wordsOf(command, file("picture.png")));
    ASSERT_EQ(drawn.status, 0) << drawn.err;
    auto errors = nlohmann::json::parse(drawn.out).at("errors");
    EXPECT_EQ(errors.at("reference_divisions"), trade.at("reference").at("divisions"));
    errors.erase("reference_divisions");
    const nlohmann::json ofCommand = errors.flatten(), ofTrade = nlohmann::json(row.at("errors")).flatten();
    ASSERT_EQ(ofCommand.size(), ofTrade.size());
    for (const auto& [key, value] : ofTrade.items()) {
      if (value.is_number_float())
        EXPECT_NEAR(ofCommand.at(key).get<double>(), value.get<double>(),
                    1e-9 * std::abs(value.get<double>()))
            << key;
      else
        EXPECT_EQ(ofCommand.at(key), value) << key;
    }
  }
}

// After an interrupt there is a chart of what is known, or it is said that there is none.
TEST_F(CommandTest, AnInterruptedTradeWritesItsChart) {
  const Strings words{"trade",    kSanitized ? "cubes" : "teapot",
                      "--size",   "400x300",
                      "--axes",   "shade,order",
                      "--budget", "600",
                      "-o",       file("chart.png")};
  bool some = false;
  for (int seconds = 1; !some && seconds <= 32; seconds *= 2) {
    std::filesystem::remove(file("chart.png"));
    RunningProgram child{words};
    std::this_thread::sleep_for(std::chrono::seconds{seconds});
    child.signal(SIGINT);
    const Finished end = child.wait();
    ASSERT_EQ(end.status, 130) << end.err;
    some = std::filesystem::exists(file("chart.png"));
    EXPECT_EQ(end.err.find("no chart was written: nothing was timed") == std::string::npos, some) << end.err;
    EXPECT_EQ(end.out.find("Nothing was timed") == std::string::npos, some) << end.out;
  }
  ASSERT_TRUE(some);
  EXPECT_GT(readPng(file("chart.png")).height, 50);
}

// --accuracy draws what it chose, says why, and leaves what the user gave.
TEST_F(CommandTest, AccuracyChoosesAndSaysWhy) {
  const Strings options{"--size",   "120x90", "--budget",        "20", "--accuracy", "0.2",
                        "--errors", "-o",     file("chosen.png")};
  const auto chosen = runProgram(Strings{"draw", "cycle"} + options);
  ASSERT_EQ(chosen.status, 0) << chosen.err;
  EXPECT_NE(chosen.err.find("xnewell: chosen: "), std::string::npos) << chosen.err;
  EXPECT_NE(chosen.err.find(" and 0.2 is allowed. It takes "), std::string::npos) << chosen.err;
  const auto stats = nlohmann::json::parse(chosen.out);
  EXPECT_LE(stats.at("errors").at("intensity").at("after_table").at("rms").get<double>(), 0.2);
  const auto& accuracy = stats.at("accuracy");
  EXPECT_EQ(accuracy.at("limit").at("rms"), 0.2);
  EXPECT_TRUE(accuracy.at("limit").at("wrong_faces").is_null());
  EXPECT_EQ(accuracy.at("within"), true);
  EXPECT_NE(chosen.err.find("xnewell: chosen: " + accuracy.at("chosen").at("name").get<std::string>()),
            std::string::npos);
  for (const auto& why : accuracy.at("why"))
    EXPECT_NE(chosen.err.find(why.get<std::string>()), std::string::npos) << why;
  EXPECT_GE(accuracy.at("timed"), accuracy.at("front").size());
  EXPECT_GT(accuracy.at("front").size(), 0u);

  const auto kept = runProgram(Strings{"draw", "teapot"} + options +
                               Strings{"--order", "newell", "--shade", "phong", "--divisions", "2"});
  ASSERT_EQ(kept.status, 0) << kept.err;
  const auto phong = nlohmann::json::parse(kept.out);
  EXPECT_EQ(phong.at("shading"), "phong");
  EXPECT_EQ(phong.at("faces"), 32 * 4);
}

}  // namespace xnewell::THIS_FILE
