#include "x11/options/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "geometry/files/input_file.h"
#include "geometry/files/model_file.h"
#include "geometry/files/output_file.h"
#include "geometry/files/text_file.h"
#include "shading/color/png.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"
#include "shading/scene/settings.h"
#include "shading/scene/units.h"
#include "tests/support/seeds.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/command_fixture.h"
#include "tests/x11/support/parsed_options.h"
#include "x11/command/commands.h"
#include "x11/options/option_rows.h"
#include "x11/options/setup_command.h"
#include "x11/options/shell_words.h"

namespace xnewell::THIS_FILE {

// What options set, what is refused for each row of a table, and links and set-ups, which are command lines,
// too. Single command lines that are refused: tests/stories.

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What the scene asks for, in its units, at a small size.
PictureSettings setupOf(const Scene& scene) {
  PictureSettings settings = scene.settings;
  settings.inPixels = false;
  settings.camera = scene.camera;
  settings.width = 64, settings.height = 48;
  return settings;
}

/// The file that `draw` writes of this set-up, with this note; "" if it has no picture.
std::string fileOf(const Scene& scene, const PictureSettings& settings, const std::string& note) {
  try {
    const CellPlan plan{settings.table.kind};
    const Picture picture = makePicture(scene, settings, plan[Cell::Well]);
    return encodePng(picture.image(), picture.palette(plan), note);
  } catch (const std::exception&) {
    return "";
  }
}

Value randomValue(const Setting& setting, std::mt19937& rng) {
  const auto number = [&] {
    const double low = std::max(setting.range.low, -4.0), high = std::min(setting.range.high, 4.0);
    return std::uniform_real_distribution{low, high}(rng);
  };
  for (;;) {
    Value value = number();
    if (setting.field.kind == ValueKind::Triple) value = glm::dvec3{number(), number(), number()};
    if (setting.field.kind == ValueKind::Whole) value = setting.range.low + static_cast<double>(rng() % 200);
    if (setting.field.kind == ValueKind::Flag) value = static_cast<double>(rng() % 2);
    if (setting.field.kind == ValueKind::Choice)
      value = static_cast<double>(rng() % setting.field.choices.size());
    if (setting.key == "table.hue") value = glm::dvec3{1.0, std::abs(number()) / 4, 0.5};
    if (setting.key == "table.shades") value = 30.0 + static_cast<double>(rng() % 200);
    if (allows(setting, value)) return value;
  }
}

/// A random camera, or the scene's own turned, or another projection.
CameraSettings randomCamera(const Scene& scene, const PictureSettings& settings, std::mt19937& rng) {
  const Camera placed = placeCamera(scene, settings.camera, 4.0 / 3);
  CameraSettings camera = settings.camera;
  switch (rng() % 6) {
    case 0:
      return moved(camera, placed, scene, 20.0, -7.5, 1.3);
    case 1:  // as the key P does
      camera.parallel = !camera.parallel && !camera.oblique;
      camera.oblique.reset(), camera.height.reset();
      return camera;
    case 2:
      camera = {}, camera.oblique = Oblique{0.5, 30};
      return completed(camera, settings.camera);
    case 3:
      camera = {}, camera.vpn = glm::dvec3{0.3, -1, 0.4}, camera.front = 0.25;
      return completed(camera, settings.camera);
    case 4:
      camera = {}, camera.parallel = true, camera.height = 1.7, camera.vup = glm::dvec3{0.1, 0.2, 1};
      return completed(camera, settings.camera);
    default:
      return camera;
  }
}

/// A picture that carries a note.
std::string picture(const TemporaryFolder& folder, const std::string& note,
                    const std::string& name = "a.png") {
  return folder.write(name, encodePng(IndexImage{3, 2, 7}, Palette{}, note));
}

using SetupCommandTest = CommandTest;

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

TEST(Address, IsACommandLine) {
  EXPECT_THAT(argumentsOf(""), IsEmpty());
  EXPECT_THAT(argumentsOf("teapot&view=pixel&pixel=288,158&shade=phong"),
              ElementsAre("teapot", "--view=pixel", "--pixel=288,158", "--shade=phong"));
  EXPECT_THAT(argumentsOf("lesson&cycles&step=3"), ElementsAre("lesson", "cycles", "--step=3"));
  EXPECT_THAT(argumentsOf("view=colours"), ElementsAre("--view=colours"));
  EXPECT_THAT(argumentsOf("a%26b%20c.obj&dither&%zz%2"), ElementsAre("a&b c.obj", "--dither", "--%zz%2"));

  const Options pixel = parsed(argumentsOf("teapot&view=pixel&pixel=288,158&shade=phong"));
  EXPECT_EQ(pixel.window.view, View::Pixel);
  EXPECT_EQ(pixel.window.pixel, (glm::ivec2{288, 158}));
  EXPECT_EQ(parsed(argumentsOf("lesson&cycles&step=3")).window.step, 3);
  EXPECT_THROW((void)parsed(argumentsOf("teapot&view=pixels")), UsageError);
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
  EXPECT_THAT(
      argumentsOf(addressOf("xnewell snapshot 'a&b=c%20.obj' --beside 'order=none' --dither --eye=-3,4,9")),
      ElementsAre("a&b=c%20.obj", "--beside=order=none", "--dither", "--eye=-3,4,9"));
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

// The command draws the set-up again, byte for byte: for any settings that may be chosen in a window, any
// camera, scenes with lights, materials and textures of their own, and set-ups from a file.
TEST_F(SetupCommandTest, DrawsTheSameFile) {
  const std::string setup = write("setup.json", R"({"scene": "lamp", "without": ["kd"],
    "camera": {"parallel": true}, "shading": {"method": "gouraud", "kd": 0.5, "dither": true,
    "constant_v": true, "attenuation": "inverse"}})");
  const std::string worn =
      write("worn.json", R"({"scene": "teapot", "divisions": 3, "texture": ")" XNEWELL_DATA_DIR
                         R"(/textures/checks.png", "shading": {"method": "phong", "light_at": [4, -5, 6]}})");
  const std::string far = write("far.obj", "v 0 0 0\nv 3e9 0 0\nv 0 3e9 1e9\nf 1 2 3\n");
  const std::string half =
      write("half.json", R"({"materials": {"m": {"ka": 0.5, "kd": 0.6, "ks": 0.7, "n": 9}},
    "objects": [{"solid": "sphere", "material": "m"}, {"solid": "cube", "move": [1.5, 0, 0]}]})");
  std::mt19937 rng{11};
  int drawn = 0, kept = 0, lit = 0;
  for (const std::string& name :
       Strings{setup, worn, far, half, "teapot", "colored-lights", "textured-cube", "spotlight", "hues"})
    for (int trial = 0; trial < (kSanitized ? 4 : 16); ++trial) {
      Scene scene = readScene(name, 4);
      PictureSettings settings = setupOf(scene);
      std::vector<Override> overrides;
      for (const Setting& setting : settingRows()) {
        if (setting.key == "fill" || rng() % 4 != 0) continue;
        if (setting.key == "Ia" && !scene.light.lights.empty()) continue;  // their sum must not exceed 1
        overrides.push_back({&setting, randomValue(setting, rng)});
        if (!setting.replaces.empty() && rng() % 2) strip(scene, setting.replaces);
      }
      if (!applyOverrides(settings, overrides)) continue;
      if (scene.light.lights.empty() && scene.light.Ia && largest(*scene.light.Ia) + settings.light.Ip > 1)
        continue;
      settings.camera = randomCamera(scene, settings, rng);
      const std::string command = SetupCommand{scene}.of(settings);
      // The file carries the command, unless that rests on a second file.
      const std::string expected = fileOf(scene, settings, scene.origin.texture.empty() ? command : "");
      if (expected.empty()) continue;
      SCOPED_TRACE(command);
      const Finished end = runProgram(commandWords(command, file("out.png")));
      ASSERT_EQ(end.status, 0) << end.err;
      ASSERT_TRUE(contents(file("out.png")) == expected);
      ++drawn;
      kept += command.find(" --keep ") != std::string::npos;
      lit += command.find(" --light") != std::string::npos;
    }
  EXPECT_GT(drawn, kSanitized ? 15 : 60);
  EXPECT_GT(kept, kSanitized ? -1 : 0);  // few trials may have none
  EXPECT_GT(lit, kSanitized ? 1 : 10);
}

// A picture of a lesson opens the lesson.
TEST(CarriedSetup, APictureOfALessonOpensIt) {
  const TemporaryFolder folder;
  const std::string own = folder.write("my own.json", ""),
                    file = picture(folder, lessonNote("cycles", {1700, 1300}, 2, 3)),
                    ofOwn = picture(folder, lessonNote("my own.json", {900, 700}, 1, 2), "b.png");
  const Options opened = parsed({file});
  EXPECT_EQ(opened.command, Command::Lesson);
  EXPECT_EQ(opened.scene, "cycles");
  EXPECT_EQ(opened.window.step, 3);
  EXPECT_EQ(opened.size, (glm::ivec2{1700, 1300}));
  EXPECT_EQ(opened.scale, 2);
  EXPECT_EQ(parsed({file, "--step", "1"}).window.step, 1);
  EXPECT_EQ(parsed({ofOwn}).scene, own);
}

}  // namespace xnewell::THIS_FILE
