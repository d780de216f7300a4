#include "x11/lessons/lesson_view.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "geometry/files/parse_error.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/lesson_window.h"

namespace xnewell::THIS_FILE {

namespace {

nlohmann::json read(const std::string& file) {
  std::ifstream in{file};
  return nlohmann::json::parse(in);
}

std::string contents(const std::string& file) {
  std::ifstream in{file};
  return {std::istreambuf_iterator<char>{in}, {}};
}

}  // namespace

// Each answer of a student is in the file at once, in its order in time. A right answer is confirmed. What an
// earlier session has kept stays, and counts in the score.
TEST(KeptAnswers, AreWhatTheStudentGave) {
  const TemporaryFolder folder;
  const std::string file = folder.file("answers.json");
  {
    LessonWindow window;
    begin(window, "cycles");
    window.bench.keepAnswers(file);
    window.bench.goTo(2);
    window.draw();
    EXPECT_FALSE(std::filesystem::exists(file));
    window.press('b');
    window.press(NamedKey::Return);
    window.draw();
    EXPECT_FALSE(window.bench.page().question->right);
    EXPECT_NE(window.bench.layout().after.front().text.find("B was painted"), std::string::npos);
    EXPECT_EQ(read(file),
              nlohmann::json::parse(
                  R"({"answers": [{"lesson": "cycles", "step": 3, "tries": ["b"], "right": "d"}]})"));
    window.press('d');
    window.press(NamedKey::Return);
    window.draw();
    EXPECT_TRUE(window.bench.page().question->right);
    EXPECT_EQ(window.bench.layout().after.front().text.find("Right. "), 0u);
    EXPECT_EQ(read(file)["answers"][0]["tries"], (nlohmann::json{"b", "d"}));
  }
  KeptAnswers later;
  later.keepIn(file);
  EXPECT_EQ(later.score("cycles"), "0 of 1 right at the first try");
  EXPECT_EQ(later.score("five-tests"), "");
  const Lesson lesson = readLesson(std::string{XNEWELL_DATA_DIR} + "/lessons/cycles.json");
  later.add(lesson, 5, 2);
  EXPECT_EQ(later.score("cycles"), "1 of 2 right at the first try");
  const nlohmann::json both = read(file);
  EXPECT_EQ(both["answers"].size(), 2u);
  EXPECT_EQ(both["answers"][1],
            nlohmann::json::parse(R"({"lesson": "cycles", "step": 6, "tries": ["c"], "right": "c"})"));
}

// Without a file of their own, answers are kept where programs keep their state. Nothing is made there before
// the first answer, and two windows keep both their answers.
TEST(KeptAnswers, HaveAUsualPlace) {
  const TemporaryFolder folder;
  const auto placeWith = [](const char* state, const char* home) {
    state ? setenv("XDG_STATE_HOME", state, 1) : unsetenv("XDG_STATE_HOME");
    home ? setenv("HOME", home, 1) : unsetenv("HOME");
    return KeptAnswers::usualFile();
  };
  const char* const home = std::getenv("HOME");
  const std::string before = home ? home : "", file = placeWith(folder.file("s").c_str(), "/h");
  EXPECT_EQ(file, folder.file("s") + "/xnewell/answers.json");
  EXPECT_EQ(placeWith("relative", "/h"), "/h/.local/state/xnewell/answers.json");
  EXPECT_EQ(placeWith(nullptr, nullptr), "");
  static_cast<void>(placeWith(nullptr, home ? before.c_str() : nullptr));

  const Lesson lesson = readLesson(std::string{XNEWELL_DATA_DIR} + "/lessons/cycles.json");
  KeptAnswers one, other;
  one.keepIn(file), other.keepIn(file);
  EXPECT_FALSE(std::filesystem::exists(folder.file("s")));
  one.add(lesson, 2, 3);
  other.add(lesson, 5, 1);
  EXPECT_EQ(other.score("cycles"), "1 of 2 right at the first try");
  EXPECT_EQ(read(file)["answers"].size(), 2u);
}

// A file that holds anything else is refused with its place, and stays as it is.
TEST(KeptAnswers, RefuseOtherFiles) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.json");
  const std::pair<const char*, const char*> kRows[]{
      {"[]", "an object { } is needed"},
      {"{}", "answers is needed"},
      {R"({"answers": [{"lesson": "cycles"}]})", "answers[0]: step is needed"},
      {R"({"answers": [{"lesson": "cycles", "step": 13, "tries": ["a"], "right": "a"}]})",
       "answers[0].step: a whole number from 1 to 12 is needed"},
      {R"({"answers": [{"lesson": "cycles", "step": 1, "tries": [], "right": "a"}]})",
       "answers[0].tries: an answer is needed"},
      {R"({"answers": [{"lesson": "cycles", "step": 1, "tries": ["e"], "right": "a"}]})",
       "answers[0].tries[0]: a letter from a to d is needed"},
  };
  for (const auto& [text, what] : kRows) {
    std::ofstream{file} << text;
    KeptAnswers answers;
    try {
      answers.keepIn(file);
      ADD_FAILURE() << text;
    } catch (const ParseError& e) {
      EXPECT_NE(std::string{e.what()}.find(what), std::string::npos) << e.what();
    }
    EXPECT_EQ(contents(file), text);
  }
}

}  // namespace xnewell::THIS_FILE
