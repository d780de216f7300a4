#include "x11/homework/judge_run.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "shading/picture/picture_cache.h"
#include "tests/support/student_sort.h"
#include "tests/support/student_world.h"
#include "tests/support/temporary_folder.h"
#include "x11/command/commands.h"

namespace xnewell::THIS_FILE {

namespace {

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

}  // namespace xnewell::THIS_FILE
