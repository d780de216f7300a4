#include "x11/options/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/files/data_folder.h"
#include "geometry/files/input_file.h"
#include "geometry/files/output_file.h"
#include "geometry/files/text_file.h"
#include "shading/scene/settings.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/parsed_options.h"
#include "x11/command/commands.h"
#include "x11/options/option_rows.h"
#include "x11/options/shell_words.h"

namespace xnewell::THIS_FILE {

// What options set, what is refused for each row of a table, and links, which are command lines, too. Single
// command lines that are refused: tests/stories.

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What the table of options makes of an address.
Options optionsOf(std::string_view address) {
  const std::vector<std::string> words = argumentsOf(address);
  std::vector<const char*> arguments{"xnewell"};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  return parseOptions(static_cast<int>(arguments.size()), arguments.data()).value();
}

}  // namespace

// Each option sets its own setting and no other.
TEST(Options, SetOneSettingEach) {
  const auto only = [](const std::vector<std::string>& words, auto&& set) {
    PictureSettings expected;
    set(expected);
    EXPECT_EQ(drawn(words).picture, expected) << words[0];
    EXPECT_NE(expected, PictureSettings{}) << words[0] << ": the test changes nothing";
  };
  only({"--ia", "0.1"}, [](auto& s) { s.light.Ia = 0.1; });
  only({"--ip", "0.5"}, [](auto& s) { s.light.Ip = 0.5; });
  only({"--ka", "0.5"}, [](auto& s) { s.light.ka = 0.5; });
  only({"--kd", "0"}, [](auto& s) { s.light.kd = 0; });
  only({"--ks", "1"}, [](auto& s) { s.light.ks = 1; });
  only({"--n", "1000000"}, [](auto& s) { s.light.n = 1'000'000; });
  only({"--light", "1,-2,3e0"}, [](auto& s) { s.light.light = {1, -2, 3}; });
  only({"--light-at", "0,0,0"}, [](auto& s) { s.light.lightPosition = glm::dvec3{0}; });
  only({"--mistake", "R-sign"}, [](auto& s) { s.light.mistake = Mistake::ReversedR; });
  only({"--constant-l"}, [](auto& s) { s.light.constantL = true; });
  only({"--constant-v"}, [](auto& s) { s.light.constantV = true; });
  only({"--shades", "2"}, [](auto& s) { s.table.shades = 2; });
  only({"--i0", "0.5"}, [](auto& s) { s.table.I0 = 0.5; });
  only({"--hue", "0.25,1,0"}, [](auto& s) { s.table.hue = {0.25, 1, 0}; });
  only({"--eye", "-1,-2,3"}, [](auto& s) { s.camera.eye = {-1, -2, 3}; });
  only({"--eye=-1,-2,3"}, [](auto& s) { s.camera.eye = {-1, -2, 3}; });
  only({"--eye", "+1,.5,1e3"}, [](auto& s) { s.camera.eye = {1, 0.5, 1000}; });
  only({"--look-at", "1,2,3"}, [](auto& s) { s.camera.lookAt = {1, 2, 3}; });
  only({"--up", "1,2,3"}, [](auto& s) { s.camera.up = {1, 2, 3}; });
  only({"--fov", "179.9"}, [](auto& s) { s.camera.fov = 179.9; });
  only({"--parallel", "1e-300"}, [](auto& s) { s.camera.parallel = true, s.camera.height = 1e-300; });
  only({"--oblique", "cavalier"}, [](auto& s) { s.camera.oblique = Oblique{1.0, 45.0}; });
  only({"--oblique", "cabinet:-30"}, [](auto& s) { s.camera.oblique = Oblique{0.5, -30.0}; });
  only({"--vrp", "1,2,3"}, [](auto& s) { s.camera.vrp = {1, 2, 3}; });
  only({"--vpn", "1,2,3"}, [](auto& s) { s.camera.vpn = {1, 2, 3}; });
  only({"--vup", "1,2,3"}, [](auto& s) { s.camera.vup = {1, 2, 3}; });
  only({"--prp", "1,2,3"}, [](auto& s) { s.camera.prp = {1, 2, 3}; });
  only({"--view-window", "-1,2,-3,4"}, [](auto& s) { s.camera.window = {-1, 2, -3, 4}; });
  only({"--front", "-1"}, [](auto& s) { s.camera.front = -1; });
  only({"--back", "-2"}, [](auto& s) { s.camera.back = -2; });
}

