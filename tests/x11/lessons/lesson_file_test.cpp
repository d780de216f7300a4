#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "tests/support/reader_fixture.h"
#include "x11/lessons/lesson.h"
#include "x11/lessons/lesson_facts.h"

namespace xnewell::THIS_FILE {

// Lesson files: all of ours can be read, every key does what it says, and each mistake is named with its
// place.

namespace {

Lesson parsed(const std::string& text) {
  return parseLesson(text, "l.json", std::filesystem::path{XNEWELL_DATA_DIR} / "lessons");
}

/// A lesson of one step, with `more` among its keys.
std::string withStep(const std::string& more, const std::string& scene = "sticks") {
  return R"({"title": "t", "steps": [{"heading": "h", "caption": ["c"], "scene": ")" + scene + "\"" +
         (more.empty() ? "" : ", ") + more + "}]}";
}

std::string complaintOf(const std::string& text) {
  return complaint([&] { return parsed(text); });
}

StepFigure figureOf(const std::string& more, const std::string& scene = "sticks") {
  return parsed(withStep(more, scene)).steps[0].figure;
}

}  // namespace

TEST(LessonFile, AllThatAreBuiltInCanBeRead) {
  const std::vector<LessonEntry> entries = builtInLessons();
  ASSERT_GE(entries.size(), 9U);
  int steps = 0, questions = 0;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    SCOPED_TRACE(entries[k].name);
    const Lesson lesson = readLesson(entries[k].file);
    EXPECT_EQ(lesson.name, entries[k].name);
    EXPECT_EQ(lesson.number, static_cast<int>(k) + 1);
    EXPECT_FALSE(lesson.shows.empty());
    EXPECT_GE(lesson.steps.size(), 4U);
    EXPECT_LE(lesson.steps.size(), 8U);
    steps += static_cast<int>(lesson.steps.size());
    for (const LessonStep& step : lesson.steps) questions += step.question.has_value();
  }
  EXPECT_GE(steps, 40);
  EXPECT_GE(questions, 15);
}

// The words follow the house style: no exclamation marks and no American spelling.
TEST(LessonFile, WordsAreInTheHouseStyle) {
  const std::regex american{"\\b(color|gray-|center|behavior|brighten up)\\b", std::regex::icase};
  int words = 0;
  const auto check = [&](const std::string& text) {
    EXPECT_EQ(text.find('!'), std::string::npos) << text;
    EXPECT_FALSE(std::regex_search(text, american)) << text;
    ++words;
  };
  for (const LessonEntry& entry : builtInLessons())
    for (const LessonStep& step : readLesson(entry.file).steps) {
      check(step.heading);
      for (const std::string& paragraph : step.caption) check(paragraph);
      if (!step.question) continue;
      check(step.question->asks);
      check(step.question->hint);
      for (const LessonAnswer& answer : step.question->answers) check(answer.text), check(answer.says);
    }
  EXPECT_GT(words, 200);
}

