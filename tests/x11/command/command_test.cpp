#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <set>
#include <sstream>
#include <thread>

#include "tests/support/seeds.h"
#include "tests/x11/support/command_fixture.h"
#include "x11/lessons/lesson.h"
#include "x11/options/options.h"

namespace xnewell::THIS_FILE {

/// The program's messages, files and exit status, when something is wrong and when nothing is.

// A bad file gives one line with the file, the line in it and what is wrong. An old picture stays as it was.
// (malformed_files_test.cpp has the lines of each kind of file.)
TEST_F(CommandTest, BadScenesAreRefusedInOneLine) {
  std::filesystem::create_directory(file("folder"));
  std::filesystem::create_directory(file("folder.obj"));
  std::ifstream whole{XNEWELL_DATA_DIR "/teapot.bpt"};
  std::string truncated;
  for (std::string line; std::getline(whole, line) && truncated.size() < 3000;) truncated += line + "\n";

  refusedToDraw(file("missing.obj"), 1, ": No such file or directory");
  refusedToDraw(file("folder"), 1, ": Is a directory");
  refusedToDraw(file("folder.obj"), 1, ": Is a directory");
  const std::string cut = write("cut.bpt", truncated);
  EXPECT_TRUE(runProgram({"draw", cut, "-o", file("x")}).err.starts_with("xnewell: " + cut + ":"))
      << truncated;
  refusedToDraw(write("two.obj", "v 0 0 0\nf 1 2\n"), 2, ":2: a face needs three vertices; this one has 2");
  refusedToDraw(write("scene.json", "{}"), 2, ": the scene has no faces");
  refusedToDraw(write("scene.xyz", kTriangleObj), 2,
                ": not a scene file: scenes are .json files and models: .obj, .ply, .off, .bpt");
  refused({"draw", "nosuch", "-o", file("new.png")}, 2,
          "nosuch: there is no built-in scene of that name; `xnewell scenes` lists them");
  refused({"nosuch"}, 2,
          "nosuch: not a command or a built-in scene; `xnewell --help` lists the commands, `xnewell "
          "scenes` the scenes");
}

// A message is one line of bounded length, whatever names are in it.
TEST_F(CommandTest, MessagesAreOneShortLine) {
  const std::string longest(100'000, 'a');
  for (const Strings& words :
       {Strings{"draw", longest, "-o", file("a.png")}, Strings{"draw", longest + ".obj", "-o", file("a.png")},
        Strings{longest}, Strings{"draw", "teapot", "-o", longest}, Strings{"--" + longest},
        Strings{"draw", "no\nsuch\x1b.obj", "-o", file("a.png")}, Strings{"draw", "teapot", "--size", "3\n4"},
        Strings{"draw", "teapot", "--fo\no"}, Strings{"no\r\nsuch"}}) {
    const Finished end = runProgram(words);
    EXPECT_TRUE(end.status == 1 || end.status == 2) << end.status;
    EXPECT_EQ(end.err.find_first_of("\n\r\x1b"), end.err.size() - 1);
    EXPECT_LT(end.err.size(), 1000u);
    EXPECT_TRUE(end.err.starts_with("xnewell: "));
  }
}

// Wrong usage gives one line and status 2, and touches no file. (options_complaints_test.cpp has the lines in
// full.)
TEST_F(CommandTest, WrongUsageIsStatus2) {
  const Strings whole{"draw", "teapot", "-o", file("old.png")};
  refused(whole + Strings{"--nonsense"}, 2, "unknown option '--nonsense'");
  for (const std::string size : {"0x600", "800x0", "-8x6", "8193x600", "800x8193", "800"})
    refused(whole + Strings{"--size", size}, 2,
            "--size: '" + size + "' is not a size WxH from 1x1 to 8192x8192");
  refused(whole + Strings{"--eye", "nan,0,0"}, 2, "--eye: 'nan,0,0' is not three finite numbers x,y,z");
  refused(whole + Strings{"--shade", "foggy"}, 2,
          "--shade: 'foggy' is not one of none, depth, flat, gouraud, phong, envmap");
  refused(whole + Strings{"--view", "machbands", "--scanline", "261"}, 2,
          "--scanline: 261 is below the picture: in this view its rows are 0 to 260");
  refused(whole + Strings{"--texture", "none.png"}, 1, "none.png: No such file or directory");
  refused(whole + Strings{"--eye", "1,1,1", "--look-at", "1,1,1"}, 2,
          "the view plane normal is zero; eye and look-at point must differ");
  refused(whole + Strings{"--up", "0,0,1", "--eye", "0,0,9", "--look-at", "0,0,0"}, 2,
          "the up vector is zero or along the view plane normal");
  refused(whole + Strings{"--view-window", "1,-1,0,1"}, 2,
          "the view window is empty: umin < umax and vmin < vmax are needed");
  refused(whole + Strings{"--front", "-1", "--back", "1"}, 2,
          "the front plane must lie nearer than the back plane (larger n)");
  refused({"figure", "none.obj", "-o", file("old.svg")}, 1, "none.obj: No such file or directory");
}

// Without a server, a command that needs one fails with one line and status 1. `draw` and `scenes` do not
// need one.
TEST_F(CommandTest, NoServerIsStatus1) {
  const std::string unset = "DISPLAY is not set: start an X server, or name one, for example DISPLAY=:0";
  refused({}, 1, unset);
  refused({"view", "cycle"}, 1, unset);
  refused({"snapshot", "teapot", "-o", file("old.png")}, 1, unset);
  refused({"visuals"}, 1, unset);
  const Finished none = runProgram({"snapshot", "teapot", "-o", file("new.png")}, "nowhere.invalid:7");
  EXPECT_EQ(none.status, 1);
  EXPECT_TRUE(none.err.starts_with("xnewell: ") && none.err.find('\n') == none.err.size() - 1) << none.err;
  EXPECT_EQ(runProgram({"scenes"}).status, 0);
}

// A name may hold what commands a terminal. It is shown, and no command writes a control character but the
// ends of its lines.
TEST_F(CommandTest, NoForeignTextCommandsATerminal) {
  const std::string odd = "\x1b]0;x\x07\r\u009b2J",
                    scene = write("a\x1b[2J.json",
                                  Json{{"objects", {{{"solid", "cube"}, {"name", odd}, {"material", odd}}}},
                                       {"materials", {{odd, {{"color", {1, 0, 0}}}}}}}
                                      .dump());
  write("order.jsonl", "{\"face\": 0}\n");
  int shown = 0;
  for (const Strings& words : {Strings{"explain", scene, "400,300"},
                               {"explain", scene, "--viewing"},
                               {"trace", scene},
                               {"trace", scene, "--scanline", "0"},
                               {"questions", scene},
                               {"extremes", scene, "--size", "8x6"},
                               {"trade", scene, "--size", "8x6", "--budget", "1", "--axes", "order"},
                               {"judge", scene, file("order.jsonl")},
                               {"draw", scene, "-o", file("a.png"), "--accuracy", "0.5", "--budget", "1"},
                               {"draw", file("none\x1b[2J.json"), "-o", file("a.png")}}) {
    const Finished end = runProgram(words);
    const std::string all = end.out + end.err;
    EXPECT_GT(all.size(), 10u) << words[0];
    for (const char c : all) EXPECT_TRUE(c == '\n' || (c >= ' ' && c != 0x7F) || c < 0) << words[0] << int{c};
    EXPECT_EQ(all.find("\u009b"), std::string::npos) << words[0];
    shown += all.find("\\x1b") != std::string::npos;
  }
  EXPECT_GE(shown, 5);
}

// The status is 1 if the output has nowhere to go, 1 if its place refuses it, and 0 if the output is
// swallowed.
TEST_F(CommandTest, OutputsThatCannotBeWritten) {
  std::filesystem::create_directory(file("folder"));
  const auto to = [](const std::string& o) { return Strings{"draw", "cycle", "-o", o}; };
  refused(to(file("no/such/a.png")), 1, file("no/such/a.png") + ": No such file or directory");
  refused(to(file("folder")), 1, file("folder") + ": Is a directory");
  refused(to(file("old.png") + "/a.png"), 1, file("old.png") + "/a.png: Not a directory");
  refused(to("/dev/full"), 1, "/dev/full: No space left on device");
  EXPECT_EQ(runProgram(to("/dev/null")).status, 0);
  const Finished piped = runProgram(to("/dev/stdout"));
  EXPECT_EQ(runProgram(to(file("a.png"))).status, 0);
  EXPECT_EQ(piped.out, contents(file("a.png")));
}

// If either the picture or the face image cannot be written, neither is.
TEST_F(CommandTest, PictureAndFacesAreWrittenTogether) {
  const auto to = [](const std::string& o, const std::string& ids) {
    return Strings{"draw", "cycle", "-o", o, "--ids", ids, "--stats"};
  };
  for (const std::string& good : {file("old.png"), file("new.png")}) {
    refused(to(good, file("no/such/i.png")), 1, file("no/such/i.png") + ": No such file or directory");
    refused(to(good, "/dev/full"), 1, "/dev/full: No space left on device");
    refused(to(file("no/such/a.png"), good), 1, file("no/such/a.png") + ": No such file or directory");
    refused(to("/dev/full", good), 1, "/dev/full: No space left on device");
  }
}

// A file beyond the shell's size limit is not left behind. The program gives the reason: no signal kills it.
TEST_F(CommandTest, AFileTooLargeIsAnError) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{100, before.rlim_max};
  const auto ours = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  // The child's messages go to a file in memory. The limit applies to it too, but 100 bytes are enough.
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(file("."));
  std::signal(SIGXFSZ, SIG_DFL);
  const Finished end = runProgram({"draw", "cycle", "-o", "old.png"});
  std::signal(SIGXFSZ, ours);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::filesystem::current_path(here);
  EXPECT_EQ(end.status, 1);
  EXPECT_EQ(end.err, "xnewell: old.png: File too large\n");
  EXPECT_EQ(everything(), (std::map<std::string, std::string>{{"old.png", "before"}}));
}

// Ctrl-C at any moment of a long picture ends the program with status 130 (0 if it came too late). The
// picture is whole or absent, and nothing else is left in the folder.
TEST_F(CommandTest, AnInterruptLeavesNothingHalfWritten) {
  int interrupted = 0;
  for (int delay = 0; delay <= 240; delay += 20) {
    std::filesystem::remove(file("big.png"));
    RunningProgram child{
        {"draw", "teapot", "-o", file("big.png"), "--size", "3000x3000", "--ids", file("big-ids.png")}};
    std::this_thread::sleep_for(std::chrono::milliseconds(10 + delay));
    child.signal(SIGINT);
    const Finished end = child.wait();
    EXPECT_TRUE(end.status == 130 || end.status == 0) << end.status;
    interrupted += end.status == 130;
    std::set<std::string> names;
    for (const auto& [name, bytes] : everything()) names.insert(name);
    names.erase("big.png");
    names.erase("big-ids.png");
    EXPECT_EQ(names, (std::set<std::string>{"old.png"}));
    if (std::filesystem::exists(file("big.png"))) {
      EXPECT_EQ(readPng(file("big.png")).width, 3000);
    }
  }
  EXPECT_GT(interrupted, 0);
}

// Output to a closed, full or broken standard output is an error, and the text goes to no other file.
TEST_F(CommandTest, StandardOutputThatCannotBeWritten) {
  const std::string program = builtProgram();
  const auto shell = [](const std::string& line) {
    const int status = std::system(("exec 2>/dev/null; " + line).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  };
  EXPECT_EQ(shell(program + " --help >&-"), 1);
  EXPECT_EQ(shell(program + " --help >/dev/full"), 1);
  EXPECT_EQ(shell(program + " scenes >/dev/full"), 1);
  const std::string drawing = program + " draw cycle --size 80x60 -o '" + file("a.png") + "'";
  EXPECT_EQ(shell(drawing + " --stats >/dev/full"), 1);
  EXPECT_EQ(shell(drawing + " --stats >&-"), 1);
  EXPECT_EQ(shell(drawing + " >&- 2>&- <&-"), 0);  // it says nothing, so nothing is lost
  EXPECT_EQ(readPng(file("a.png")).width, 80);
  // The reader closes its end of the pipe, and then lets the program begin.
  ASSERT_EQ(mkfifo(file("begin").c_str(), 0600), 0);
  EXPECT_EQ(shell("{ read go <'" + file("begin") + "'; " + drawing + " --stats; echo $? >'" + file("status") +
                  "'; } | { exec <&-; echo go >'" + file("begin") + "'; }"),
            0);
  EXPECT_EQ(contents(file("status")), "141\n");  // SIGPIPE, as everywhere
}

// --help prints to standard output, wherever it stands among the words. It gives the defaults, and promises
// nothing that is not built.
TEST_F(CommandTest, HelpTellsWhatThereIs) {
  const Finished help = runProgram({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  for (const CommandRow& row : kCommands) EXPECT_NE(help.out.find(row.usage), std::string::npos);
  for (const std::string expected :
       {"[800x600, a window 1024x768 times --scale, extremes 160x120]", "[flat]", "[newell]", "[linear]",
        "[240]", "[0.02]", "[30]", "[1,0,0]", "[8]", "[teapot, in a window only]"})
    EXPECT_NE(help.out.find(expected), std::string::npos) << expected;
  for (const Strings& words :
       {Strings{"-h"}, Strings{"draw", "--help"}, Strings{"draw", "nosuch", "-h"}, Strings{"view", "-h"},
        Strings{"visuals", "--help"}, Strings{"draw", "teapot", "-o", file("x.png"), "--help"}}) {
    const Finished same = runProgram(words);
    EXPECT_EQ(same.status, 0);
    EXPECT_EQ(same.out, help.out);
  }
  EXPECT_EQ(everything().size(), 1u);
}

// `scenes` has a line for every built-in scene and for every lesson. Each scene can be drawn.
TEST_F(CommandTest, ScenesListsTheBuiltInOnes) {
  const std::string list = runProgram({"scenes"}).out;
  const std::vector<LessonEntry> lessons = builtInLessons();
  const std::vector<BuiltInScene> scenes = builtInScenes();
  const std::vector<LectureEntry> lectures = builtInLectures();
  EXPECT_EQ(std::ranges::count(list, '\n'), std::ssize(scenes) + std::ssize(lessons) + std::ssize(lectures));
  for (const LectureEntry& lecture : lectures)
    EXPECT_NE(list.find("lecture " + lecture.name + ' '), std::string::npos);
  for (const LessonEntry& lesson : lessons)
    EXPECT_NE(list.find("lesson " + lesson.name + ' '), std::string::npos);
  for (const BuiltInScene& scene : scenes) EXPECT_NE(list.find(scene.shows), std::string::npos);
  for (const BuiltInScene& scene : someOf(scenes, 6))
    EXPECT_GT(draw(std::string{scene.name}).stats["fragments"], 0);
}

// A built-in name wins over a file of that name; a path always means the file. Odd file names work.
TEST_F(CommandTest, NamesOfScenes) {
  const std::filesystem::path before = std::filesystem::current_path();
  write("teapot", kTriangleObj);
  for (const std::string name : {"teapot.obj", "-dash.obj", "with blank.obj", "\xC3\xBC\xE6\x97\xA5.obj",
                                 "q'\"$.obj", "new\nline.obj", "\xFF.obj"})
    write(name, kTriangleObj);
  std::filesystem::current_path(std::filesystem::path{file(".")});
  const auto facesOf = [&](const Strings& words) {
    const Finished end = runProgram(Strings{"draw", "--stats", "--size", "8x6", "-o", "-o.png"} + words);
    EXPECT_EQ(end.err, "");
    return end.status == 0 ? Json::parse(end.out)["faces"].get<int>() : -1;
  };
  EXPECT_EQ(facesOf({"teapot"}), 32 * 8 * 8);
  EXPECT_EQ(facesOf({"--", "teapot"}), 32 * 8 * 8);
  for (const std::string name : {"./teapot.obj", "teapot.obj", "./-dash.obj", "with blank.obj",
                                 "\xC3\xBC\xE6\x97\xA5.obj", "q'\"$.obj", "new\nline.obj"})
    EXPECT_EQ(facesOf({name}), 1) << name;
  EXPECT_EQ(facesOf({"--", "-dash.obj"}), 1);
  EXPECT_TRUE(std::filesystem::exists("-o.png"));
  // A name need not be UTF-8. Only the statistics cannot hold such bytes.
  const Finished bytes = runProgram({"draw", "\xFF.obj", "-o", "bytes.png", "--stats"});
  EXPECT_EQ(bytes.status, 0) << bytes.err;
  EXPECT_EQ(Json::parse(bytes.out)["scene"], "\xEF\xBF\xBD.obj");
  std::filesystem::current_path(before);
}

// --stats prints one object with everything that is promised, and its times add up.
TEST_F(CommandTest, StatsHoldWhatIsPromised) {
  const Json stats = draw("teapot").stats;
  for (const char* key : {"polygons", "culled", "fragments", "splits", "cycles", "saturated"})
    EXPECT_TRUE(stats.at(key).is_number_integer()) << key;
  EXPECT_TRUE(stats.at("tests").is_object());
  double sum = 0;
  for (const char* key : {"read", "shade", "transform", "sort", "fill", "present"})
    sum += stats.at("ms").at(key).get<double>();
  EXPECT_GT(sum, 0);
  EXPECT_NEAR(stats.at("ms").at("total").get<double>(), sum, 1e-6);
  EXPECT_EQ(stats["polygons"], stats["in_view"].get<int>() + stats["degenerate"].get<int>() +
                                   stats["culled"].get<int>() + stats["outside"].get<int>());
}

// What is painted is counted in one way. The trace of the same run tells of each polygon and piece that it
// paints, in a line of its own; there are as many lines. A scene that is divided into areas is not traced.
TEST_F(CommandTest, PaintedIsWhatTheTracePaints) {
  for (const char* scene : {"teapot", "cycle", "penetrate", "pinwheels", "slivers"}) {
    SCOPED_TRACE(scene);
    const Json stats = draw(scene, {"--size", "320x240"}).stats;
    if (stats["areas"] != 0) continue;
    std::istringstream trace{runProgram({"trace", scene, "--quick", "--size", "320x240"}).out};
    int painted = 0;
    for (std::string line; std::getline(trace, line);) painted += Json::parse(line)["event"] == "paint";
    EXPECT_EQ(stats["painted"], painted);
    EXPECT_EQ(stats["fragments"], painted);
    EXPECT_LE(painted, stats["in_view"].get<int>() + stats["splits"].get<int>());
  }
}

// The statistics have what each way to decide costs: a tree its nodes, a z-buffer its tests and its memory.
TEST_F(CommandTest, StatsHoldTheCostOfTheOrder) {
  const Json newell = draw("cubes").stats, tree = draw("cubes", {"--order", "bsp"}).stats;
  EXPECT_EQ(newell["tree_nodes"], 0);
  EXPECT_GT(newell["planes_made"], 10);
  EXPECT_LT(newell["planes_made"], tree["planes_made"]);
  EXPECT_EQ(tree["splits"], 0);
  EXPECT_GT(tree["tree_nodes"], 10);
  EXPECT_LE(tree["tree_nodes"], tree["polygons"]);
  EXPECT_GT(tree["tree_depth"], 1);
  EXPECT_GT(tree["order_bytes"], newell["order_bytes"]);
  for (const int bits : {16, 24, 32}) {
    const Json buffer = draw("cubes", {"--order", "zbuffer" + std::to_string(bits)}).stats;
    const int samples = buffer["size"][0].get<int>() * buffer["size"][1].get<int>();
    EXPECT_EQ(buffer["order_bytes"], samples * (bits == 16 ? 2 : 4));
    EXPECT_GT(buffer["depth_tests"], 10'000);
    EXPECT_EQ(buffer["painted"], 0);
    EXPECT_EQ(buffer["tree_nodes"], 0);
  }
}

// --errors adds the errors to the statistics. With L and V constant they are found, and the worst places say
// what is wrong there.
TEST_F(CommandTest, ErrorsAreInTheStatistics) {
  EXPECT_FALSE(draw("lamp").stats.contains("errors"));
  const Json exact = draw("lamp", {"--errors"}).stats.at("errors");
  const Json constant = draw("lamp", {"--errors", "--constant-l", "--constant-v"}).stats.at("errors");
  EXPECT_EQ(exact["samples"], constant["samples"]);
  EXPECT_EQ(constant["wrong_faces"], 0);
  for (const char* key : {"mean", "rms", "p99", "largest"}) {
    EXPECT_LT(exact["intensity"]["before_table"].at(key).get<double>(), 1e-6);
    EXPECT_LT(exact["intensity"]["after_table"].at(key).get<double>(), 0.51 / 239);
    EXPECT_GT(constant["intensity"]["before_table"].at(key).get<double>(), 0.1);
    EXPECT_GT(constant["ciede2000"].at(key).get<double>(), 5);
  }
  ASSERT_EQ(constant["worst"].size(), 10u);
  for (const Json& place : constant["worst"]) {
    EXPECT_NEAR(place.at("error").get<double>(),
                std::abs(place["shows"][0].get<double>() - place["should"][0].get<double>()), 1e-6);
    EXPECT_EQ(place["shows_face"], place["should_face"]);
  }
  EXPECT_EQ(constant["worst"][0]["error"], constant["intensity"]["after_table"]["largest"]);
  EXPECT_LT(constant["distance_to_patches"]["largest"].get<double>(), 1e-12);  // the floor is flat
  EXPECT_TRUE(constant["blocks_8x8"].is_null());
  EXPECT_GT(draw("teapot", {"--errors"}).stats["errors"]["distance_to_patches"]["largest"].get<double>(),
            0.01);
  EXPECT_FALSE(
      draw("hues", {"--errors", "--dither", "--colors", "cube"}).stats["errors"]["blocks_8x8"].is_null());
}

// --costs adds what each required item costs, and says nothing of the others. The highlights of a large Phong
// picture cost more than nothing and less than all light.
TEST_F(CommandTest, CostsAreInTheStatistics) {
  const std::vector<std::string> heavy{"--shade", "phong", "--size", "800x600", "--n", "511"};
  EXPECT_FALSE(draw("highlight", heavy).stats.contains("required_cost_ms"));
  std::vector<std::string> asked = heavy;
  asked.emplace_back("--costs");
  const Json stats = draw("highlight", asked).stats;
  const Json &costs = stats.at("required_cost_ms"), &required = stats.at("required");
  for (const auto& [name, what] : required.items()) {
    const int least = name == "channels" || name == "ramps" ? 1 : 0;
    EXPECT_EQ(costs.contains(name), what.is_boolean() ? what.get<bool>() : what.get<int>() > least) << name;
  }
  EXPECT_EQ(costs.contains("attenuation"), false);
  // A step that is done alone takes some time. What is a difference of times may be lost in chance.
  EXPECT_GT(costs.at("vertex_normals").get<double>(), 0.0);
}

// The same command writes the same bytes twice.
TEST_F(CommandTest, IsDeterministic) {
  for (const std::string scene : {"teapot", "cycle"}) {
    const Drawn a = draw(scene), b = draw(scene);
    EXPECT_EQ(a.png, b.png);
    EXPECT_EQ(a.ids.rgb, b.ids.rgb);
  }
}

// A sort that makes too many pieces ends with one line that says what to do.
TEST_F(CommandTest, SortsMakeAtMostSoManyFragments) {
  const std::string advice =
      " pieces, for the polygons cross too often; --max-fragments allows more, and --order oracle needs none";
  refused({"draw", "crossing-sheets", "-o", file("new.png"), "--max-fragments", "10"}, 1,
          "the depth sort needs more than 10" + advice);
  refused({"trace", "crossing-sheets", "--max-fragments", "20"}, 1,
          "the depth sort needs more than 20" + advice);
  refused({"draw", "crossing-sheets", "-o", file("new.png"), "--order", "bsp", "--max-fragments", "10"}, 1,
          "the BSP tree needs more than 10" + advice);
  refused({"draw", "teapot", "-o", file("new.png"), "--max-fragments", "0"}, 2,
          "--max-fragments: '0' is not a whole number from 1 to 1000000000");
  EXPECT_EQ(runProgram({"draw", "crossing-sheets", "-o", file("new.png"), "--max-fragments", "200"}).status,
            0);
}

}  // namespace xnewell::THIS_FILE
