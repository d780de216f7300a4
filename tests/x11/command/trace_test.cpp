#include "x11/command/commands.h"

#include <gtest/gtest.h>

#include <set>
#include <span>
#include <sstream>

#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

/// The trace as a user meets it: its lines, its frames, and what is refused.

namespace {

using TraceCommand = CommandTest;

std::vector<Json> linesOf(const Strings& words) {
  const Finished end = runProgram(Strings{"trace"} + words);
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_EQ(end.err, "");
  std::vector<Json> lines;
  std::istringstream in{end.out};
  for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
  return lines;
}

/// What the numbers of a test's line say by themselves.
std::string decided(const Json& line) {
  const Json& n = line["numbers"];
  const std::string test = line["test"];
  const auto apart = [](const Json& p, const Json& q) { return p[1] <= q[0] || q[1] <= p[0] ? "yes" : "no"; };
  const auto only = [](const Json& corners, const char* where, const char* notThere) {
    return corners[notThere] == 0 && corners[where] > 0 ? "yes" : "no";
  };
  if (test == "1") return apart(n["P_x"], n["Q_x"]);
  if (test == "2") return apart(n["P_y"], n["Q_y"]);
  if (test == "3") return only(n["P_from_plane_of_Q"], "behind", "in_front");
  if (test == "4") return only(n["Q_from_plane_of_P"], "in_front", "behind");
  if (test == "5") return n["separating_edge"].is_null() ? "no" : "yes";
  if (test == "3'") return only(n["Q_from_plane_of_P"], "behind", "in_front");
  if (test == "4'") return only(n["P_from_plane_of_Q"], "in_front", "behind");
  if (test == "plane") return "yes";
  if (n["contact"]) return line["outcome"];
  return n["P_nearer"] == 0 ? "P first" : n["Q_nearer"] == 0 ? "Q first" : "crossing";
}

/// The number of files in the folder for each word that follows a file's number.
std::map<std::string, int> framesIn(const std::string& folder) {
  std::map<std::string, int> words;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name.size() > 9 && name[4] == '-' && name.ends_with(".png")) << name;
    ++words[name.substr(5, name.size() - 9)];
  }
  return words;
}

}  // namespace

// Every line is JSON. Steps are counted without a gap. All tests of a step failed but the last, which settled
// the pair. The numbers of each test give the same decision. The summary counts what was told.
TEST_F(TraceCommand, LinesTellTheRun) {
  std::map<std::string, int> settled;
  for (const Strings& words : {Strings{"cycle"}, Strings{"penetrate"}, Strings{"nested-cycles"},
                               Strings{"decals"}, Strings{"crossing-sheets"}, Strings{"room", "--quick"},
                               Strings{"nested-cycles", "--quick"}, Strings{"cycle", "--size", "64x64"}}) {
    SCOPED_TRACE(words[0]);
    const bool quick = std::ranges::find(words, "--quick") != words.end();
    const std::vector<Json> lines = linesOf(words);
    ASSERT_GT(lines.size(), 2u);
    EXPECT_EQ(lines.front()["event"], "run");
    EXPECT_EQ(lines.front()["scene"], words[0]);
    EXPECT_EQ(lines.front()["run"], quick ? "quick" : "textbook");
    const Json& summary = lines.back();
    EXPECT_EQ(summary["event"], "summary");

    std::map<std::string, int> events;
    int step = 0, pairs = 0;
    bool open = false;  // a test failed, so the next line goes on with the same pair
    for (const Json& line : std::span{lines}.subspan(1, lines.size() - 2)) {
      const std::string event = line["event"];
      ASSERT_EQ(line["step"], open ? step : step + 1) << line;
      step = line["step"];
      if (open) {
        ASSERT_EQ(event, "test") << line;
      }
      ASSERT_FALSE(line["P"].empty());
      ASSERT_TRUE(line["says"].get<std::string>().ends_with('.'));
      ++events[event];
      open = event == "test" && line["outcome"] == "no";
      if (event != "test") continue;
      EXPECT_EQ(line["outcome"], decided(line)) << line;
      EXPECT_EQ(line.contains("verdict"), !open) << line;
      if (open) continue;
      ++pairs;
      ++settled[line["test"]];
      const std::string test = line["test"], verdict = line["verdict"];
      if (test.size() == 1 && test != "6") {
        EXPECT_EQ(verdict, "P first");
      }
      if (test.size() == 2) {
        EXPECT_EQ(verdict, "Q first");
      }
      if (test == "plane") {
        EXPECT_EQ(verdict == "P first", line["numbers"]["P_place"] < line["numbers"]["Q_place"]);
      }
    }
    EXPECT_FALSE(open);
    EXPECT_EQ(lines.front()["steps"], step);
    EXPECT_EQ(summary["pairs"], pairs);
    EXPECT_EQ(summary["fragments"], events["paint"]);
    EXPECT_EQ(summary["moves"], events["move"]);
    EXPECT_EQ(summary["cycles"], events["cycle"]);
    EXPECT_EQ(summary["cuts"], events["cut"]);
    if (words[0] == "cycle") {
      EXPECT_GE(events["cycle"], 1);
      EXPECT_GE(events["cut"], 1);
    }
    if (words[0] == "penetrate") {
      EXPECT_GE(events["cut"], 1);
    }
  }
  for (const TestRow& row : kTestRows) EXPECT_GT(settled[std::string{row.name}], 0) << row.name;
}