TEST(LessonFile, EveryKeyOfAFigureWorks) {
  EXPECT_EQ(figureOf("").stage, View::Picture);
  for (const StageRow& row : stageRows())
    if (row.id != View::SideBySide) {
      EXPECT_EQ(figureOf("\"window\": \"" + std::string{row.name} + "\"").stage, row.id);
    }
  EXPECT_EQ(figureOf(R"("shading": {"method": "phong", "n": 7})").settings.light.n, 7);
  EXPECT_EQ(figureOf(R"("shading": {"order": "zmean", "table": {"shades": 9}})").settings.table.shades, 9);
  EXPECT_EQ(figureOf(R"("camera": {"parallel": 4})").settings.camera.height.has_value(), true);
  EXPECT_NE(figureOf(R"("camera": {"eye": [1, 2, 9]})").settings.camera, figureOf("").settings.camera);
  EXPECT_EQ(figureOf(R"("line": "l")").line, "l");
  EXPECT_TRUE(figureOf(R"("names": {"A": 0}, "extents": true)").extents);
  EXPECT_TRUE(figureOf(R"("wrong": true)").wrongMarked);
  EXPECT_EQ(figureOf(R"("divisions": 3)", "teapot").scene->divisions, 3);

  const StepFigure named = figureOf(R"("names": {"A": 0, "C": 2}, "listed": [2, 0, 1])");
  ASSERT_EQ(named.names.size(), 2U);
  EXPECT_EQ(named.names[0].face, 1);  // names follow their faces
  EXPECT_EQ(named.names[1].face, 0);
  EXPECT_EQ(named.scene->mesh.groupNames[static_cast<std::size_t>(named.scene->mesh.group[0])], "C");

  const StepFigure sides = figureOf(
      R"("window": "side by side", "beside": {"shading": {"method": "gouraud"}, "upper": "u", "lower": "o"})");
  EXPECT_EQ(sides.beside.shading, Shading::Gouraud);
  EXPECT_EQ(sides.settings.shading, Shading::Flat);
  EXPECT_EQ(sides.upperLine + sides.lowerLine, "uo");

  const PaletteEffects effects =
      figureOf(
          R"("effects": {"stored": "brief", "hue turn": 90, "gamma": 2, "rotate": 5, "lit": 40, "bend": [100, 7]})")
          .effects;
  EXPECT_EQ(effects, (PaletteEffects{TableKind::Brief, 90, 2, CurvePoint{100, 7}, 5, 40}));

  const EventChoice cut = figureOf(R"("event": {"kind": "cut", "number": 2, "says": "split"})").event;
  EXPECT_EQ(cut.kind, Event::Kind::Split);
  EXPECT_EQ(cut.number, 2);
  EXPECT_EQ(cut.says, "split");
  EXPECT_EQ(figureOf(R"("event": {"test": "3'"})").event.test, xnewell::Test::QBehindP);

  const std::vector<Claim> claims =
      figureOf(R"("claims": {"cuts": 3, "samples": {"at least": 1, "at most": 2}})").claims;
  ASSERT_EQ(claims.size(), 2U);
  EXPECT_EQ(claims[0].is, 3);
  EXPECT_EQ(claims[1].least, 1);
  EXPECT_EQ(claims[1].most, 2);
}

// A step without a scene takes the one before it and changes it. An answer takes its step's scene and changes
// it.
TEST(LessonFile, StepsInherit) {
  const Lesson lesson = parsed(
      R"({"title": "t", "steps": [
        {"heading": "1", "caption": ["c"], "scene": "sticks", "names": {"A": 0}, "shading": {"order": "zsort"},
         "claims": {"cuts": 1}},
        {"heading": "2", "caption": ["c"], "shading": {"method": "phong"},
         "question": {"asks": "q", "answers": [
           {"text": "a", "says": "s", "shown": {"wrong": true}}, {"text": "b", "holds": true, "says": "s"}]}}]})");
  const StepFigure& second = lesson.steps[1].figure;
  EXPECT_EQ(second.settings.order, Order::ZSort);
  EXPECT_EQ(second.settings.shading, Shading::Phong);
  EXPECT_EQ(second.names.size(), 1U);
  EXPECT_TRUE(second.claims.empty());
  EXPECT_EQ(second.scene, lesson.steps[0].figure.scene);  // it is read once
  const std::vector<LessonAnswer>& answers = lesson.steps[1].question->answers;
  EXPECT_TRUE(answers[0].shown.wrongMarked);
  EXPECT_FALSE(answers[1].shown.wrongMarked);
  EXPECT_EQ(answers[0].shown.settings, second.settings);
}

TEST(LessonFile, EveryControlIsKnown) {
  std::string keys = "hkxf1234567weuUrq?";  // the hint, the keys of spareOf(), and those of all views
  for (const LessonControl& row : lessonControls()) {
    const Lesson lesson = parsed(withStep("\"controls\": [\"" + std::string{row.name} + "\"]"));
    EXPECT_EQ(lesson.steps[0].controls, std::vector{row.id});
    EXPECT_EQ(keys.find(row.id), std::string::npos) << row.name;
    keys += row.id;
  }
}

// A file with any bytes changed gives a lesson or a complaint, and never anything else.
TEST(LessonFile, AnyTextIsReadOrRefused) {
  std::ifstream file{std::string{XNEWELL_DATA_DIR} + "/lessons/cycles.json"};
  std::stringstream text;
  text << file.rdbuf();
  int refused = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    refused += complaintOf(mutated(text.str(), rng)).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 100);
}

}  // namespace xnewell::THIS_FILE
