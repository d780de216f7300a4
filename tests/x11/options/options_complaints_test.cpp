#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/x11/support/parsed_options.h"
#include "x11/options/option_rows.h"

namespace xnewell::THIS_FILE {

// Command lines that are refused, and the complaint about each. What options set: options_test.cpp.

// A wrong number is refused in one line that names the option, shows the text and says what is wanted.
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
              "--hue: '" + wrong + "' is not three finite numbers r,g,b from 0 to 1, where the largest is 1");
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
  for (const std::string wrong : {"-1", "2.", ".5", "nan", "1,2", "1e3", "12345678901"})
    refused("--scanline", wrong);
  for (const std::string wrong : {"8192", "2.5"})
    EXPECT_EQ(complaint({"--view", "machbands", "--scanline", wrong}),
              "--scanline: '" + wrong + "' is not a whole number from 0 to 8191");
  for (const std::string wrong : {"front", "Back"}) refused("--cull", wrong);
  for (const std::string wrong : {"three", "1"}) refused("--sided", wrong);
  for (const std::string wrong : {"-0.1", "1.01", "nan", "1,1"}) refused("--adapt", wrong);
  EXPECT_EQ(complaint({"--oblique", "cabinet:"}), "--oblique: '' is not an angle in degrees");
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

// Every option that needs a value says so if there is none, and no option may be given twice.
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

// The complaint shows the unknown word, or part of it if it is long. It never contains a byte that would
// control a terminal.
TEST(Options, RefuseTheUnknown) {
  EXPECT_EQ(complaint({"--nonsense"}), "unknown option '--nonsense'");
  EXPECT_EQ(complaint({"--nonsense=3"}), "unknown option '--nonsense=3'");
  EXPECT_EQ(complaint({"-z", "3"}), "unknown option '-z'");
  EXPECT_EQ(complaint({"--stat"}),
            "unknown option '--stat'");  // no abbreviations: they would become promises
  EXPECT_EQ(complaint({"extra.obj"}), "unexpected argument: 'extra.obj'");
  EXPECT_EQ(complaint({""}), "unexpected argument: ''");
  EXPECT_EQ(complaint({"--", "extra.obj"}), "unexpected argument: 'extra.obj'");
  EXPECT_EQ(complaintAll({"lesson", "cycles", "extra"}), "unexpected argument: 'extra'");
  EXPECT_EQ(complaint({"--shade", "\x1b[2J"}),
            "--shade: '\\x1b[2J' is not one of none, depth, flat, gouraud, phong, envmap");
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
    EXPECT_LT(complaint(words).size(), 300u) << words[0].substr(0, 20);
}

// A figure is an SVG, PDF or EPS file of polygons in a painting order.
TEST(Options, FiguresAreOfPolygons) {
  const auto figure = [](std::vector<std::string> words) {
    words.insert(words.begin(), {"figure", "teapot", "-o", "a.svg"});
    return complaintAll(words);
  };
  EXPECT_EQ(figure({"--paper", "#ffffff", "--stats"}), "");
  EXPECT_EQ(figure({"--ids", "b.pdf", "--order", "zmean", "--shade", "depth"}), "");
  EXPECT_EQ(complaintAll({"figure", "teapot"}), "figure needs -o FILE.svg, FILE.pdf or FILE.eps");
  EXPECT_EQ(complaintAll({"figure", "-o", "a.svg"}), "figure needs a scene, such as teapot");
  EXPECT_EQ(complaintAll({"figure", "teapot", "-o", "a.png"}),
            "-o a.png: figures are SVG, PDF or EPS files; call it .svg, .pdf or .eps");
  EXPECT_EQ(figure({"--ids", "b.png"}),
            "--ids b.png: figures are SVG, PDF or EPS files; call it .svg, .pdf or .eps");
  EXPECT_EQ(figure({"--paper", "white"}),
            "--paper: 'white' is not #rrggbb, a colour by six hexadecimal digits");
  EXPECT_EQ(complaint({"--paper", "#ffffff"}), "--paper works only with figure");
  EXPECT_EQ(complaint({"--edges", "all"}), "");
  EXPECT_EQ(figure({"--edges", "all", "--edge-color", "#80808"}),
            "--edge-color: '#80808' is not #rrggbb, a colour by six hexadecimal digits");
  EXPECT_EQ(figure({"--shade", "phong", "--tolerance", "0"}), "");
  EXPECT_EQ(figure({"--edges", "all"}), "");
  EXPECT_EQ(figure({"--smooth"}),
            "--smooth needs -o FILE.pdf: only PDF has triangles with a colour at each corner");
  EXPECT_EQ(complaintAll({"figure", "teapot", "--smooth", "-o", "a.PDF"}), "");
  EXPECT_EQ(figure({"--tolerance", "65"}), "--tolerance: '65' is not a whole number from 0 to 64");
  EXPECT_EQ(figure({"--order", "bsp"}),
            "--order bsp leaves out what has no sample: use --order newell for a figure");
  EXPECT_EQ(figure({"--order", "oracle"}),
            "--order oracle decides each sample by itself: a figure needs a painting order");
}

