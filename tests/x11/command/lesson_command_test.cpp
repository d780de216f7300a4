#include <gtest/gtest.h>

#include "tests/x11/support/command_fixture.h"
#include "x11/lessons/lesson.h"

namespace xnewell::THIS_FILE {

// `xnewell lesson` as a user meets it.

namespace {

class LessonCommand : public CommandTest {};

}  // namespace

// `xnewell lesson` writes a numbered picture of the whole window for each step, without any X server.
TEST_F(LessonCommand, FramesOfEveryLesson) {
  for (const LessonEntry& entry : builtInLessons()) {
    SCOPED_TRACE(entry.name);
    const std::string folder = file("deep/" + entry.name);
    const Finished end = runProgram({"lesson", entry.name, "--frames", folder, "--size", "800x600"});
    ASSERT_EQ(end.status, 0) << end.err;
    EXPECT_EQ(end.out + end.err, "");
    const std::vector<std::string> names = filesIn(folder);
    ASSERT_EQ(names.size(), readLesson(entry.file).steps.size());
    EXPECT_EQ(names.front(), "0001-step.png");
    std::string before;
    for (const std::string& name : names) {
      const std::string bytes = contents(folder + "/" + name);
      EXPECT_NE(bytes, before);
      const RgbImage image = readPng(folder + "/" + name);
      EXPECT_EQ(image.width, 800);
      EXPECT_EQ(image.height, 600);
      before = bytes;
    }
  }
}

TEST_F(LessonCommand, FramesAreAsLargeAsTheWindowIsAtFirst) {
  ASSERT_EQ(runProgram({"lesson", "cycles", "--frames", file("f")}).status, 0);
  EXPECT_EQ(readPng(file("f/0001-step.png")).width, 1024);
  EXPECT_EQ(readPng(file("f/0006-step.png")).height, 768);
}

// A lesson file of the user's own works. Its scenes are looked for in its folder.
TEST_F(LessonCommand, AFileIsALesson) {
  write("bare.obj", kTriangleObj);
  write(
      "own.json",
      R"({"title": "own", "steps": [{"heading": "One", "caption": ["It has {polygons} polygon."], "scene": "bare.obj"}]})");
  const Finished end = runProgram({"lesson", file("own.json"), "--frames", file("f")});
  EXPECT_EQ(end.err, "");
  EXPECT_EQ(filesIn(file("f")).size(), 1U);
}

TEST_F(LessonCommand, Refusals) {
  const std::string folder = file("frames");
  refused({"lesson", "nosuch", "--frames", folder}, 2,
          "there is no lesson 'nosuch'; `xnewell scenes` lists the lessons");
  refused({"lesson", "nosuch"}, 2, "there is no lesson 'nosuch'; `xnewell scenes` lists the lessons");
  refused({"lesson", "--frames", folder}, 2, "--frames needs a lesson's name");
  refused({"lesson", "cycles", "--frames", folder, "--shade", "flat"}, 2,
          "--shade does not work with lesson: the lesson decides how its steps are drawn");
  refused({"lesson", "cycles", "--frames", folder, "--size", "799x600"}, 2,
          "a lesson needs a --size of at least 800x540");
  refused({"lesson", "cycles", "--frames", folder, "--visual", "GrayScale8"}, 2,
          "--visual needs a server, and lesson --frames uses none");
  refused({"lesson", "cycles", "-o", file("new.png")}, 2,
          "-o works only with draw, snapshot, trade and extremes");
  refused({"lesson", "cycles", "--frames", file("old.png")}, 1, file("old.png") + ": Not a directory");
  const std::string bad = write("bad.json", R"({"title": "t", "steps": [{"heading": "h"}]})");
  refused({"lesson", bad, "--frames", folder}, 2, bad + ": steps[0]: caption is needed");
}

TEST_F(LessonCommand, FramesOfAnEarlierRunStay) {
  ASSERT_EQ(runProgram({"lesson", "cycles", "--frames", file("f")}).status, 0);
  const std::string before = contents(file("f/0002-step.png"));
  const Finished again = runProgram({"lesson", "specular", "--frames", file("f")});
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.err.find("already holds frames"), std::string::npos) << again.err;
  EXPECT_EQ(contents(file("f/0002-step.png")), before);
}

TEST_F(LessonCommand, AnInterruptLeavesWholeFrames) {
  interruptsLeaveWholeFrames({"lesson", "specular", "--size", "2000x1500"}, 2000);
}

}  // namespace xnewell::THIS_FILE
