#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/text/document.h"

namespace xnewell::THIS_FILE {

namespace {

using Names = std::set<std::string>;
using Rooms = std::map<std::string, Names>;  ///< a room, "shading/color", and the rooms that it names as used

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex wanted{pattern};
  std::vector<std::string> found;
  for (std::sregex_iterator at{text.begin(), text.end(), wanted}, end; at != end; ++at)
    found.push_back(at->str());
  return found;
}

/// The rooms as the CMakeLists.txt of the floors have them.
Rooms built() {
  Rooms rooms;
  for (const std::string floor : {"geometry", "depthsort", "shading", "x11"}) {
    const std::string text = documentOf(floor + "/CMakeLists.txt");
    const std::regex room{R"(\nroom\((\w+)\s+(?:USES ([\w\s]*?))?\s*FILES)"};
    for (std::sregex_iterator at{text.begin(), text.end(), room}, end; at != end; ++at) {
      Names& uses = rooms[floor + '/' + at->str(1)];
      for (std::string name : matches(at->str(2), R"(\w+)")) {
        std::replace(name.begin(), name.end(), '_', '/');
        uses.insert(name);
      }
    }
  }
  for (std::string name : matches(documentOf("depthsort/CMakeLists.txt"), R"(geometry_\w+)")) {
    std::replace(name.begin(), name.end(), '_', '/');
    rooms["depthsort"].insert(name);
  }
  return rooms;
}

/// The rooms as the table of the README has them. A name without a floor is on the floor of the row's first
/// name. Libraries of others, such as GLM, are in capitals.
Rooms told() {
  Rooms rooms;
  for (std::string line : linesOf(documentOf("README.md"), "## The rooms")) {
    line = std::regex_replace(line, std::regex{R"(\*\*\[(\w+)\]\([^)]*\)\*\*)"}, "$1");
    const std::vector<std::string> cells = cellsOf(line);
    if (cells.size() != 3 || cells[0] == "room" || cells[0] == "---") continue;
    const std::string floor = matches(cells[0], R"(\w+)").front();
    const auto full = [&](const std::string& name) {
      return name.find('/') != std::string::npos || name == "depthsort" ? name : floor + '/' + name;
    };
    Names uses;
    for (const std::string& name : matches(cells[2], R"([a-z][\w/]*)")) uses.insert(full(name));
    for (const std::string& name : matches(cells[0], R"([a-z][\w/]*)")) rooms[full(name)] = uses;
  }
  return rooms;
}

}  // namespace

// The README's table of rooms says what the build does.
TEST(Rooms, UseWhatTheReadmeSays) {
  const Rooms actual = built(), stated = told();
  EXPECT_GT(actual.size(), 20u);
  for (const auto& [room, uses] : actual) {
    ASSERT_TRUE(stated.contains(room)) << room << " is missing";
    EXPECT_EQ(stated.at(room), uses) << room;
  }
  EXPECT_EQ(stated.size(), actual.size());
}

// Keys and controls belong to the kit. Elsewhere no code tells keys apart, tests a list of them, or draws the
// parts of a control: views give the kit rows.
TEST(Rooms, KeysAndControlsBelongToTheKit) {
  struct Rule {
    const char* pattern;
    Names allowed;  ///< files where it means something else
  };
  const std::vector<Rule> rules{
      {R"(case '[^']+':)", {}},
      {R"("[^" ]{4,}"\}?\.find(_first_of)?\(|\.find(_first_of)?\((key|letter)\b)", {}},
      {R"(\b(key|event)\.letter\b)", {"x11/app/workbench_keys.cpp"}},  // a letter of a typed text
      {R"(\b(drawOptions|optionFrames|drawToggle|drawNumber)\()", {}},
      {R"(\bdrawTrack\()", {"x11/stepper/sort_controls.cpp"}},  // the speed has words beside its track
  };
  int files = 0;
  for (const char* const room : {"window", "views", "sides", "trade", "stepper", "lessons", "app"})
    for (const auto& entry :
         std::filesystem::directory_iterator{std::string{XNEWELL_DATA_DIR} + "/../x11/" + room}) {
      const std::string path = std::string{"x11/"} + room + '/' + entry.path().filename().string();
      if (!path.ends_with(".cpp") && !path.ends_with(".h")) continue;
      ++files;
      const std::string text = documentOf(path);
      for (const Rule& rule : rules) {
        if (!rule.allowed.contains(path)) {
          EXPECT_THAT(matches(text, rule.pattern), testing::IsEmpty()) << path;
        }
      }
    }
  EXPECT_GT(files, 80);
}

// The README is short enough to be read.
TEST(Readme, HasAtMost150Lines) {
  const std::string text = documentOf("README.md");
  EXPECT_LE(std::ranges::count(text, '\n'), 150);
}

}  // namespace xnewell::THIS_FILE