// Two options that exclude each other are refused: neither is ignored.
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

// An option that does not apply to its command is refused, not ignored.
TEST(Options, RefuseWhatTheCommandIgnores) {
  EXPECT_EQ(complaintAll({"draw"}), "draw needs a scene, such as teapot");
  EXPECT_EQ(complaintAll({"draw", "-o", "a.png"}), "draw needs a scene, such as teapot");
  EXPECT_EQ(complaintAll({"draw", "teapot"}), "draw needs -o FILE.png");
  EXPECT_EQ(complaintAll({"snapshot", "teapot", "-o", ""}), "snapshot needs -o FILE.png");
  EXPECT_EQ(complaintAll({"draw", "", "-o", "a.png"}), "the scene's name is empty");
  EXPECT_EQ(complaintAll({""}), "the scene's name is empty");
  EXPECT_EQ(complaintAll({"scenes", "teapot"}), "scenes takes no scene");
  EXPECT_EQ(complaintAll({"visuals", "teapot"}), "visuals takes no scene");
  EXPECT_EQ(complaintAll({"view", "-o", "a.png"}),
            "-o works only with draw, snapshot, figure, trade, extremes, diagnose, judge and grade");
  EXPECT_EQ(complaintAll({"view", "--stats"}), "--stats works only with draw, snapshot and figure");
  EXPECT_EQ(complaintAll({"--ids", "i.png"}), "--ids works only with draw, snapshot and figure");
  EXPECT_EQ(complaint({"--whole-window"}), "--whole-window works only with snapshot and trace --frames");
  EXPECT_EQ(complaintAll({"scenes", "--ka", "1"}), "--ka does not work with scenes: it draws no scene");
  EXPECT_EQ(complaintAll({"draw", "teapot", "-o", "a", "--scale", "2"}),
            "--scale works only with view, lesson, lecture and --whole-window");
  EXPECT_EQ(complaintAll({"lesson", "cycles", "--scale", "2", "--size", "1599x1200"}),
            "a lesson needs a --size of at least 1600x1080");
  EXPECT_EQ(complaintAll({"lesson", "cycles", "--scale", "2"}), "");
  EXPECT_EQ(
      complaintAll({"lesson", "cycles", "--scale", "1.5"}),
      "--scale: '1.5' is not a whole number from 1 to 4; the letters are made of pixels, and a part of a "
      "pixel cannot be drawn");
  EXPECT_EQ(complaint({"--fill", "x11"}), "--fill x11 needs a server: use snapshot");
  for (const OrderRow& row : kOrders) {
    const std::string name{row.name};
    const bool bySample = name == "oracle" || name.starts_with("zbuffer");
    EXPECT_EQ(complaintAll(
                  {"snapshot", "teapot", "-o", "a.png", "--fill", "x11", "--shade", "flat", "--order", name}),
              bySample ? "--order " + name +
                             " decides each sample by itself: there is no polygon for --fill x11 to fill"
                       : "");
  }
  EXPECT_EQ(complaint({"--visual", "TrueColor24"}),
            "--visual works only with view, snapshot, lesson, lecture and visuals");
  EXPECT_EQ(complaintAll({"lesson", "cycles", "--frames", "f", "--nearest"}),
            "--nearest needs a server, and lesson --frames uses none");
  for (const std::string method : {"none", "depth", "phong", "envmap"})
    EXPECT_EQ(complaint({"--adapt", "0.02", "--shade", method}),
              "--adapt applies only to flat and gouraud shading without --mistake");
  EXPECT_EQ(complaint({"--fov", "30", "--parallel", "3"}),
            "--fov is for perspective: leave out --parallel and --oblique");
  EXPECT_EQ(complaint({"--fov", "30", "--oblique", "cabinet"}),
            "--fov is for perspective: leave out --parallel and --oblique");
}

