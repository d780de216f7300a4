#include "x11/homework/judge_run.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <random>

#include "shading/picture/picture_cache.h"
#include "tests/support/student_sort.h"
#include "tests/support/student_world.h"
#include "tests/x11/support/command_fixture.h"
#include "tests/x11/support/x_server.h"
#include "x11/command/commands.h"

namespace xnewell::THIS_FILE {

namespace {

const std::string kExample = XNEWELL_DATA_DIR "/../x11/example/";
const std::vector<std::string> kScenes{"cycle", "nested-cycles", "penetrate",
                                       "bench", "two-cards",     "crossing-sheets"};

Picture pictureOf(const std::string& name) {
  Scene scene = readScene(name);
  PictureSettings settings = scene.settings;
  settings.camera = scene.camera, settings.width = 400, settings.height = 300,
  settings.order = Order::Unsorted;
  return makePicture(std::move(scene), settings).withPlanes();
}

std::string toldOf(const RunReport& report) { return page::asText(pageOf(report)); }

}  // namespace

// Another program's runs are right, whatever it chooses among what is legal.
TEST(JudgeRun, LegalChoicesAreRight) {
  const TemporaryFolder folder;
  int ended = 0;
  for (const std::string& name : kScenes) {
    const Picture picture = pictureOf(name);
    const student::World world = studentsWorld(picture);
    const unsigned seeds = picture.snapped().faces.size() > 50 ? 8 : 120;
    for (unsigned seed = 0; seed < seeds; ++seed) {
      const std::string file = folder.file("run.jsonl");
      const student::Sorted run = student::writeRun(world, 400, 300, file.c_str(), seed);
      if (!run.ended) continue;
      ++ended;
      const RunReport report = judgeRun(picture, RunFile{file});
      ASSERT_TRUE(report.wrong.empty()) << name << ' ' << seed << ": " << toldOf(report);
      ASSERT_EQ(report.untested, 0) << name << ' ' << seed;
    }
  }
  EXPECT_GE(ended, 400);
}

// Each planted mistake is told by its kind and its line, wherever it is done, and nothing is told before it.
TEST(JudgeRun, FirstFalseStepsAreNamed) {
  const TemporaryFolder folder;
  std::map<std::string_view, std::pair<int, int>> named;  // done, and named
  std::string missed;
  for (const std::string& name : kScenes) {
    const Picture picture = pictureOf(name);
    const student::World world = studentsWorld(picture);
    for (const student::Fault& fault : student::kFaults) {
      const std::string file = folder.file("run.jsonl");
      const student::Sorted run = student::writeRun(world, 400, 300, file.c_str(), 1, fault.name);
      const RunReport report = judgeRun(picture, RunFile{file});
      const std::string of =
          name + ", " + std::string{fault.name} + ", line " + std::to_string(run.line) + ": ";
      if (!run.done) {
        EXPECT_TRUE(report.wrong.empty() || !run.ended) << of << toldOf(report);
        continue;
      }
      auto& [done, told] = named[fault.name];
      ++done;
      if (!report.wrong.empty() && report.wrong[0].line == run.line &&
          kFalsehoods[static_cast<std::size_t>(report.wrong[0].kind)] == fault.kind)
        ++told;
      else
        missed += of + toldOf(report);
    }
  }
  int done = 0, told = 0;
  for (const auto& [fault, counts] : named) done += counts.first, told += counts.second;
  EXPECT_GE(told, 0.95 * done) << missed;
  EXPECT_EQ(named.size(), student::kFaults.size());
}

// What trace writes is a right run, in every scene: the textbook's where it is short, and the
// quick one.
TEST(JudgeRun, OwnRunsAreRight) {
  const TemporaryFolder folder;
  for (const BuiltInScene& scene : builtInScenes())
    for (const bool textbook : {true, false}) {
      const Picture picture = pictureOf(scene.name);
      if (textbook && picture.snapped().faces.size() > 400) continue;
      Options options;
      options.quick = !textbook, options.scene = scene.name;
      std::ofstream out{folder.file("run.jsonl")};
      printTrace(options, picture, recordedRun(options, picture), out);
      out.close();
      const RunReport report = judgeRun(picture, RunFile{folder.file("run.jsonl")});
      EXPECT_TRUE(report.wrong.empty()) << scene.name << ' ' << textbook << ": " << toldOf(report);
      EXPECT_EQ(report.untested, 0) << scene.name << ' ' << textbook;
    }
}

// The program that students begin with compiles, and its picture and its order are right. With the 2 taken
// out of R, its picture tells so.
TEST_F(CommandTest, StudentsProgramIsRightAndItsMistakesAreNamed) {
  const XServer server = XServer::xvfb(24);
  const std::string source = contents(kExample + "student.cpp");
  const auto drawn = [&](const std::string& text, const std::string& name) {
    std::ofstream{file(name + ".cpp")} << text;
    const std::string compiled = file(name), run = "DISPLAY=" + server.name() + " " + compiled + " " +
                                                   kExample + "house.obj " + file(name + ".ppm") + " " +
                                                   file(name + ".jsonl") + " " + file(name + ".run");
    std::ofstream{file("xnewell_run.h")} << runProgram({"run-header"}).out;
    EXPECT_EQ(std::system((std::string{XNEWELL_CXX} + " -std=c++20 " + file(name + ".cpp") + " -o " +
                           compiled + " -lX11")
                              .c_str()),
              0);
    EXPECT_EQ(std::system(run.c_str()), 0);
  };
  const Strings house{kExample + "house.obj",  "--eye", "4,3,6", "--look-at", "0,0.4,0",
                      "--light=-0.5,0.6,-0.4", "--n",   "4"};
  drawn(source, "right");
  auto said = runProgram(Strings{"diagnose"} + house + Strings{file("right.ppm")});
  EXPECT_TRUE(said.out.starts_with("right\n  this picture would be the same with ")) << said.out << said.err;
  said = runProgram(Strings{"judge"} + house + Strings{file("right.jsonl"), "--size", "640x480"});
  EXPECT_TRUE(said.out.starts_with("right: 9 steps")) << said.out << said.err;

  said = runProgram(Strings{"judge"} + house + Strings{"--run", file("right.run")});
  EXPECT_TRUE(said.out.starts_with("right: 18 steps")) << said.out << said.err;

  std::string wrong = source;
  const std::string R = "2.0 * NL * N - L";
  ASSERT_NE(wrong.find(R), std::string::npos);
  wrong.replace(wrong.find(R), R.size(), "NL * N - L");
  drawn(wrong, "wrong");
  said = runProgram(Strings{"diagnose"} + house + Strings{file("wrong.ppm")});
  EXPECT_TRUE(said.out.starts_with("wrong: R-without-2: ")) << said.out << said.err;
}

}  // namespace xnewell::THIS_FILE
