#include "x11/options/options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "shading/scene/scene.h"
#include "shading/scene/settings.h"

namespace xnewell {

namespace {

Options parsed(const std::vector<std::string>& arguments) {
  std::vector<const char*> argv{"xnewell"};
  for (const std::string& a : arguments) argv.push_back(a.c_str());
  const auto options = parseOptions(static_cast<int>(argv.size()), argv.data());
  if (!options) throw std::logic_error{"only --help returns nothing"};
  return *options;
}

/// `draw teapot -o no.png` and these.
Options drawn(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"draw", "teapot", "-o", "no.png"});
  return parsed(arguments);
}

/// The complaint about `draw teapot -o no.png` and these; "" if there is none.
std::string complaint(const std::vector<std::string>& arguments) {
  try {
    static_cast<void>(drawn(arguments));
  } catch (const UsageError& e) {
    return e.what();
  }
  return "";
}

std::string complaintAll(const std::vector<std::string>& arguments) {
  try {
    static_cast<void>(parsed(arguments));
  } catch (const UsageError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

// Nothing at all is a window on the teapot, and every command's name gives that command.
TEST(Options, CommandIsTheFirstWordOrView) {
  EXPECT_EQ(parsed({}).command, Command::View);
  EXPECT_EQ(parsed({}).scene, "teapot");
  EXPECT_EQ(parsed({"cycle"}).command, Command::View);
  EXPECT_EQ(parsed({"cycle"}).scene, "cycle");
  EXPECT_EQ(parsed({"view", "cycle"}).scene, "cycle");
  EXPECT_EQ(parsed({"--", "view"}).scene, "view");  // the word behind -- is no command
  for (const CommandRow& row : kCommands) {
    std::vector<std::string> words{std::string{row.name}};
    if (row.id == Command::Draw || row.id == Command::Snapshot)
      words.insert(words.end(), {"a.obj", "-o", "a"});
    if (row.id == Command::Trace) words.emplace_back("a.obj");
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
  for (const ViewRow& r : kViews) EXPECT_EQ(drawn({"--view", std::string{r.name}}).view, r.id);
  EXPECT_EQ(drawn({"--cull", "back"}).picture.cull, Cull::Back);
  EXPECT_EQ(drawn({"--cull", "none"}).picture.cull, Cull::Keep);
  EXPECT_FALSE(drawn({"--sided", "one"}).picture.light.twoSided);
  EXPECT_TRUE(drawn({"--sided", "two"}).picture.light.twoSided);
  EXPECT_EQ(drawn({"--bits", "8"}).picture.table.bits, 8);
  EXPECT_EQ(drawn({"--bits", "16"}).picture.table.bits, 16);
}

// Without options the settings are those of a default-made value: what --help prints is what is used.
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

// Over settings that a scene asks for, each option sets its own and leaves the others.
TEST(Options, SetOverWhatASceneAsksFor) {
  PictureSettings scene;
  scene.shading = Shading::Phong;
  scene.light.ks = 0.75;
  scene.table.shades = 64;
  scene.dither = true;
  const auto over = [&](std::vector<const char*> words) {
    words.insert(words.begin(), {"xnewell", "draw", "teapot", "-o", "no.png"});
    return parseOptions(static_cast<int>(words.size()), words.data(), scene)->picture;
  };
  EXPECT_EQ(over({}), scene);
  scene.light.kd = 0.5;
  EXPECT_EQ(over({"--kd", "0.5"}), scene);
  PictureSettings flat = scene;
  flat.shading = Shading::Flat;
  EXPECT_EQ(over({"--shade", "flat"}), flat);  // also where that is the program's default
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

// What one option refuses by itself, another setting may allow.
TEST(Options, RefuseSettingsWithoutEffect) {
  EXPECT_EQ(complaint({"--light-at", "1,2,3", "--range", "3"}), "--range applies only to attenuation linear");
  EXPECT_EQ(complaint({"--light-at", "1,2,3", "--range", "3", "--attenuation", "linear"}), "");
  EXPECT_EQ(complaint({"--light-at", "1,2,3", "--coefficients", "1,0,1", "--attenuation", "linear"}),
            "--coefficients applies only to attenuation textbook");
  EXPECT_EQ(complaint({"--light-at", "1,2,3", "--coefficients", "1,0,1", "--attenuation", "textbook"}), "");
  EXPECT_EQ(complaint({"--adapt", "0"}), "");
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
  EXPECT_EQ(drawn({"--view", "machbands", "--scanline", "8191"}).scanline, 8191);
  EXPECT_FALSE(drawn({"--view", "machbands"}).scanline.has_value());
  EXPECT_EQ(drawn({"--colormap", "private", "--view", "picture"}).picture, PictureSettings{});
  EXPECT_EQ(parsed({"snapshot", "teapot", "-o", "a", "--colormap", "shared"}).colormap, MapOwner::Shared);
  EXPECT_EQ(parsed({"visuals", "--colormap", "shared"}).colormap, MapOwner::Shared);
  EXPECT_TRUE(parsed({"view", "--nearest"}).nearest);
}

// Of Ia and Ip the one that was set pushes the other, so that their sum stays within 1; both together
// must keep to it themselves.
TEST(Options, IntensitiesPushEachOther) {
  EXPECT_EQ(drawn({"--ia", "1"}).picture.light.Ip, 0.0);
  EXPECT_EQ(drawn({"--ip", "1"}).picture.light.Ia, 0.0);
  EXPECT_EQ(drawn({"--ip", "0.75"}).picture.light.Ia, 0.2);
  EXPECT_EQ(complaint({"--ia", "0.5", "--ip", "0.5"}), "");
  EXPECT_EQ(complaint({"--ia", "0.5", "--ip", "0.6"}), "--ia and --ip: their sum must not exceed 1");
}

// Each wrong number is refused in one line that names the option, shows the text and says what is wanted.
TEST(Options, RefuseWrongNumbers) {
  const std::string size = " is not a size WxH from 1x1 to 8192x8192";
  for (const std::string wrong : {"0x5", "5x0", "-1x5", "8193x1", "1x8193", "8192", "x", "3x", "x3", "3x4x5",
                                  "3 x4", "+3x4", "3.0x4", "99999999999x3", "3X4", "nanxnan", "0x10x10"})
    EXPECT_EQ(complaint({"--size", wrong}), "--size: '" + wrong + "'" + size);

  for (const std::string option :
       {"--eye", "--look-at", "--up", "--light-at", "--vrp", "--vpn", "--vup", "--prp"})
    for (const std::string wrong :
         {"1,2", "1,2,3,4", "1,2,3,", ",1,2", "1,,3", "1 2 3", " 1,2,3", "1,2,3 ", "1e400,0,0", "nan,0,0",
          "inf,0,0", "-inf,0,0", "0x1,0,0", "a,b,c", "++1,2,3"})
      EXPECT_EQ(complaint({option, wrong}), option + ": '" + wrong + "' is not three finite numbers x,y,z");
  for (const std::string wrong : {"red", "1,1,2", "-1,1,0", "0.5,0.5,0.5", "0,0,0", "nan,1,1"})
    EXPECT_EQ(complaint({"--hue", wrong}),
              "--hue: '" + wrong + "' is not three finite numbers r,g,b from 0 to 1, the largest 1");
  for (const std::string wrong : {"1", "1,-1,0"})
    EXPECT_EQ(complaint({"--coefficients", wrong}),
              "--coefficients: '" + wrong + "' is not three finite numbers c1,c2,c3 of at least 0");
  for (const std::string wrong : {"1,2", "0,0,-0", "inf,0,0", "1,2,3,"})
    EXPECT_EQ(complaint({"--light", wrong}),
              "--light: '" + wrong + "' is not three finite numbers x,y,z, not all 0");
  for (const std::string wrong : {"0", "-1", "inf"})
    EXPECT_EQ(complaint({"--range", wrong}), "--range: '" + wrong + "' is not a number above 0");

  for (const std::string option : {"--ia", "--ip", "--ka", "--kd", "--ks"})
    for (const std::string wrong : {"-0.001", "1.001", "nan", "inf", "half", "0.5,0.5", "1e999"})
      EXPECT_EQ(complaint({option, wrong}), option + ": '" + wrong + "' is not a number from 0 to 1");

  const auto refused = [](const std::string& option, const std::string& wrong) {
    const std::string said = complaint({option, wrong});
    EXPECT_TRUE(said.starts_with(option + ": '" + wrong + "' is not "))
        << option << ' ' << wrong << ": " << said;
  };
  for (const std::string wrong : {"0", "180", "-30", "nan", "inf", "1e400", "30deg"}) refused("--fov", wrong);
  for (const std::string wrong : {"0", "-1", "nan", "inf", "3,4"}) refused("--parallel", wrong);
  for (const std::string wrong : {"1,2,3", "1,2,3,nan", "1,2,3,4,5"}) refused("--view-window", wrong);
  for (const std::string wrong : {"nan", "inf", "1,2", "near"})
    refused("--front", wrong), refused("--back", wrong);
  for (const std::string wrong : {"0", "257", "2.5", "-1", "nan", "99999999999"})
    refused("--divisions", wrong);
  for (const std::string wrong : {"1", "241", "2.5", "nan"}) refused("--shades", wrong);
  for (const std::string wrong : {"-1", "1000001", "1.5", "1e300"}) refused("--n", wrong);
  for (const std::string wrong : {"0", "1", "-1", "nan"}) refused("--i0", wrong);
  for (const std::string wrong : {"9", "0", "016", "eight"}) refused("--bits", wrong);
  for (const std::string wrong : {"cubist", "Cabinet"}) refused("--oblique", wrong);
  for (const std::string wrong : {"-1", "8192", "2.5", "nan", "1,2"}) refused("--scanline", wrong);
  for (const std::string wrong : {"front", "Back"}) refused("--cull", wrong);
  for (const std::string wrong : {"three", "1"}) refused("--sided", wrong);
  for (const std::string wrong : {"-0.1", "1.01", "nan", "1,1"}) refused("--adapt", wrong);
  EXPECT_EQ(complaint({"--oblique", "cabinet:"}), "--oblique: '' is not an angle in degrees");
}

// What is about a server's colormap is not for those that ask none.
TEST(Options, ColormapsAreForServers) {
  for (const std::vector<std::string>& server :
       std::vector<std::vector<std::string>>{{"--colormap", "shared"}, {"--nearest"}})
    EXPECT_EQ(complaint(server),
              "--colormap shared and --nearest go with view and snapshot: they need a server");
}

// Every option that wants a value says so when there is none, and none may be given twice.
TEST(Options, NeedOneValueEach) {
  for (const std::string option :
       {"--size",    "--divisions",   "--shade",       "--order",       "--fill",         "--cull",
        "--sided",   "--ia",          "--ip",          "--ka",          "--kd",           "--ks",
        "--n",       "--light",       "--light-at",    "--table",       "--shades",       "--i0",
        "--pick",    "--hue",         "--bits",        "--eye",         "--look-at",      "--up",
        "--fov",     "--parallel",    "--oblique",     "--vrp",         "--vpn",          "--vup",
        "--prp",     "--view-window", "--front",       "--back",        "--visual",       "--colormap",
        "--view",    "--ids",         "--attenuation", "--range",       "--coefficients", "--form",
        "--normals", "--crease",      "--polygons",    "--environment", "--texture",      "--mapping",
        "--colors",  "--scanline",    "--adapt"}) {
    EXPECT_EQ(complaint({option}), option + " needs a value");
    EXPECT_EQ(complaint({option + "="}), option + " needs a value");
    EXPECT_NE(complaint({option, ""}), "") << option;
    EXPECT_EQ(complaint({option, "1", option, "1"}), option + " is given more than once");
  }
  EXPECT_EQ(complaint({"--output", "b.png"}), "--output is given more than once");
  EXPECT_NE(complaint({"--stats=no"}), "");
  EXPECT_EQ(complaint({"--stats", "--stats"}), "");
}

// What is unknown is shown, a part of it if it is long, and never a byte that a terminal would obey.
TEST(Options, RefuseTheUnknown) {
  EXPECT_EQ(complaint({"--nonsense"}), "unknown option '--nonsense'");
  EXPECT_EQ(complaint({"--nonsense=3"}), "unknown option '--nonsense=3'");
  EXPECT_EQ(complaint({"-z", "3"}), "unknown option '-z'");
  EXPECT_EQ(complaint({"--stat"}),
            "unknown option '--stat'");  // no abbreviations: they would become promises
  EXPECT_EQ(complaint({"extra.obj"}), "one argument too many: 'extra.obj'");
  EXPECT_EQ(complaint({""}), "one argument too many: ''");
  EXPECT_EQ(complaint({"--", "extra.obj"}), "one argument too many: 'extra.obj'");
  EXPECT_EQ(complaintAll({"lesson", "cycles", "extra"}), "one argument too many: 'extra'");
  EXPECT_EQ(complaint({"--shade", "\x1b[2J"}),
            "--shade: '?[2J' is not one of none, depth, flat, gouraud, phong, envmap");
  const std::string longest(100'000, 'a');
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--" + longest},
                                                {"--size", longest},
                                                {"--eye", longest},
                                                {longest},
                                                {"--view", longest},
                                                {"--order", longest},
                                                {"--fov", longest},
                                                {"--cull", longest},
                                                {"--bits", longest}})
    EXPECT_LT(complaint(words).size(), 200u) << words[0].substr(0, 20);
}

// The words of the contract that do nothing yet say so; none of them is taken for a misspelling.
TEST(Options, SayWhatIsNotBuiltYet) {
  for (const std::string command : {"figure", "trade"})
    for (const std::vector<std::string>& rest :
         {std::vector<std::string>{}, {"teapot", "-o", "no.svg"}, {"--help"}}) {
      std::vector<std::string> words{command};
      words.insert(words.end(), rest.begin(), rest.end());
      EXPECT_EQ(complaintAll(words),
                "the command '" + command + "' is not built yet; `xnewell --help` lists what is");
    }
  for (const std::string option : {"--json"}) {
    EXPECT_EQ(complaint({option}), option + " is not built yet");
    EXPECT_EQ(complaint({option + "=x"}), option + " is not built yet");
  }
}

// Of two options that cannot both be heeded neither is ignored.
TEST(Options, RefuseWhatExcludesEachOther) {
  EXPECT_EQ(complaint({"--light", "1,0,0", "--light-at", "1,2,9"}),
            "--light and --light-at exclude each other");
  EXPECT_EQ(complaint({"--eye", "1,2,3", "--prp", "0,0,9"}),
            "--eye and the textbook's --vpn, --prp exclude each other");
  EXPECT_EQ(complaint({"--look-at", "1,2,3", "--vrp", "0,0,9"}), "--look-at and --vrp exclude each other");
  EXPECT_EQ(complaint({"--up", "0,0,1", "--vup", "0,0,1"}), "--up and --vup exclude each other");
  EXPECT_EQ(complaint({"--fov", "20", "--view-window", "-1,1,-1,1"}),
            "--fov and --view-window exclude each other");
}

// An option that its command cannot heed is refused, not ignored.
TEST(Options, RefuseWhatTheCommandIgnores) {
  EXPECT_EQ(complaintAll({"draw"}), "draw needs a scene, such as teapot");
  EXPECT_EQ(complaintAll({"draw", "-o", "a.png"}), "draw needs a scene, such as teapot");
  EXPECT_EQ(complaintAll({"draw", "teapot"}), "draw needs -o FILE.png");
  EXPECT_EQ(complaintAll({"snapshot", "teapot", "-o", ""}), "snapshot needs -o FILE.png");
  EXPECT_EQ(complaintAll({"draw", "", "-o", "a.png"}), "the scene's name is empty");
  EXPECT_EQ(complaintAll({""}), "the scene's name is empty");
  EXPECT_EQ(complaintAll({"scenes", "teapot"}), "scenes takes no scene");
  EXPECT_EQ(complaintAll({"visuals", "teapot"}), "visuals takes no scene");
  EXPECT_EQ(complaintAll({"view", "-o", "a.png"}), "-o goes with draw and snapshot");
  EXPECT_EQ(complaintAll({"view", "--stats"}), "--stats and --ids go with draw and snapshot");
  EXPECT_EQ(complaintAll({"--ids", "i.png"}), "--stats and --ids go with draw and snapshot");
  EXPECT_EQ(complaint({"--whole-window"}), "--whole-window goes with snapshot and with trace --frames");
  EXPECT_EQ(complaint({"--fill", "x11"}), "--fill x11 needs a server: use snapshot");
  EXPECT_EQ(complaint({"--visual", "TrueColor24"}), "--visual goes with view, snapshot and visuals");
  for (const std::string method : {"none", "depth", "phong", "envmap"})
    EXPECT_EQ(complaint({"--adapt", "0.02", "--shade", method}),
              "--adapt applies only to flat and gouraud shading");
  EXPECT_EQ(complaint({"--fov", "30", "--parallel", "3"}),
            "--fov is for perspective: leave out --parallel and --oblique");
  EXPECT_EQ(complaint({"--fov", "30", "--oblique", "cabinet"}),
            "--fov is for perspective: leave out --parallel and --oblique");
}

// A view of numbers is a picture of its own, of at least the size of its words.
TEST(Options, RefuseWhatAViewCannotHeed) {
  EXPECT_EQ(complaint({"--scanline", "3"}), "--scanline goes with --view machbands");
  EXPECT_EQ(complaint({"--view", "normals", "--scanline", "3"}), "--scanline goes with --view machbands");
  for (const ViewRow& row : kViews) {
    if (row.id == View::Picture) continue;
    const std::string name{row.name}, view = "--view " + name;
    const std::string width = std::to_string(row.leastWidth), height = std::to_string(row.leastHeight);
    EXPECT_EQ(complaint({"--view", name, "--size", width + "x" + height}), "");
    for (const std::string& small :
         {std::to_string(row.leastWidth - 1) + "x8192", "8192x" + std::to_string(row.leastHeight - 1)})
      EXPECT_EQ(complaint({"--view", name, "--size", small}),
                view + " needs a --size of at least " + width + "x" + height);
    EXPECT_EQ(complaint({"--view", name}), "") << "the size without --size is too small";
    EXPECT_EQ(complaintAll({"--view", name}), "");
    EXPECT_EQ(complaintAll({"--view", name, "--size", "799x600"}),
              view + " needs a --size of at least 800x600");
    EXPECT_EQ(complaintAll({"trace", "teapot", "--view", name}), view + " goes with view, draw and snapshot");
    const std::string more = view + " is more than a picture: --stats and --ids go with --view picture";
    EXPECT_EQ(complaint({"--view", name, "--ids", "i.png"}), more);
    EXPECT_EQ(complaint({"--view", name, "--stats"}), more);
    EXPECT_EQ(complaintAll({"snapshot", "teapot", "-o", "a", "--whole-window", "--view", name}), "");
    EXPECT_EQ(complaintAll({"snapshot", "teapot", "-o", "a", "--fill", "x11", "--view", name}),
              view + " is filled by the scanline: leave out --fill x11");
  }
  for (const std::string name : {"depthsort", "sidebyside", "lesson"}) {
    EXPECT_EQ(complaintAll({"--view", name}), "");
    EXPECT_EQ(complaintAll({"snapshot", "teapot", "-o", "a", "--whole-window", "--view", name}), "");
    EXPECT_EQ(complaint({"--view", name}),
              "--view " + name + " is a view of the window: with view, or with snapshot --whole-window");
  }
  EXPECT_EQ(complaintAll({"--scanline", "3", "--view", "machbands"}),
            "--scanline goes with a view that is drawn without its window");
}

// Effects on the palette are read as they are written, and refused with what they have no say in.
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
  EXPECT_EQ(drawn({"--view", "colours", "--cell", "0"}).cell, 0);
  for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{{"--store", "gray"},
                                                                                   {"--gamma", "0"},
                                                                                   {"--bend", "100"},
                                                                                   {"--bend", "256,3"},
                                                                                   {"--bend", "9,256"},
                                                                                   {"--rotate", "1.5"},
                                                                                   {"--lit", "256"},
                                                                                   {"--lit", "-1"}})
    EXPECT_EQ(complaint(bad).rfind(bad[0] + ": '", 0), 0u) << complaint(bad);
  EXPECT_EQ(complaint({"--view", "machbands", "--lit", "20"}).rfind("--lit goes with --view picture", 0), 0u);
  EXPECT_EQ(complaintAll({"view", "--lit", "20"}), "--lit goes with draw and snapshot");
  EXPECT_EQ(complaint({"--cell", "20"}), "--cell goes with --view colours");
}

// No output may take the place of the scene or of the other output.
TEST(Options, OutputsAreFilesOfTheirOwn) {
  const std::string lost = "-o and --ids must not name the scene's own file: it would be lost";
  EXPECT_EQ(complaintAll({"draw", "a.obj", "-o", "a.obj"}), lost);
  EXPECT_EQ(complaintAll({"draw", "a.obj", "-o", "x/../a.obj"}), lost);
  EXPECT_EQ(complaintAll({"draw", "a.obj", "-o", "b", "--ids", "./a.obj"}), lost);
  EXPECT_EQ(complaintAll({"draw", "a.obj", "-o", "b", "--ids", "./b"}), "-o and --ids name the same file");
  EXPECT_EQ(complaintAll({"draw", "teapot", "-o", "teapot"}), "");  // a built-in scene is no file here
  EXPECT_EQ(complaintAll({"draw", "a.obj", "-o", "/dev/null", "--ids", "/dev/null"}), "");
}

}  // namespace xnewell
