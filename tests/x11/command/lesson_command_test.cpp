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

}  // namespace xnewell::THIS_FILE