// Settings of light and surfaces replace the scene's own; each says which.
TEST(Options, ReplaceTheScenes) {
  std::vector<std::string_view> replaced;
  for (const Setting& setting : settingRows()) {
    if (setting.replaces.empty()) continue;
    EXPECT_NE(std::ranges::find(kStrippable, setting.replaces), kStrippable.end()) << setting.replaces;
    replaced.push_back(setting.option);
    const std::string value = setting.letters.empty() ? "0" : "1,0,0";
    const Options o = drawn({std::string{setting.option}, value});
    EXPECT_TRUE(o.gave(setting.option));
    for (const Setting& other : settingRows())
      EXPECT_EQ(o.gave(other.option), other.option == setting.option) << other.option;
  }
  const std::vector<std::string_view> all{"--ia", "--ip", "--light", "--light-at",
                                          "--ka", "--kd", "--ks",    "--n"};
  EXPECT_EQ(replaced, all);
}

// If only one of Ia and Ip is set, the other gives way, so that their sum stays within 1.
TEST(Options, IntensitiesPushEachOther) {
  EXPECT_EQ(drawn({"--ia", "1"}).picture.light.Ip, 0.0);
  EXPECT_EQ(drawn({"--ip", "1"}).picture.light.Ia, 0.0);
  EXPECT_EQ(drawn({"--ip", "0.75"}).picture.light.Ia, 0.2);
}

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

TEST(Address, IsACommandLine) {
  EXPECT_THAT(argumentsOf(""), IsEmpty());
  EXPECT_THAT(argumentsOf("teapot&view=pixel&pixel=288,158&shade=phong"),
              ElementsAre("teapot", "--view=pixel", "--pixel=288,158", "--shade=phong"));
  EXPECT_THAT(argumentsOf("lesson&cycles&step=3"), ElementsAre("lesson", "cycles", "--step=3"));
  EXPECT_THAT(argumentsOf("view=colours"), ElementsAre("--view=colours"));
  EXPECT_THAT(argumentsOf("a%26b%20c.obj&dither&%zz%2"), ElementsAre("a&b c.obj", "--dither", "--%zz%2"));

  const Options pixel = optionsOf("teapot&view=pixel&pixel=288,158&shade=phong");
  EXPECT_EQ(pixel.window.view, View::Pixel);
  EXPECT_EQ(pixel.window.pixel, (glm::ivec2{288, 158}));
  EXPECT_EQ(optionsOf("lesson&cycles&step=3").window.step, 3);
  EXPECT_THROW((void)optionsOf("teapot&view=pixels"), UsageError);
}

// The link that `C` copies shows what its command shows, without the size of the picture and its file.
TEST(Address, IsThatOfACommand) {
  EXPECT_EQ(addressOf("xnewell snapshot teapot --size 1024x768 --whole-window --view pixel --pixel 288,158 "
                      "--shade phong -o picture.png"),
            "teapot&size=1024x768&view=pixel&pixel=288,158&shade=phong");
  EXPECT_EQ(addressOf("xnewell draw cycle --size 100x80 --dither --eye=-3,4,9 -o picture.png"),
            "cycle&dither&eye=-3,4,9");
  EXPECT_EQ(addressOf("xnewell snapshot teapot --size 1600x1080 --scale 2"), "teapot");
  EXPECT_EQ(addressOf("xnewell lesson 'my own.json' --step 2"), "lesson&my%20own.json&step=2");
  EXPECT_EQ(addressOf("xnewell snapshot teapot --beside 'order=none shade=phong'"),
            "teapot&beside=order%3Dnone%20shade%3Dphong");
  EXPECT_EQ(addressOf("xnewell 'not ended"), "");
  for (const char* const command :
       {"xnewell snapshot 'a&b=c%20.obj' --beside 'order=none' --dither --eye=-3,4,9"}) {
    const std::vector<std::string> words = argumentsOf(addressOf(command));
    EXPECT_THAT(words, ElementsAre("a&b=c%20.obj", "--beside=order=none", "--dither", "--eye=-3,4,9"));
  }
}

// A page that begins with a lesson holds the lesson's own files beside each other, and no byte of them ends
// the script.
TEST(Address, OfAPageWithItsFiles) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "a/b");
  writeFile(folder.file("a/<!--.json"), "{}");
  writeFile(folder.file("a/b/x.obj"), "v 0 0 0\n");
  const std::set<std::string> read{placeOf(folder.file("a/<!--.json")), placeOf(folder.file("a/b/x.obj")),
                                   placeOf(dataFolder() / "scenes/cycle.json")};
  Options options;
  options.command = Command::Lesson;
  options.scene = folder.file("a/<!--.json");
  options.given = {"scene", "--page", "--step"};
  options.values = {options.scene, "out.html", "3"};
  const std::string empty = readTextFile(XNEWELL_DATA_DIR "/../x11/browser/page.html");
  const std::string page = pageThatBeginsWith(options, read, empty);
  EXPECT_THAT(page, HasSubstr(R"(const begin = {"address":"lesson&%3C%21--.json&step=3",)"
                              R"("files":{"\u003c!--.json":"e30=","b/x.obj":"diAwIDAgMAo="}};)"));
  EXPECT_THROW((void)pageThatBeginsWith(options, read, "<html>"), std::runtime_error);
}

}  // namespace xnewell::THIS_FILE