// --frames writes a picture for each step of the chosen kind and one for the end. The last one shows what
// `draw` draws.
TEST_F(TraceCommand, FramesOfEachKind) {
  const std::map<std::string, int> all = [] {
    std::map<std::string, int> events;
    std::set<int> told;
    for (const Json& line : linesOf({"nested-cycles"}))
      if (line.contains("step") && told.insert(line["step"].get<int>()).second) ++events[line["event"]];
    return events;
  }();
  for (const auto& row : kEvery) {
    const std::string word{row.name}, folder = file("deep/" + word);
    const Finished end =
        runProgram({"trace", "nested-cycles", "--frames", folder, "--every", word, "--size", "160x120"});
    ASSERT_EQ(end.status, 0) << end.err;
    EXPECT_EQ(end.out + end.err, "");
    std::map<std::string, int> expected = all;
    if (row.id != Every::Step) expected = {{word, all.at(word)}};
    expected["done"] = 1;
    EXPECT_EQ(framesIn(folder), expected) << word;
  }
  for (const std::string scene : {"cycle", "penetrate", "nested-cycles", "room"}) {
    const Strings options = scene == "room" ? Strings{"--every", "cycle"} : Strings{};
    for (const std::string size : {"64x64", "800x600"}) {
      const std::string folder = file(scene + size);
      ASSERT_EQ(runProgram(Strings{"trace", scene, "--frames", folder, "--size", size} + options).status, 0);
      const Drawn drawn = draw(scene, {"--size", size});
      std::set<std::string> names;
      for (const auto& entry : std::filesystem::directory_iterator{folder})
        names.insert(entry.path().string());
      ASSERT_TRUE(names.rbegin()->ends_with("-done.png"));
      EXPECT_GT(names.size(), 1u);
      const RgbImage last = readPng(*names.rbegin());
      ASSERT_GE(last.width, drawn.picture.width);
      for (int j = 0; j < drawn.picture.height; ++j)
        ASSERT_TRUE(std::equal(drawn.picture.pixel(0, j), drawn.picture.pixel(0, j) + 3 * drawn.picture.width,
                               last.pixel(0, j)))
            << scene << size << ", row " << j;
    }
  }
}

TEST_F(TraceCommand, AnInterruptLeavesWholeFrames) {
  interruptsLeaveWholeFrames({"trace", "nested-cycles", "--every", "step", "--size", "1500x1500"}, 1500);
}

}  // namespace xnewell::THIS_FILE
