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

// Claims of one's own lesson that do not hold are told, each with its place; the lesson is shown all the
// same.
TEST_F(LessonCommand, ClaimsOfAnOwnLessonAreChecked) {
  write("bare.obj", kTriangleObj);
  const std::string own = write("own.json", R"({"title": "own", "steps": [
    {"heading": "One", "caption": ["It has {polygons} polygon."], "scene": "bare.obj", "claims": {"polygons": 1},
     "question": {"asks": "How many?", "answers": [
       {"text": "one", "holds": true, "says": "Yes."},
       {"text": "two", "says": "No.", "shown": {"claims": {"polygons": 2}}}]}},
    {"heading": "Two", "caption": ["No cut."], "claims": {"cuts": 0, "n": 7}}]})");
  const Finished end = runProgram({"lesson", own, "--frames", file("f")});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.err, "xnewell: " + own +
                         ": step 1, answer b: polygons is 1, which is not what the lesson claims\nxnewell: " +
                         own + ": step 2: n is 20, which is not what the lesson claims\n");
  EXPECT_EQ(filesIn(file("f")).size(), 2U);
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
  refused({"lesson", "cycles", "--step", "9"}, 2, "--step: the lesson has 6 steps");
  refused({"lesson", "cycles", "--step", "0"}, 2, "--step: the steps of a lesson count from 1");
  refused({"lesson", "--worksheet", folder}, 2, "--worksheet needs a lesson's name");
  refused({"lesson", "cycles", "--worksheet", file("no/w.html")}, 1,
          file("no/w.html") + ": No such file or directory");
  refused({"lesson", "cycles", "--worksheet", folder, "--answers", folder}, 2,
          "--worksheet and --answers exclude each other");
  refused({"lesson", "cycles", "-o", file("new.png")}, 2,
          "-o works only with draw, snapshot, figure, trade, extremes, diagnose, judge and grade");
  refused({"lesson", "cycles", "--frames", file("old.png")}, 1, file("old.png") + ": Not a directory");
  const std::string bad = write("bad.json", R"({"title": "t", "steps": [{"heading": "h"}]})");
  refused({"lesson", bad, "--frames", folder}, 2, bad + ": steps[0]: caption is needed");
}

// The longest part of `text` that stands as it is in HTML, with no placeholder in it.
std::string longestPlain(const std::string& text) {
  std::string longest;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("{<>&\"'", at), text.size());
    if (end - at > longest.size()) longest = text.substr(at, end - at);
    at = end < text.size() && text[end] == '{' ? text.find('}', end) + 1 : end + 1;
  }
  return longest;
}

// `--worksheet` writes one HTML file without any X server: a picture for each step, each question with all
// its answers and room to write, and the right letter of each only after the last step.
TEST_F(LessonCommand, AWorksheetAsksAndSolves) {
  for (const LessonEntry& entry : builtInLessons()) {
    SCOPED_TRACE(entry.name);
    const std::string sheet = file("sheet.html");
    const Finished end = runProgram({"lesson", entry.name, "--worksheet", sheet});
    ASSERT_EQ(end.status, 0) << end.err;
    const std::string html = contents(sheet);
    const auto count = [&](const std::string& what) {
      std::size_t n = 0;
      for (std::size_t at = html.find(what); at != std::string::npos; at = html.find(what, at + 1)) ++n;
      return n;
    };
    const Lesson lesson = readLesson(entry.file);
    const std::size_t questions =
        std::ranges::count_if(lesson.steps, [](const auto& s) { return s.question.has_value(); });
    EXPECT_EQ(count("src=\"data:image/png;base64,iVBORw0KGgo"), lesson.steps.size());
    EXPECT_EQ(count("class=\"room\""), questions);
    EXPECT_EQ(count("<code>xnewell lesson " + entry.name + " --step "),
              std::ranges::count_if(lesson.steps, [](const auto& s) { return !s.controls.empty(); }));
    const std::size_t solutions = html.find("<h2>Solutions</h2>");
    for (const LessonStep& step : lesson.steps) {
      if (!step.question) continue;
      const auto right = std::ranges::find(step.question->answers, true, &LessonAnswer::holds);
      const std::string letter{static_cast<char>('a' + (right - step.question->answers.begin()))};
      EXPECT_NE(html.find("<li>" + letter + ": ", solutions), std::string::npos);
    }
    for (const LessonStep& step : lesson.steps)  // an explanation stands among the solutions only
      for (const auto& answer : step.question ? step.question->answers : std::vector<LessonAnswer>{})
        if (const std::string words = longestPlain(answer.says); words.size() > 20) {
          EXPECT_GE(html.find(words), solutions) << words;
        }
    for (const std::string name : {"section", "ol", "p", "html", "li", "h2"})
      EXPECT_EQ(count('<' + name + '>') + count('<' + name + ' '), count("</" + name + '>')) << name;
    EXPECT_EQ(html.find('{'), html.find("{ font"));  // no placeholder is left, only the style
    EXPECT_EQ(html.find('{', html.find("</style>")), std::string::npos);
  }
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
