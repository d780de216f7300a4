#include "x11/options/options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "shading/scene/scene.h"
#include "shading/scene/settings.h"
#include "tests/x11/support/parsed_options.h"

namespace xnewell::THIS_FILE {

// What options set. Command lines that are refused: tests/stories.

// Without arguments the program opens a window on the teapot. Every command's name selects that command.
TEST(Options, CommandIsTheFirstWordOrView) {
  EXPECT_EQ(parsed({}).command, Command::View);
  EXPECT_EQ(parsed({}).scene, "teapot");
  EXPECT_EQ(parsed({"cycle"}).command, Command::View);
  EXPECT_EQ(parsed({"cycle"}).scene, "cycle");
  EXPECT_EQ(parsed({"view", "cycle"}).scene, "cycle");
  EXPECT_EQ(parsed({"--", "view"}).scene, "view");  // the word after -- is no command
  for (const CommandRow& row : kCommands) {
    std::vector<std::string> words{std::string{row.name}};
    if (row.id == Command::Draw || row.id == Command::Snapshot)
      words.insert(words.end(), {"a.obj", "-o", "a"});
    if (row.id == Command::Trace || row.id == Command::Trade || row.id == Command::Extremes ||
        row.id == Command::Lecture)
      words.emplace_back("a.obj");
    if (row.id == Command::Figure) words.insert(words.end(), {"a.obj", "-o", "a.svg"});
    if (!row.takes.empty()) words.insert(words.end(), {"a.obj", "a.png"});
    if (row.id == Command::Grade) words.insert(words.end(), {"-o", "a.csv"});
    if (row.id == Command::Questions) words.emplace_back("a.obj");
    if (row.id == Command::Explain) words.insert(words.end(), {"a.obj", "1,1"});
    EXPECT_EQ(parsed(words).command, row.id) << row.name;
  }
}

// Every name of every table of choices selects its row.
TEST(Options, ChoicesAreTheirTables) {
  for (const ShadingRow& r : kShadings)
    EXPECT_EQ(drawn({"--shade", std::string{r.name}}).picture.shading, r.id);
  for (const OrderRow& r : kOrders) EXPECT_EQ(drawn({"--order", std::string{r.name}}).picture.order, r.id);
  for (const auto& r : kTables) EXPECT_EQ(drawn({"--table", std::string{r.name}}).picture.table.kind, r.id);
  for (const auto& r : kPicks) EXPECT_EQ(drawn({"--pick", std::string{r.name}}).picture.table.pick, r.id);
  EXPECT_EQ(parsed({"view", "--fill", "x11"}).fill, Fill::XFillPolygon);
  EXPECT_EQ(parsed({"view", "--fill", "scanline"}).fill, Fill::Scanline);
  for (const ViewRow& r : kViews) {
    if (r.hasSheet()) {
      EXPECT_EQ(drawn({"--view", std::string{r.name}}).view, r.id);
    }
  }
  EXPECT_EQ(drawn({"--cull", "back"}).picture.cull, Cull::Back);
  EXPECT_EQ(drawn({"--cull", "none"}).picture.cull, Cull::Keep);
  EXPECT_FALSE(drawn({"--sided", "one"}).picture.light.twoSided);
  EXPECT_TRUE(drawn({"--sided", "two"}).picture.light.twoSided);
  EXPECT_EQ(drawn({"--bits", "8"}).picture.table.bits, 8);
  EXPECT_EQ(drawn({"--bits", "16"}).picture.table.bits, 16);
}

// Without options, the settings are those of a default-constructed value: the defaults that --help prints.
TEST(Options, DefaultsAreThoseOfTheSettings) {
  EXPECT_EQ(drawn({}).picture, PictureSettings{});
  EXPECT_EQ(drawn({}).divisions, kDefaultDivisions);
  EXPECT_FALSE(drawn({}).size.has_value());
}

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

// A flag ends what a scene asks for with =false. Nothing but true and false is taken.
TEST(Options, FlagsMayBeFalse) {
  PictureSettings scene;
  scene.dither = true;
  const std::vector<std::string> words{"draw", "teapot", "-o", "no.png"};
  const auto dithered = [&](const std::string& word) {
    std::vector<std::string> all = words;
    if (!word.empty()) all.push_back(word);
    return parsed(all, scene).picture.dither;
  };
  EXPECT_TRUE(dithered("") && dithered("--dither") && dithered("--dither=true"));
  EXPECT_FALSE(dithered("--dither=false"));
  EXPECT_EQ(complaint({"--dither=perhaps"}), "--dither: 'perhaps' is not true or false");
}

// --keep takes names of what the scene may set.
TEST(Options, KeepsPartsOfTheScene) {
  EXPECT_EQ(drawn({"--ka", "1", "--keep", "ka,n"}).keep, (std::vector<std::string>{"ka", "n"}));
  EXPECT_EQ(complaint({"--keep", "kq"}),
            "--keep: 'kq' is not names of these, with commas between them: ambient, lights, ka, kd, ks, n");
}

// What an option needs may be said by the scene: a range goes with its linear attenuation.
TEST(Options, GoWithWhatASceneAsksFor) {
  PictureSettings scene;
  scene.light.lightPosition = glm::dvec3{1, 2, 3}, scene.light.attenuation = Attenuation::Linear;
  const std::vector<std::string> words{"draw", "teapot", "-o", "no.png", "--range", "3"};
  EXPECT_EQ(parsed(words, scene).picture.light.range, 3);
  EXPECT_THROW((void)parsed(words), UsageError);
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

TEST(Options, SetWhatIsNotInThePicture) {
  EXPECT_EQ(drawn({"--size", "8192x1"}).size, (glm::ivec2{8192, 1}));
  EXPECT_EQ(drawn({"--divisions", "256"}).divisions, 256);
  EXPECT_TRUE(drawn({"--stats"}).stats);
  EXPECT_EQ(drawn({"--ids", "i.png"}).ids, "i.png");
  EXPECT_EQ(parsed({"draw", "--output=-x.png", "--", "-s.obj"}).output, "-x.png");
  EXPECT_EQ(parsed({"draw", "--output=-x.png", "--", "-s.obj"}).scene, "-s.obj");
  EXPECT_EQ(parsed({"visuals", "--visual", "TrueColor24"}).visual, "TrueColor24");
  EXPECT_TRUE(parsed({"snapshot", "teapot", "-o", "a", "--whole-window"}).wholeWindow);
  EXPECT_EQ(drawn({"--view", "machbands", "--scanline", "8191"}).window.scanline, 8191);
  EXPECT_FALSE(drawn({"--view", "machbands"}).window.scanline.has_value());
  EXPECT_EQ(drawn({"--view", "picture"}).picture, PictureSettings{});
  EXPECT_EQ(parsed({"snapshot", "teapot", "-o", "a", "--colormap", "shared"}).colormap, MapOwner::Shared);
  EXPECT_EQ(parsed({"visuals", "--colormap", "shared"}).colormap, MapOwner::Shared);
  EXPECT_TRUE(parsed({"view", "--nearest"}).nearest);
}

// If only one of Ia and Ip is set, the other gives way, so that their sum stays within 1.
TEST(Options, IntensitiesPushEachOther) {
  EXPECT_EQ(drawn({"--ia", "1"}).picture.light.Ip, 0.0);
  EXPECT_EQ(drawn({"--ip", "1"}).picture.light.Ia, 0.0);
  EXPECT_EQ(drawn({"--ip", "0.75"}).picture.light.Ia, 0.2);
}

// Effects on the palette are read as they are written.
TEST(Options, EffectsChangeWhatIsStored) {
  const auto only = [](const std::vector<std::string>& words, const PaletteEffects& expected) {
    EXPECT_EQ(drawn(words).effects, expected) << words[0];
    EXPECT_EQ(drawn(words).picture, PictureSettings{}) << words[0];
  };
  only({"--store", "brief"}, {.stored = TableKind::Brief});
  only({"--turn", "-120.5"}, {.hueTurn = -120.5});
  only({"--gamma", "2.2"}, {.gamma = 2.2});
  only({"--bend", "100,12.5"}, {.bend = CurvePoint{100, 12.5}});
  only({"--rotate", "-30"}, {.rotate = -30});
  only({"--lit", "255"}, {.lit = 255});
  EXPECT_EQ(drawn({"--view", "colours", "--cell", "0"}).window.cell, 0);
}

}  // namespace xnewell::THIS_FILE
