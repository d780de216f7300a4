#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/x11/support/parsed_options.h"
#include "x11/options/option_rows.h"

namespace xnewell::THIS_FILE {

// Command lines that are refused: what is so for each row of a table. Single ones are in tests/stories.

// Each option either works with all commands that draw a scene, or says where it works: it names commands
// that there are, or options that there are. There it is accepted, and with every other command it is refused
// in one line that names these places.
TEST(Options, WorkWhereTheirRowSays) {
  std::vector<std::string> names;
  for (const OptionRow& row : optionRows()) names.push_back(row.name);
  int refusals = 0;
  for (const OptionRow& row : optionRows()) {
    if (row.name == "--help" || row.name == "--version") continue;
    const auto among = [&](std::string_view word) {
      return std::ranges::any_of(row.places, [&](std::string_view place) {
        return place == word || place.starts_with(std::string{word} + ' ');
      });
    };
    for (const std::string_view place : row.places) {
      const std::string first{place.substr(0, place.find(' '))};
      EXPECT_TRUE(std::ranges::find(names, first) != names.end() ||
                  std::ranges::find(kCommands, first, &CommandRow::name) != kCommands.end())
          << row.name << ": " << place;
    }
    const auto alone = std::ranges::count_if(row.places, [](auto place) { return place.starts_with('-'); });
    for (const CommandRow& command : kCommands) {
      std::vector<std::string> words{std::string{command.name}};
      if (command.draws || command.id == Command::Lesson) words.emplace_back("teapot");
      if (command.id == Command::Explain) words.emplace_back("1,1");
      if (!command.takes.empty()) words.emplace_back("handed-in");
      if (row.name != "--output" &&
          (command.id == Command::Draw || command.id == Command::Snapshot || command.id == Command::Grade))
        words.insert(words.end(), {"-o", "no.png"});
      if (row.name != "--output" && command.id == Command::Figure)
        words.insert(words.end(), {"-o", "no.svg"});
      words.push_back(row.name);
      if (row.takes != Takes::Nothing) words.push_back(row.words.empty() ? "1" : row.words.front());
      const std::string said = complaintAll(words);
      const std::string only =
          row.shown() + (row.places.empty() ? " does not work with " : " works only with ");
      if (row.places.empty() ? command.draws : among(command.name) || alone > 0) continue;
      if (said.starts_with(row.name + ": ")) continue;  // its value is refused first
      EXPECT_TRUE(said.starts_with(only)) << said;
      for (const std::string_view place : row.places) EXPECT_NE(said.find(place), std::string::npos) << said;
      ++refusals;
    }
  }
  EXPECT_GT(refusals, 150);
}

// A complaint shows part of a word that is long.
TEST(Options, ComplaintsAreShort) {
  const std::string longest(100'000, 'a');
  EXPECT_LT(complaint({longest}).size(), 300u);
  EXPECT_LT(complaint({"--" + longest}).size(), 300u);
  for (const char* option : {"--size", "--eye", "--view", "--order", "--fov", "--cull", "--bits"})
    EXPECT_LT(complaint({option, longest}).size(), 300u) << option;
}

// A view refuses options that do not apply to it, and a size too small for its words.
TEST(Options, RefuseWhatAViewCannotHeed) {
  for (const ViewRow& row : kViews) {
    if (row.id == View::Picture || !row.hasSheet()) continue;
    const std::string name{row.name}, view = "--view " + name;
    const std::string width = std::to_string(row.least.x), height = std::to_string(row.least.y);
    EXPECT_EQ(complaint({"--view", name, "--size", width + "x" + height}), "");
    for (const std::string& small :
         {std::to_string(row.least.x - 1) + "x8192", "8192x" + std::to_string(row.least.y - 1)})
      EXPECT_EQ(complaint({"--view", name, "--size", small}),
                view + " needs a --size of at least " + width + "x" + height);
    EXPECT_EQ(complaint({"--view", name}), "") << "the size without --size is too small";
    EXPECT_EQ(complaintAll({"--view", name}), "");
    EXPECT_EQ(complaintAll({"--view", name, "--size", "799x540"}),
              view + " needs a --size of at least 800x540");
    EXPECT_EQ(complaintAll({"trace", "teapot", "--view", name}),
              "--view works only with view, draw and snapshot");
    const std::string more =
        view + " is not just the picture: --stats, --errors and --ids work only with --view picture";
    EXPECT_EQ(complaint({"--view", name, "--ids", "i.png"}), more);
    EXPECT_EQ(complaint({"--view", name, "--stats"}), more);
    EXPECT_EQ(complaintAll({"snapshot", "teapot", "-o", "a", "--whole-window", "--view", name}), "");
    EXPECT_EQ(complaintAll({"snapshot", "teapot", "-o", "a", "--fill", "x11", "--view", name}),
              view + " uses the scanline filler: leave out --fill x11");
  }
  // The others are drawn in the window only.
  int inTheWindow = 0;
  for (const ViewRow& row : kWindowViews) {
    const std::string name{row.name};
    if (row.hasSheet()) continue;
    ++inTheWindow;
    EXPECT_EQ(complaintAll({"--view", name}), "");
    EXPECT_EQ(complaintAll({"snapshot", "teapot", "-o", "a", "--whole-window", "--view", name}), "");
    EXPECT_EQ(complaint({"--view", name}),
              "--view " + name + " is a view of the window: use view, or snapshot --whole-window");
  }
  EXPECT_GE(inTheWindow, 4);
}

}  // namespace xnewell::THIS_FILE
