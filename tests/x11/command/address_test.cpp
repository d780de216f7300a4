
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "geometry/files/data_folder.h"
#include "geometry/files/input_file.h"
#include "geometry/files/output_file.h"
#include "geometry/files/text_file.h"
#include "tests/support/temporary_folder.h"
#include "x11/command/commands.h"
#include "x11/options/options.h"
#include "x11/options/shell_words.h"

namespace xnewell::THIS_FILE {

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