// A view refuses options that do not apply to it, and a size too small for its words.
TEST(Options, RefuseWhatAViewCannotHeed) {
  EXPECT_EQ(complaint({"--scanline", "3"}),
            "--scanline works only with --view machbands, --view scanline and trace");
  EXPECT_EQ(complaintAll({"--step", "3"}),
            "--step works only with --view depthsort, --view viewing, --view scanline and lesson");
  EXPECT_EQ(complaintAll({"lesson", "--step", "3"}), "--step needs a lesson's name");
  EXPECT_EQ(complaintAll({"lesson", "cycles", "--step", "3", "--frames", "f"}),
            "--frames and --step exclude each other");
  const auto beside = [](const std::string& text) {
    return complaintAll({"--view", "sidebyside", "--beside", text});
  };
  for (const std::string right :
       {"same", "order=none", " shade=phong  ks=0.4 ", "light-at= light=0,0,1", "dither=true"})
    EXPECT_EQ(beside(right), "") << right;
  for (const std::string wrong : {"order", "colour=red", "fill=x11", "size=3x3"})
    EXPECT_EQ(beside(wrong), "--beside: '" + wrong +
                                 "' is not a setting with its value, such as order=none, or the word same");
  EXPECT_EQ(beside(""),
            "--beside: '' is not settings with their values, such as order=none, or the word same");
  EXPECT_EQ(beside("order=none ks=2"), "--ks: '2' is not a number from 0 to 1");
  EXPECT_EQ(beside("dither=perhaps"), "--dither: 'perhaps' is not true or false");
  EXPECT_EQ(beside("ia=0.8 ip=0.8"), "--beside: the sum of ia and ip must not exceed 1");
  EXPECT_EQ(complaintAll({"--beside", "same"}), "--beside works only with --view sidebyside");
  EXPECT_EQ(complaintAll({"--view", "sidebyside", "--difference", "z"}),
            "--difference: 'z' is not one of face, intensity, colour");
  EXPECT_EQ(complaintAll({"--pixel", "3,3"}), "--pixel works only with --view pixel");
  EXPECT_EQ(complaintAll({"--view", "pixel", "--pixel", "3"}),
            "--pixel: '3' is not a pixel X,Y: two whole numbers from 0, counted from the top left");
  EXPECT_EQ(complaintAll({"draw", "cubes", "-o", "a", "--controls", "s"}),
            "--controls works only with view and --whole-window");
  EXPECT_EQ(complaintAll({"--controls", "none", "--view", "depthsort"}), "");
  EXPECT_EQ(complaint({"--view", "normals", "--scanline", "3"}),
            "--scanline works only with --view machbands, --view scanline and trace");
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
  for (const WindowViewRow& row : kWindowViews) {
    const std::string name{row.option};
    if (std::ranges::find(kViews, name, &ViewRow::name) != kViews.end()) continue;
    ++inTheWindow;
    EXPECT_EQ(complaintAll({"--view", name}), "");
    EXPECT_EQ(complaintAll({"snapshot", "teapot", "-o", "a", "--whole-window", "--view", name}), "");
    EXPECT_EQ(complaint({"--view", name}),
              "--view " + name + " is a view of the window: use view, or snapshot --whole-window");
  }
  EXPECT_GE(inTheWindow, 4);
  EXPECT_EQ(complaintAll({"--scanline", "3", "--view", "machbands"}), "");
}

}  // namespace xnewell::THIS_FILE
